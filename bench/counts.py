#!/usr/bin/env python3
"""Triangles of the paper's three molecules, in every reading of the weight (2.1), and of
gramicidin from fine to coarse (4.3).

One line for each run, also in papers/results/counts.tsv. The counts depend on no machine and no
clock. A run is good when it is certified.
"""

from math import asin, degrees

from molecule_runs import BUNDLED, Rows, argument_parser, end, markdown, mesh

# By molecule here: the file and the paper's triangles.
MOLECULES = {"5TMN inhibitor": ("5tmn_ligand.pdb", 24336),
             "one strand of 9DNA": ("9dna.pdb", 114316),
             "1GRM, model 1": ("1grm_model1.pdb", 305186)}
MODELS = {"paper": (r"$\sqrt{2}\,(r + p)$, in Å²", "1.44 to 1.50 Å"), "vdw": ("$2 r^2$", "$r$"),
          "sas": (r"$2\,(r + p)^2$", "$r + p$")}
COARSE = [0.08, 0.12, 0.16, 0.2, 0.25, 0.3, 0.35, 0.4]
GRAMICIDIN = "1grm_model1.pdb"
COLUMNS = ["file", "model", "C", "Q", "method", "triangles", "min_angle", "verdict"]
WIDTHS = [16, 5, 5, 6, 7, 9, 9, 10]


def runs():
    yield from ((file, model, 0.08) for file, _ in MOLECULES.values() for model in MODELS)
    yield from ((GRAMICIDIN, "paper", c) for c in COARSE[1:])


def count(rows, file, model, c=0.08):
    return next(r for r in rows if (r["file"], r["model"], float(r["C"])) == (file, model, c))


def percent_off(rows, model):
    """By how much more triangles there are than the paper has, of each molecule."""
    return [100 * (int(count(rows, file, model)["triangles"]) / printed - 1)
            for file, printed in MOLECULES.values()]


def weights_table(rows):
    """2.1: triangles in each reading of the weight."""
    names = {"5TMN inhibitor": "(paper's 7TMN: {:,})", "one strand of 9DNA": "(A-DNA: {:,})",
             "1GRM, model 1": "({:,})"}
    head = ["model", "$w$", "patch radius",
            *(f"{name} {names[name].format(MOLECULES[name][1])}" for name in MOLECULES)]
    return markdown(head, (
        [model, weight, radius, *(f"{int(count(rows, file, model)['triangles']):,}"
                                  for file, _ in MOLECULES.values())]
        for model, (weight, radius) in MODELS.items()))


def weights_sentence(rows):
    """2.1: how near each reading comes."""
    off = {model: percent_off(rows, model) for model in MODELS}
    factors = [1 / (1 + p / 100) for p in off["sas"]]
    paper, vdw = ([f"{p:+.0f} %".replace("-", "−") for p in off[m]] for m in ("paper", "vdw"))
    return (f"The literal reading is off the printed counts by {', '.join(paper)}. The one with "
            f"van der Waals radii is off by {', '.join(vdw)}. The squared one misses them by "
            f"factors of {min(factors):.1f} to {max(factors):.1f}.")


def coarse_table(rows):
    """4.3: gramicidin, model paper, with growing C."""
    body = []
    most = int(count(rows, GRAMICIDIN, "paper")["triangles"])
    for c in COARSE:
        r = count(rows, GRAMICIDIN, "paper", c)
        q, triangles = float(r["Q"]), int(r["triangles"])
        body.append([f"{c:g}", f"{q:.3g}", r["method"], rf"${c * q:.3f}\, \rho$",
                     f"{degrees(asin(1 / q ** 2)):.1f}°", f"{float(r['min_angle']):.1f}°",
                     f"{triangles:,}", f"{most / triangles:.1f}"])
    return markdown(["$C$", "$Q$", "method", "$R$ below", "angles above", "angles measured",
                     "triangles of 1GRM, model paper", "one in"], body)


def coarse_sentence(rows):
    """README: what a larger C saves."""
    most = int(count(rows, GRAMICIDIN, "paper")["triangles"])
    some, few = (most / int(count(rows, GRAMICIDIN, "paper", c)["triangles"]) for c in (0.2, 0.35))
    return (f"C = 0.2 takes one in {some:.1f} of the triangles of C = 0.08, C = 0.35 one in "
            f"{few:.0f}")


def main():
    options = argument_parser(__doc__, timeout=300, results="papers/results/counts.tsv", takes=[])
    options = options.parse_args()
    with Rows(options.results, COLUMNS, WIDTHS, 1) as rows:
        for file, model, c in runs():
            if options.only not in file:
                continue
            run = mesh(BUNDLED / file, model, options.timeout, "-C", str(c))
            report = run.report or dict.fromkeys(("Q", "method", "triangles", "min_angle_deg"), "")
            good = run.code == 0 and report["certified"]
            rows.add({"file": file, "model": model, "C": c, "Q": report["Q"],
                      "method": report["method"], "triangles": report["triangles"],
                      "min_angle": report["min_angle_deg"],
                      "verdict": "certified" if good else f"FAILED: {run.complaint}"})
    end([r["verdict"] for r in rows.rows if r["verdict"] != "certified"], rows.rows)


if __name__ == "__main__":
    main()
