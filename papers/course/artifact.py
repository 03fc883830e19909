"""The claims of papers/artifact.md with their commands, and what papers/results has for each."""

import balls
import reproduce_tables as tables

COLUMNS = ["claim", "command", "expected", "minutes"]
QUICK, WHOLE = "5, with QUICK=1", "60"


def of_molecules(rows, column, form, unit=""):
    """What the sweep has on each molecule of Table 1."""
    found = [tables.measured(rows, molecule=m, method="sweep")[0][column] for m in tables.PAPER]
    return ", ".join(f"{float(value):{form}}{unit}" for value in found)


def in_words(values, form):
    return ", ".join(f"{value:{form}}" for value in values)


def right_topology(rows, method):
    """On how many skins a method has χ, components and genus right."""
    return sum(all(r[name] == r["expected_" + name] for name in
                   ("euler_characteristic", "components", "genus"))
               for r in tables.measured(rows, method=method))


def claims(table1, scaling, agreement, ablation, solvers):
    """Rows of the columns above, from the rows of the results' files."""
    papers_own = list(tables.PAPER.values())
    exponents = [tables.fit(scaling, "seconds", series=series, method="sweep")[0]
                 for series in ("corpus", "finer")]
    skins = sum(r["method"] == "sweep" for r in agreement)
    certified = {r["as_printed"]: f"{r['certified']} of {r['runs']}" for r in ablation}
    reproduce = "`make reproduce`"
    yield ["The meshes are about as large as the paper's", reproduce,
           f"triangles {of_molecules(table1, 'triangles', ',.0f')}; the paper's "
           f"{in_words((p[1] for p in papers_own), ',')}", QUICK]
    yield ["No smallest angle is below the paper's", reproduce,
           f"{of_molecules(table1, 'min_angle_deg', '.2f', '°')}; the paper's "
           f"{in_words((p[2] for p in papers_own), '.2f')}°", QUICK]
    ratios = [tables.ratio(table1, m, "dynamic", "seconds") for m in tables.PAPER]
    yield ["The sweep is many times as fast as growth", reproduce,
           f"dynamic / sweep {in_words(ratios, '.0f')}; the paper's "
           f"{in_words((p[4] / p[3] for p in papers_own), '.0f')}", QUICK]
    yield ["The sweep's time is almost linear in the triangles", reproduce,
           "exponents " + " and ".join(f"{p:.3f} ± {error:.3f}" for p, error, _ in exponents),
           WHOLE]
    yield ["Sweep, static and dynamic method have the topology right", reproduce,
           ", ".join(f"{right_topology(agreement, m)} of {skins}"
                     for m in ("sweep", "static", "dynamic")) +
           f"; marching cubes {right_topology(agreement, 'marching-cubes')}", WHOLE]
    yield ["The general guard of the front cannot be left out", reproduce,
           f"certified {certified['nothing']}; with protecting spheres alone "
           f"{certified['guard']}", WHOLE]
    orders = [balls.order(solvers, f"{name}_error") for name in ("born", "kirkwood")]
    yield ["Boundary elements converge on the meshes", "`make solvers`",
           f"power of the edges' length, Born {orders[0]:.2f}, Kirkwood {orders[1]:.2f}", "15"]


def table(*rows):
    return tables.markdown(COLUMNS, claims(*rows))
