#!/usr/bin/env python3
"""How much of the skin's area do flat and curved triangles lack? Meshes with --order 2 (model vdw)
against the area of curved triangles with C = 0.05.

One line for each run, also in papers/results/second-order.tsv: the shares of the area that the flat
and the curved mesh lack, and the least Jacobian over the flat triangles'. A run is good when it is
certified, which means that every Jacobian was proved positive, or refused since one was not.
"""

import tempfile
from pathlib import Path

from molecule_runs import (BUNDLED, Rows, argument_parser, end, markdown, mesh, molecule_folder,
                           named_files)

MOLECULES = ["benzene.pdb", "caffeine.xyz", "5tmn_ligand.pdb", "1crn.pdb"]
SIZES = [0.4, 0.35, 0.3, 0.25, 0.2, 0.15, 0.1, 0.08]
GOAL = 0.01  # of what flat triangles lack
REFERENCE = 0.05
COLUMNS = ["molecule", "C", "triangles", "flat_lacks", "curved_lacks", "least_jacobian", "verdict"]
WIDTHS = [18, 6, 10, 12, 12, 14, 12]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/second-order.tsv",
                             takes=["molecules"])
    parser.set_defaults(molecules=BUNDLED)
    return parser.parse_args()


def meshed(path, C, timeout):
    with tempfile.TemporaryDirectory() as folder:
        return mesh(path, "vdw", timeout, "-C", str(C), "--order", "2", "-o",
                    Path(folder) / "curved.vtu")


def failed(path, C, run):
    return dict.fromkeys(COLUMNS, "") | {"molecule": path.name, "C": C,
                                         "verdict": f"FAILED: {run.complaint}"}


def row_of(path, C, run, exact):
    """A run that is refused, exit code 4, has no triangle to tell of."""
    row = failed(path, C, run)
    if run.code == 4 and "Jacobian" in run.complaint:
        return row | {"verdict": "refused"}
    report = run.report
    if not report or not report["certified"]:
        return row
    curved = report["second_order"]
    return row | {"triangles": report["triangles"], "flat_lacks": 1 - report["area"] / exact,
                  "curved_lacks": 1 - curved["area"] / exact,
                  "least_jacobian": curved["least_jacobian"], "verdict": "certified"}


def table(rows):
    body = []
    for r in rows:
        values = ["refused", "", "", "not proved positive"]
        if r["verdict"].startswith("FAILED"):
            values = ["FAILED", "", "", ""]
        elif r["verdict"] != "refused":
            values = [f"{int(r['triangles']):,}", f"{100 * float(r['flat_lacks']):.3f} %",
                      f"{100 * float(r['curved_lacks']):.4f} %",
                      f"{float(r['least_jacobian']):.2f}"]
        body.append([r["molecule"], r["C"], *values])
    return markdown(["molecule", "$C$", "triangles", "flat lacks", "curved lacks",
                     "least Jacobian"], body)


def shares(rows, C):
    """What curved triangles lack over what flat ones lack, by molecule."""
    return [abs(float(r["curved_lacks"]) / float(r["flat_lacks"])) for r in rows
            if float(r["C"]) == C and r["verdict"] == "certified"]


def met_from(rows):
    """The largest C from which on the goal is met with every molecule."""
    missed = [C for C in SIZES if max(shares(rows, C)) > GOAL]
    return max(C for C in SIZES if C < min(missed))


def sentence(rows):
    """What the page says of some sizes, and of the goal."""
    coarse, middle, fine = (f"{min(shares(rows, C)):.4f} to {max(shares(rows, C)):.4f}"
                            for C in (0.35, 0.2, 0.08))
    return (f"With $C = 0.35$ curved triangles lack {coarse} of what flat ones lack, with 0.2 "
            f"{middle}, with 0.08 {fine}. From $C = {met_from(rows)}$ on it is a hundredth at most")


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    paths = named_files(folder, [name for name in MOLECULES if options.only in name])
    with Rows(Path(options.results), COLUMNS, WIDTHS, 1) as rows:
        for path in paths:
            finest = meshed(path, REFERENCE, options.timeout)
            if finest.code != 0:
                rows.add(failed(path, REFERENCE, finest))
                continue
            exact = finest.report["second_order"]["area"]
            for C in SIZES:
                rows.add(row_of(path, C, meshed(path, C, options.timeout), exact))
    as_text = [{k: str(v) for k, v in r.items()} for r in rows.rows]
    failures = [r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")]
    print(table(as_text))
    if not failures and all(shares(as_text, C) for C in SIZES):
        print(sentence(as_text))
    end(failures, rows.rows)


if __name__ == "__main__":
    main()
