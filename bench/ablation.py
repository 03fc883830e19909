#!/usr/bin/env python3
"""What is each departure from the paper's Algorithm 1 worth? Meshes 11 bundled molecules (model
paper) and 100 random sets of balls from one front, unsmoothed, with departures taken back to what
the paper prints: none, each alone, all but one, all.

One line for each, also in papers/results/ablation.tsv. Triangles, angles, breaches of [L] and [U]
when the sweep has ended, and processor time from the critical points to the refined mesh are those
of the runs that are certified; ratios are to the same runs of the first line. No safety net: a
failure is a failure, of which `left_open` are sweeps that left their front open. Of repetitions, in
turns, the shortest time counts.
"""

import json
import math
import random
import resource
import subprocess
import tempfile
from pathlib import Path

from molecule_runs import (BUNDLED, ROOT, Rows, argument_parser, end, markdown, molecule_files,
                           positive, run_program)

PROGRAM = ROOT / "build" / "bench" / "morskin_ablation"
NONE = "nothing"
# By row the switches, and what is printed.
ROWS = {
    NONE: ([], "nothing: one front, unsmoothed"),
    "radius": (["radius"], r"$r = 0.208\, \rho$, not 0.87 of it"),
    "length-scale": (["length-scale"], r"$\rho$ at the departure vertex only"),
    "sectors": (["sectors"], "sectors by rounding the angle over 60° up, not to the nearest"),
    "wings": (["wings"], "wings below 90°, not 75°"),
    "edges": (["edges"], "no rule for big ears and long edges"),
    "contraction": (["contraction"], "arcs contracted by distance"),
    "refinement": (["refinement"], "refinement in the loop"),
    "guard": (["guard"], "collisions sought in protecting spheres only"),
}
SWITCHES = [switch for switches, _ in ROWS.values() for switch in switches]
ROWS["all-but-guard"] = ([s for s in SWITCHES if s != "guard"], "all but the last")
ROWS["all"] = (SWITCHES, "all")

COLUMNS = ["as_printed", "runs", "certified", "failed", "out_of_time", "left_open", "triangles",
           "triangles_ratio", "min_angle", "max_angle", "per_million_below_25",
           "per_million_below_30", "laid_short_edges", "laid_big_triangles", "cpu_seconds",
           "cpu_ratio", "triangles_1grm", "min_angle_1grm"]
WIDTHS = [14, 4, 9, 6, 11, 9, 9, 15, 9, 9, 20, 20, 16, 18, 11, 9, 14, 14]
GRAMICIDIN = "1grm_model1.pdb"  # the one molecule that may be the paper's
# By name: what is bundled for other ends later must not change what the page counts.
MOLECULES = ["1crn.pdb", GRAMICIDIN, "5tmn_ligand.pdb", "9dna.pdb", "benzene.pdb", "c60.xyz",
             "caffeine.xyz", "cube8.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "two_balls.xyzr"]
RANDOM_SETS = 100
MAX_MEMORY = 2 * 2**30  # bytes, of a run
TIMEOUT = 60  # seconds, of a run


def arguments():
    parser = argument_parser(__doc__, timeout=TIMEOUT, results="papers/results/ablation.tsv",
                             takes=[])
    parser.add_argument("--repetitions", type=positive, default=2,
                        help="of every run (%(default)s)")
    return parser.parse_args()


def write_balls(path, seed):
    """1 to 40 balls with radii from 0.5 to 3 Angstrom, in a box that makes them a loose chain, a
    dense clump or a scatter."""
    generator = random.Random(seed)
    count = 1 + int(40 * generator.random())
    box = (1 + 2 * generator.random()) * count ** (1 / 3) * 1.7
    lines = []
    for _ in range(count):
        numbers = [box * generator.random() for _ in range(3)] + [0.5 + 2.5 * generator.random()]
        lines.append(" ".join(f"{x:.6f}" for x in numbers))
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def inputs(folder, only=""):
    """Pairs of file and model."""
    for seed in range(RANDOM_SETS):
        write_balls(folder / f"random{seed}.xyzr", seed)
    pairs = [(BUNDLED / name, "paper") for name in MOLECULES]
    pairs += [(path, "vdw") for path in molecule_files(folder)]
    return [(path, model) for path, model in pairs if only in str(path)]


def run(path, model, switches, timeout):
    """The report of a run, with what became of it."""
    try:
        done = run_program([PROGRAM, path, model, *switches], capture_output=True, text=True,
                           timeout=timeout, preexec_fn=lambda: resource.setrlimit(
                               resource.RLIMIT_AS, (MAX_MEMORY, MAX_MEMORY)))
    except subprocess.TimeoutExpired:
        return {"outcome": "out_of_time", "reason": f"still running after {timeout:g} s"}
    if done.returncode != 0:
        complaint = " ".join(done.stderr.split())
        return {"outcome": "failed", "reason": complaint or f"exit {done.returncode}"}
    report = json.loads(done.stdout)
    return report | {"input": path.name,
                     "outcome": "certified" if report["certified"] else "failed"}


def rank(report):
    """Of several runs of the same the lowest counts: a failure, or else the quickest. One that was
    in time shows what comes out; others were slowed by the machine."""
    return -1 if report["outcome"] == "failed" else report.get("cpu_seconds", math.inf)


def run_in_turns(path, model, timeout, repetitions):
    """By row the report that counts."""
    reports = {}
    for _ in range(repetitions):
        for name, (switches, _) in ROWS.items():
            if name in reports and reports[name]["outcome"] != "certified":
                continue
            report = run(path, model, switches, timeout)
            reports[name] = min(reports.get(name, report), report, key=rank)
    for name, report in reports.items():
        if report["outcome"] != "certified":
            print(f"{path.name}, {name}: {report['outcome']}: {report['reason']}", flush=True)
    return reports


def row(name, reports, base):
    """The row of these reports, beside those of the first row."""
    good = [(r, b) for r, b in zip(reports, base)
            if r["outcome"] == b["outcome"] == "certified"]

    def total(column, which=0):
        return sum(pair[which][column] for pair in good)

    def ratio(column):
        return total(column) / total(column, 1) if total(column, 1) else "-"

    def per_million_angles(column):
        return 1e6 * total(column) / (3 * total("triangles")) if good else "-"

    outcomes = [r["outcome"] for r in reports]
    gramicidin = next((r for r, _ in good if r["input"] == GRAMICIDIN), {})
    return {"as_printed": name, "runs": len(reports),
            **{o: outcomes.count(o) for o in ("certified", "failed", "out_of_time")},
            "left_open": sum(r.get("open_edges", 0) > 0 for r in reports),
            "triangles": total("triangles"), "triangles_ratio": ratio("triangles"),
            "min_angle": min((r["min_angle_deg"] for r, _ in good), default="-"),
            "max_angle": max((r["max_angle_deg"] for r, _ in good), default="-"),
            "per_million_below_25": per_million_angles("angles_below_25"),
            "per_million_below_30": per_million_angles("angles_below_30"),
            "laid_short_edges": total("laid_short_edges"),
            "laid_big_triangles": total("laid_big_triangles"),
            "cpu_seconds": total("cpu_seconds"), "cpu_ratio": ratio("cpu_seconds"),
            "triangles_1grm": gramicidin.get("triangles", "-"),
            "min_angle_1grm": gramicidin.get("min_angle_deg", "-")}


def measure(results, timeout, repetitions=2, only="", is_quick=False):
    """Runs all rows and writes them; returns them. Quick takes every ninth input, once."""
    if is_quick:
        timeout, repetitions = min(timeout, TIMEOUT / 6), 1
    with tempfile.TemporaryDirectory() as folder:
        pairs = inputs(Path(folder), only)[::9 if is_quick else 1]
        if not pairs:
            return []
        runs = []
        for path, model in pairs:
            runs.append(run_in_turns(path, model, timeout, repetitions))
            print(f"ablation   {path.name:24} {len(runs)} of {len(pairs)}", flush=True)
    with Rows(results, COLUMNS, WIDTHS, 1) as rows:
        for name in ROWS:
            rows.add(row(name, [reports[name] for reports in runs], [r[NONE] for r in runs]))
        return rows.rows


def table(rows):
    """The rows in Markdown, as papers/5-results.md shows them."""
    head = ["as printed", "certified", "triangles", "smallest, largest angle",
            "angles below 25°, 30° in a million", "edges below [L], triangles above [U] as swept",
            "time", "1GRM: triangles, smallest angle"]
    body = []
    for r in rows:
        cells = [ROWS[r["as_printed"]][1], f"{r['certified']} of {r['runs']}"]
        if int(r["out_of_time"]) > 0:
            cells[-1] += f", {r['out_of_time']} not measured"
        if r["triangles_ratio"] != "-":  # some runs are certified here and in the first row
            cells += [f"{float(r['triangles_ratio']):.3f}",
                      f"{float(r['min_angle']):.2f}°, {float(r['max_angle']):.1f}°",
                      f"{float(r['per_million_below_25']):.1f}, "
                      f"{float(r['per_million_below_30']):,.0f}",
                      f"{int(r['laid_short_edges']):,}, {int(r['laid_big_triangles']):,}",
                      f"{float(r['cpu_ratio']):.2f}"]
        else:
            cells += ["-"] * 5
        is_meshed = r["triangles_1grm"] != "-"
        cells.append(f"{int(r['triangles_1grm']):,}, {float(r['min_angle_1grm']):.2f}°"
                     if is_meshed else "-")
        body.append(cells)
    return markdown(head, body)


def failures(rows):
    """What may not fail: the sweep with all its departures."""
    return [f"ablation: {r['runs'] - r['certified']} runs with nothing as printed"
            for r in rows if r["as_printed"] == NONE and r["certified"] < r["runs"]]


def main():
    options = arguments()
    rows = measure(options.results, options.timeout, options.repetitions, options.only)
    print("\n" + table(rows))
    end(failures(rows), rows)


if __name__ == "__main__":
    main()
