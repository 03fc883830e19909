#!/usr/bin/env python3
"""Meshes every molecule of a folder in every model, one line each, and fails on any failure.

Each mesh goes to a temporary folder and is removed after its run. A run is good when the mesh is
certified, without a violation, with every angle above the bound and without a fallback to another
run or method, or when the molecule is refused as singular (exit code 4). With --check the mesh is
then read by the command `check`, which must agree and find no self-intersection. The lines also go
to results/corpus.tsv, each at once.
"""

import concurrent.futures
import math
import tempfile
from pathlib import Path

from molecule_runs import (MODELS, Rows, argument_parser, end, mesh, molecule_folder, run_command,
                           sized_files)

LARGEST = {"paper": 20_000, "sas": 60_000, "vdw": 20_000}  # atoms

COLUMNS = ["file", "model", "atoms", "triangles", "chi", "chi_expected", "components", "genus",
           "min_angle", "worst_L", "worst_U", "seconds", "floor_ratio", "delaunay_violations",
           "verdict"]
WIDTHS = [26, 6, 7, 10, 7, 12, 10, 6, 9, 7, 7, 8, 11, 8, 0]


def arguments():
    parser = argument_parser(__doc__, timeout=900, results="results/corpus.tsv")
    parser.add_argument("--method", default="sweep", help="default %(default)s")
    parser.add_argument("--jobs", type=int, choices=[1, 2], default=1, help="runs at a time")
    parser.add_argument("--check", action="store_true", help="run `check` on every mesh as well")
    return parser.parse_args()


def plan(options, folder):
    """Pairs of file and model, small molecules first."""
    files, unreadable = sized_files(folder, options.only)
    largest = {m: min(LARGEST[m], options.largest or math.inf) for m in options.models.split(",")}
    return [(p, m) for atoms, p in files for m in largest if atoms <= largest[m]], unreadable


def verdict_of(code, report, complaint):
    if code == 4 and "singular" in complaint:
        return "refused: " + complaint
    if code == 0:
        bound = math.degrees(math.asin(1 / report["Q"] ** 2))
        violations = report["violations_L"] + report["violations_U"]
        for fallback in report["fallbacks"]:
            return (f"FAILED: fell back to {fallback['to']} at component {fallback['component']}: "
                    f"{fallback['why']}")
        if report["certified"] and violations == 0 and report["min_angle_deg"] > bound:
            return "certified"
        return "FAILED: exit code 0, but the report disagrees"
    return f"FAILED: exit code {code}: {report.get('reason') or complaint}"


def verdict_of_check(made, path, model, report, timeout):
    """Whether `check` agrees with the report of the run that wrote the mesh."""
    done = run_command(["check", made, "--against", path, "--model", model, "--json"], timeout)
    if done.code != 0:
        verdicts = [v["name"] for v in done.report.get("verdicts", []) if not v["holds"]]
        return f"FAILED: check ends with {done.code}: {', '.join(verdicts) or done.complaint}"
    if done.report["self_intersections"] or not done.report["self_intersections_complete"]:
        return "FAILED: check finds self-intersections"
    for key in ["triangles", "euler_characteristic", "components", "genus", "min_angle_deg",
                "worst_L", "worst_U", "restricted_delaunay_violations"]:
        if done.report[key] != report[key]:
            return f"FAILED: check has another {key}: {done.report[key]}, not {report[key]}"
    return "certified"


def run(path, model, folder, options):
    with tempfile.TemporaryDirectory() as temporary:
        made = Path(temporary) / "mesh.ply"
        done = mesh(path, model, options.timeout, "--method", options.method,
                    keep=made if options.check else None)
        row = row_of(path, model, folder, done)
        if options.check and row["verdict"] == "certified":
            row["verdict"] = verdict_of_check(made, path, model, done.report, options.timeout)
    return row


def row_of(path, model, folder, done):
    row = {"file": str(path.relative_to(folder)), "model": model,
           "verdict": verdict_of(done.code, done.report, done.complaint)}
    keys = {"atoms": "atoms_used", "triangles": "triangles", "chi": "euler_characteristic",
            "chi_expected": "expected_euler_characteristic", "components": "components",
            "genus": "genus", "min_angle": "min_angle_deg", "worst_L": "worst_L",
            "worst_U": "worst_U", "floor_ratio": "floor_ratio",
            "delaunay_violations": "restricted_delaunay_violations"}
    row.update({column: done.report.get(key, "") for column, key in keys.items()})
    row["seconds"] = done.report.get("seconds", {}).get("total", "")
    return row


def print_totals(rows):
    certified = [r for r in rows if r["verdict"] == "certified"]
    refused = [r for r in rows if r["verdict"].startswith("refused")]
    failed = [r for r in rows if r["verdict"].startswith("FAILED")]
    triangles = sum(r["triangles"] for r in certified)
    seconds = sum(r["seconds"] for r in certified)
    print(f"\n{len(rows)} runs: {len(certified)} certified, {len(refused)} refused as singular, "
          f"{len(failed)} failed")
    if certified:
        print(f"{triangles:,} triangles in {seconds:.1f} s, "
              f"{triangles / max(seconds, 1e-9):,.0f} per second; "
              f"smallest angle {min(r['min_angle'] for r in certified):.2f} degrees, "
              f"worst [L] {min(r['worst_L'] for r in certified):.4f}, "
              f"worst [U] {max(r['worst_U'] for r in certified):.4f}; "
              f"{sum(r['delaunay_violations'] for r in certified)} restricted Delaunay violations")
    for row in failed:
        print(f"  {row['file']} {row['model']}: {row['verdict']}")
    return len(failed)


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    runs, unreadable = plan(options, folder)
    with Rows(options.results, COLUMNS, WIDTHS, 2) as rows, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        for row in pool.map(lambda r: run(*r, folder, options), runs):
            rows.add(row)
    failures = print_totals(rows.rows)
    for path in unreadable:
        print(f"  {path}: FAILED: morskin info cannot read it")
    end(failures or unreadable, runs)


if __name__ == "__main__":
    main()
