#!/usr/bin/env python3
"""Meshes a list of molecules by several methods in every model and compares what comes out.

One line a run. Each mesh must be certified without a fallback, and all methods must agree on Euler
characteristic, components and genus, which the certificate has compared with the dual complex.
The lines also go to results/methods.tsv, each at once.
"""

import argparse
import json
import math
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MORSKIN = ROOT / "build" / "morskin"
MODELS = ["paper", "vdw", "sas"]
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

COLUMNS = ["input", "model", "method", "triangles", "chi", "components", "genus", "min_angle",
           "worst_L", "worst_U", "cpu_seconds", "per_second", "verdict"]


def arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--methods", default="sweep,static", help="default %(default)s")
    parser.add_argument("--models", default=",".join(MODELS), help="default %(default)s")
    parser.add_argument("--only", default="", metavar="PATTERN", help="part of the input's name")
    parser.add_argument("--molecules", type=Path, default=ROOT / "../shared/molecules/corpus",
                        help="where to look for what is not in bench/molecules")
    parser.add_argument("--timeout", type=float, default=900, help="seconds for one run")
    parser.add_argument("--results", type=Path, default=ROOT / "results" / "methods.tsv")
    return parser.parse_args()


def inputs(options, folder):
    """Pairs of name and file."""
    for name, lines in BALLS.items():
        path = folder / (name.replace(" ", "_").replace(",", "") + ".xyzr")
        path.write_text("\n".join(lines) + "\n")
        yield name, path
    for name in BUNDLED_BALLS + FILES:
        path = ROOT / "bench" / "molecules" / name
        yield name, path if path.exists() else options.molecules / name


def run(path, model, method, options, folder):
    """The report, and the seconds of processor time of all threads."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    command = [MORSKIN, "mesh", path, "--model", model, "--method", method, "--json",
               "--progress", "never", "-o", folder / "mesh.ply"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=options.timeout)
    except subprocess.TimeoutExpired:
        return None, f"still running after {options.timeout:g} s", 0
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    report = json.loads(done.stdout) if done.stdout else None
    return report, " ".join(done.stderr.split()), after.ru_utime - before.ru_utime


def verdict_of(report, complaint, first):
    """`first` is the report of the first method on the same skin."""
    if report is None:
        return "FAILED: " + complaint
    if not report["certified"]:
        return "FAILED: " + report["reason"]
    if report["fallbacks"]:
        return "FAILED: fell back: " + report["fallbacks"][0]["why"]
    for key in ("euler_characteristic", "components", "genus"):
        if first and report[key] != first[key]:
            return f"FAILED: {key} is {report[key]}, {first['method']} has {first[key]}"
    return "certified"


def row_of(name, model, method, report, seconds, verdict):
    report = report or {}
    keys = ["triangles", "euler_characteristic", "components", "genus", "min_angle_deg",
            "worst_L", "worst_U"]
    triangles = report.get("triangles", 0)
    return [name, model, method, *(report.get(key, "") for key in keys), seconds,
            round(triangles / seconds) if seconds > 0 else "", verdict]


def brief(value):
    return f"{value:.4g}" if isinstance(value, float) else str(value)


def main():
    options = arguments()
    options.results.parent.mkdir(parents=True, exist_ok=True)
    widths = [22, 6, 8, 9, 6, 10, 5, 9, 7, 7, 11, 10]
    failed = runs = 0
    with tempfile.TemporaryDirectory() as temporary, \
            open(options.results, "w", encoding="utf-8") as table:
        print("\t".join(COLUMNS), file=table)
        print(" ".join(c.ljust(w) for c, w in zip(COLUMNS, widths)))
        for name, path in inputs(options, Path(temporary)):
            if options.only not in name:
                continue
            for model in options.models.split(","):
                first = None
                for method in options.methods.split(","):
                    report, complaint, seconds = run(path, model, method, options,
                                                     Path(temporary))
                    verdict = verdict_of(report, complaint, first)
                    first = first or report
                    row = row_of(name, model, method, report, seconds, verdict)
                    print("\t".join(str(v) for v in row), file=table, flush=True)
                    print(" ".join(brief(v).ljust(w) for v, w in zip(row, widths)), verdict,
                          flush=True)
                    runs += 1
                    failed += verdict != "certified"
    print(f"\n{runs} runs, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
