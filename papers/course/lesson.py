"""What a lesson of the reading path must be: short, in parts. All pages but a few must be in short
sentences."""

import re

from page import FENCE, LESSONS, PAPERS, Page

MAX_WORDS = 1500
MAX_SENTENCE = 30

# Pages about the program that are not part of the course.
MAY_BE_LONG = {"hostile-input", "provenance", "vertex-data", "viewer"}

PARTS = ["## The claim", "## The picture", "## By hand", "## The code", "## The command",
         "## Exercises", "## One click away"]
WHY_PARTS = ["## Four surfaces", "## What a skin is", "## Asked and got", "## Others"]
# Words that a lesson defines, in bold, before it or any later one uses them; also in the glossary.
DEFINED = ["complementarity", "power cell", "orthosphere", "closed ball property", "isotopy",
           "Reeb graph"]
NEEDS = re.compile(r"^\*You need\*: (.+?)\.\s+\*Time\*:\s+(\d+)\s+minutes\.\s+"
                   r"\*Afterwards\s+you\s+can\*", re.MULTILINE | re.DOTALL)


def prose(text):
    """Paragraphs and list items without tables, code, formulas on lines of their own, headings
    and pictures. A formula, a code span and a link's address count as one word or none."""
    lines, is_fenced, is_formula = [], False, False
    for line in text.splitlines():
        if FENCE.match(line):
            is_fenced = not is_fenced
        elif line.startswith("$$"):
            is_formula = not line.rstrip().endswith("$$") or line.strip() == "$$"
        elif is_formula:
            is_formula = "$$" not in line
        elif not is_fenced and not re.match(r"#|\||!\[|    |\[excerpt:", line):
            lines.append(re.sub(r"^\s*([-*]|\d+\.)\s", "\n", line) if line.strip() else "\n")
    text = re.sub(r"\]\([^)]*\)", "]", "\n".join(lines))
    text = re.sub(r"\$[^$]+\$", "FORMULA", text)
    return re.sub(r"`[^`]+`", "CODE", text)


def sentences(text):
    for paragraph in re.split(r"\n\s*\n", prose(text)):
        for sentence in re.split(r"(?<=[.?!])[*\"”)]*\s+", " ".join(paragraph.split())):
            if sentence:
                yield sentence


def long_sentences(text):
    return [s for s in sentences(text) if len(s.split()) > MAX_SENTENCE]


def lesson_complaints(page):
    """What is wrong with a lesson, in words; of other pages only sentences that are too long."""
    where = page.path.relative_to(PAPERS)
    found = [] if page.stem in MAY_BE_LONG else [
        f"{where}: {len(s.split())} words in a sentence: {s}" for s in long_sentences(page.text)]
    if not page.is_lesson:
        return found
    words = len(page.text.split())
    if words > MAX_WORDS:
        found.append(f"{where}: {words} words, more than {MAX_WORDS}")
    if not NEEDS.search(page.text):
        found.append(f"{where}: does not say what one needs, how long it takes, what for")
    is_why = page.stem.startswith("0-")
    places = [page.text.find(f"\n{part}\n") for part in (WHY_PARTS if is_why else PARTS)]
    if min(places) < 0 or places != sorted(places):
        found.append(f"{where}: the parts are not the usual ones in the usual order")
    if not list(page.commands()) or "](../figures/" not in page.text:
        found.append(f"{where}: no command, or no picture")
    if not is_why and not page.excerpts():
        found.append(f"{where}: no excerpt")
    return found


def lessons():
    """The pages of the reading path, in order."""
    return sorted(map(Page, LESSONS.glob("*.md")), key=lambda p: int(p.stem.split("-")[0]))


def path_complaints():
    """Lessons 0 to 10, joined by links in order, the syllabus with the minutes of each, and words
    that are defined where they come first."""
    path = lessons()
    if [p.stem.split("-")[0] for p in path] != [str(n) for n in range(11)]:
        return ["not the lessons 0 to 10"]
    found = [f"{here.stem}: no link to {other.stem}" for one, two in zip(path, path[1:])
             for here, other in ((one, two), (two, one)) if f"]({other.stem}.md)" not in here.text]
    glossary = (PAPERS / "glossary.md").read_text(encoding="utf-8")
    whole = "\n".join(p.text for p in path)
    for word in DEFINED:
        first = re.search(rf"\**{word}s?\b\**", whole, re.IGNORECASE)
        if not first or not first[0].startswith("**") or f"\n| {word}" not in glossary:
            found.append(f"{word}: not defined where it comes first, or not in the glossary")
    index = (PAPERS / "README.md").read_text(encoding="utf-8")
    syllabus = (PAPERS / "syllabus.md").read_text(encoding="utf-8")
    for page in path:
        if f"](lessons/{page.stem}.md)" not in index:
            found.append(f"README.md: no link to {page.stem}")
        needs = NEEDS.search(page.text)
        row = re.search(rf"^\|.*\]\(lessons/{page.stem}\.md\).*\| (\d+) \|$", syllabus,
                        re.MULTILINE)
        if not row or (needs and row[1] != needs[2]):
            found.append(f"syllabus.md: not the minutes of {page.stem}")
    return found
