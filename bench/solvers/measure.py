"""What the scripts of this folder share: a mesh of morskin's, and what the solver makes of it."""

import sys
import tempfile
from pathlib import Path

BENCH = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(BENCH), str(BENCH.parent / "certify" / "verify")]
from molecule_runs import mesh  # noqa: E402

# NumPy and SciPy are imported where they are used: the tables are made without them.

MESH_COLUMNS = ["options", "vertices", "triangles", "density", "edges", "min_angle", "verdict"]
SYSTEM_COLUMNS = ["condition", "scaled_condition"]


def is_marching_cubes(options):
    return "marching-cubes" in options


def model_of(options):
    return "ses-like" if "ses-like" in options else "vdw"


def made(path, options, timeout=600):
    """A row of MESH_COLUMNS, and the mesh: vertices (n, 3) and triangles (m, 3).

    @param path     the molecule
    @param options  the command's, in one string"""
    import numpy as np

    from files import read_mesh

    words, model = options.replace("--model ses-like", "").split(), model_of(options)
    with tempfile.TemporaryDirectory() as folder:
        kept = Path(folder) / "mesh.ply"
        run = mesh(path, model, timeout, *words, keep=kept)
        if not kept.exists():
            raise ValueError(f"{options}: {run.complaint}")
        vertices, triangles = map(np.array, read_mesh(kept))
    row = {"options": options, "vertices": len(vertices), "triangles": len(triangles),
           "density": run.report["quality"]["vertices_per_square_angstrom"],
           "edges": edge_ratio(vertices, triangles), "min_angle": run.report["min_angle_deg"],
           "verdict": "certified" if run.code == 0 else "not certified"}
    return row, vertices, triangles


def edge_ratio(vertices, triangles):
    """The longest edge over the shortest."""
    import numpy as np

    corners = vertices[triangles]
    lengths = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return lengths.max() / lengths.min()


def solved(vertices, triangles, problems):
    """What the solver finds on one mesh.

    @param problems  pairs of places (k, 3) and charges (k,)
    @return  a row of SYSTEM_COLUMNS, and for each problem the energy, kJ/mol, and GMRES's steps"""
    from scipy.linalg import lu_factor, lu_solve

    from conditioning import VertexBlocks, condition_numbers, gmres_steps
    from poisson_boltzmann import PoissonBoltzmann

    equations = PoissonBoltzmann(vertices, triangles)
    matrix = equations.matrix()
    factors, blocks = lu_factor(matrix), VertexBlocks(matrix)
    found = []
    for places, charges in problems:
        right = equations.right_side(places, charges)
        found.append((equations.energy(places, charges, lu_solve(factors, right)),
                      gmres_steps(matrix, right, blocks)))
    return dict(zip(SYSTEM_COLUMNS, condition_numbers(matrix, factors, blocks))), found
