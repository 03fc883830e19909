#!/usr/bin/env python3
"""Fails on an include against the module order, and on a few habits the project does without.

Order: geometry <- skin <- morse, refine <- front <- bench/baselines <- app; the rest of bench, and
tests, may include everything.
"""

import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

MAY_INCLUDE = {
    "geometry": {"geometry"},
    "skin": {"geometry", "skin"},
    "morse": {"geometry", "skin", "morse"},
    "refine": {"geometry", "skin", "refine"},
    "front": {"geometry", "skin", "morse", "refine", "front"},
}
BASELINES = "bench/baselines"  # a module inside a folder that may include everything
MAY_INCLUDE[BASELINES] = MAY_INCLUDE["front"] | {BASELINES}
MAY_INCLUDE["app"] = MAY_INCLUDE[BASELINES] | {"app"}
EVERYTHING = MAY_INCLUDE["app"] | {"bench", "tests", "papers"}
MAY_INCLUDE["papers"] = EVERYTHING | {"answers"}  # a link to the exercises or the solutions
for top in ("bench", "tests"):
    MAY_INCLUDE[top] = EVERYTHING

# Within app: pictures knows meshes only, figures no commands.
WITHIN_APP = {"pictures": {"pictures"}, "figures": {"pictures", "figures"}}

TEXT_ENDINGS = {".h", ".cpp", ".py", ".cmake", ".in", ".sh"}
LONGEST_LINE = 100
FORBIDDEN = [
    (re.compile(r"^\s*#\s*if\s+0\b"), "code switched off; remove it"),
    (re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X)\b"), "a note to self"),
]
INCLUDE = re.compile(r'^\s*#\s*include\s+"(bench/baselines|\w+)/([\w.]+)')


def files():
    for folder in [*(m for m in MAY_INCLUDE if m != BASELINES), "cmake"]:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file() and (path.suffix in TEXT_ENDINGS or path.name == "CMakeLists.txt"):
                yield path


def complaints(path):
    parts = path.relative_to(ROOT).parts
    module = BASELINES if "/".join(parts[:2]) == BASELINES else parts[0]
    inner = parts[1]
    within = WITHIN_APP.get(inner) if module == "app" else None
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), start=1):
        include = INCLUDE.match(line)
        if include and module in MAY_INCLUDE and include[1] not in MAY_INCLUDE[module]:
            yield number, f"{module} may not include {include[1]}"
        if include and within and include[1] == "app" and include[2] not in within:
            yield number, f"app/{inner} may not include app/{include[2]}"
        if include and inner == "pictures" and include[1] not in ("app", "geometry"):
            yield number, f"app/pictures may not include {include[1]}"
        if "\t" in line:
            yield number, "a tab; use spaces"
        if len(line) > LONGEST_LINE:
            yield number, f"{len(line)} columns; at most {LONGEST_LINE}"
        for pattern, reason in FORBIDDEN:
            if pattern.search(line):
                yield number, reason


def main():
    count = 0
    for path in files():
        for number, complaint in complaints(path):
            print(f"{path.relative_to(ROOT)}:{number}: {complaint}")
            count += 1
    if count:
        sys.exit(f"lint: {count} complaint(s)")
    print("lint: module order and layout are as they should be")


if __name__ == "__main__":
    main()
