"""The smallest dihedral angle of the tetrahedra with which TetGen fills a skin of 1L2Y, and the
space between it and a ball about it."""

import subprocess
import tempfile
from pathlib import Path

from measure import MESH_COLUMNS, is_marching_cubes, made
from molecule import PQR
from molecule_runs import markdown

TETGEN = "tetgen -pqAQ"  # with points added where it wants them, the surface split where it must
BALL = "0 0 0 30\n"
MESHES = ["--density 2 --voids drop", "-C 0.4 --voids drop", "-C 0.4",
          "--model ses-like --density 2 --voids drop", "--method marching-cubes --grid 1",
          "--model ses-like --method marching-cubes --grid 1"]
COLUMNS = [*MESH_COLUMNS, "inside", "inside_angle", "outside",
           "outside_angle"]
WIDTHS = [52, 8, 9, 7, 6, 9, 14, 8, 12, 8, 13]


def off_text(*meshes):
    """One OFF file of several meshes, each vertices and triangles."""
    points, corners, count = [], [], 0
    for vertices, triangles in meshes:
        points += [" ".join(map(repr, map(float, v))) for v in vertices]
        corners += ["3 " + " ".join(str(i + count) for i in t) for t in triangles]
        count = len(points)
    return "\n".join(["OFF", f"{len(points)} {len(corners)} 0", *points, *corners, ""])


def filled(surfaces):
    """The corners of TetGen's tetrahedra, (n, 4, 3), and by tetrahedron the region's number."""
    import numpy as np

    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "m.off").write_text(surfaces, encoding="utf-8")
        subprocess.run([*TETGEN.split(), "m.off"], cwd=folder, check=True, capture_output=True)
        nodes = np.loadtxt(Path(folder, "m.1.node"), skiprows=1)
        elements = np.loadtxt(Path(folder, "m.1.ele"), skiprows=1, dtype=int)
    return nodes[elements[:, 1:5] - int(nodes[0, 0])][:, :, 1:4], elements[:, 5]


def dihedral_angles(corners):
    """(n, 6), degrees."""
    import numpy as np

    normals = []
    for k in range(4):
        a, b, c = (corners[:, (k + i) % 4] for i in (1, 2, 3))
        normal = np.cross(b - a, c - a)
        normal *= np.sign(np.einsum("ni,ni->n", normal, a - corners[:, k]))[:, None]
        normals.append(normal / np.linalg.norm(normal, axis=1)[:, None])
    cosines = [np.einsum("ni,ni->n", normals[i], normals[j]) for i in range(4) for j in range(i)]
    return 180 - np.degrees(np.arccos(np.clip(cosines, -1, 1))).T


def rows():
    import numpy as np

    with tempfile.TemporaryDirectory() as folder:
        ball = Path(folder) / "ball.xyzr"
        ball.write_text(BALL, encoding="utf-8")
        _, *outer = made(ball, "--density 0.05")
    for options in MESHES:
        row, *inner = made(PQR, options)
        corners, regions = filled(off_text(inner, outer))
        # The region about the farthest corner is the outside.
        farthest = np.linalg.norm(corners, axis=2).max(axis=1).argmax()
        angles = dihedral_angles(corners).min(axis=1)
        is_outside = regions == regions[farthest]
        yield row | {"inside": (~is_outside).sum(), "inside_angle": angles[~is_outside].min(),
                     "outside": is_outside.sum(), "outside_angle": angles[is_outside].min()}


def table(rows):
    """The rows of the page."""
    return markdown(
        ["mesh", "triangles", "smallest angle", "tetrahedra inside", "smallest dihedral angle",
         "outside", "smallest dihedral angle"],
        ([f"`{r['options']}`", f"{int(r['triangles']):,}", f"{float(r['min_angle']):.2f}°",
          f"{int(r['inside']):,}", f"{float(r['inside_angle']):.2f}°", f"{int(r['outside']):,}",
          f"{float(r['outside_angle']):.2f}°"] for r in rows))


def sentence(rows):
    """What the page says of the table."""
    def extent(is_cubes):
        angles = [float(r[c]) for r in rows if is_marching_cubes(r["options"]) == is_cubes
                  for c in ("inside_angle", "outside_angle")]
        return f"{min(angles):.2f} to {max(angles):.2f} degrees"
    return f"{extent(False)}, and {extent(True)} on marching cubes' meshes"
