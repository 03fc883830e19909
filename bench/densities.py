#!/usr/bin/env python3
"""Do meshes have the density that is asked for? Meshes 20 proteins and nucleic acids (model vdw)
with 1, 2, 5, 10 and 20 vertices per square Angstrom.

One line for each run, also in papers/results/densities.tsv: vertices per square Angstrom asked for
and made; the lengths that a twentieth of the edges is below and above, over the median; the share
of the area that bends too much for edges so long, and the triangles there over those that
R <= 0.68 length scales forces. A run is good when it is certified and makes the density within a
tenth, or says that C allows nothing so coarse.
"""

import statistics
from pathlib import Path

from molecule_runs import (Rows, argument_parser, end, markdown, mesh, molecule_folder,
                           named_files)

MOLECULES = ["1crn.pdb", "1ejg.pdb", "5pti.pdb", "1ubq.pdb", "1l2y.cif", "1aki.pdb", "1stp.cif",
             "1hpv.pdb", "2buk.pdb", "1brs.pdb", "1j4n.pdb", "2por.pdb", "1atp.pdb",
             "1k4c_tetramer.pdb", "1ake.pdb", "4hhb.pdb", "1a63.pqr", "1bna.pdb", "1ehz.pdb",
             "2koc.pdb"]
DENSITIES = [1, 2, 5, 10, 20]
COLUMNS = ["molecule", "asked", "made", "short_end", "long_end", "bent_share", "over_forced",
           "triangles", "min_angle", "method", "cpu_seconds", "verdict"]
WIDTHS = [18, 5, 6, 9, 9, 10, 11, 9, 9, 7, 11, 20]


def arguments():
    parser = argument_parser(__doc__, timeout=600, results="papers/results/densities.tsv",
                             takes=["molecules"])
    return parser.parse_args()


def verdict_of(run, report, asked):
    if run.code != 0 or not report["certified"]:
        return f"FAILED: exit code {run.code}: {run.complaint}"
    if "missed_size" not in report:
        return "made"
    # The report says the same of a mesh that is too coarse, which C does not force.
    is_finer = report["quality"]["vertices_per_square_angstrom"] > asked
    return "coarser is not possible" if is_finer else "FAILED: " + report["missed_size"]


def row_of(path, asked, run):
    report = run.report
    if not report:
        return dict.fromkeys(COLUMNS, "") | {"molecule": path.name, "asked": asked,
                                             "verdict": f"FAILED: {run.complaint}"}
    edges = report["quality"]["edge_length_quantiles"]
    bent = report["bent"]
    return {"molecule": path.name, "asked": asked,
            "made": report["quality"]["vertices_per_square_angstrom"],
            "short_end": edges["5"] / edges["50"], "long_end": edges["95"] / edges["50"],
            "bent_share": bent["area_share"],
            "over_forced": bent["triangles"] / max(bent["forced_triangles"], 1),
            "triangles": report["triangles"], "min_angle": report["min_angle_deg"],
            "method": report["method"], "cpu_seconds": run.cpu_seconds,
            "verdict": verdict_of(run, report, asked)}


def table(rows):
    """The rows of the page: by density, medians over the molecules that have it."""
    body = []
    for density in DENSITIES:
        of_it = [r for r in rows if float(r["asked"]) == density]
        made = [r for r in of_it if r["verdict"] == "made"]
        cells = [f"{density}", f"{len(made)} of {len(of_it)}",
                 f"{sum(not r['verdict'].startswith('FAILED') for r in of_it)}"]
        if made:
            def of(column):
                return [float(r[column]) for r in made]
            cells += [f"{min(of('made')):.2f} to {max(of('made')):.2f}",
                      f"{statistics.median(of('short_end')):.2f} medians",
                      f"{statistics.median(of('long_end')):.2f} medians",
                      f"{min(of('cpu_seconds')):.1f} to {max(of('cpu_seconds')):.1f}"]
        else:
            cells += ["", "", "", ""]
        body.append(cells)
    return markdown(["asked, per Å²", "have it", "certified", "made", "5 % of edges below",
                     "95 % below", "seconds"], body)


MOST_OVER_FORCED = 1.3


def bent(rows):
    """Over the forced triangles, of the runs with a thousandth of the area bent or more."""
    return [float(r["over_forced"]) for r in rows
            if r["bent_share"] and float(r["bent_share"]) >= 0.001]


def sentence(rows):
    """What the page says of the bent parts."""
    over = bent(rows)
    return (f"{len(over)}, there are {min(over):.2f} to {max(over):.2f} times the triangles that "
            f"are forced, {statistics.median(over):.2f} in the median")


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    paths = named_files(folder, [name for name in MOLECULES if options.only in name])
    with Rows(Path(options.results), COLUMNS, WIDTHS, 1) as rows:
        for path in paths:
            for asked in DENSITIES:
                run = mesh(path, "vdw", options.timeout, "--density", str(asked), "--threads", "1")
                rows.add(row_of(path, asked, run))
    as_text = [{k: str(v) for k, v in r.items()} for r in rows.rows]
    print(table(as_text))
    if bent(as_text):
        print(sentence(as_text))
    end([r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")], rows.rows)


if __name__ == "__main__":
    main()
