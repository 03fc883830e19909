"""The arrays that learning on surfaces takes, without a file."""

from pathlib import Path

import morskin
import numpy as np

MOLECULES = Path(__file__).resolve().parent.parent / "molecules"

# [excerpt: python-features]
arrays = morskin.features(MOLECULES / "1crn.pdb", density=2)
residues = arrays["atom_residue"][arrays["atom"]]  # of the nearest atom, by vertex
share = np.isin(residues, ["ILE", "LEU", "VAL"]).mean()
# [/excerpt]

print(f"{len(arrays['vertices'])} vertices, {len(arrays['faces'])} faces")
print(f"{share:.0%} of the vertices lie at ILE, LEU and VAL")
index = arrays["shape_index"]
print(f"shape index from {index.min():.2f} to {index.max():.2f}")
