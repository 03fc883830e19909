#!/usr/bin/env python3
"""Gaussian surfaces beside skins: meshes ten molecules both ways, and checks the files.

One line for each run, also in papers/results/implicit.tsv. The skins are of model vdw, the Gaussian
surfaces of decay 0.5 per square Angstrom and level 1, both with C = 0.2. A run is good when `mesh`
certifies and `check`, from the file, does too.
"""

import tempfile
from pathlib import Path

from molecule_runs import BUNDLED, Rows, argument_parser, end, markdown, run_command

MOLECULES = ["cube8.xyzr", "ring12.xyzr", "benzene.pdb", "cyclohexane.pdb", "caffeine.xyz",
             "atp.pdb", "5tmn_ligand.pdb", "c60.xyz", "amprenavir.pdb", "heme.pdb"]
SURFACES = ["skin", "gaussian"]
COLUMNS = ["molecule", "surface", "triangles", "min_angle", "max_angle", "components", "genus",
           "critical", "cpu_seconds", "check_seconds", "verdict"]
WIDTHS = [18, 9, 9, 9, 9, 10, 5, 12, 11, 13, 20]
C = "0.2"


def words_of(path, surface):
    """How the surface is named to `mesh`, and to `check`."""
    if surface == "skin":
        return [path], ["--against", path]
    return ["--surface", f"gaussian:{path}"], []


def row_of(path, surface, timeout):
    name = path.name
    source, against = words_of(str(path), surface)
    with tempfile.TemporaryDirectory() as temporary:
        mesh = Path(temporary) / "mesh.ply"
        made = run_command(["mesh", *source, "-o", mesh, "-C", C, "--json", "--progress", "never",
                            "--threads", "1"], timeout)
        empty = dict.fromkeys(COLUMNS, "") | {"molecule": name, "surface": surface}
        if made.code != 0:
            return empty | {"verdict": f"FAILED: {made.complaint}"}
        checked = run_command(["check", mesh, *against, "--json", "--threads", "1"], timeout)
    report = made.report
    is_certified = checked.code == 0 and checked.report["certified"]
    return {"molecule": name, "surface": surface, "triangles": report["triangles"],
            "min_angle": report["min_angle_deg"], "max_angle": report["max_angle_deg"],
            "components": report["components"], "genus": report["genus"],
            "critical": f"{report['minima']}-{report['saddles']}+{report['maxima']}",
            "cpu_seconds": made.cpu_seconds, "check_seconds": checked.cpu_seconds,
            "verdict": "certified" if is_certified else f"FAILED: check: {checked.complaint}"}


def table(rows):
    """The rows of the page."""
    return markdown(
        ["molecule", "surface", "triangles", "angles", "components, genus", "critical points",
         "mesh, s", "check, s"],
        ([r["molecule"], r["surface"], f"{int(r['triangles']):,}",
          f"{float(r['min_angle']):.1f} to {float(r['max_angle']):.1f}",
          f"{r['components']}, {r['genus']}",
          r["critical"].replace("-", " − ", 1).replace("+", " + "),
          f"{float(r['cpu_seconds']):.2f}", f"{float(r['check_seconds']):.2f}"] for r in rows))


def sentence(rows):
    """How the Gaussian surfaces compare with the skins."""
    gaussians = [r for r in rows if r["surface"] == "gaussian"]
    skins = {r["molecule"]: r for r in rows if r["surface"] == "skin"}
    certified = sum(r["verdict"] == "certified" for r in gaussians)
    ratios = sorted(int(r["triangles"]) / int(skins[r["molecule"]]["triangles"])
                    for r in gaussians)
    seconds = [float(r["cpu_seconds"]) for r in gaussians]
    angles = min(float(r["min_angle"]) for r in gaussians)
    return (f"Of {len(gaussians)} Gaussian surfaces {certified} are certified, with angles from "
            f"{angles:.1f} degrees, in {min(seconds):.1f} to {max(seconds):.1f} seconds of "
            f"processor time. They have {ratios[0]:.1f} to {ratios[-1]:.1f} times the triangles "
            f"of the skins.")


def main():
    options = argument_parser(__doc__, timeout=600,
                              results="papers/results/implicit.tsv", takes=[]).parse_args()
    with Rows(Path(options.results), COLUMNS, WIDTHS, 2) as rows:
        for name in MOLECULES:
            if options.only not in name:
                continue
            for surface in SURFACES:
                rows.add(row_of(BUNDLED / name, surface, options.timeout))
    print(table([{k: str(v) for k, v in r.items()} for r in rows.rows
                 if r["verdict"] == "certified"]))
    end([r["verdict"] for r in rows.rows if r["verdict"] != "certified"], rows.rows)


if __name__ == "__main__":
    main()
