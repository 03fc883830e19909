#!/usr/bin/env python3
"""How far are curved triangles from the skin, by the number of its patches that they lie over, and
for two choices of the nodes in edges? Runs build/bench/morskin_curved_errors (model vdw).

One line for each surface, C, choice and number of patches, also in
papers/results/curved-errors.tsv: triangles, the area of the skin under them and what they lack of
it, flat and curved, Angstrom^2; the mean distance from the skin, Angstrom, and the root mean square
of the angle to its normal, degrees.
"""

import subprocess
import sys
from pathlib import Path

from molecule_runs import (BUNDLED, ROOT, Rows, argument_parser, end, markdown, molecule_folder,
                           named_files, run_program)

PROGRAM = ROOT / "build" / "bench" / "morskin_curved_errors"
SURFACES = ["ball", "caffeine.xyz", "5tmn_ligand.pdb"]
SIZES = [0.35, 0.2, 0.08]
CHOICES = ["middle", "parabola"]
KINDS = {"1": "one", "2": "two", "more": "more", "all": "all"}
COLUMNS = ["surface", "C", "nodes", "patches", "triangles", "area", "flat_lacks", "curved_lacks",
           "distance", "angle_deg"]
WIDTHS = [16, 5, 9, 7, 10, 10, 10, 12, 10, 9]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/curved-errors.tsv",
                             takes=["molecules"])
    parser.set_defaults(molecules=BUNDLED)
    return parser.parse_args()


def measured(surface, C, timeout):
    """The lines that the program prints; ends the script where it prints none, saying why."""
    try:
        done = run_program([PROGRAM, surface, str(C)], capture_output=True, text=True,
                           timeout=timeout)
    except subprocess.TimeoutExpired:
        sys.exit(f"{surface} with C = {C}: still running after {timeout:g} s")
    if done.returncode != 0:
        sys.exit(f"{surface} with C = {C}: exit code {done.returncode}: {done.stderr.strip()}")
    return done.stdout.splitlines()


def table(rows):
    """A line for each kind of triangle, both choices side by side."""
    known = {tuple(r[c] for c in COLUMNS[:4]): r for r in rows}

    def both(surface, C, kind, tell):
        return [tell(known[surface, C, nodes, kind]) for nodes in CHOICES]

    def of_flat(r):
        return f"{float(r['curved_lacks']) / float(r['flat_lacks']):.4f}"

    body = []
    for surface, C, _, kind in [k for k in known if k[2] == CHOICES[0]]:
        r = known[surface, C, CHOICES[0], kind]
        lacks = 100 * float(r["flat_lacks"]) / float(r["area"])
        body.append([surface, C, KINDS[kind], f"{int(r['triangles']):,}", f"{lacks:.3f} %",
                     *both(surface, C, kind, of_flat),
                     *both(surface, C, kind, lambda r: f"{1e3 * float(r['distance']):.3g}"),
                     *both(surface, C, kind, lambda r: f"{float(r['angle_deg']):.2f}°")])
    return markdown(["surface", "$C$", "patches", "triangles", "flat lacks", "of that lack", "",
                     "$10^{-3}$ Å off", "", "normals off", ""], body)


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    surfaces = [s for s in SURFACES if options.only in s]
    paths = [s if s == "ball" else named_files(folder, [s])[0] for s in surfaces]
    with Rows(Path(options.results), COLUMNS, WIDTHS, 4) as rows:
        for surface, path in zip(surfaces, paths):
            for C in SIZES:
                for line in measured(path, C, options.timeout):
                    rows.add(dict(zip(COLUMNS, [surface, C, *line.split("\t")])))
    print(table([{k: str(v) for k, v in r.items()} for r in rows.rows]))
    end([], rows.rows)


if __name__ == "__main__":
    main()
