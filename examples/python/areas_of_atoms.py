"""The area of each atom's part of the skin, from the atoms' shares at the vertices."""

from pathlib import Path

import morskin
import numpy as np

MOLECULES = Path(__file__).resolve().parent.parent / "molecules"

molecule = morskin.read(MOLECULES / "benzene.pdb")
mesh = molecule.mesh(model="sas", density=5)

# [excerpt: python-areas]
a, b, c = mesh.vertices[mesh.faces].transpose(1, 0, 2)
thirds = np.linalg.norm(np.cross(b - a, c - a), axis=1) / 6
of_vertex = np.bincount(mesh.faces.ravel(), np.repeat(thirds, 3))
ids, shares = mesh.atom_ids, mesh.atom_weights * of_vertex[:, None]
of_atom = np.bincount(ids[ids >= 0], shares[ids >= 0], len(molecule))
# [/excerpt]
for radius in sorted(set(molecule.radii)):
    areas = of_atom[molecule.radii == radius]
    print(f"{len(areas)} atoms of radius {radius:.2f} A: {areas.mean():.1f} A^2 each")
print(f"sum {of_atom.sum():.2f} A^2, the certificate's {mesh.certificate.area:.2f} A^2")
