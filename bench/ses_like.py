#!/usr/bin/env python3
"""Which skin comes nearest to the solvent-excluded surface? Meshes the skins of 20 protein chains,
without voids, with patches larger than the atoms by 0 to 0.5 Angstrom (model sas with that probe),
and compares each with the solvent-excluded surface of the same atoms and a probe of 1.4 Angstrom.

One line for each skin, also in papers/results/ses-like.tsv: the distances from each surface to the
other, mean and 95 %, Angstrom; area, volume and solvation energy over those of the
solvent-excluded surface. The energy is a generalised Born one of the formal charges, with Born
radii from the surface by the r^-6 integral. Needs python3-numpy and python3-scipy.
"""

import gzip
import statistics
import tempfile
from pathlib import Path

from molecule_runs import (MORSKIN, Rows, argument_parser, end, markdown, mesh, molecule_folder,
                           named_files, run_program)

CHAINS = ["1crn A", "1ejg A", "5pti A", "1ubq A", "1hpv A", "1aki A", "1brs A", "1brs B", "1kx5 A",
          "1kx5 B", "1kx5 C", "1dps A", "1r03 A", "1ake A", "1k4c C", "4hhb A", "4hhb B", "2por A",
          "2buk A", "1j4n A"]
OFFSETS = [0.0, 0.1, 0.2, 0.25, 0.3, 0.4, 0.5]
COLUMNS = ["chain", "atoms", "offset", "to_ses_mean", "to_ses_95", "from_ses_mean", "from_ses_95",
           "area", "volume", "energy", "genus", "verdict"]
WIDTHS = [8, 6, 6, 11, 9, 13, 11, 8, 8, 8, 6, 10]
CHARGES = {("LYS", "NZ"): 1, ("ARG", "NH1"): 0.5, ("ARG", "NH2"): 0.5, ("ASP", "OD1"): -0.5,
           ("ASP", "OD2"): -0.5, ("GLU", "OE1"): -0.5, ("GLU", "OE2"): -0.5}


def chain_lines(path, chain):
    """The atoms of a chain of a PDB file, as its lines; no water, no other groups."""
    data = path.read_bytes()
    text = (gzip.decompress(data) if path.suffix == ".gz" else data).decode()
    lines = []
    for line in text.split("ENDMDL")[0].splitlines():
        if line.startswith("TER") and lines:
            break
        if line.startswith("ATOM") and line[21] == chain and line[16] in " A":
            lines.append(line)
    return lines


def charges_of(lines):
    """By atom, of those that have one: the formal charge, the ends of the chain included."""
    charges = {}
    for i, line in enumerate(lines):
        charge = CHARGES.get((line[17:20], line[12:16].strip()), 0)
        charge += (i == 0) - (line[12:16].strip() == "OXT")
        if charge:
            charges[i] = charge
    return charges


def run_chain(rows, file, chain, timeout):
    from ses_comparison import Comparison  # here, for --help without numpy

    lines = chain_lines(file, chain.split()[1])
    with tempfile.TemporaryDirectory() as place:
        path = Path(place) / "chain.pdb"
        path.write_text("\n".join(lines) + "\nEND\n", encoding="utf-8")
        xyzr = Path(place) / "chain.xyzr"
        run_program([MORSKIN, "balls", path, "-o", xyzr, "-q"]).check_returncode()
        comparison = Comparison(xyzr, charges_of(lines))
        for offset in OFFSETS:
            out = Path(place) / "skin.ply"
            run = mesh(path, "sas", timeout, "--probe", str(offset), "-C", "0.1", "--voids",
                       "drop", keep=out)
            row = {"chain": chain, "atoms": len(lines), "offset": offset,
                   "verdict": "certified" if run.code == 0 else f"FAILED: {run.complaint}"}
            if run.code == 0:
                row |= comparison.figures(run.report, out)
            rows.add(dict.fromkeys(COLUMNS, "") | row)


def table(rows):
    """The rows of the page: by offset, medians over the chains."""
    body = []
    for offset in OFFSETS:
        these = [r for r in rows if float(r["offset"]) == offset and r["verdict"] == "certified"]
        if not these:
            continue
        far = sum(float(r["to_ses_95"]) > 1 or float(r["from_ses_95"]) > 1 for r in these)

        def of(column):
            return statistics.median(float(r[column]) for r in these)
        body.append([f"{offset} Å", f"{of('to_ses_mean'):.3f}, {of('to_ses_95'):.2f} Å",
                     f"{of('from_ses_mean'):.3f}, {of('from_ses_95'):.2f} Å",
                     f"{far} of {len(these)}", f"{of('area'):.2f}", f"{of('volume'):.3f}",
                     f"{of('energy'):.3f}", f"{of('genus'):.0f}"])
    return markdown(["patches larger by", "skin to SES, mean, 95 %", "SES to skin, mean, 95 %",
                     "95 % above 1 Å", "area", "volume", "energy", "genus"], body)


def main():
    options = argument_parser(__doc__, timeout=600,
                              results="papers/results/ses-like.tsv",
                              takes=["molecules"]).parse_args()
    folder = molecule_folder(options.molecules)
    chains = [chain for chain in CHAINS if options.only in chain]
    files = named_files(folder, [f"{chain.split()[0]}*.pdb*" for chain in chains])
    if not chains:
        end([], chains)
    from ses_comparison import check_on_two_balls  # here, for --help without numpy
    check_on_two_balls()
    with Rows(Path(options.results), COLUMNS, WIDTHS, 3) as rows:
        for file, chain in zip(files, chains):
            run_chain(rows, file, chain, options.timeout)
    print(table([{k: str(v) for k, v in r.items()} for r in rows.rows]))
    end([r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")], rows.rows)


if __name__ == "__main__":
    main()
