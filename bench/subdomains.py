#!/usr/bin/env python3
"""How large should subdomains be? Sweeps four surfaces in 1 to 128 subdomains.

One line for each run, also in papers/results/subdomains.tsv: the subdomains, triangles to each, and
of the triangles laid the share that lies between subdomains. A run is good when it is certified
without the safety net.
"""

from pathlib import Path

from molecule_runs import Rows, argument_parser, end, markdown, mesh, molecule_folder, named_files

SURFACES = [("1grm_model1.pdb", "paper", []), ("1ubq.pdb", "sas", []),
            ("1ubq.pdb", "vdw", ["-C", "0.2"]), ("1kx5.pdb", "sas", [])]
COUNTS = [1, 2, 4, 8, 16, 32, 64, 128]
COLUMNS = ["molecule", "model", "options", "subdomains", "triangles", "triangles_to_each",
           "seam_share", "bowls", "touches", "verdict"]
WIDTHS = [18, 6, 8, 10, 10, 17, 10, 6, 8, 10]


def arguments():
    return argument_parser(__doc__, timeout=600,
                           results="papers/results/subdomains.tsv",
                           takes=["molecules"]).parse_args()


def row_of(path, model, options, count, run):
    report = run.report
    row = {"molecule": path.name, "model": model, "options": " ".join(options),
           "subdomains": count}
    if not report or not report["certified"] or report["fallbacks"]:
        return dict.fromkeys(COLUMNS, "") | row | {"verdict": f"FAILED: {run.complaint}"}
    laid = report["triangles_laid"]
    operations = report["operations"]
    return row | {"triangles": report["triangles"], "triangles_to_each": laid // count,
                  "seam_share": report["seam_triangles"] / laid,
                  "bowls": operations["creation"],
                  "touches": operations["guard_inside_protecting"]
                  + operations["guard_outside_protecting"], "verdict": "certified"}


def table(rows):
    """The rows of the page: by surface, the share of triangles between subdomains."""
    body = []
    for name, model, options in SURFACES:
        of_it = [r for r in rows if (r["molecule"], r["model"], r["options"])
                 == (name, model, " ".join(options))]
        if not of_it:
            continue
        label = " ".join([name.split(".")[0].split("_")[0].upper(), model, *options])
        for what, column, form in (("triangles to each", "triangles_to_each", "{:,.0f}"),
                                   ("of all, between them", "seam_share", "{:.1%}"),
                                   ("triangles in the end", "triangles", "{:,.0f}")):
            cells = (form.format(float(r[column])) if r[column] else "FAILED" for r in of_it)
            body.append([f"{label}: {what}", *cells])
    return markdown(["subdomains", *map(str, COUNTS)], body)


def main():
    options = arguments()
    folder = molecule_folder(options.molecules)
    surfaces = [s for s in SURFACES if options.only in s[0]]
    paths = named_files(folder, [name for name, _, _ in surfaces])
    with Rows(Path(options.results), COLUMNS, WIDTHS, 1) as rows:
        for path, (_, model, words) in zip(paths, surfaces):
            for count in COUNTS:
                run = mesh(path, model, options.timeout, "--fronts", str(count), *words)
                rows.add(row_of(path, model, words, count, run))
    print(table([{k: str(v) for k, v in r.items()} for r in rows.rows]))
    end([r["verdict"] for r in rows.rows if r["verdict"].startswith("FAILED")], rows.rows)


if __name__ == "__main__":
    main()
