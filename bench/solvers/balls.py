"""Charges in a ball of 2 Angstrom, whose energies have closed forms: Born's and Kirkwood's."""

import tempfile
from math import log
from pathlib import Path

from measure import MESH_COLUMNS, SYSTEM_COLUMNS, is_marching_cubes, made, solved
from molecule_runs import markdown

RADIUS = 2.0
BORN = [[0.0, 0.0, 0.0]], [1.0]
KIRKWOOD = [[0.8, 0.0, 0.0], [-0.3, 0.7, 0.2]], [1.0, -0.5]
MESHES = [*(f"--density {d}" for d in (2.5, 5, 10, 20)),
          *(f"--method marching-cubes --grid {h}" for h in (0.77, 0.55, 0.39, 0.27))]
COLUMNS = [*MESH_COLUMNS, *SYSTEM_COLUMNS, "born", "born_error", "born_steps", "kirkwood",
           "kirkwood_error", "kirkwood_steps"]
WIDTHS = [36, 8, 9, 7, 6, 9, 14, 9, 16, 8, 10, 10, 8, 14, 14]


def rows():
    import numpy as np

    from spheres import born, kirkwood

    exact = born(RADIUS), kirkwood(RADIUS, *map(np.array, KIRKWOOD))
    problems = [tuple(map(np.array, problem)) for problem in (BORN, KIRKWOOD)]
    with tempfile.TemporaryDirectory() as folder:
        ball = Path(folder) / "ball.xyzr"
        ball.write_text(f"0 0 0 {RADIUS}\n", encoding="utf-8")
        for options in MESHES:
            row, *mesh = made(ball, options)
            system, found = solved(*mesh, problems)
            row |= system
            for name, (energy, steps), closed in zip(("born", "kirkwood"), found, exact):
                row |= {name: energy, f"{name}_error": energy / closed - 1, f"{name}_steps": steps}
            yield row


def in_two_digits(text):
    """A condition number, whose further digits are the mesh's and say nothing of its kind."""
    return f"{float(f'{float(text):.2g}'):,.0f}"


def table(rows):
    """The rows of the page."""
    return markdown(
        ["mesh", "triangles", "Born, off by", "Kirkwood, off by", "condition number",
         "blocks solved", "steps"],
        ([f"`{r['options']}`", f"{int(r['triangles']):,}", f"{float(r['born_error']):+.2%}",
          f"{float(r['kirkwood_error']):+.2%}", in_two_digits(r["condition"]),
          in_two_digits(r["scaled_condition"]), r["kirkwood_steps"]] for r in rows))


def own_and_cubes(rows):
    return ([r for r in rows if not is_marching_cubes(r["options"])],
            [r for r in rows if is_marching_cubes(r["options"])])


def order(rows, column):
    """Of convergence, by the distance between vertices, from the coarsest mesh to the finest."""
    own, _ = own_and_cubes(rows)
    first, last = own[0], own[-1]
    return 2 * (log(float(first[column]) / float(last[column])) /
                log(float(last["vertices"]) / float(first["vertices"])))


def sentence(rows):
    """What the page says of the table."""
    own, cubes = own_and_cubes(rows)
    ratios = [float(c["condition"]) / float(o["condition"]) for o, c in zip(own, cubes)]
    return (f"From the coarsest mesh to the finest the errors fall with the power "
            f"{order(rows, 'born_error'):.2f} and {order(rows, 'kirkwood_error'):.2f} of the "
            f"edges' length. With about as many triangles marching cubes have {min(ratios):.1f} to "
            f"{max(ratios):.0f} times the condition number.")
