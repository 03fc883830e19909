#!/usr/bin/env python3
"""How large are Morse-Smale complexes of molecules, and how long does one take?

Traces and simplifies the complex of the default height, model paper (`morskin morse`), one line
each, also in papers/results/complexes.tsv: critical points, arcs and regions before and after the
simplification, overlaps of protecting spheres, radii shrunk, processor seconds of the whole
command.
"""

import json
import tempfile
from pathlib import Path

from molecule_runs import (Rows, argument_parser, end, markdown, molecule_folder, named_files,
                           run_command)

MOLECULES = {"5TMN's inhibitor": "5tmn_ligand.pdb", "cube of eight balls": "cube8.xyzr",
             "hollow shell": "shell_hollow.xyzr", "9DNA, one strand": "9dna.pdb",
             "1GRM": "1grm_model1.pdb", "1CRN": "1crn.pdb", "1UBQ": "1ubq.pdb", "1BRS": "1brs.pdb",
             "4HHB": "4hhb.pdb", "1KX5": "1kx5.pdb", "1BMF": "1bmf.pdb.gz", "1AON": "1aon.pdb.gz"}
COUNTS = ["minima", "saddles", "maxima", "arcs", "regions"]
COLUMNS = ["molecule", *COUNTS, *(f"{name}_left" for name in COUNTS), "overlaps", "shrunk",
           "cpu_seconds", "verdict"]
WIDTHS = [18, *(8 for _ in COUNTS * 2), 12, 8, 11, 8]


def row_of(name, path, timeout):
    with tempfile.TemporaryDirectory() as folder:
        output = Path(folder) / "complex.json"
        run = run_command(["morse", path, "--model", "paper", "-q", "-o", output],
                          timeout)
        row = dict.fromkeys(COLUMNS, "") | {"molecule": name, "cpu_seconds": run.cpu_seconds}
        if run.code != 0:
            return row | {"verdict": f"FAILED: {run.complaint}"}
        made = json.loads(output.read_text(encoding="utf-8"))
    row |= {count: made["before"][count] for count in COUNTS}
    row |= {f"{count}_left": made["after"][count] for count in COUNTS}
    return row | {"overlaps": made["overlaps_before"], "shrunk": made["shrunk_radii"],
                  "verdict": verdict_of(made)}


def verdict_of(made):
    """Each surface's Euler characteristic, and the arcs and regions of every saddle."""
    for counts in (made["before"], made["after"]):
        chi = counts["minima"] - counts["saddles"] + counts["maxima"]
        if chi != made["euler_characteristic"]:
            return f"FAILED: Euler characteristic {chi}"
        if (counts["arcs"], counts["regions"]) != (4 * counts["saddles"], 2 * counts["saddles"]):
            return f"FAILED: {counts['arcs']} arcs, {counts['regions']} regions"
    return "good"


def signs(row, left=""):
    return " − ".join(f"{int(row[name + left]):,}" for name in COUNTS[:2]) + \
        f" + {int(row['maxima' + left]):,}"


def table(rows):
    """3.2: complexes from small to large."""
    return markdown(
        ["molecule", "minima − saddles + maxima", "arcs", "regions", "left", "overlaps of spheres",
         "radii shrunk", "processor time, $s$"],
        ([r["molecule"], signs(r), f"{int(r['arcs']):,}", f"{int(r['regions']):,}",
          signs(r, "_left"), f"{int(r['overlaps']):,}", r["shrunk"],
          f"{float(r['cpu_seconds']):.2g}"] for r in rows))


def simplification_sentence(rows):
    """3.2, simplification: two molecules of the table."""
    of = {r["molecule"]: r for r in rows}
    return (f"gramicidin A goes from {signs(of['1GRM'])} critical points to "
            f"{signs(of['1GRM'], '_left')}. Crambin goes from {signs(of['1CRN'])} to "
            f"{signs(of['1CRN'], '_left')}.")


def main():
    options = argument_parser(__doc__, timeout=600, results="papers/results/complexes.tsv",
                              takes=["molecules"]).parse_args()
    chosen = {name: file for name, file in MOLECULES.items() if options.only in file}
    folder = molecule_folder(options.molecules)
    paths = named_files(folder, chosen.values())
    with Rows(options.results, COLUMNS, WIDTHS, 1) as rows:
        for name, path in zip(chosen, paths):
            rows.add(row_of(name, path, options.timeout))
    end([r["verdict"] for r in rows.rows if r["verdict"] != "good"], rows.rows)


if __name__ == "__main__":
    main()
