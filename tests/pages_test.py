#!/usr/bin/env python3
"""Checks what the pages say about the code: those of papers/ and ARCHITECTURE.md.

- Every relative link and picture resolves, with its heading if it names one; in READMES as well.
- Every code span names something that is there:
      a file or folder              `certify/sizing.h`, `papers/`
      a name in the file before it  `Sizing::edge_ratio` (a header stands for its .cpp too);
                                    with no file before it in the block, in any source file
      a test case, word for word    `"points on a line are collinear"`, in the test file before it
      a make target, an option      `make demo`, `--height`
  A block is a paragraph, a list item or a table row. Formulas are not set as code.
- Every table has a head, and every row of it as many cells, there as well.
- Every console block of README.md stands on a page as well, where its commands are run.
- Every option of the library has a place in the tables of papers/library.md.
- Every figure is shown on some page, and every SVG well-formed.
- Every small program of papers/steps has at most 80 lines and is run on some page.
- The pages of the course have all their parts, every excerpt is marked in the sources and shown,
  and the exercises have tests and solutions (papers/course/page.py; `make papers` runs the
  commands too); the lessons are short and have theirs (papers/course/lesson.py).
- No sentence has more than 30 words, but for some pages about the program.
- No page of papers/ has a formula as plain text (papers/course/plain_formulas.py).

Prints one line and exits with 1 on any failure.
"""

import re
import sys
import xml.etree.ElementTree
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "papers" / "course"))
from page import page_files  # noqa: E402
PAGES = [*page_files(), ROOT / "ARCHITECTURE.md"]
READMES = [ROOT / "README.md", ROOT / "CHANGELOG.md", ROOT / "bench" / "MEASUREMENTS.md",
           *sorted(ROOT.glob("*/README.md"))]  # their links and tables only
CODE_FOLDERS = ["geometry", "surface", "implicit", "skin", "morse", "certify", "refine", "front",
                "morskin", "python", "app", "bench", "tests", "cmake", "papers", "examples",
                "packaging"]
CODE_ENDINGS = {".h", ".cpp", ".py", ".pyi", ".cmake", ".sh", ".in"}

FENCE = re.compile(r"^\s*(```|~~~)")
SPAN = re.compile(r"(`+)(.+?)\1", re.DOTALL)
LINK = re.compile(r"\]\(([^)\s]+)[^)]*\)|<img[^>]*\ssrc=\"([^\"]+)\"")
FILE = re.compile(r"\.?[\w.-]+(/[\w.-]+)+/?|[\w.-]+/|[\w-]+\.(md|txt|json|h|cpp|py|sh)|Makefile")
NAME = re.compile(r"[A-Za-z_]\w*((::|\.)[A-Za-z_]\w*)*(\(\))?")
TEST_CASE = re.compile(r'TEST_CASE(?:_TEMPLATE)?\(\s*((?:"(?:[^"\\]|\\.)*"\s*)+)')
LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')


class Checks:
    def __init__(self):
        self.passed = 0
        self.failures = []

    def expect(self, condition, where, what):
        if condition:
            self.passed += 1
        else:
            self.failures.append(f"{where}: {what}")


def words_of(path):
    """The words of a source file, of its .cpp too if it is a header."""
    text = path.read_text(encoding="utf-8")
    if path.suffix == ".h" and path.with_suffix(".cpp").exists():
        text += path.with_suffix(".cpp").read_text(encoding="utf-8")
    return set(re.findall(r"\w+", text))


class Sources:
    """Words by file, read once each."""

    def __init__(self):
        self.words = {}
        self.everywhere = set()
        for folder in CODE_FOLDERS:
            for path in sorted((ROOT / folder).rglob("*")):
                if path.suffix in CODE_ENDINGS or path.name == "CMakeLists.txt":
                    self.everywhere |= self.of(path)

    def of(self, path):
        if path not in self.words:
            self.words[path] = words_of(path)
        return self.words[path]


def test_cases(path):
    text = path.read_text(encoding="utf-8")
    return {"".join(LITERAL.findall(m[1])).replace('\\"', '"') for m in TEST_CASE.finditer(text)}


def blocks(text):
    """(number of the first line, text) of each paragraph, list item, heading and table row."""
    block, start, is_fenced = [], 0, False
    for number, line in enumerate(text.splitlines(), start=1):
        if FENCE.match(line):
            is_fenced = not is_fenced
            line = ""
        elif is_fenced:
            continue
        starts_anew = re.match(r"\s*([-*]|\d+\.)\s|\s*\||#", line)
        if block and (not line.strip() or starts_anew):
            yield start, "\n".join(block)
            block = []
        if line.strip():
            if not block:
                start = number
            block.append(line)
    if block:
        yield start, "\n".join(block)


def slugs(path):
    """The anchors that GitHub gives a page's headings."""
    heads = re.findall(r"^#+\s+(.*?)\s*$", path.read_text(encoding="utf-8"), re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", h.lower()).replace(" ", "-") for h in heads}


def check_link(checks, page, where, target):
    if re.match(r"[a-z]+:", target):
        return
    path, _, anchor = target.partition("#")
    file = (page.parent / path).resolve() if path else page
    if file.parent == ROOT / "papers" / "interactive":  # pages that `make papers` bundles
        parts = (file.parent / "build.py").read_text(encoding="utf-8")
        checks.expect(f'"{file.stem}"' in parts, where, f"{target} is not made by build.py")
        return
    checks.expect(file.exists(), where, f"the link {target} leads nowhere")
    if anchor and file.suffix == ".md" and file.exists():
        checks.expect(anchor in slugs(file), where, f"{target}: no such heading")


def check_span(checks, sources, where, span, file):
    """Checks one code span; returns the file that the next span is about."""
    if span.startswith('"'):
        name = span.strip('"')
        is_test = file is not None and file.name.endswith("_test.cpp")
        checks.expect(is_test and name in test_cases(file), where, f"no TEST_CASE {span}"
                      + (f" in {file.relative_to(ROOT)}" if file else "; name its file first"))
    elif span.startswith("make "):
        targets = re.findall(r"^([\w-]+):", (ROOT / "Makefile").read_text(), re.MULTILINE)
        checks.expect(span.split()[1] in targets, where, f"no such target: {span}")
    elif span.startswith("-"):
        options = "".join((ROOT / "app" / name).read_text(encoding="utf-8")
                          for name in ("options.cpp", "shared_options.cpp",
                                       "features_options.cpp", "selection_arguments.cpp",
                                       "batch/options.cpp"))
        checks.expect(f"{span.split()[0]}" in options, where, f"no such option: {span}")
    elif FILE.fullmatch(span):
        exists = (ROOT / span).exists()
        checks.expect(exists, where, f"no such file: {span}")
        if exists and (ROOT / span).is_file():
            return ROOT / span
    elif NAME.fullmatch(span):
        words = sources.of(file) if file else sources.everywhere
        missing = [w for w in re.findall(r"\w+", span) if w not in words]
        checks.expect(not missing, where, f"no {', '.join(missing)} in "
                      + (str(file.relative_to(ROOT)) if file else "any source file"))
    else:
        checks.expect(False, where, f"a code span that names nothing: `{span}`")
    return file


def checked_blocks(checks, page):
    """(where, block) of each block, with its links and rows of tables checked."""
    columns, last_row, rows = 0, 0, 0
    for line, block in blocks(page.read_text(encoding="utf-8")):
        where = f"{page.relative_to(ROOT)}:{line}"
        if block.startswith("|"):
            cells = len(re.findall(r"(?<!\\)\|", block)) - 1
            columns, rows = (columns, rows + 1) if line == last_row + 1 else (cells, 1)
            last_row = line
            checks.expect(cells == columns, where, f"{cells} cells in a table of {columns}")
            checks.expect(rows != 2 or not block.strip("|:- "), where, "a table without a head")
        for match in LINK.finditer(block):
            check_link(checks, page, where, match[1] or match[2])
        yield where, block


def check_page(checks, sources, page):
    for where, block in checked_blocks(checks, page):
        file = None
        for match in SPAN.finditer(block):
            file = check_span(checks, sources, where, " ".join(match[2].split()), file)


def check_figures(checks):
    shown = "".join(page.read_text(encoding="utf-8") for page in [*PAGES, *READMES])
    for figure in sorted((ROOT / "papers" / "figures").iterdir()):
        where = str(figure.relative_to(ROOT))
        checks.expect(f"figures/{figure.name}" in shown, where, "on no page")
        if figure.suffix != ".svg":
            continue
        try:
            xml.etree.ElementTree.parse(figure)
        except xml.etree.ElementTree.ParseError as error:
            checks.expect(False, where, str(error))


def check_readme(checks):
    """The commands that README.md shows are run where papers/ show them too."""
    shown = "".join(page.read_text(encoding="utf-8") for page in PAGES if page.exists())
    text = READMES[0].read_text(encoding="utf-8")
    found = re.findall(r"^```console\n.*?^```$", text, re.MULTILINE | re.DOTALL)
    checks.expect(found, "README.md", "no console block")
    for block in found:
        line = text[:text.index(block)].count("\n") + 1
        checks.expect(block in shown, f"README.md:{line}", "a console block that no page runs")


def check_library(checks):
    page = (ROOT / "papers" / "library.md").read_text(encoding="utf-8")
    rows = "".join(re.findall(r"^\| `(.*?) \|", page, re.MULTILINE))
    for header, options in (("molecule.h", "ReadOptions"), ("morskin.h", "SkinOptions"),
                            ("morskin.h", "RunOptions"), ("morskin.h", "MeshOptions")):
        text = (ROOT / "morskin" / header).read_text(encoding="utf-8")
        fields = re.search(rf"^struct {options} {{(.*?)^}};", text, re.MULTILINE | re.DOTALL)[1]
        for name in re.findall(r"(\w+) = ", re.sub(r"static .*|//.*", "", fields)):
            checks.expect(f"{name}`" in rows, "papers/library.md", f"no row for {options}::{name}")


def declarations(path):
    """What is to be answered in a file of answers: types and names."""
    text = re.sub(r"\s+", " ", re.sub(r"//.*", "", path.read_text(encoding="utf-8")))
    return re.findall(r"\b((?:Number|Count|Counts|Formula<[^>]*>) \w+) =", text)


def check_course(checks):
    from lesson import lesson_complaints, path_complaints
    from page import Page, complaints
    from sources import all_excerpts
    pages = [Page(page) for page in page_files()]
    found = path_complaints()
    checks.expect(not found, "the reading path", "; ".join(found))
    for page in pages:
        found = complaints(page) + lesson_complaints(page)
        checks.expect(not found, page.path.name, "; ".join(found))
    try:
        shown = {(file, name) for page in pages for name, file in page.excerpts()}
        for file, name in all_excerpts():
            where = str(file.relative_to(ROOT))
            checks.expect((file, name) in shown, where, f"excerpt {name}: on no page")
    except ValueError as error:
        checks.expect(False, "excerpts", str(error))
    for task in sorted((ROOT / "papers" / "exercises").glob("[0-9]*.h")):
        solution = ROOT / "papers" / "solutions" / task.name
        where = f"papers/exercises/{task.name}"
        checks.expect((ROOT / "papers" / f"{task.stem}.md").exists(), where, "no page")
        checks.expect(solution.exists() and declarations(task) == declarations(solution), where,
                      "not what the solution answers")
        checks.expect(task.read_text().count("= unanswered;") == len(declarations(task)), where,
                      "an answer is given away")


def check_formulas(checks):
    from plain_formulas import plain_formulas
    for plain in ("where ρ falls", "with C = 0.2", "a circle of radius √2", "10⁻⁹ of it", "d > 2"):
        checks.expect(list(plain_formulas(plain)), "plain_formulas", f"not found: {plain}")
    for text in ("where $\\rho$ falls", "$$\nC = 1\n$$", "`a = b`", "```\nρ\n```", "\n    C = 1",
                 "5 Å², 30°, −4 %", "![ρ](rho.png)", "[Index](a.md) · [next](b.md)"):
        checks.expect(not list(plain_formulas(text)), "plain_formulas", f"no formula: {text}")
    for page in page_files():
        for line, found in plain_formulas(page.read_text(encoding="utf-8"), page.stem):
            checks.expect(False, f"papers/{page.name}:{line}", f"a formula as plain text: {found}")


def check_steps(checks):
    from page import STEP, Page
    commands = {command for path in page_files()
                for _, command, output in Page(path).commands() if output}
    shown = {match[1] for match in map(STEP.match, commands) if match}
    for program in sorted((ROOT / "papers" / "steps").glob("*.cpp")):
        where = str(program.relative_to(ROOT))
        checks.expect(program.stem in shown, where, "on no page with what it prints")
        lines = len(program.read_text(encoding="utf-8").splitlines())
        checks.expect(lines <= 80, where, f"{lines} lines, not a small program")


def main():
    checks = Checks()
    sources = Sources()
    for page in PAGES:
        check_page(checks, sources, page)
    for page in READMES:
        list(checked_blocks(checks, page))
    check_figures(checks)
    check_readme(checks)
    check_library(checks)
    check_course(checks)
    check_steps(checks)
    check_formulas(checks)
    for failure in checks.failures:
        print(failure)
    print(f"{checks.passed} passed, {len(checks.failures)} failed")
    return 1 if checks.failures else 0


if __name__ == "__main__":
    sys.exit(main())
