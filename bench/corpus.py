#!/usr/bin/env python3
"""Meshes every molecule of a folder in every model, one line each, and fails on any failure.

Each mesh goes to a temporary folder and is removed after its run. A run is good when the mesh is
certified, without a violation, with every angle above the bound and without a fallback to another
run or method, or when the molecule is refused as singular (exit code 4). The lines also go to
results/corpus.tsv, each at once.
"""

import argparse
import concurrent.futures
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MORSKIN = ROOT / "build" / "morskin"
BUNDLED = ROOT / "bench" / "molecules"
ENDINGS = {".pdb", ".ent", ".cif", ".pqr", ".xyz", ".xyzr"}
MODELS = ["paper", "sas", "vdw"]
LARGEST = {"paper": 20_000, "sas": 60_000, "vdw": 20_000}  # atoms

COLUMNS = ["file", "model", "atoms", "triangles", "chi", "chi_expected", "components", "genus",
           "min_angle", "worst_L", "worst_U", "seconds", "floor_ratio", "verdict"]
WIDTHS = [26, 6, 7, 10, 7, 12, 10, 6, 9, 7, 7, 8, 11, 0]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--molecules", type=Path, default=Path("../shared/molecules"),
                        help="folder to search (default %(default)s, else bench/molecules)")
    parser.add_argument("--largest", type=int, metavar="N", help="no molecule of more atoms")
    parser.add_argument("--models", default=",".join(MODELS), help="default %(default)s")
    parser.add_argument("--method", default="sweep", help="default %(default)s")
    parser.add_argument("--only", default="", metavar="PATTERN", help="part of the file's path")
    parser.add_argument("--jobs", type=int, choices=[1, 2], default=1, help="runs at a time")
    parser.add_argument("--timeout", type=float, default=900, help="seconds for one run")
    parser.add_argument("--results", type=Path, default=ROOT / "results" / "corpus.tsv")
    return parser.parse_args()


def molecule_files(folder, only):
    def ending(path):
        return Path(path.stem).suffix if path.suffix == ".gz" else path.suffix

    return [p for p in sorted(folder.rglob("*")) if ending(p) in ENDINGS and only in str(p)]


def atom_count(path):
    """The atoms that a mesh would be made of; infinitely many if `info` does not say."""
    done = subprocess.run([MORSKIN, "info", path, "--json"], capture_output=True, text=True)
    return json.loads(done.stdout)["atoms"] if done.returncode == 0 else math.inf


def plan(options, folder):
    """Pairs of file and model, small molecules first."""
    files = [(atom_count(p), p) for p in molecule_files(folder, options.only)]
    unreadable = [p for atoms, p in files if atoms == math.inf]
    largest = {m: min(LARGEST[m], options.largest or math.inf) for m in options.models.split(",")}
    runs = [(p, m) for atoms, p in sorted(files) for m in largest if atoms <= largest[m]]
    return runs, unreadable


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


def run(path, model, folder, method, timeout):
    with tempfile.TemporaryDirectory() as temporary:
        command = [MORSKIN, "mesh", path, "--model", model, "--method", method, "--json",
                   "--progress", "never", "-o", Path(temporary) / "mesh.ply"]
        try:
            done = subprocess.run(command, capture_output=True, text=True, timeout=timeout)
            code, output, complaint = done.returncode, done.stdout, done.stderr
        except subprocess.TimeoutExpired:
            code, output, complaint = -1, "", f"still running after {timeout:g} s"
    complaint = " ".join(complaint.split()).removeprefix("morskin: ")
    report = json.loads(output) if output else {}
    row = {"file": str(path.relative_to(folder)), "model": model,
           "verdict": verdict_of(code, report, complaint)}
    keys = {"atoms": "atoms_used", "triangles": "triangles", "chi": "euler_characteristic",
            "chi_expected": "expected_euler_characteristic", "components": "components",
            "genus": "genus", "min_angle": "min_angle_deg", "worst_L": "worst_L",
            "worst_U": "worst_U", "floor_ratio": "floor_ratio"}
    row.update({column: report.get(key, "") for column, key in keys.items()})
    row["seconds"] = report.get("seconds", {}).get("total", "")
    return row


def brief(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def print_row(values):
    cells = [brief(v) for v in values]
    text = [c.ljust(w) if i < 2 else c.rjust(w) for i, (c, w) in enumerate(zip(cells, WIDTHS))]
    print(" ".join(text[:-1]), "", cells[-1], flush=True)


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
              f"worst [U] {max(r['worst_U'] for r in certified):.4f}")
    for row in failed:
        print(f"  {row['file']} {row['model']}: {row['verdict']}")
    return len(failed)


def main():
    options = arguments()
    folder = options.molecules if options.molecules.is_absolute() else ROOT / options.molecules
    if not folder.is_dir():
        print(f"{folder} is not there; using {BUNDLED}")
        folder = BUNDLED
    folder = folder.resolve()
    runs, unreadable = plan(options, folder)
    options.results.parent.mkdir(parents=True, exist_ok=True)
    rows = []
    with open(options.results, "w", encoding="utf-8") as table, \
            concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        table.write("\t".join(COLUMNS) + "\n")
        print_row(COLUMNS)
        for row in pool.map(lambda r: run(*r, folder, options.method, options.timeout), runs):
            values = [row[c] for c in COLUMNS]
            table.write("\t".join(map(str, values)) + "\n")
            table.flush()
            print_row(values)
            rows.append(row)
    failures = print_totals(rows)
    for path in unreadable:
        print(f"  {path}: FAILED: morskin info cannot read it")
    if not runs:
        print("nothing was run")
    sys.exit(1 if failures or unreadable or not runs else 0)


if __name__ == "__main__":
    main()
