#!/usr/bin/env python3
"""Meshes every molecule of a folder in every model, one line each, and fails on any failure.

C is 0.08 unless given; models paper and vdw of the largest molecules take a larger one at least,
with which meshes stay below 30 million triangles (COARSER). If the largest molecule has more than
200,000 atoms there is one run more: four copies of it side by side, model sas, C = 0.3. --largest
leaves out what takes too long.

Each mesh goes to a temporary folder and is removed after its run. A run is good when the mesh is
certified, without a violation of [U], with every angle at least 30 degrees and without a fallback
to another run or method, or when the molecule is refused as singular (exit code 4). With --check
the mesh is then read by the command `check`, which must agree and find no self-intersection. The
lines also go to results/corpus.tsv, each at once. Triangles that miss the goal for angles are
counted, as are edges that break [L]; they fail nothing.
"""

import concurrent.futures
import dataclasses
import subprocess
import tempfile
from pathlib import Path

from molecule_runs import (MORSKIN, ROOT, Rows, argument_parser, end, mesh, molecule_folder,
                           run_command, sized_files)

# By model, C for molecules of more than so many atoms.
COARSER = {"paper": [(100_000, 0.34), (20_000, 0.23)], "vdw": [(100_000, 0.3), (20_000, 0.2)]}
WORTH_TILING = 200_000  # atoms

COLUMNS = ["file", "model", "atoms", "C", "triangles", "area", "chi", "chi_expected", "components",
           "genus", "min_angle", "max_angle", "missed", "worst_L", "broken_L", "worst_U", "seconds",
           "peak_mib", "floor_ratio", "delaunay_violations", "verdict"]
WIDTHS = [26, 6, 7, 5, 10, 8, 7, 12, 10, 6, 9, 9, 6, 7, 8, 7, 8, 8, 11, 8, 0]


def arguments():
    parser = argument_parser(__doc__, timeout=3600, results="results/corpus.tsv")
    parser.add_argument("--method", default="auto", help="default %(default)s")
    parser.add_argument("-C", type=float, default=0.08, help="default %(default)s")
    parser.add_argument("--angle-goal", type=float, default=0, metavar="DEG",
                        help="fail where an angle is smaller (default: the command's, which may "
                             "be missed)")
    parser.add_argument("--jobs", type=int, choices=[1, 2], default=1, help="runs at a time")
    parser.add_argument("--check", action="store_true", help="run `check` on every mesh as well")
    return parser.parse_args()


def plan(options, folder):
    """What to run, small molecules first: file, model, C if it is not the usual one, copies."""
    files, unreadable = sized_files(folder, options.only, options.largest)
    models = options.models.split(",")
    runs = [Planned(p, m, max([options.C, *(C for least, C in COARSER.get(m, [])
                                            if atoms > least)]))
            for atoms, p in files for m in models]
    if files and files[-1][0] > WORTH_TILING and "sas" in models:
        runs.append(Planned(files[-1][1], "sas", max(0.3, options.C), "2x2x1"))
    return runs, unreadable


@dataclasses.dataclass
class Planned:
    path: Path
    model: str
    C: float
    copies: str = ""  # as bench/tile.py has them

    @property
    def words(self):
        return ["--model", self.model, "-C", str(self.C)]


def verdict_of(code, report, complaint, angle_goal):
    if code == 4 and "singular" in complaint:
        return "refused: " + complaint
    if code == 0:
        violations = report["violations_U"]
        for fallback in report["fallbacks"]:
            return (f"FAILED: fell back to {fallback['to']} at component {fallback['component']}: "
                    f"{fallback['why']}")
        if report["min_angle_deg"] < angle_goal:
            return f"FAILED: an angle of {report['min_angle_deg']:.2f} degrees"
        if report["certified"] and violations == 0 and report["proved_angle_deg"] >= 30:
            return "certified"
        return "FAILED: exit code 0, but the report disagrees"
    return f"FAILED: exit code {code}: {report.get('reason') or complaint}"


def verdict_of_check(made, path, planned, report, timeout):
    """Whether `check` agrees with the report of the run that wrote the mesh."""
    done = run_command(["check", made, "--against", path, *planned.words, "--json"], timeout)
    if done.code != 0:
        verdicts = [v["name"] for v in done.report.get("verdicts", []) if not v["holds"]]
        return f"FAILED: check ends with {done.code}: {', '.join(verdicts) or done.complaint}"
    if done.report["self_intersections"] or not done.report["self_intersections_complete"]:
        return "FAILED: check finds self-intersections"
    for key in ["triangles", "euler_characteristic", "components", "genus", "min_angle_deg",
                "worst_L", "worst_U"]:
        if done.report[key] != report[key]:
            return f"FAILED: check has another {key}: {done.report[key]}, not {report[key]}"
    # The mesher asks the neighbours only, `check` all vertices: the same question for a small C.
    all_found, found = (r["restricted_delaunay_violations"] for r in (done.report, report))
    if all_found < found or (planned.C <= 0.2 and all_found != found):
        return f"FAILED: check has {all_found} restricted Delaunay violations, the mesher {found}"
    return "certified"


def run(planned, folder, options):
    with tempfile.TemporaryDirectory() as temporary:
        made, path = Path(temporary) / "mesh.ply", planned.path
        if planned.copies:
            path = Path(temporary) / "copies.xyzr"
            subprocess.run([ROOT / "bench" / "tile.py", MORSKIN, planned.path, "-n", planned.copies,
                            "-o", path], check=True, capture_output=True)
        goal = ["--angle-goal", str(options.angle_goal)] if options.angle_goal else []
        done = mesh(path, planned.model, options.timeout, "--method", options.method, *goal,
                    *planned.words[2:], keep=made if options.check else None)
        row = row_of(planned, folder, done, options.angle_goal)
        if options.check and row["verdict"] == "certified":
            row["verdict"] = verdict_of_check(made, path, planned, done.report, options.timeout)
    return row


def row_of(planned, folder, done, angle_goal):
    name = str(planned.path.relative_to(folder)) + (" " + planned.copies).rstrip()
    row = {"file": name, "model": planned.model,
           "verdict": verdict_of(done.code, done.report, done.complaint, angle_goal)}
    keys = {"atoms": "atoms_used", "C": "C", "triangles": "triangles", "area": "area",
            "chi": "euler_characteristic", "chi_expected": "expected_euler_characteristic",
            "components": "components", "genus": "genus", "min_angle": "min_angle_deg",
            "max_angle": "max_angle_deg", "worst_L": "worst_L", "broken_L": "violations_L",
            "worst_U": "worst_U", "floor_ratio": "floor_ratio",
            "delaunay_violations": "restricted_delaunay_violations"}
    row.update({column: done.report.get(key, "") for column, key in keys.items()})
    row["missed"] = done.report.get("smoothing", {}).get("left", "")
    row["seconds"] = done.report.get("seconds", {}).get("total", "")
    peak = done.report.get("peak_memory_bytes")
    row["peak_mib"] = "" if peak is None else round(peak / 2**20)
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
              f"angles from {min(r['min_angle'] for r in certified):.2f} to "
              f"{max(r['max_angle'] for r in certified):.2f} degrees, "
              f"{sum(r['missed'] for r in certified)} triangles miss the goal, "
              f"{sum(r['broken_L'] for r in certified)} edges break [L], "
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
        for row in pool.map(lambda r: run(r, folder, options), runs):
            rows.add(row)
    failures = print_totals(rows.rows)
    end(failures, runs, unreadable)


if __name__ == "__main__":
    main()
