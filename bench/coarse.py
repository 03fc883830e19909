#!/usr/bin/env python3
"""How coarse can a method go? Meshes pieces of one big molecule, balls of atoms about random ones,
for several C, and counts the runs that fell back to another sweep or method or were not certified.

One line for each piece, model and C, totals by model and C at the end; no failed run fails the
script, arguments that make no sense do. The lines also go to results/coarse.tsv, each at once. The
same seed takes the same pieces.
"""

import collections
import math
import random
import sys
import tempfile
from pathlib import Path

from molecule_runs import (MORSKIN, Rows, argument_parser, atom_count, end, mesh, molecule_files,
                           molecule_folder)
from tile import read_balls

COLUMNS = ["piece", "model", "C", "atoms", "triangles", "min_angle", "seconds", "verdict"]
WIDTHS = [5, 6, 5, 6, 9, 9, 8, 0]
USAGE = 2  # the exit code for arguments that make no sense


def arguments():
    parser = argument_parser(__doc__, timeout=120, results="results/coarse.tsv",
                             takes=["molecules", "models"])
    parser.set_defaults(only="1f2n_capsid")
    parser.add_argument("--sizes", default="0.2,0.25,0.3,0.35,0.4", help="C, default %(default)s")
    parser.add_argument("--method", choices=["auto", "sweep", "static"], default="auto")
    parser.add_argument("--pieces", type=int, default=40, help="default %(default)s")
    parser.add_argument("--radius", type=float, default=14, help="of a piece, Angstrom (14)")
    parser.add_argument("--seed", type=int, default=1)
    return parser.parse_args()


def verdict_of(run):
    if run.code == USAGE:
        sys.exit(run.complaint)
    if run.code == 4 and "singular" in run.complaint:
        return "refused"
    if not run.report:
        return "FAILED: " + run.complaint
    if not run.report["certified"]:
        return "FAILED: " + run.report["reason"]
    fallbacks = run.report["fallbacks"]
    return f"fell back to {fallbacks[0]['to']}: {fallbacks[0]['why']}" if fallbacks else "certified"


def piece(atoms, centre, radius):
    return [a for a in atoms if math.dist(a[:3], centre[:3]) < radius]


def main():
    options = arguments()
    files = molecule_files(molecule_folder(options.molecules), options.only)
    if not files:
        end([], [])
    if atom_count(files[0]) == math.inf:
        end([], [], files[:1])
    atoms = read_balls(MORSKIN, files[0])
    print(f"pieces of {files[0].name}, {len(atoms)} atoms")
    chosen = random.Random(options.seed)
    counts = collections.defaultdict(collections.Counter)
    with tempfile.TemporaryDirectory() as folder, Rows(options.results, COLUMNS, WIDTHS, 2) as rows:
        for number in range(options.pieces):
            balls = piece(atoms, chosen.choice(atoms), options.radius)
            path = Path(folder) / "piece.xyzr"
            path.write_text("".join(f"{x} {y} {z} {r}\n" for x, y, z, r in balls))
            for model in options.models.split(","):
                for size in options.sizes.split(","):
                    run = mesh(path, model, options.timeout, "-C", size, "--method", options.method)
                    verdict = verdict_of(run)
                    rows.add({"piece": number, "model": model, "C": size, "atoms": len(balls),
                              "triangles": run.report.get("triangles", ""),
                              "min_angle": run.report.get("min_angle_deg", math.nan),
                              "seconds": run.seconds, "verdict": verdict})
                    counts[model, size].update([verdict.split()[0].rstrip(":"), "runs"])
                    counts[model, size]["atoms"] += len(balls)
                    counts[model, size]["triangles"] += run.report.get("triangles", 0)
    print()
    for (model, size), count in sorted(counts.items()):
        print(f"{model:6} C = {size:5} {count['atoms']:8} atoms in {count['runs']} pieces, "
              f"{count['triangles']} triangles: {count['certified']} certified at once, "
              f"{count['fell']} after a fallback, {count['refused']} refused as singular, "
              f"{count['FAILED']} not")
    end([], rows.rows)


if __name__ == "__main__":
    main()
