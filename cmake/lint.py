#!/usr/bin/env python3
"""Fails on an include against the module order, and on a few habits the project does without.

Order: geometry <- surface <- skin <- morse; surface <- implicit; surface <- certify <- refine <-
front; all of these <- morskin <- bench/baselines <- app; the rest of bench, and tests, may include
everything. python stands beside app and includes the library's face only, morskin/. What knows
surfaces only by the seam (certify, refine, front) includes nothing of skin/ or implicit/, not even
through another module's header: front may take plain values from morse/, and no more.
"""

import functools
import re
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent

MAY_INCLUDE = {
    "geometry": {"geometry"},
    "surface": {"geometry", "surface"},
    "implicit": {"geometry", "surface", "implicit"},
    "skin": {"geometry", "surface", "skin"},
    "morse": {"geometry", "surface", "skin", "morse"},
    "certify": {"geometry", "surface", "certify"},
    "refine": {"geometry", "surface", "certify", "refine"},
    "front": {"geometry", "surface", "morse", "certify", "refine", "front"},
}
MAY_INCLUDE["morskin"] = MAY_INCLUDE["front"] | {"implicit", "skin", "morskin"}
BASELINES = "bench/baselines"  # a module inside a folder that may include everything
MAY_INCLUDE[BASELINES] = MAY_INCLUDE["morskin"] | {BASELINES}
# Never to be reached by any chain of includes.
MAY_NOT_REACH = {
    "certify": {"implicit", "skin", "morse"},
    "refine": {"implicit", "skin", "morse"},
    "front": {"implicit", "skin"},
}
MAY_INCLUDE["python"] = {"morskin", "python"}
MAY_INCLUDE["app"] = MAY_INCLUDE[BASELINES] | {"app"}
EVERYTHING = MAY_INCLUDE["app"] | {"bench", "tests", "papers"}
MAY_INCLUDE["papers"] = EVERYTHING | {"answers"}  # a link to the exercises or the solutions
for top in ("bench", "tests"):
    MAY_INCLUDE[top] = EVERYTHING

# Within app: pictures knows meshes only, figures no commands.
WITHIN_APP = {"pictures": {"pictures"}, "figures": {"pictures", "figures"}}

TEXT_ENDINGS = {".h", ".cpp", ".py", ".pyi", ".cmake", ".in", ".sh"}
SOURCE_ENDINGS = {".h", ".cpp", ".py"}
LONGEST_LINE = 100
LONGEST_SOURCE = 300  # lines
FORBIDDEN = [
    (re.compile(r"^\s*#\s*if\s+0\b"), "code switched off; remove it"),
    (re.compile(r"\b(TO" + r"DO|FIX" + r"ME|XX" + r"X)\b"), "a note to self"),
]
INCLUDE = re.compile(r'^\s*#\s*include\s+"(bench/baselines|\w+)/([\w./]+)')


@functools.cache
def included(path):
    """The project's files that a file includes directly."""
    if not path.exists():  # made by the build
        return ()
    lines = path.read_text(encoding="utf-8").splitlines()
    return tuple(f"{m[1]}/{m[2]}" for line in lines if (m := INCLUDE.match(line)))


@functools.cache
def reached(name):
    """All files of the project that including a file brings in, each with the chain to it."""
    chains = {name: (name,)}
    waiting = [name]
    while waiting:
        at = waiting.pop()
        for other in included(ROOT / at):
            if other not in chains:
                chains[other] = (*chains[at], other)
                waiting.append(other)
    return chains


def forbidden_chains(path):
    parts = path.relative_to(ROOT).parts
    for name, chain in reached("/".join(parts)).items():
        if name.split("/")[0] in MAY_NOT_REACH.get(parts[0], ()):
            yield f"{parts[0]} may not reach {name}: {' -> '.join(chain)}"


def files():
    modules = (m for m in MAY_INCLUDE if m != BASELINES)
    for folder in [*modules, "cmake", "packaging", "examples"]:
        for path in sorted((ROOT / folder).rglob("*")):
            if path.is_file() and (path.suffix in TEXT_ENDINGS or path.name == "CMakeLists.txt"):
                yield path
    yield from sorted(ROOT.glob("*.py"))


def complaints(path):
    parts = path.relative_to(ROOT).parts
    module = BASELINES if "/".join(parts[:2]) == BASELINES else parts[0]
    inner = parts[1] if len(parts) > 1 else ""
    within = WITHIN_APP.get(inner) if module == "app" else None
    lines = path.read_text(encoding="utf-8").splitlines()
    if path.suffix in SOURCE_ENDINGS and len(lines) > LONGEST_SOURCE:
        yield len(lines), f"{len(lines)} lines; at most {LONGEST_SOURCE}"
    for number, line in enumerate(lines, start=1):
        include = INCLUDE.match(line)
        if include and module in MAY_INCLUDE and include[1] not in MAY_INCLUDE[module]:
            yield number, f"{module} may not include {include[1]}"
        if include and within and include[1] == "app" and include[2].split("/")[0] not in within:
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
        chains = ((1, chain) for chain in forbidden_chains(path))
        for number, complaint in (*complaints(path), *chains):
            print(f"{path.relative_to(ROOT)}:{number}: {complaint}")
            count += 1
    if count:
        sys.exit(f"lint: {count} complaint(s)")
    print("lint: module order and layout are as they should be")


if __name__ == "__main__":
    main()
