#!/usr/bin/env python3
"""The table of densities on papers/4.3-large-molecules.md is the one that
papers/results/densities.tsv makes, and every run in it is good."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import densities  # noqa: E402


def complaints():
    rows = densities.read(ROOT / "papers" / "results" / "densities.tsv")
    page = ROOT / "papers" / "4.3-large-molecules.md"
    if densities.table(rows) not in page.read_text(encoding="utf-8"):
        yield f"{page.name} has not the table of the results:\n{densities.table(rows)}"
    asked = [(r["molecule"], int(r["asked"])) for r in rows]
    if asked != [(m, d) for m in densities.MOLECULES for d in densities.DENSITIES]:
        yield "papers/results/densities.tsv has not the runs of bench/densities.py"
    for r in rows:
        if r["verdict"].startswith("FAILED") or float(r["min_angle"]) < 30:
            yield f"{r['molecule']} with {r['asked']}: {r['verdict']}, {r['min_angle']} degrees"
        if r["verdict"] == "made" and abs(float(r["made"]) / float(r["asked"]) - 1) > 0.1:
            yield f"{r['molecule']} with {r['asked']}: {r['made']} is off by more than a tenth"


def main():
    found = list(complaints())
    for complaint in found:
        print(complaint)
    print(f"{len(densities.MOLECULES)} molecules, {len(found)} complaints")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
