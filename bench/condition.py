#!/usr/bin/env python3
"""What a boundary element solver makes of coarse meshes: solves the linear Poisson-Boltzmann
equation (bench/poisson_boltzmann.py) on skins of 1L2Y, 304 atoms with hydrogen.

One line for each mesh, also in papers/results/condition.tsv: triangles, the longest edge over the
shortest, the smallest angle, the condition number of the equations (1-norm, estimated), steps of
GMRES to 1e-6 without restarts, and the solvation energy of the formal charges, kcal/mol. Needs
python3-numpy and python3-scipy.
"""

import sys
import tempfile
from pathlib import Path

from molecule_runs import Rows, argument_parser, end, mesh, molecule_files, molecule_folder
from ses_like import CHARGES

COARSE = ["-C", "0.4"]
DROP = [*COARSE, "--voids", "drop"]
CUBES = ["--method", "marching-cubes", "--grid", "1"]  # for comparison, uncertified as a rule
MESHES = [("vdw", COARSE), ("vdw", DROP), ("vdw", [*DROP, "--size", "0.7"]),
          ("vdw", [*DROP, "--grading", "0.3"]), ("ses-like", DROP), ("sas", DROP),
          ("vdw", CUBES), ("ses-like", CUBES), ("sas", CUBES)]
COLUMNS = ["model", "options", "triangles", "edges", "min_angle", "condition", "steps", "energy",
           "verdict"]
WIDTHS = [9, 34, 9, 8, 9, 10, 6, 8, 10]


def atoms_of(path):
    """Of the first model of an mmCIF file: residue's number and name, atom's name, x, y, z."""
    lines = path.read_text(encoding="utf-8").splitlines()
    names = [line.split(".")[1].strip() for line in lines if line.startswith("_atom_site.")]
    words = [dict(zip(names, line.split())) for line in lines if line.startswith("ATOM")]
    return [(int(w["label_seq_id"]), w["label_comp_id"], w["label_atom_id"],
             [float(w["Cartn_" + axis]) for axis in "xyz"])
            for w in words if w["pdbx_PDB_model_num"] == "1"]


def formal_charges(atoms):
    """Places and charges, the chain's ends included."""
    places, charges = [], []
    for number, residue, atom, place in atoms:
        charge = CHARGES.get((residue, atom), 0) + ((number, atom) == (atoms[0][0], "N"))
        charge -= atom == "OXT"
        if charge:
            places.append(place)
            charges.append(charge)
    return places, charges


def figures(path, places, charges):
    """By column, of the mesh in a file."""
    import numpy as np  # here, for --help without it

    from poisson_boltzmann import solved
    from ses_comparison import read_mesh
    positions, triangles = (np.array(x) for x in read_mesh(path))
    corners = positions[triangles]
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2)
    return {"edges": edges.max() / edges.min()} | solved(positions, triangles, np.array(places),
                                                         np.array(charges))


def verdict(run, words):
    if run.code == 0:
        return "certified"
    return "not certified" if words is CUBES and run.report else f"FAILED: {run.complaint}"


def table(rows):
    """The rows of the page."""
    lines = ["| model | options | triangles | longest edge over shortest | smallest angle | "
             "condition number | steps | energy |", "|---|---|---|---|---|---|---|---|"]
    for r in rows:
        lines.append(f"| {r['model']} | `{r['options']}` | {int(r['triangles']):,} | "
                     f"{float(r['edges']):.0f} | {float(r['min_angle']):.1f}° | "
                     f"{float(r['condition']):.1e} | {r['steps']} | {float(r['energy']):.1f} |")
    return "\n".join(lines)


def check_on_a_ball(timeout):
    """Raises ValueError where a charge in the middle of a ball has not Born's energy within 1 %."""
    from poisson_boltzmann import born_energy
    with tempfile.TemporaryDirectory() as place:
        ball, out = Path(place) / "ball.xyzr", Path(place) / "ball.ply"
        ball.write_text("0 0 0 2\n", encoding="utf-8")
        mesh(ball, "vdw", timeout, "-C", "0.1", keep=out)
        found = figures(out, [[0, 0, 0]], [1.0])["energy"]
    if not abs(found / born_energy(2.0) - 1) < 0.01:
        raise ValueError(f"the energy in a ball is {found}, not {born_energy(2.0)}")


def main():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/condition.tsv")
    parser.set_defaults(only="1l2y.cif")
    options = parser.parse_args()
    files = molecule_files(molecule_folder(options.molecules), options.only)
    if not files:
        sys.exit("1l2y.cif is not there")
    check_on_a_ball(options.timeout)
    places, charges = formal_charges(atoms_of(files[0]))
    with tempfile.TemporaryDirectory() as place, Rows(options.results, COLUMNS, WIDTHS, 2) as rows:
        for model, words in MESHES:
            out = Path(place) / "mesh.ply"
            run = mesh(files[0], model, options.timeout, *words, keep=out)
            row = {"model": model, "options": " ".join(words),
                   "triangles": run.report.get("triangles", ""),
                   "min_angle": run.report.get("min_angle_deg", ""),
                   "verdict": verdict(run, words)}
            rows.add(dict.fromkeys(COLUMNS, "") | row | figures(out, places, charges))
    print(table([{k: str(v) for k, v in r.items()} for r in rows.rows]))
    failed = [r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")]
    end(failed, rows.rows)


if __name__ == "__main__":
    main()
