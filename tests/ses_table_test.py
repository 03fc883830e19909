#!/usr/bin/env python3
"""The table on papers/coarser-skins.md is the one that papers/results/ses-like.tsv makes, every
skin in it is certified, and the model ses-like has the smallest 95 % distances."""

import re
import statistics
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "bench"))
import ses_like  # noqa: E402


def complaints():
    rows = ses_like.read(ROOT / "papers" / "results" / "ses-like.tsv")
    page = ROOT / "papers" / "coarser-skins.md"
    if ses_like.table(rows) not in page.read_text(encoding="utf-8"):
        yield f"{page.name} has not the table of the results:\n{ses_like.table(rows)}"
    made = [(r["chain"], float(r["offset"])) for r in rows]
    if made != [(c, o) for c in ses_like.CHAINS for o in ses_like.OFFSETS]:
        yield "papers/results/ses-like.tsv has not the runs of bench/ses_like.py"
    yield from (f"{r['chain']}: {r['verdict']}" for r in rows if r["verdict"] != "certified")

    def farthest(offset):
        return statistics.median(max(float(r["to_ses_95"]), float(r["from_ses_95"]))
                                 for r in rows if float(r["offset"]) == offset)
    code = (ROOT / "skin" / "model.h").read_text(encoding="utf-8")
    used = float(re.search(r"ses_like_offset = ([\d.]+);", code)[1])
    if used != min(ses_like.OFFSETS, key=farthest):
        yield f"the model's {used} is not the offset with the smallest distances"


def main():
    found = list(complaints())
    for complaint in found:
        print(complaint)
    print(f"{len(ses_like.CHAINS)} chains, {len(found)} complaints")
    sys.exit(bool(found))


if __name__ == "__main__":
    main()
