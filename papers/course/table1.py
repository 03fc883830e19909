"""What pages say of the paper's Table 1 as it comes out here, and of what the same run measures
beside it: how time grows with size, and on how many skins each method has the topology right."""

import math
import statistics

import reproduce_tables as tables

METHODS = ["sweep", "one-front-unsmoothed", "static", "dynamic", "marching-cubes"]
HERE = {"5TMN": "5TMN for pdb7tmn", "9DNA": "9DNA for A-DNA", "1GRM": "1GRM for GramicidinA"}


def median(rows, molecule, method, column):
    return statistics.median(tables.numbers(
        tables.measured(rows, molecule=molecule, method=method), column))


def per_molecule(rows, above, below, column):
    """Medians over medians, of each molecule."""
    return [tables.ratio(rows, m, above, column, below) for m in tables.PAPER]


def span(values, form=".0f"):
    return f"{min(values):{form}} to {max(values):{form}}"


def each(values, form=".1f"):
    *first, last = [f"{v:{form}}" for v in values]
    return f"{', '.join(first)} and {last}"


def shape_rows(rows):
    """Counts, angles and ratios beside the paper's: the rows of the tables below, by name."""
    def one(column, method, form, unit=""):
        return [f"{median(rows, m, method, column):{form}}{unit}" for m in tables.PAPER]

    def angle(method):
        return one("min_angle_deg", method, ".2f", "°")

    def over(above, form):
        clock, cpu = (per_molecule(rows, above, "sweep", c) for c in ("seconds", "cpu_seconds"))
        return [f"{a:{form}} ({b:{form}})" for a, b in zip(clock, cpu)]

    def speed(method):
        def of(m):
            return median(rows, m, method, "triangles") / median(rows, m, method, "seconds")
        return [f"{float(f'{of(m):.3g}'):,.0f}" for m in tables.PAPER]

    def certified(m):
        return ", ".join(str(sum(r["certified"] for r in tables.measured(
            rows, molecule=m, method=method))) for method in METHODS[:4])

    paper = list(tables.PAPER.values())
    return {
        "triangles, the paper's": [f"{p[1]:,}" for p in paper],
        "triangles, sweep": one("triangles", "sweep", ",.0f"),
        "smallest angle, the paper's": [f"{p[2]}°" for p in paper],
        "smallest angle, one front, unsmoothed": angle("one-front-unsmoothed"),
        "smallest angle, sweep": angle("sweep"),
        "smallest angle, marching cubes": angle("marching-cubes"),
        "dynamic over sweep, the paper's": [f"{p[4] / p[3]:.0f}" for p in paper],
        "dynamic over sweep": over("dynamic", ".0f"),
        "static over sweep": over("static", ".1f"),
        "dynamic over static": [f"{a:.1f} ({b:.1f})" for a, b in zip(
            *(per_molecule(rows, "dynamic", "static", c) for c in ("seconds", "cpu_seconds")))],
        "marching cubes over sweep": over("marching-cubes", ".1f"),
        "sweep, triangles per second": speed("sweep"),
        "dynamic, triangles per second": speed("dynamic"),
        "certified: sweep, one front, static, dynamic, of five each":
            [certified(m) for m in tables.PAPER],
    }


def reproduced_table(rows, wanted=None):
    named = shape_rows(rows)
    return tables.markdown(["", *HERE.values()], [[name, *named[name]] for name in wanted or named])


LESSON_ROWS = ["triangles, the paper's", "triangles, sweep", "smallest angle, the paper's",
               "smallest angle, sweep", "dynamic over sweep, the paper's", "dynamic over sweep",
               "static over sweep", "dynamic over static"]


def scaling_table(rows):
    series = {"corpus": "molecules of the corpus", "finer": "5TMN's inhibitor, ever smaller $C$"}
    body = []
    for method, name in (("sweep", "corpus"), ("sweep", "finer"), ("static", "corpus"),
                         ("static", "finer"), ("dynamic", "finer")):
        clock, points = tables.fit(rows, "seconds", series=name, method=method)
        cpu, _ = tables.fit(rows, "cpu_seconds", series=name, method=method)
        body.append([f"{method}, {series[name]}", len(points),
                     f"{points[0][0]:,} to {points[-1][0]:,}",
                     f"{clock[0]:.3f} ± {clock[1]:.3f} ({cpu[0]:.3f} ± {cpu[1]:.3f})"])
    return tables.markdown(["", "meshes", "triangles", "exponent"], body)


def gain_sentences(rows):
    grown = per_molecule(rows, "dynamic", "sweep", "seconds")
    static = per_molecule(rows, "static", "sweep", "seconds")
    growing = per_molecule(rows, "dynamic", "static", "seconds")
    products = [f"{g:.1f} × {s:.1f}" for g, s in zip(growing, static)]
    shares = [100 * math.log(g) / math.log(d) for g, d in zip(growing, grown)]
    cpu = per_molecule(rows, "static", "sweep", "cpu_seconds")
    return [f"The sweep is {span(grown)} times as fast as growth, where the paper has 28 to 120.",
            f"takes {span(static, '.1f')} times the sweep's time, {span(cpu, '.1f')} times its "
            "processor time.",
            f"(static over sweep): {', '.join(products[:2])} and {products[2]}.",
            f"growing makes {each(shares, '.0f')} % of the gain"], grown, products, shares


def readme_table(rows):
    """Counts and smallest angles beside the paper's."""
    body = []
    for (molecule, (_, triangles, angle, *_)), (name, file) in zip(tables.PAPER.items(), (
            ("7TMN / 5TMN inhibitor", "5tmn_ligand.pdb"), ("A-DNA / 9DNA", "9dna.pdb"),
            ("gramicidin A, 1GRM", "1grm_model1.pdb"))):
        counted, angles = ([median(rows, molecule, m, column) for m in METHODS[:2]]
                           for column in ("triangles", "min_angle_deg"))
        body.append([name, f"`{file}`", f"{triangles:,}", *(f"{c:,.0f}" for c in counted), angle,
                     *(f"{a:.2f}" for a in angles)])
    return tables.markdown(
        ["molecule", "file", "paper", "morskin", "one front, unsmoothed", "smallest angle, paper",
         "morskin", "one front, unsmoothed"], body)


def count_sentence(rows):
    off = [100 * (median(rows, m, "sweep", "triangles") / p[1] - 1)
           for m, p in tables.PAPER.items()]
    return (f"come within {abs(off[0]):.0f} % for the inhibitor and {abs(off[2]):.0f} % for "
            f"gramicidin; 9DNA as deposited has {off[1]:.0f} % more than the paper's A-DNA")


def agreement_sentence(rows):
    right = {m: sum(all(r[k] == r["expected_" + k] for k in (
        "euler_characteristic", "components", "genus"))
        for r in tables.measured(rows, method=m)) for m in METHODS}
    certified = {m: sum(bool(r["certified"]) for r in rows if r["method"] == m) for m in METHODS}
    runs = sum(r["method"] == "sweep" for r in rows)
    assert all(certified[m] == right[m] == runs for m in ("sweep", "static", "dynamic")), certified
    return [f"are {runs} skins", f"certified on all {runs}",
            f"marching cubes have them right on {right['marching-cubes']} and are certified on "
            f"{certified['marching-cubes'] or 'none'}"]


def texts(rows, scaling, agreement):
    """(page, text) of what is said of the sweep and of all methods together."""
    yield from (("papers/results/table1.md", text) for text in (
        tables.molecules_text(rows, METHODS), tables.ratios_text(rows, METHODS),
        tables.scaling_text(scaling, METHODS), tables.agreement_text(agreement, METHODS),
        tables.asked_text({"table1": rows, "scaling": scaling})))
    sentences, grown, products, shares = gain_sentences(rows)
    page = "papers/5-results.md"
    yield from ((page, text) for text in (
        reproduced_table(rows), scaling_table(scaling), count_sentence(rows), *sentences,
        *agreement_sentence(agreement)))
    exponent, error, _ = tables.fit(scaling, "seconds", series="corpus", method="sweep")[0]
    yield page, f"{exponent:.3f} ± {error:.3f} over molecules, below"
    slower = [p[3] / median(rows, m, "sweep", "cpu_seconds") for m, p in tables.PAPER.items()]
    slower = [round(ratio, -1) for ratio in slower]  # of times twenty years apart
    yield page, f"processor time here is {span(slower)} times less than the paper's seconds"
    yield "papers/lessons/10-results.md", reproduced_table(rows, LESSON_ROWS)
    yield ("papers/lessons/10-results.md",
           f"\\qquad {grown[0]:.0f} \\approx {products[0].replace('×', chr(92) + 'times')} .$$")
    yield ("papers/lessons/10-results.md", f"$\\log {products[0].split()[0]} / "
           f"\\log {grown[0]:.0f} = {shares[0] / 100:.2f}$")
    by_clock, speeds = ([median(rows, m, "sweep", "triangles") / median(rows, m, "sweep", c) / 1e3
                         for m in tables.PAPER] for c in ("seconds", "cpu_seconds"))
    yield "README.md", f"{span(by_clock)} thousand certified triangles per second on two cores"
    yield "README.md", readme_table(rows)
    yield "README.md", f"under 10⁻¹¹ Å | {span(speeds)} |"
    yield "README.md", f"serves for comparison, and takes {span(grown)} times the sweep's time"
    spent = [100 * median(rows, m, "sweep", "seconds_critical_points")
             / median(rows, m, "sweep", "seconds") for m in tables.PAPER]
    yield ("papers/6-discussion.md",
           f"On the molecules of Table 1 a run spends {span(spent)} % of its time on Morse theory")
    one_front = median(rows, "1GRM", "one-front-unsmoothed", "triangles")
    yield "README.md", f"Gramicidin's {one_front:,.0f} triangles take 2.6 MB"


def baseline_texts(rows):
    """(page, text) of what the pages of the other methods say."""
    clock, cpu = ({m: per_molecule(rows, m, "sweep", c) for m in ("static", "dynamic")}
                  for c in ("seconds", "cpu_seconds"))
    yield "papers/5-dynamic.md", (
        f"growing takes {each(cpu['dynamic'], '.0f')} times the sweep's processor time, and "
        f"{each(clock['dynamic'], '.0f')} times its time by the clock")
    yield "papers/5-dynamic.md", (
        f"growing takes {span(cpu['dynamic'])} times the sweep's processor time on the molecules")
    yield "papers/5-dynamic.md", (
        f"needs {span(cpu['static'], '.1f')} times the sweep's processor time for everything")
    more = [100 * (tables.ratio(rows, m, "static", "triangles") - 1) for m in tables.PAPER]
    speeds = [median(rows, m, "static", "triangles") / median(rows, m, "static", "cpu_seconds")
              for m in tables.PAPER]
    yield "papers/5-static.md", (
        f"takes {each(cpu['static'])} times the sweep's processor time, {each(clock['static'])} "
        f"times its time by the clock. It makes {span(more)} % more triangles, "
        f"{min(speeds) / 1e3:.0f},000 to {max(speeds) / 1e3:.0f},000 a processor second")
    yield "README.md", (
        f"certificate, at {span(cpu['static'], '.1f')} times the sweep's processor time")
