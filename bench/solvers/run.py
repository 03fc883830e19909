#!/usr/bin/env python3
"""What solvers make of morskin's meshes: a boundary element solver of the Poisson-Boltzmann
equation on balls and on 1L2Y, and TetGen's tetrahedra inside and outside of 1L2Y.

One line for each mesh, also in papers/results/solvers-balls.tsv, solvers-molecule.tsv and
solvers-tetrahedra.tsv. The tables of papers/solvers.md are printed at the end. Needs
python3-numpy, python3-scipy and tetgen, and some ten minutes on two cores.
"""

import argparse
import sys
from pathlib import Path

import balls
import molecule
import tetrahedra
from measure import BENCH, is_marching_cubes
from molecule_runs import Rows, end, read_rows

PARTS = {"balls": balls, "molecule": molecule, "tetrahedra": tetrahedra}


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("parts", nargs="*", default=list(PARTS), metavar="PART",
                        help="of " + ", ".join(PARTS) + " (all)")
    parser.add_argument("--results", type=Path, default=BENCH.parent / "papers" / "results",
                        help="folder to write to (default: papers/results)")
    options = parser.parse_args()
    if not set(options.parts) <= set(PARTS):
        parser.error("a part is one of " + ", ".join(PARTS))
    every = []
    for name in options.parts:
        part, path = PARTS[name], options.results / f"solvers-{name}.tsv"
        with Rows(path, part.COLUMNS, part.WIDTHS, 1) as rows:
            for row in part.rows():
                rows.add(row)
        every += rows.rows
        print(part.table(read_rows(path)))
    failures = [r["options"] for r in every
                if r["verdict"] != "certified" and not is_marching_cubes(r["options"])]
    end(failures, every)


if __name__ == "__main__":
    sys.exit(main())
