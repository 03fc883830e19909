"""From a file to a certified mesh: what its arrays are, and how to check any mesh."""

import tempfile
from pathlib import Path

import morskin

MOLECULES = Path(__file__).resolve().parent.parent / "molecules"

# [excerpt: python-mesh]
molecule = morskin.read(MOLECULES / "caffeine.xyz")
mesh = molecule.mesh(model="sas", density=5)
print(len(molecule), "atoms,", len(mesh.faces), "triangles,", mesh.certificate)
print(f"area {mesh.certificate.area:.2f} A^2, volume {mesh.certificate.volume:.2f} A^3")
# [/excerpt]

# [excerpt: python-arrays]
is_saddle = mesh.curvatures.prod(axis=1) < 0
print(f"{is_saddle.mean():.0%} of the vertices where the skin is saddle-shaped")
print("vertex 0 belongs to atom", mesh.atoms[0], "and is made by", mesh.atom_ids[0])
# [/excerpt]

# [excerpt: python-check]
with tempfile.TemporaryDirectory() as folder:
    file = mesh.save(Path(folder) / "caffeine.ply")
    vertices, faces = morskin.read_mesh(file)
skin = molecule.skin("sas")
print(morskin.check(vertices, faces, skin, **mesh.sizing))
print(morskin.check(vertices, faces[1:], skin, **mesh.sizing))
# [/excerpt]

# [excerpt: python-not-certified]
try:
    skin.mesh(C=0.9, Q=1.9, angle_goal_deg=0)
except morskin.NotCertified as error:
    print(error, "in", error.mesh)
# [/excerpt]
