#!/usr/bin/env python3
"""Makes bench/molecules/1l2y.pqr again: the first model of 1L2Y with PARSE's charges and radii.

Takes 1l2y.cif of the Protein Data Bank, and Debian's pdb2pqr and python3-gemmi, whose Python is
/usr/bin/python3. pdb2pqr itself does not read this file, which has no unit cell.
"""

import argparse
import subprocess
import tempfile
from pathlib import Path

PQR = Path(__file__).resolve().parent.parent / "molecules" / "1l2y.pqr"


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("cif", type=Path)
    parser.add_argument("-o", "--output", type=Path, default=PQR)
    options = parser.parse_args()
    import gemmi  # here, for --help without it

    structure = gemmi.read_structure(str(options.cif))
    del structure[1:]
    with tempfile.TemporaryDirectory() as folder:
        pdb = Path(folder) / "1l2y.pdb"
        structure.write_pdb(str(pdb))
        subprocess.run(["pdb2pqr", "--ff=PARSE", "--drop-water", "--log-level=ERROR", pdb,
                        Path(folder) / "1l2y.pqr"], check=True)
        atoms = [line for line in (Path(folder) / "1l2y.pqr").read_text().splitlines()
                 if line.startswith("ATOM")]
    options.output.write_text("\n".join(atoms) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
