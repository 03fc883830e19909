#!/usr/bin/env python3
"""Tables and sentences of the pages that come from the files of papers/results.

    papers/course/results.py            # puts them in place of older ones (make papers-update)
    papers/course/results.py --check    # names those that are stale (tests/tables_test.py)

An older table is the one with the same head, an older sentence the one that differs in numbers.
"""

import argparse
import json
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
sys.path[:0] = [str(ROOT / "bench"), str(ROOT / "bench" / "solvers")]
import ablation  # noqa: E402
import artifact  # noqa: E402
import balls  # noqa: E402
import batch  # noqa: E402
import complexes  # noqa: E402
import corpus_totals  # noqa: E402
import counts  # noqa: E402
import curved_errors  # noqa: E402
import densities  # noqa: E402
import features  # noqa: E402
import implicit  # noqa: E402
import large  # noqa: E402
import methods  # noqa: E402
import molecule  # noqa: E402
import operations  # noqa: E402
import prediction  # noqa: E402
import replay  # noqa: E402
import reproduce_tables as tables  # noqa: E402
import second_order  # noqa: E402
import ses_like  # noqa: E402
import subdomains  # noqa: E402
import table1  # noqa: E402
import tetrahedra  # noqa: E402
import which_density  # noqa: E402
from molecule_runs import read_rows  # noqa: E402

RESULTS = ROOT / "papers" / "results"


def ablation_texts(rows):
    by_name = {r["as_printed"]: r for r in rows}
    names = list(ablation.ROWS)
    spheres, rest, all_of_it = (by_name[name] for name in names[-3:])
    nearest = float(by_name[names[3]]["triangles_ratio"])
    runs = int(spheres["runs"])
    yield "papers/5-results.md", ablation.table(rows)
    yield "papers/results/table1.md", ablation.table(rows)
    yield ("papers/lessons/5-creep.md",
           f"Without that test {runs - int(spheres['certified'])} of {runs} meshes fail.")
    yield "papers/lessons/5-creep.md", f"{100 - 100 / nearest:.0f} % fewer triangles"
    yield ("papers/lessons/10-results.md",
           f"the collision test, {rest['certified']} of {runs} meshes are certified. Without that "
           f"test, {all_of_it['certified']} are.")


def texts():
    """(page, text) of everything that a page has from papers/results."""
    known = json.loads((RESULTS / "environment.json").read_text(encoding="utf-8"))
    yield "papers/5-results.md", tables.environments_text(known)
    yield "README.md", f"waters left out; measured on {known['table1']['date'][:10]}:"
    measured, scaling, agreement = (tables.read_rows(RESULTS / f"{name}.csv")
                                    for name in ("table1", "scaling", "agreement"))
    yield from table1.texts(measured, scaling, agreement)
    yield from table1.baseline_texts(measured)
    yield from ablation_texts(read_rows(RESULTS / "ablation.tsv"))
    rows = read_rows(RESULTS / "counts.tsv")
    yield "papers/2.1-molecular-skin.md", counts.weights_table(rows)
    yield "papers/2.1-molecular-skin.md", counts.weights_sentence(rows)
    yield "papers/4.3-large-molecules.md", counts.coarse_table(rows)
    yield "README.md", counts.coarse_sentence(rows)
    yield "papers/5-dynamic.md", methods.table(read_rows(RESULTS / "methods.tsv"))
    rows = read_rows(RESULTS / "prediction.tsv")
    for text in (prediction.touches_table, prediction.touches_sentence, prediction.guards_table):
        yield "papers/3.1-morse-functions.md", text(rows)
    yield ("papers/3.1-morse-functions.md",
           prediction.functions_table(read_rows(RESULTS / "functions.tsv")))
    yield from operations.texts(read_rows(RESULTS / "operations.tsv"))
    rows = read_rows(RESULTS / "densities.tsv")
    yield "papers/4.3-large-molecules.md", densities.table(rows)
    yield "papers/4.3-large-molecules.md", densities.sentence(rows)
    for script, name, page in ((subdomains, "subdomains", "4.1-algorithm"),
                               (ses_like, "ses-like", "coarser-skins"),
                               (which_density, "solvers-molecule", "solvers"),
                               (batch, "batch", "batch"),
                               (replay, "replay", "4.3-large-molecules"),
                               (large, "large", "4.3-large-molecules"),
                               (complexes, "complexes", "3.2-morse-smale-complex"),
                               (corpus_totals, "corpus", "4.3-large-molecules"),
                               (features, "features", "features"),
                               (second_order, "second-order", "second-order"),
                               (curved_errors, "curved-errors", "second-order"),
                               (implicit, "implicit", "6-implicit-surfaces")):
        yield f"papers/{page}.md", script.table(read_rows(RESULTS / f"{name}.tsv"))
    yield "papers/solvers.md", which_density.sentence(read_rows(RESULTS / "solvers-molecule.tsv"))
    yield ("papers/second-order.md",
           second_order.sentence(read_rows(RESULTS / "second-order.tsv")))
    for page in ("papers/6-implicit-surfaces.md", "papers/lessons/10-results.md"):
        yield page, implicit.sentence(read_rows(RESULTS / "implicit.tsv"))
    yield "papers/features.md", features.sentence(read_rows(RESULTS / "features.tsv"))
    yield ("papers/3.2-simplification.md",
           complexes.simplification_sentence(read_rows(RESULTS / "complexes.tsv")))
    yield "README.md", corpus_totals.sentence(read_rows(RESULTS / "corpus.tsv"))
    yield "papers/4.3-large-molecules.md", replay.sentence(read_rows(RESULTS / "replay.tsv"))
    rows = read_rows(RESULTS / "large.tsv")
    yield "papers/4.3-large-molecules.md", large.sentence(rows)
    yield "README.md", large.readme_sentence(rows)
    yield "papers/artifact.md", artifact.table(
        measured, scaling, agreement,
        *(read_rows(RESULTS / f"{name}.tsv") for name in ("ablation", "solvers-balls")))
    for script in (balls, molecule, tetrahedra):
        rows = read_rows(RESULTS / f"solvers-{script.__name__}.tsv")
        yield "papers/solvers.md", script.table(rows)
        yield "papers/solvers.md", script.sentence(rows)


def pattern(text):
    """Matches a table with the same head, or a sentence that differs in numbers and line ends."""
    if text.startswith("|"):
        return re.escape(text.split("\n")[0]) + r"\n(?:\|.*\n)*(?:\|.*)?"
    escaped = r"\s+".join(re.escape(word) for word in text.split())
    number = r"(?:−|\\[+-])?\d(?:\d|,(?=\d)|\\\.(?=\d))*"
    return re.sub(number, lambda _: r"[+−-]?\d(?:\d|[,.](?=\d))*", escaped)


def has(page, text):
    return " ".join(text.split()) in " ".join(page.split())


def renewed(page, text, where):
    """The page with the text in its place. Raises ValueError if it has none."""
    if has(page, text):
        return page
    places = list(re.finditer(pattern(text), page))
    if len(places) != 1:
        raise ValueError(f"{where} has {len(places)} places for: {text.splitlines()[0]}")
    start, end = places[0].span()
    new = text.rstrip("\n") + ("\n" if places[0][0].endswith("\n") else "")
    return page[:start] + new + page[end:]


def stale():
    for name, text in texts():
        if not has((ROOT / name).read_text(encoding="utf-8"), text):
            yield f"{name} does not have what papers/results says (make papers-update):\n{text}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--check", action="store_true", help="change nothing")
    if parser.parse_args().check:
        found = list(stale())
        print("\n".join(found))
        return bool(found)
    for name, text in texts():
        page = (ROOT / name).read_text(encoding="utf-8")
        new = renewed(page, text, name)
        if new != page:
            print(f"{name}: {text.splitlines()[0][:70]}")
            (ROOT / name).write_text(new, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
