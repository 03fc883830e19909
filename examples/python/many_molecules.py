"""Molecules in parallel: each process of a pool meshes with one thread."""

from multiprocessing import Pool
from pathlib import Path

import morskin

MOLECULES = Path(__file__).resolve().parent.parent / "molecules"


# [excerpt: python-pool]
def volume(file):
    """Angstrom^3."""
    return morskin.read(file).mesh(C=0.3, threads=1).certificate.volume


def main():
    files = [MOLECULES / name for name in ("benzene.pdb", "caffeine.xyz", "5tmn_ligand.pdb")]
    with Pool(2) as pool:
        for file, found in zip(files, pool.map(volume, files)):
            print(f"{file.name}: {found:.1f} A^3")
# [/excerpt]


if __name__ == "__main__":
    main()
