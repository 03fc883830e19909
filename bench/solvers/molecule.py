"""The solvation energy of 1L2Y, a protein of 20 residues, on its skins."""

from measure import BENCH, MESH_COLUMNS, SYSTEM_COLUMNS, made, model_of, solved
from molecule_runs import markdown

PQR = BENCH / "molecules" / "1l2y.pqr"
UNIFORM = (1, 1.5, 2)  # vertices per square Angstrom
MESHES = [
    "-C 0.4", "--density 1.5", "-C 0.4 --voids drop",
    *(f"--density {d} --voids drop" for d in UNIFORM), "--model ses-like -C 0.4 --voids drop",
    *(f"--model ses-like --density {d} --voids drop" for d in UNIFORM),
    *(f"--method marching-cubes --grid {h}" for h in (1.3, 1)),
    *(f"--model ses-like --method marching-cubes --grid {h}" for h in (1.3, 1))]
COLUMNS = [*MESH_COLUMNS, *SYSTEM_COLUMNS, "energy", "steps"]
WIDTHS = [60, 8, 9, 7, 6, 9, 14, 9, 16, 8, 6]


def atoms():
    """Places and charges of the PQR file."""
    import numpy as np

    numbers = np.loadtxt(PQR, usecols=(5, 6, 7, 8))
    return numbers[:, :3], numbers[:, 3]


def rows():
    for options in MESHES:
        row, *mesh = made(PQR, options)
        system, [(energy, steps)] = solved(*mesh, [atoms()])
        yield row | system | {"energy": energy, "steps": steps}


def uniform_meshes(rows, model):
    """The rows of ever finer meshes of one density, without voids."""
    return [r for r in rows if "--density" in r["options"] and "--voids drop" in r["options"]
            and model_of(r["options"]) == model]


def limit(rows, model):
    """The energy on ever finer meshes, on a line against 1 / vertices through the two finest: flat
    triangles are off by the square of their size."""
    coarse, fine = [(1 / int(r["vertices"]), float(r["energy"]))
                    for r in uniform_meshes(rows, model)[-2:]]
    slope = (coarse[1] - fine[1]) / (coarse[0] - fine[0])
    return fine[1] - slope * fine[0]


def table(rows):
    """The rows of the page. Energies are compared with the limit of their model without voids."""
    body = []
    for r in rows:
        off = float(r["energy"]) / limit(rows, model_of(r["options"])) - 1
        body.append([f"`{r['options']}`", f"{int(r['vertices']):,}", f"{float(r['edges']):,.0f}",
                     f"{float(r['min_angle']):.2f}°", f"{float(r['condition']):.1e}",
                     f"{float(r['scaled_condition']):.1e}", r["steps"],
                     f"{float(r['energy']):,.0f}", f"{off:+.1%}"])
    return markdown(["mesh", "vertices", "longest edge over shortest", "smallest angle",
                     "condition number", "blocks solved", "steps", "energy, kJ/mol", "off by"],
                    body)


def sentence(rows):
    """What the page says of voids."""
    by_options = {r["options"]: r for r in rows}
    parts = []
    for kept in ("-C 0.4", "--density 1.5"):
        with_voids, without = (by_options[kept + more] for more in ("", " --voids drop"))
        change = float(with_voids["energy"]) / float(without["energy"]) - 1
        parts.append(f"with `{kept}` the condition number is {float(with_voids['condition']):.1e} "
                     f"with the voids and {float(without['condition']):.1e} without, and the "
                     f"energy of the voids is {change:.1%}")
    return ". ".join(p[0].upper() + p[1:] for p in parts) + "."
