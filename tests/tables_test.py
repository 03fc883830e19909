#!/usr/bin/env python3
"""Tables on pages are the ones that papers/results makes, of all the runs that the scripts in bench
plan, and every run in them is good."""

import re
import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import ablation  # noqa: E402
import condition  # noqa: E402
import densities  # noqa: E402
import features  # noqa: E402
import second_order  # noqa: E402
import ses_like  # noqa: E402
import subdomains  # noqa: E402
from molecule_runs import read_rows  # noqa: E402


def wrong_ablation(rows):
    """Each switch of the program must have a row of its own."""
    if [r["as_printed"] for r in rows] != list(ablation.ROWS):
        yield "not the rows of bench/ablation.py"
    header = (ROOT / "bench" / "ablation" / "as_printed.h").read_text(encoding="utf-8")
    switches = re.findall(r'\{"([\w-]+)", &AsPrinted::', header)
    alone = [row[0][0] for row in ablation.ROWS.values() if len(row[0]) == 1]
    if sorted(switches) != sorted(alone):
        yield "the rows of bench/ablation.py with one switch are not the program's switches"
    for r in rows:
        if int(r["certified"]) + int(r["failed"]) + int(r["out_of_time"]) != int(r["runs"]):
            yield f"{r['as_printed']}: the outcomes are not as many as the runs"
    if ablation.failures([{**r, "runs": int(r["runs"]), "certified": int(r["certified"])}
                          for r in rows]):
        yield "with nothing as printed not every run is certified"


def wrong_densities(rows):
    asked = [(r["molecule"], int(r["asked"])) for r in rows]
    if asked != [(m, d) for m in densities.MOLECULES for d in densities.DENSITIES]:
        yield "not the runs of bench/densities.py"
    for r in rows:
        if r["verdict"].startswith("FAILED") or float(r["min_angle"]) < 30:
            yield f"{r['molecule']} with {r['asked']}: {r['verdict']}, {r['min_angle']} degrees"
        if r["verdict"] == "made" and abs(float(r["made"]) / float(r["asked"]) - 1) > 0.1:
            yield f"{r['molecule']} with {r['asked']}: {r['made']} is off by more than a tenth"
    if max(densities.bent(rows)) > densities.MOST_OVER_FORCED:
        yield f"more than {densities.MOST_OVER_FORCED} times the triangles that are forced"
    page = (ROOT / "papers" / "4.3-large-molecules.md").read_text(encoding="utf-8")
    if densities.sentence(rows) not in page:
        yield f"4.3-large-molecules.md does not say: {densities.sentence(rows)}"


def wrong_offsets(rows):
    """The model ses-like must have the smallest 95 % distances."""
    if [(r["chain"], float(r["offset"])) for r in rows] != [(c, o) for c in ses_like.CHAINS
                                                            for o in ses_like.OFFSETS]:
        yield "not the runs of bench/ses_like.py"
    yield from (f"{r['chain']}: {r['verdict']}" for r in rows if r["verdict"] != "certified")

    def farthest(offset):
        return statistics.median(max(float(r["to_ses_95"]), float(r["from_ses_95"]))
                                 for r in rows if float(r["offset"]) == offset)
    code = (ROOT / "skin" / "model.h").read_text(encoding="utf-8")
    used = float(re.search(r"ses_like_offset = ([\d.]+);", code)[1])
    if used != min(ses_like.OFFSETS, key=farthest):
        yield f"the model's {used} is not the offset with the smallest distances"


def wrong_conditions(rows):
    if [(r["model"], r["options"]) for r in rows] != [(m, " ".join(words))
                                                      for m, words in condition.MESHES]:
        yield "not the runs of bench/condition.py"
    for r in rows:
        if r["options"] == " ".join(condition.CUBES):
            continue
        if r["verdict"] != "certified" or float(r["min_angle"]) < 30:
            yield f"{r['model']} {r['options']}: {r['verdict']}, {r['min_angle']} degrees"


def wrong_subdomains(rows):
    if [(r["molecule"], r["model"], r["options"], int(r["subdomains"])) for r in rows] != [
            (name, model, " ".join(options), count)
            for name, model, options in subdomains.SURFACES for count in subdomains.COUNTS]:
        yield "not the runs of bench/subdomains.py"
    for r in rows:
        if r["verdict"] != "certified":
            yield f"{r['molecule']} in {r['subdomains']}: {r['verdict']}"


def wrong_second_order(rows):
    if [(r["molecule"], float(r["C"])) for r in rows] != [
            (m, C) for m in second_order.MOLECULES for C in second_order.SIZES]:
        yield "not the runs of bench/second_order.py"
    for r in rows:
        if r["verdict"] != "certified":
            yield f"{r['molecule']} with {r['C']}: {r['verdict']}"
    page = (ROOT / "papers" / "second-order.md").read_text(encoding="utf-8")
    if second_order.sentence(rows) not in page:
        yield f"second-order.md does not say: {second_order.sentence(rows)}"


def wrong_features(rows):
    if [r["molecule"] for r in rows] != features.MOLECULES:
        yield "not the runs of bench/features.py"
    for r in rows:
        if r["verdict"] != "certified" or abs(float(r["density"]) / 2 - 1) > 0.2:
            yield f"{r['molecule']}: {r['verdict']}, {r['density']} vertices per square Angstrom"


TABLES = [(ablation, "ablation.tsv", "5-results.md", wrong_ablation),
          (ablation, "ablation.tsv", "results/table1.md", wrong_ablation),
          (densities, "densities.tsv", "4.3-large-molecules.md", wrong_densities),
          (subdomains, "subdomains.tsv", "4.1-algorithm.md", wrong_subdomains),
          (ses_like, "ses-like.tsv", "coarser-skins.md", wrong_offsets),
          (features, "features.tsv", "features.md", wrong_features),
          (second_order, "second-order.tsv", "second-order.md", wrong_second_order),
          (condition, "condition.tsv", "coarser-skins.md", wrong_conditions)]


def complaints():
    for script, results, page, wrong in TABLES:
        rows = read_rows(ROOT / "papers" / "results" / results)
        if script.table(rows) not in (ROOT / "papers" / page).read_text(encoding="utf-8"):
            yield f"{page} has not the table of {results}:\n{script.table(rows)}"
        yield from (f"{results}: {complaint}" for complaint in wrong(rows))


def main():
    found = list(complaints())
    for complaint in found:
        print(complaint)
    print(f"{len(TABLES)} tables, {len(found)} complaints")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
