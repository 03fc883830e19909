#!/usr/bin/env python3
"""How far Morse theory predicts where the front touches itself, and what that is worth.

Every molecule and model is swept from below with one front and the guard searching everywhere,
along the front's own polygon and in enlarged protecting spheres, and in those spheres only. One
line a run, also in results/prediction.tsv: the saddles, those that survive the simplification, the
touches of the front inside protecting spheres and outside, and how many of each were futile (split
off a loop that closed again without meeting the front or a maximum); whether it is certified, and
the seconds of the sweep. Of a sweep that fails the counts are left out.

With --functions instead, in results/functions.tsv: every molecule along 10 random directions and 3
squared distances from random points, with both fronts; all must be certified with the same Euler
characteristic. Singular skins (exit code 4) and degenerate functions (2) are left out, with a line
each.
"""

import random
import subprocess

import molecule_runs
from molecule_runs import Rows, markdown

GUARDS = ["everywhere", "adjacent", "spheres"]
COUNTS = {"saddles": "saddles", "surviving": "surviving.saddles",
          "inside": "operations.guard_inside_protecting",
          "outside": "operations.guard_outside_protecting",
          "inside_vain": "operations.vain_inside_protecting",
          "outside_vain": "operations.vain_outside_protecting"}
COLUMNS = ["molecule", "model", "guard", *COUNTS, "certified", "sweep_seconds"]
WIDTHS = [24, 6, 10, *(12 for _ in COUNTS), 9, 13]
FUNCTION_COLUMNS = ["molecule", "model", "functions", "certified", "chi", "min_angle"]
# The lines of the page's table of touches, before the totals.
SHOWN = [("cube8.xyzr", "paper"), ("ring12.xyzr", "vdw"), ("c60.xyz", "paper"),
         ("shell_hollow.xyzr", "paper"), ("5tmn_ligand.pdb", "paper"), ("9dna.pdb", "paper"),
         ("1grm_model1.pdb", "paper"), ("1grm_model1.pdb", "vdw"), ("1crn.pdb", "paper"),
         ("1ubq.pdb", "paper"), ("1ubq.pdb", "sas"), ("1brs.pdb", "paper"), ("2buk.pdb", "paper"),
         ("1ehz.pdb", "paper")]


def arguments():
    parser = molecule_runs.argument_parser(__doc__, timeout=120, results="results/prediction.tsv",
                                           largest=2200)
    parser.add_argument("--functions", action="store_true", help="directions and distances")
    parser.add_argument("--seed", type=int, default=1)
    options = parser.parse_args()
    if options.functions and options.results == parser.get_default("results"):
        options.results = options.results.with_name("functions.tsv")
    return options


def mesh(path, model, timeout, *options):
    """The report of a run, empty if it made no mesh; None if it could not be asked to."""
    done = molecule_runs.mesh(path, model, timeout, *options)
    if (done.code == 4 and "singular" in done.complaint or
            done.code == 2 and "degenerate" in done.complaint):
        print(f"{path.name} {model} is left out: {done.complaint}", flush=True)
        return None
    return done.report if done.code in (0, 5) else {}


def row_of(path, model, guard, report):
    row = dict.fromkeys(COLUMNS, "") | {"molecule": path.name, "model": model, "guard": guard,
                                        "certified": 0}
    if not report or not report["certified"]:
        return row
    for column, place in COUNTS.items():
        value = report
        for key in place.split("."):
            value = value[key]
        row[column] = value
    return row | {"certified": 1, "sweep_seconds": report["seconds"]["sweep"]}


def compare_guards(options, runs):
    with Rows(options.results, COLUMNS, WIDTHS, 3) as rows:
        for path, model in runs:
            for guard in GUARDS:
                report = mesh(path, model, options.timeout, "--fronts", "1", "--guard", guard)
                if report is None:
                    break
                rows.add(row_of(path, model, guard, report))
    return sum(not r["certified"] for r in rows.rows if r["guard"] == GUARDS[0])


def of_guard(rows, guard):
    return [r for r in rows if r["guard"] == guard]


def totals(rows):
    return {column: sum(int(r[column]) for r in rows) for column in COUNTS}


def touches_table(rows):
    """3.1: touches inside and outside of protecting spheres, of some runs and of all."""
    rows = of_guard(rows, GUARDS[0])
    lines = [(name, model, next(r for r in rows if (r["molecule"], r["model"]) == (name, model)))
             for name, model in SHOWN]
    molecules = len({r["molecule"] for r in rows})
    for model in sorted({r["model"] for r in rows}):
        lines.append((f"all {molecules}", model, totals([r for r in rows if r["model"] == model])))
    lines.append((f"all {len(rows)}", "", totals(rows)))
    return markdown(
        ["molecule", "model", "saddles", "surviving saddles", "touches inside", "outside",
         "futile, inside", "futile, outside", "share inside"],
        ([name, model, *(f"{int(r[column]):,}" for column in COUNTS),
          f"{100 * int(r['inside']) / (int(r['inside']) + int(r['outside'])):.0f} %"]
         for name, model, r in lines))


def touches_sentence(rows):
    """3.1: what theory predicts of all touches, and of those that matter."""
    all_of_it = totals(of_guard(rows, GUARDS[0]))
    inside, outside = all_of_it["inside"], all_of_it["outside"]
    real = inside - all_of_it["inside_vain"]
    changing = real + outside - all_of_it["outside_vain"]
    return (f"theory predicts {100 * inside / (inside + outside):.0f} % of the touches. But "
            f"{100 * all_of_it['outside_vain'] / outside:.0f} % of those outside are futile. Of "
            f"the touches that changed the front for good, {real:,} of {changing:,} are inside, "
            f"**{100 * real / changing:.0f} %**.")


def common_runs(rows):
    """The molecules and models that are certified with every guard."""
    good = [(r["molecule"], r["model"]) for r in rows if int(r["certified"])]
    return {key for key in good if good.count(key) == len(GUARDS)}


def guards_table(rows):
    """3.1: what narrower guards are worth."""
    common = common_runs(rows)
    body = []
    for guard in GUARDS:
        runs = of_guard(rows, guard)
        certified = sum(int(r["certified"]) for r in runs)
        seconds = sum(float(r["sweep_seconds"]) for r in runs
                      if (r["molecule"], r["model"]) in common)
        body.append([guard, len(runs), certified, len(runs) - certified, f"{seconds:.2f}"])
    return markdown(["guard", "runs", "certified", "failed",
                     "seconds of the sweep, runs that all three certify"], body)


def functions_table(rows):
    """3.1: other functions on the same surfaces."""
    return markdown(["molecule", "functions", "certified", r"$\chi$", "smallest angle"],
                    ([r["molecule"], r["functions"], r["certified"], r["chi"],
                      f"{float(r['min_angle']):.2f}°"] for r in rows))


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


def try_functions(options, runs):
    failures, generator = 0, random.Random(options.seed)
    with Rows(options.results, FUNCTION_COLUMNS, [24, 6, 9, 9, 6, 9], 2) as rows:
        for path, model in runs:
            reports = [mesh(path, model, options.timeout, "--function", f)
                       for f in functions(path, generator)]
            reports = [r for r in reports if r is not None]
            good = [r for r in reports if r and r["certified"]]
            chi = {r["euler_characteristic"] for r in good}
            failures += len(reports) - len(good) + (len(chi) > 1)
            rows.add({"molecule": path.name, "model": model, "functions": len(reports),
                      "certified": len(good), "chi": ", ".join(map(str, sorted(chi))),
                      "min_angle": min((r["min_angle_deg"] for r in good), default=0)})
    return failures


def main():
    options = arguments()
    folder = molecule_runs.molecule_folder(options.molecules)
    files, unreadable = molecule_runs.sized_files(folder, options.only, options.largest)
    runs = [(path, model) for _, path in files for model in options.models.split(",")]
    if not runs:
        molecule_runs.end(0, runs, unreadable)
    failures = (try_functions if options.functions else compare_guards)(options, runs)
    print(f"{len(runs)} molecules and models, {failures} failures"
          + ("" if options.functions else " of the default guard"))
    molecule_runs.end(failures, runs, unreadable)


if __name__ == "__main__":
    main()
