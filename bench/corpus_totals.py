#!/usr/bin/env python3
"""Totals of the corpus by C and model, from tables that corpus.py wrote with one C each.

    bench/corpus.py -C 0.2 --largest 5000 --results results/corpus-0.2.tsv
    bench/corpus_totals.py results/corpus-*.tsv

One line for each C and model, in papers/results/corpus.tsv: molecules and how many are certified at
once, the largest one's atoms, triangles, the median of triangles per square Angstrom, the extreme
angles, triangles that miss the goal, edges that break [L], microseconds a triangle. Refused
molecules, singular ones, are left out.
"""

import argparse
import statistics
import sys
from pathlib import Path

from molecule_runs import ROOT, Rows, end, markdown, read_rows

COLUMNS = ["C", "model", "molecules", "certified", "largest", "triangles", "per_area", "min_angle",
           "max_angle", "missed", "broken_L", "microseconds"]
WIDTHS = [5, 6, 9, 9, 8, 10, 8, 9, 9, 6, 8, 12]


def total(runs):
    certified = [r for r in runs if r["verdict"] == "certified"]
    row = dict.fromkeys(COLUMNS, "") | {
        "C": runs[0]["C"], "model": runs[0]["model"], "molecules": len(runs),
        "certified": len(certified), "largest": max(int(r["atoms"]) for r in runs)}
    if not certified:
        return row
    triangles = [int(r["triangles"]) for r in certified]
    densities = [t / float(r["area"]) for t, r in zip(triangles, certified)]
    return row | {
        "triangles": sum(triangles), "per_area": statistics.median(densities),
        "min_angle": min(float(r["min_angle"]) for r in certified),
        "max_angle": max(float(r["max_angle"]) for r in certified),
        "missed": sum(int(r["missed"]) for r in certified),
        "broken_L": sum(int(r["broken_L"]) for r in certified),
        "microseconds": 1e6 * sum(float(r["seconds"]) for r in certified) / sum(triangles)}


def totals(rows):
    """By C and model."""
    keys = sorted({(float(r["C"]), r["model"]) for r in rows})
    for key in keys:
        yield total([r for r in rows if (float(r["C"]), r["model"]) == key])


def table(rows):
    """4.3: what came of the corpus."""
    return markdown(
        ["$C$", "model", "certified at once", "largest, atoms", "triangles", "per Å², median",
         "angles", "miss the goal", "edges that break [L]", "µs a triangle"],
        ([r["C"], r["model"], f"{r['certified']} of {r['molecules']}", f"{int(r['largest']):,}",
          f"{int(r['triangles']):,}", f"{float(r['per_area']):.1f}",
          f"{float(r['min_angle']):.2f}° to {float(r['max_angle']):.2f}°", r["missed"],
          r["broken_L"], f"{float(r['microseconds']):.1f}"] for r in rows))


def sentence(rows):
    """README: the whole in short."""
    def least(fits):
        return min(float(r["min_angle"]) for r in rows if fits(float(r["C"])))
    molecules, certified, triangles = (sum(int(r[column]) for r in rows)
                                       for column in ("molecules", "certified", "triangles"))
    largest = max(int(r["largest"]) for r in rows)
    return (f"Of {molecules:,} meshes of molecules of up to {largest:,} "
            f"atoms in three models, C from {rows[0]['C']} to {rows[-1]['C']}, {certified:,} are "
            f"certified at once: {triangles:,} triangles, with angles from "
            f"{least(lambda c: c <= 0.2):.2f} degrees up to C = 0.2, from "
            f"{least(lambda c: c > 0.2):.2f} beyond")


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", type=Path, nargs="+", help="written by corpus.py")
    parser.add_argument("--results", type=Path, default=ROOT / "papers/results/corpus.tsv",
                        help="where to write (default: papers/results/corpus.tsv)")
    options = parser.parse_args()
    missing = [str(path) for path in options.tables if not path.is_file()]
    if missing:
        sys.exit(f"{', '.join(missing)}: no such file; write it by bench/corpus.py")
    rows = [r for path in options.tables for r in read_rows(path)
            if not r["verdict"].startswith("refused")]
    with Rows(options.results, COLUMNS, WIDTHS, 2) as written:
        for row in totals(rows):
            written.add(row)
    end([r for r in written.rows if r["certified"] < r["molecules"]], written.rows)


if __name__ == "__main__":
    main()
