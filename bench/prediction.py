#!/usr/bin/env python3
"""How far Morse theory predicts where the front touches itself, and what that is worth.

Two tables, as text on standard output and as Markdown in results/prediction.md:

  touches   every molecule and model, swept once from below with the guard looking everywhere: the
            saddles, those that survive the simplification, the touches of the front inside
            protecting spheres and outside, how many of each were futile (split off a loop that
            closed again without meeting the front or a maximum), and the share inside
  guards    the same runs with the guard searching everywhere, along the front's own polygon and in
            enlarged protecting spheres, and in those spheres only: how many are certified, and
            the seconds of those that all three have certified

With --functions instead: every molecule along 10 random directions and 3 squared distances from
random points, with both fronts; all must be certified with the same Euler characteristic. Singular
skins (exit code 4) and degenerate functions (2) are left out, with a line each.
"""

import random
import subprocess

import molecule_runs
from molecule_runs import markdown

GUARDS = ["everywhere", "adjacent", "spheres"]


def arguments():
    parser = molecule_runs.argument_parser(__doc__, timeout=120, results="results/prediction.md",
                                           largest=2000)
    parser.add_argument("--functions", action="store_true", help="directions and distances")
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_args()


def mesh(path, model, timeout, *options):
    """The report of a run, empty if it made no mesh; None if it could not be asked to."""
    done = molecule_runs.mesh(path, model, timeout, *options)
    if (done.code == 4 and "singular" in done.complaint or
            done.code == 2 and "degenerate" in done.complaint):
        print(f"{path.name} {model} is left out: {done.complaint}", flush=True)
        return None
    return done.report if done.code in (0, 5) else {}


def touches_row(name, model, report):
    operations = report["operations"]
    inside = operations["guard_inside_protecting"]
    outside = operations["guard_outside_protecting"]
    share = f"{100 * inside / (inside + outside):.0f} %" if inside + outside else "-"
    return [name, model, report["saddles"], report["surviving"]["saddles"], inside, outside,
            operations["vain_inside_protecting"], operations["vain_outside_protecting"], share]


def compare_guards(options, folder, runs):
    touches, outcomes = [], []
    for path, model in runs:
        name = str(path.relative_to(folder))
        reports = [mesh(path, model, options.timeout, "--fronts", "1", "--guard", guard)
                   for guard in GUARDS]
        if reports[0] is None:
            continue
        outcomes.append([r["seconds"]["sweep"] if r and r["certified"] else None for r in reports])
        if reports[0]:
            touches.append(touches_row(name, model, reports[0]))
        print(name, model, *("failed" if s is None else f"{s:.3f}" for s in outcomes[-1]),
              touches[-1][2:] if reports[0] else "", flush=True)
    total = [sum(row[k] for row in touches) for k in range(2, 8)]
    share = f"{100 * total[2] / max(total[2] + total[3], 1):.0f} %"
    touches.append(["all", "", *total, share])
    common = [o for o in outcomes if None not in o]
    guards = [[guard, len(outcomes), sum(o[i] is not None for o in outcomes),
               sum(o[i] is None for o in outcomes), f"{sum(o[i] for o in common):.2f}"]
              for i, guard in enumerate(GUARDS)]
    first = markdown(["molecule", "model", "saddles", "surviving", "inside", "outside",
                      "futile inside", "futile outside", "share inside"], touches)
    second = markdown(["guard", "runs", "certified", "failed",
                       f"seconds of sweep, {len(common)} runs"], guards)
    return first + "\n" + second, sum(o[0] is None for o in outcomes)


def functions(path, generator):
    """Ten directions and three points in and about the molecule."""
    balls = subprocess.run([molecule_runs.MORSKIN, "balls", path, "-o", "-", "-q"], text=True,
                           capture_output=True, check=True).stdout.splitlines()
    centres = [list(map(float, line.split()[:3])) for line in balls if line and line[0] != "#"]
    for _ in range(10):
        direction = [generator.gauss(0, 1) for _ in range(3)]
        yield "height:" + ",".join(f"{x:.6f}" for x in direction)
    for _ in range(3):
        centre = generator.choice(centres)
        yield "distance:" + ",".join(f"{x + generator.gauss(0, 5):.6f}" for x in centre)


def try_functions(options, folder, runs):
    rows, failures = [], 0
    generator = random.Random(options.seed)
    for path, model in runs:
        name = str(path.relative_to(folder))
        reports = [mesh(path, model, options.timeout, "--function", f)
                   for f in functions(path, generator)]
        reports = [r for r in reports if r is not None]
        good = [r for r in reports if r and r["certified"]]
        chi = {r["euler_characteristic"] for r in good}
        bad = len(reports) - len(good) + (len(chi) > 1)
        failures += bad
        rows.append([name, model, len(reports), len(good), ", ".join(map(str, sorted(chi))) or "-",
                     f"{min((r['min_angle_deg'] for r in good), default=0):.2f}"])
        print(*rows[-1], flush=True)
    return markdown(["molecule", "model", "functions", "certified", "chi", "smallest angle"],
                    rows), failures


def main():
    options = arguments()
    folder = molecule_runs.molecule_folder(options.molecules)
    files, unreadable = molecule_runs.sized_files(folder, options.only, options.largest)
    runs = [(path, model) for _, path in files for model in options.models.split(",")]
    if not runs:
        molecule_runs.end(0, runs, unreadable)
    study = try_functions if options.functions else compare_guards
    text, failures = study(options, folder, runs)
    options.results.parent.mkdir(parents=True, exist_ok=True)
    options.results.write_text(text, encoding="utf-8")
    print("\n" + text)
    print(f"{len(runs)} molecules and models, {failures} failures of the default guard"
          if not options.functions else f"{failures} failures")
    molecule_runs.end(failures, runs, unreadable)


if __name__ == "__main__":
    main()
