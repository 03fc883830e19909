"""Formulas that a page has as plain text. All of them stand between dollar signs, inline or as a
display, so that they are set alike (papers/course/plugins/formulas.py); code stays code."""

import re

from page import FENCE

SIGNS = re.compile(r"[Α-Ωα-ωℓ√∛∫∑∇∞≤≥≈≠∈·½‖⁰¹²³⁴-⁹⁻⁺ᵀⁿ₀-₉ᵢⱼ]")
RELATION = re.compile(r"(?<![\w'’.-])[A-Za-z] [=<>] [\w−(]|[\w)] [=<>] [A-Za-z](?![\w'’-])")
UNITS = re.compile(r"Å[²³]|µ[sm]\b")
# Neither prose nor formula: displays, code spans, formulas, pictures with their alternative text,
# addresses, and the line that leads from page to page.
ASIDE = re.compile(r"\$\$.*?\$\$|`[^`]+`|\$[^$]+\$|!\[[^\]]*\]\([^)]*\)|\]\([^)]*\)"
                   r"|^\[[^\n]* · [^\n]*$", re.DOTALL | re.MULTILINE)

# Its tables show what the program says of bad files, word for word.
QUOTES_THE_PROGRAM = "hostile-input"


def without_code(text):
    """The lines of a page, those of blocks of code empty."""
    is_fenced = is_code = False
    before = ""
    for line in text.splitlines():
        is_fence = FENCE.match(line)
        is_fenced = is_fenced != bool(is_fence)
        is_code = line.startswith("    ") and (is_code or not before.strip())
        yield "" if is_fenced or is_fence or is_code else line
        before = line


def plain_formulas(text, stem=""):
    """(line, sign or relation) of each line that has one."""
    prose = ASIDE.sub(lambda m: "\n" * m[0].count("\n"), "\n".join(without_code(text)))
    for number, line in enumerate(prose.splitlines(), start=1):
        if stem == QUOTES_THE_PROGRAM and line.startswith("|"):
            continue
        rest = UNITS.sub("", line)
        found = SIGNS.search(rest) or RELATION.search(rest)
        if found:
            yield number, found[0]
