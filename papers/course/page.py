"""A page in Markdown: its blocks, commands, excerpts and exercises."""

import re
from pathlib import Path

from sources import ROOT, excerpts_in

PAPERS = ROOT / "papers"
LESSONS = PAPERS / "lessons"
SOLUTIONS = PAPERS / "solutions"
FENCE = re.compile(r"^\s*(```|~~~)\s*(\w*)")
EXCERPT = re.compile(r"^\[excerpt: ([\w-]+)\]\((?:\.\./)+(\w[\w./-]+)\)$", re.MULTILINE)
STEP = re.compile(r"build/papers/steps/step_(\w+)$")  # one of the small programs of papers/steps
# What a command on a page may start with; `make` ones are looked up, not run.
RUNNABLE = ("build/morskin ", "build/papers/steps/", "python3 ", "/usr/bin/python3 ", "mkdir ",
            "PYTHONPATH=build/python /usr/bin/python3 ")
# What one in an installed tree may start with; tests/installed_test.py runs these.
INSTALLED = ("morskin ", "cmake ", "cp ", "export ", "PKG_CONFIG_PATH=", "source ", "man ",
             "examples/", "with-cmake/")
COURSE_FIRST_WORDS = (*RUNNABLE, *INSTALLED, "make ")

# Every page of the course has these, in this order.
PARTS = ["## The claim", "## The picture", "## The formula", "## Formula, code, test",
         "## The code", "## Exercises"]
# And one of these, on what the paper does not say.
OPEN_PARTS = ["## What the paper leaves open", "## What was chosen", "## What was not, and why"]
KINDS = ["Predict", "Run", "Explain"]


def page_files():
    """All pages: the reference and the notebooks, the lessons of the reading path, solutions."""
    return [file for folder in (PAPERS, LESSONS, SOLUTIONS) for file in sorted(folder.glob("*.md"))]


class Page:
    def __init__(self, path):
        self.path = Path(path)
        self.text = self.path.read_text(encoding="utf-8")
        self.stem = self.path.stem

    @property
    def title(self):
        match = re.search(r"^# (.*)$", self.text, re.MULTILINE)
        return re.sub(r"[`*]", "", match[1]) if match else self.stem

    @property
    def is_lesson(self):
        return self.path.parent == LESSONS

    @property
    def is_of_course(self):
        return self.exercises.exists()

    @property
    def exercises(self):
        return PAPERS / "exercises" / f"{self.stem}.h"

    def excerpts(self):
        """(name, file) of each excerpt that the page shows."""
        return [(m[1], ROOT / m[2]) for m in EXCERPT.finditer(self.text)]

    def commands(self):
        """(line, command, output) of each command; output is None where none is shown."""
        lines = self.text.splitlines()
        i = 0
        while i < len(lines):
            fence = FENCE.match(lines[i])
            if fence:
                rest = range(i + 1, len(lines))
                end = next((j for j in rest if FENCE.match(lines[j])), len(lines))
                if fence[2] == "console":
                    yield from console_commands(lines[i + 1:end], i + 2)
                i = end + 1
                continue
            is_start = lines[i].startswith("    ") and (i == 0 or not lines[i - 1].strip())
            if is_start and lines[i].strip().startswith(COURSE_FIRST_WORDS):
                while i < len(lines) and lines[i].startswith("    "):
                    command, line = lines[i].strip(), i + 1
                    while command.endswith("\\"):
                        i += 1
                        command = command[:-1] + lines[i].strip()
                    yield line, command, None
                    i += 1
                continue
            i += 1


def console_commands(lines, first):
    """Commands of a console block: each `$ command`, then what it prints."""
    found = []
    for number, line in enumerate(lines, start=first):
        if line.startswith("$ "):
            found.append((number, line[2:], []))
        elif found and found[-1][1].endswith("\\"):
            number, command, output = found.pop()
            found.append((number, command[:-1] + line.strip(), output))
        elif found:
            found[-1][2].append(line)
    return [(number, command, output) for number, command, output in found]


def complaints(page):
    """What a page of the course lacks, in words."""
    where = page.path.relative_to(ROOT)
    found = []
    for name, file in page.excerpts():
        try:
            if not file.exists() or name not in excerpts_in(file):
                found.append(f"{where}: no excerpt {name} in {file.relative_to(ROOT)}")
        except ValueError as error:
            found.append(str(error))
    for number, command, _ in page.commands():
        if not command.startswith(COURSE_FIRST_WORDS):
            found.append(f"{where}:{number}: no command of this project: {command}")
        target = re.match(r"make ([\w-]+)", command)
        makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
        if target and not re.search(rf"^{target[1]}:", makefile, re.MULTILINE):
            found.append(f"{where}:{number}: no such target: {command}")
        step = STEP.match(command)
        if step and not (PAPERS / "steps" / f"{step[1]}.cpp").exists():
            found.append(f"{where}:{number}: no such program: {command}")
    if not page.is_of_course:
        return found
    places = [page.text.find(f"\n{part}\n") for part in PARTS]
    for part, place in zip(PARTS, places):
        if place < 0:
            found.append(f"{where}: no part called {part}")
    if min(places) >= 0 and places != sorted(places):
        found.append(f"{where}: the parts are not in the usual order")
    if not any(f"\n{part}" in page.text for part in OPEN_PARTS):
        found.append(f"{where}: no part on what the paper leaves open")
    if not list(page.commands()):
        found.append(f"{where}: no command")
    if not page.excerpts():
        found.append(f"{where}: no excerpt")
    if "](figures/" not in page.text:
        found.append(f"{where}: no picture")
    tests = PAPERS / "exercises" / "tests" / f"{page.stem}.cpp"
    solution = PAPERS / "solutions" / f"{page.stem}.h"
    for file in (tests, solution):
        if not file.exists():
            found.append(f"{where}: no {file.relative_to(ROOT)}")
    for kind in KINDS:
        if f"**{kind}.**" not in page.text:
            found.append(f"{where}: no exercise **{kind}.**")
        if tests.exists() and f'"{page.stem}, {kind.lower()}: ' not in tests.read_text():
            found.append(f"{where}: no test \"{page.stem}, {kind.lower()}: ...\"")
    return found
