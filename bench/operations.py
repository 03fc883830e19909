#!/usr/bin/env python3
"""How often each operation of Algorithm 1 and of the refinement is done, and what it leaves.

One line for each molecule and set of options, model paper, also in papers/results/operations.tsv.
The counts depend on no machine and no clock. A run is good when it is certified.
"""

from molecule_runs import BUNDLED, Rows, argument_parser, end, markdown, mesh

# By name on the pages: those of the paper, then small ones.
LARGE = {"5TMN inhibitor": "5tmn_ligand.pdb", "9DNA strand": "9dna.pdb", "1GRM": "1grm_model1.pdb"}
PRINTED = {"5TMN inhibitor": 27.02, "9DNA strand": 24.12, "1GRM": 24.37}  # the paper's angles
SMALL = {"caffeine": "caffeine.xyz", "C60": "c60.xyz", "hollow shell": "shell_hollow.xyzr"}
FILES = LARGE | SMALL
ONE_FRONT = "--fronts 1"
BARE, ONE_FRONT_BARE, USUAL = "--angle-goal 0", "--fronts 1 --angle-goal 0", "--angle-goal 35"
FEW = ["5TMN inhibitor", "caffeine", "C60", "hollow shell", "1GRM"]
# By column, where the report has it.
COLUMNS = {"vertices": "vertices", "triangles": "triangles", "minima": "minima",
           "saddles": "saddles", "maxima": "maxima", "minima_left": "surviving.minima",
           "saddles_left": "surviving.saddles", "maxima_left": "surviving.maxima",
           "bowls": "operations.creation", "fans": "operations.creep",
           "wings": "operations.wing", "bridges": "operations.bridge",
           "seals": "operations.seal", "inside": "operations.guard_inside_protecting",
           "inside_vain": "operations.vain_inside_protecting",
           "outside": "operations.guard_outside_protecting",
           "outside_vain": "operations.vain_outside_protecting", "flips": "operations.flip",
           "contractions": "operations.contract", "insertions": "operations.insert",
           "below": "smoothing.below", "moved": "smoothing.moved", "min_angle": "min_angle_deg",
           "worst_L": "worst_L", "worst_U": "worst_U"}
HEAD = ["file", "options", *COLUMNS, "verdict"]
WIDTHS = [16, 26, *(8 for _ in COLUMNS), 10]


def runs():
    for name, file in FILES.items():
        options = [ONE_FRONT, BARE, ONE_FRONT_BARE, USUAL] if name in LARGE else [ONE_FRONT]
        yield from ((file, words) for words in options)


def value(report, path):
    for key in path.split("."):
        report = report[key]
    return report


class Row:
    """Of one molecule: whole numbers with their thousands, angles with two digits."""

    def __init__(self, rows, name, options):
        self.values = next(r for r in rows if (r["file"], r["options"]) == (FILES[name], options))

    def number(self, column):
        return int(self.values[column])

    def __getitem__(self, column):
        if column.endswith("angle"):
            return f"{float(self.values[column]):.2f}°"
        return f"{self.number(column):,}"

    def share(self, column):
        return f"{100 * self.number(column) / self.number('vertices'):.1f} %"

    def signs(self, left=""):
        return f"{self['minima' + left]} − {self['saddles' + left]} + {self['maxima' + left]}"


def table_of(rows, names, lines, options=ONE_FRONT):
    """A line for each pair of a text and a function of a molecule's row."""
    molecules = [Row(rows, name, options) for name in names]
    return markdown(["", *names], ([text, *map(cell, molecules)] for text, cell in lines))


def with_left(kind):
    return f"{kind}, of which survive", lambda r: f"{r[kind]}, {r[f'{kind}_left']}"


def algorithm_table(rows):
    """4.1: all of one front's operations."""
    return table_of(rows, LARGE, [
        ("minima − saddles + maxima", Row.signs),
        ("of which survive", lambda r: r.signs("_left")),
        *((name, lambda r, column=name: r[column])
          for name in ("bowls", "fans", "wings", "bridges", "seals")),
        ("touches in protecting spheres, bridges among them", lambda r: r["inside"]),
        ("of which futile", lambda r: r["inside_vain"]),
        ("touches outside", lambda r: r["outside"]),
        ("of which futile", lambda r: r["outside_vain"])])


def prediction_sentence(rows):
    """4.1: how many of the touches that matter lie in protecting spheres."""
    counts = []
    for name in LARGE:
        r = Row(rows, name, ONE_FRONT)
        inside, outside = (r.number(side) - r.number(f"{side}_vain")
                           for side in ("inside", "outside"))
        counts.append(f"{inside} of {inside + outside}")
    return f"nearly all that are not futile: {counts[0]}, {counts[1]} and {counts[2]}."


def touches_sentence(rows):
    """ARCHITECTURE.md: touches that Morse theory does not predict."""
    r = Row(rows, "1GRM", ONE_FRONT)
    return (f"{r['outside']} of {r.number('inside') + r.number('outside')} touches of the front on "
            "gramicidin lie outside every protecting sphere")


def bridge_table(rows):
    return table_of(rows, FEW, [
        with_left("saddles"), ("bridges", lambda r: r["bridges"]),
        *((f"touches {where}, of which futile",
           lambda r, c=column: f"{r[c]}, {r[f'{c}_vain']}")
          for where, column in (("in protecting spheres", "inside"), ("outside", "outside")))])


def creation_table(rows):
    return table_of(rows, FEW, [with_left("minima"), ("bowls, one front", lambda r: r["bowls"]),
                                with_left("maxima")])


def seal_table(rows):
    return table_of(rows, FEW, [with_left("maxima"), ("sealed, one front", lambda r: r["seals"])])


def creep_table(rows):
    return table_of(rows, ["5TMN inhibitor", "hollow shell", "1GRM"], [
        ("fans", lambda r: r["fans"]), ("wings", lambda r: r["wings"]),
        ("wings to a hundred fans", lambda r: f"{100 * r.number('wings') / r.number('fans'):.1f}"),
        ("triangles at the end, to a fan",
         lambda r: f"{r.number('triangles') / r.number('fans'):.1f}"),
        ("vertices inserted afterwards", lambda r: r.share("insertions"))])


def refinement_table(rows):
    """4.3: what is mended, and the angles before and after."""
    def of(options):
        return {name: Row(rows, name, options) for name in LARGE}
    bare, one_front, usual = of(BARE), of(ONE_FRONT_BARE), of(USUAL)
    lines = [("vertices", lambda n: usual[n]["vertices"]), ("flips", lambda n: usual[n]["flips"]),
             ("contractions", lambda n: usual[n]["contractions"]),
             ("insertions",
              lambda n: f"{usual[n]['insertions']} ({usual[n].share('insertions')})"),
             ("smallest angle before smoothing", lambda n: bare[n]["min_angle"]),
             ("with one front", lambda n: one_front[n]["min_angle"]),
             ("triangles below 35°, vertices moved for them",
              lambda n: f"{usual[n]['below']}, {usual[n]['moved']}"),
             ("smallest angle", lambda n: usual[n]["min_angle"]),
             ("smallest ratio to [L], largest to [U]",
              lambda n: f"{float(usual[n].values['worst_L']):.4f}, "
                        f"{float(usual[n].values['worst_U']):.6f}"),
             ("the paper's smallest angle (7TMN, A-DNA, Gramicidin A)",
              lambda n: f"{PRINTED[n]:.2f}°")]
    return markdown(["", *LARGE], ([text, *map(cell, LARGE)] for text, cell in lines))


def texts(rows):
    """(page, text) of what the pages have from here."""
    for page, table in (("4.1-algorithm", algorithm_table), ("4.1-bridge", bridge_table),
                        ("4.1-creation", creation_table), ("4.1-creep-and-wing", creep_table),
                        ("4.1-seal", seal_table), ("4.3-local-refinement", refinement_table)):
        yield f"papers/{page}.md", table(rows)
    yield "papers/4.1-algorithm.md", prediction_sentence(rows)
    yield "ARCHITECTURE.md", touches_sentence(rows)


def main():
    options = argument_parser(__doc__, timeout=300, results="papers/results/operations.tsv",
                              takes=[]).parse_args()
    with Rows(options.results, HEAD, WIDTHS, 2) as rows:
        for file, words in runs():
            if options.only not in file:
                continue
            run = mesh(BUNDLED / file, "paper", options.timeout, *words.split())
            row = dict.fromkeys(HEAD, "") | {"file": file, "options": words}
            if run.code == 0 and run.report["certified"]:
                row |= {column: value(run.report, path) for column, path in COLUMNS.items()}
                rows.add(row | {"verdict": "certified"})
            else:
                rows.add(row | {"verdict": f"FAILED: {run.complaint}"})
    end([r["verdict"] for r in rows.rows if r["verdict"] != "certified"], rows.rows)


if __name__ == "__main__":
    main()
