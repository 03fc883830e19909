"""The course without its solutions: what is left out, and what would give an answer away."""

import html
import re

from page import LESSONS, PAPERS, SOLUTIONS, Page, page_files
from sources import ROOT

# Sources that have answers, or compare with them. The site lists none of them.
HIDDEN = (SOLUTIONS, PAPERS / "exercises" / "tests", LESSONS / "questions.py")

LEADS_THERE = re.compile(r"papers/solutions|\bsolutions/")


def is_hidden(path):
    return any(path == hidden or path.is_relative_to(hidden) for hidden in HIDDEN)


def without_solutions(text):
    """A page without the lines that name the solutions, or lead to them."""
    return "\n".join(line for line in text.split("\n") if not LEADS_THERE.search(line))


def sentences_of_solutions():
    """What only a solution says: long sentences and lines of code, with single blanks."""
    for file in sorted(SOLUTIONS.iterdir()):
        text = file.read_text(encoding="utf-8")
        if file.suffix == ".md":
            said = re.split(r"(?<=[.:?])\s+", text[text.index("\n## "):])
        else:
            comments = " ".join(re.findall(r"^// (.*)$", text, re.MULTILINE))
            said = re.split(r"(?<=[.:])\s+", comments)
            said += re.findall(r"^\s*return (.*);$", text, re.MULTILINE)
        for one in said:
            plain = " ".join(one.split())
            if len(plain) >= 40:
                yield plain


def run_answers():
    """Numbers that are to be found by running something: (where, number)."""
    for task in sorted((PAPERS / "exercises").glob("[0-9]*.h")):
        run = re.search(r"/// Run\..*?(\w+) = unanswered;", task.read_text("utf-8"), re.DOTALL)
        solution = (SOLUTIONS / task.name).read_text(encoding="utf-8")
        yield task.stem, re.search(rf"\b{run[1]} = ([\d.]+);", solution)[1]
    text = (SOLUTIONS / "lessons.md").read_text(encoding="utf-8")
    for number, answer in enumerate(re.findall(r"^    run ([\d,.]+)$", text, re.MULTILINE), 1):
        yield f"lesson {number}", answer.replace(",", "")


def has_number(text, number):
    """Whether a number stands in a text, written with commas or without."""
    grouped = f"{int(number):,}" if number.isdigit() else number
    return any(re.search(rf"(?<![\d.,]){re.escape(form)}(?![\d.,]*\d)", text)
               for form in {number, grouped})


def leaks_in(text, where):
    """What a text that students get gives away."""
    plain = " ".join(text.split())
    for sentence in sentences_of_solutions():
        if sentence in plain:
            yield f"{where}: of a solution: {sentence}"
    if LEADS_THERE.search(text):
        yield f"{where}: leads to the solutions"


def leaks_of_pages():
    """The same of all pages as students get them; no number that is to be found by a run either."""
    for page in map(Page, page_files()):
        if page.path.parent == SOLUTIONS:
            continue
        text = without_solutions(page.text)
        yield from leaks_in(text, page.path.name)
        for where, number in run_answers():
            if has_number(text, number):
                yield f"{page.path.name}: the answer to run of {where}, {number}"


def leaks_of_site(folder):
    """What a built site gives away."""
    for file in [*sorted(folder.rglob("*.html")), folder / "searchindex.js"]:
        if file.parent.name != "interactive":
            text = html.unescape(re.sub("<[^>]*>", "", file.read_text(encoding="utf-8")))
            yield from leaks_in(text, str(file.relative_to(folder)))
    for hidden in HIDDEN:
        listing = folder / "src" / hidden.relative_to(ROOT)
        if listing.exists() or listing.with_name(f"{listing.name}.html").exists():
            yield f"{listing.relative_to(folder)}: has answers"
