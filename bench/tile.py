#!/usr/bin/env python3
"""Writes copies of a molecule side by side as one XYZR file: big inputs made from real structures.

    bench/tile.py build/morskin capsid.cif.gz -n 2x2x1 -o four.xyzr

The radii are van der Waals radii, so the file goes through `morskin mesh --model` as the molecule
itself would. Boxes of balls of those radii stand `--gap` Angstrom apart; below zero they overlap.
"""

import argparse
import shutil
import subprocess
import sys


def read_balls(morskin, molecule):
    """The atoms that morskin uses, with their van der Waals radii. Where it fails, which it tells
    itself, the script ends with its exit code."""
    done = subprocess.run([morskin, "balls", molecule, "-o", "-", "--model", "vdw", "-q"],
                          check=False, stdout=subprocess.PIPE, text=True)
    if done.returncode != 0:
        sys.exit(done.returncode)
    lines = (line.split() for line in done.stdout.splitlines() if not line.startswith("#"))
    return [tuple(map(float, fields[:4])) for fields in lines if fields]


def counts(text):
    """'2x3x1' as three numbers."""
    parts = [int(part) for part in text.split("x")]
    if len(parts) != 3 or min(parts) < 1:
        raise argparse.ArgumentTypeError(f"{text}: three numbers are wanted, as in 2x2x1")
    return parts


def pitch(balls, axis, gap):
    """How far one copy stands from the next, a whole number of thousandths, as in PDB files."""
    extent = max(b[axis] + b[3] for b in balls) - min(b[axis] - b[3] for b in balls)
    return round(extent + gap, 3)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("morskin", help="the command")
    parser.add_argument("molecule", help="any file that it reads")
    parser.add_argument("-n", type=counts, default=[2, 2, 1], help="copies along x, y and z")
    parser.add_argument("--gap", type=float, default=0.0, help="between copies, Angstrom")
    parser.add_argument("-o", required=True, help="the XYZR file")
    arguments = parser.parse_args()
    if not shutil.which(arguments.morskin):
        parser.error(f"{arguments.morskin} is no command")
    balls = read_balls(arguments.morskin, arguments.molecule)
    step = [pitch(balls, axis, arguments.gap) for axis in range(3)]
    nx, ny, nz = arguments.n
    with open(arguments.o, "w", encoding="ascii") as out:
        for i in range(nx):
            for j in range(ny):
                for k in range(nz):
                    shift = (i * step[0], j * step[1], k * step[2])
                    out.writelines(
                        f"{x + shift[0]:.3f} {y + shift[1]:.3f} {z + shift[2]:.3f} {r:.3f}\n"
                        for x, y, z, r in balls)
    print(f"{nx * ny * nz * len(balls)} atoms", file=sys.stderr)


if __name__ == "__main__":
    main()
