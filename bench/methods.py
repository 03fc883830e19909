#!/usr/bin/env python3
"""Meshes a list of molecules by several methods in every model and compares what comes out.

One line a run. Each mesh must be certified without a fallback, and all methods must agree on Euler
characteristic, components and genus, which the certificate has compared with the dual complex.
The lines also go to results/methods.tsv, each at once.
"""

import math
import tempfile
from pathlib import Path

import molecule_runs
from molecule_runs import BUNDLED, markdown

# Files of bench/molecules or of the folder given; balls "x y z r" are written to a file.
FILES = ["c60.xyz", "benzene.pdb", "caffeine.xyz", "5tmn_ligand.pdb", "9dna.pdb",
         "1grm_model1.pdb", "1crn.pdb", "1ubq.pdb"]
TOUCHING = 2 * math.sqrt(2)  # where two balls of radius 1 have singular skin
BALLS = {
    "one ball": ["0 0 0 1"],
    "two, a neck": ["0 0 0 1", "2 0 0 1"],
    "two, a short neck": ["0 0 0 1", f"{TOUCHING * (1 - 1e-3):.17g} 0 0 1"],
    "two, almost touching": ["0 0 0 1", f"{TOUCHING * (1 + 1e-3):.17g} 0 0 1"],
    "two, apart": ["0 0 0 1", "9 0 0 1"],
}
BUNDLED_BALLS = ["cube8.xyzr", "ring12.xyzr", "shell_hollow.xyzr"]

COLUMNS = ["input", "model", "method", "triangles", "euler_characteristic", "components", "genus",
           "min_angle_deg", "worst_L", "worst_U", "cpu_seconds", "per_second", "verdict"]
WIDTHS = [22, 6, 8, 9, 6, 5, 5, 7, 7, 7, 8, 8, 0]


def arguments():
    parser = molecule_runs.argument_parser(__doc__, timeout=900, results="results/methods.tsv",
                                           takes=["molecules", "models"])
    parser.add_argument("--methods", default="sweep,static,dynamic", help="default %(default)s")
    return parser.parse_args()


def inputs(molecules, folder):
    """Pairs of name and file."""
    for name, lines in BALLS.items():
        path = folder / (name.replace(" ", "_").replace(",", "") + ".xyzr")
        path.write_text("\n".join(lines) + "\n")
        yield name, path
    for name in BUNDLED_BALLS + FILES:
        bundled = BUNDLED / name
        found = [bundled] if bundled.exists() else sorted(molecules.rglob(name))
        if found:
            yield name, found[0]
        else:
            print(f"{name} is neither in {BUNDLED} nor in {molecules}: left out")


def verdict_of(run, first):
    """`first` is the report of the first method that is certified on the same skin."""
    report = run.report
    if not report:
        return "FAILED: " + run.complaint
    if not report["certified"]:
        return "FAILED: " + report["reason"]
    if report["fallbacks"]:
        return "FAILED: fell back: " + report["fallbacks"][0]["why"]
    for key in ("euler_characteristic", "components", "genus"):
        if first and report[key] != first[key]:
            return f"FAILED: {key} is {report[key]}, {first['method']} has {first[key]}"
    return "certified"


def row_of(name, model, method, run, verdict):
    seconds = run.cpu_seconds
    row = {key: run.report.get(key, "") for key in COLUMNS}
    rate = round(run.report.get("triangles", 0) / seconds) if seconds > 0 else ""
    return row | {"input": name, "model": model, "method": method, "cpu_seconds": seconds,
                  "per_second": rate, "verdict": verdict}


def in_seconds(seconds):
    return f"{seconds:.2g}" if seconds < 10 else f"{seconds:.0f}"


def table(rows):
    """5, dynamic: sweep, static and dynamic side by side."""
    methods = ["sweep", "static", "dynamic"]
    columns = {"triangles": lambda r: f"{int(r['triangles']):,}",
               "smallest angle": lambda r: f"{float(r['min_angle_deg']):.2f}°",
               "CPU s": lambda r: in_seconds(float(r["cpu_seconds"]))}
    head = ["input", "model", r"$\chi$, components, genus",
            *(f"{name}, {methods[0]}" if method == methods[0] else method
              for name in columns for method in methods)]
    body = []
    for first in (r for r in rows if r["method"] == methods[0]):
        of_it = [next(r for r in rows if r["method"] == method
                      and (r["input"], r["model"]) == (first["input"], first["model"]))
                 for method in methods]
        known = any(cells[0] == first["input"] for cells in body)
        body.append(["" if known else first["input"], first["model"],
                     f"{first['euler_characteristic']}, {first['components']}, {first['genus']}",
                     *(cell(r) for cell in columns.values() for r in of_it)])
    return markdown(head, body)


def main():
    options = arguments()
    molecules = molecule_runs.molecule_folder(options.molecules)
    failed = 0
    with tempfile.TemporaryDirectory() as temporary, \
            molecule_runs.Rows(options.results, COLUMNS, WIDTHS, left=3) as table:
        for name, path in inputs(molecules, Path(temporary)):
            if options.only not in name:
                continue
            for model in options.models.split(","):
                first = None
                for method in options.methods.split(","):
                    run = molecule_runs.mesh(path, model, options.timeout, "--method", method)
                    verdict = verdict_of(run, first)
                    if verdict == "certified":
                        first = first or run.report
                    table.add(row_of(name, model, method, run, verdict))
                    failed += verdict != "certified"
    print(f"\n{len(table.rows)} runs, {failed} failed")
    molecule_runs.end(failed, table.rows)


if __name__ == "__main__":
    main()
