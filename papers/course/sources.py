"""Where things are in the sources: the line of a name, of a test, and marked excerpts."""

import re
from functools import lru_cache
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
FOLDERS = ["geometry", "surface", "skin", "morse", "certify", "refine", "front", "morskin",
           "python", "app", "bench", "tests", "papers", "examples"]

MARK = re.compile(r"^\s*(?://|#) \[excerpt: ([\w-]+)\]$")
END_MARK = re.compile(r"^\s*(?://|#) \[/excerpt\]$")


@lru_cache(maxsize=None)
def lines_of(path):
    return path.read_text(encoding="utf-8").splitlines()


def definition_patterns(name):
    """What the line of a definition looks like, the best first."""
    last = re.escape(re.split(r"::|\.", name.removesuffix("()"))[-1])
    scope = re.escape(name.split("::")[0]) + r"(<[^>]*>)?::" if "::" in name else ""
    patterns = []
    if scope:
        patterns.append(rf"^\S.*\b{scope}{last}\s*\(|^{scope}{last}\s*\(")
    patterns += [
        rf"^\s*(template.*)?\b(struct|class|enum class|enum)\s+{last}\b(?!.*;\s*$)",
        rf"^[^\s/].*\b(\w+::)?{last}\s*\((?!.*;\s*$)",      # a function's first line in a .cpp
        rf"^\s*[\w:<>,&*\[\] ]+[ &*]{last}\s*\(.*\{{",       # a function defined in a class
        rf"^\s*(def|class)\s+{last}\b",
        rf"^\s*[\w:<>,&*\[\] ]+[ &*]{last}\s*\(",            # declared
        rf"^\s*[\w:<>,&*\[\] ]+[ &*]{last}\s*(=|;|\{{|,)",    # a variable or a field
        rf"^\s*{last}\b",                                  # an enumerator
        rf"\b{last}\b",
    ]
    return [re.compile(p) for p in patterns]


def is_comment(line):
    return line.lstrip().startswith(("//", "#include", "using "))


@lru_cache(maxsize=None)
def line_of(path, name):
    """(file, line number) of a name; a header stands for its .cpp too. None if it is nowhere."""
    files = [path]
    if path.suffix == ".h" and path.with_suffix(".cpp").exists():
        files.append(path.with_suffix(".cpp"))
    for pattern in definition_patterns(name):
        for file in reversed(files):  # what is defined in the .cpp is found there
            for number, line in enumerate(lines_of(file), start=1):
                if not is_comment(line) and pattern.search(line):
                    return file, number
    return None


@lru_cache(maxsize=None)
def tests_in(path):
    """By name, the line of each TEST_CASE of a file."""
    text = path.read_text(encoding="utf-8")
    found = {}
    case = re.compile(r'TEST_CASE(?:_TEMPLATE)?\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)')
    for match in case.finditer(text):
        name = "".join(re.findall(r'"((?:[^"\\]|\\.)*)"', match[1])).replace('\\"', '"')
        found[name] = text.count("\n", 0, match.start()) + 1
    return found


@lru_cache(maxsize=None)
def excerpts_in(path):
    """By name, (first line, text) between the marks of a file, less the common indent.

    Raises ValueError on a mark without its other half, and on a name used twice.
    """
    found, name, first, body = {}, None, 0, []
    for number, line in enumerate(lines_of(path), start=1):
        if match := MARK.match(line):
            if name or match[1] in found:
                where = f"{path.relative_to(ROOT)}:{number}"
                raise ValueError(f"{where}: excerpt {match[1]} opens twice")
            name, first, body = match[1], number + 1, []
        elif END_MARK.match(line):
            if not name:
                raise ValueError(f"{path.relative_to(ROOT)}:{number}: no excerpt ends here")
            indent = min((len(b) - len(b.lstrip()) for b in body if b.strip()), default=0)
            found[name] = (first, "\n".join(b[indent:] for b in body))
            name = None
        elif name:
            body.append(line)
    if name:
        raise ValueError(f"{path.relative_to(ROOT)}: excerpt {name} has no end")
    return found


def all_excerpts():
    """By (file, name), every marked excerpt of the sources."""
    return {(path, name): place
            for folder in FOLDERS for path in sorted((ROOT / folder).rglob("*"))
            if path.suffix in {".h", ".cpp", ".py"} for name, place in excerpts_in(path).items()}
