#!/usr/bin/env python3
"""The table of papers/5-results.md is the one that papers/results/ablation.tsv makes, its rows are
those that bench/ablation.py runs, and each switch of the program has a row of its own."""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import ablation  # noqa: E402


def complaints():
    rows = ablation.read(ROOT / "papers" / "results" / "ablation.tsv")
    if [r["as_printed"] for r in rows] != list(ablation.ROWS):
        yield "papers/results/ablation.tsv has not the rows of bench/ablation.py"
    for page in ("papers/5-results.md", "papers/results/table1.md"):
        if ablation.table(rows) not in (ROOT / page).read_text(encoding="utf-8"):
            yield f"{page} has not the table of papers/results/ablation.tsv"
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


def main():
    found = list(complaints())
    for complaint in found:
        print(complaint)
    print(f"{len(ablation.ROWS)} rows, {len(found)} complaints")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
