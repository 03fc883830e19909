#!/usr/bin/env python3
"""Every exercise has a solution, and the course for students gives none of them away."""

import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(ROOT / "papers" / "lessons"), str(ROOT / "papers" / "course")]
import student  # noqa: E402
from build import archive  # noqa: E402
from answers import Run  # noqa: E402
from page import LESSONS as LESSON_PAGES  # noqa: E402
from page import PAPERS, SOLUTIONS, Page, page_files  # noqa: E402
from questions import LESSONS  # noqa: E402

from support.plain_tests import run_all  # noqa: E402

MORSKIN = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "morskin").resolve()
ITEM = re.compile(r"^\d+\. ", re.MULTILINE)


def part(text, heading):
    found = re.search(rf"^## {re.escape(heading)}\n(.*?)(?=^## |\Z)", text,
                      re.DOTALL | re.MULTILINE)
    return found[1] if found else ""


def questions_of(page):
    """How many questions of a page are for C++ or a lesson's program, and how many for nobody."""
    exercises = len(ITEM.findall(part(page.text, "Exercises")))
    further = len(ITEM.findall(part(page.text, "Further questions")))
    is_judged = page.is_of_course or page.is_lesson
    return (exercises, further) if is_judged else (0, exercises + further)


def test_every_question_has_a_solution():
    answers = (SOLUTIONS / "questions.md").read_text(encoding="utf-8")
    lessons = (SOLUTIONS / "lessons.md").read_text(encoding="utf-8")
    count = 0
    for page in map(Page, page_files()):
        judged, others = questions_of(page)
        given = len(ITEM.findall(part(answers, page.stem)))
        assert given == others, f"{page.path.name}: {others} questions, {given} solutions"
        if judged and page.is_lesson:
            solution = part(lessons, f"Lesson {int(page.stem.split('-')[0])}")
            assert len(re.findall(r"^    \w+ ", solution, re.MULTILINE)) == judged, page.stem
        elif judged:
            text = (SOLUTIONS / f"{page.stem}.h").read_text(encoding="utf-8")
            assert len(re.findall(r"^(?:Number|Count|Counts|Formula<.*>) \w+ =", text,
                                  re.MULTILINE)) == judged, page.stem
        count += judged + others
    assert len(re.findall(r"^## ", answers, re.MULTILINE)) == sum(
        questions_of(page)[1] > 0 for page in map(Page, page_files()))
    return f"{count} exercises"


def test_the_solutions_of_the_lessons_are_right():
    text = (SOLUTIONS / "lessons.md").read_text(encoding="utf-8")
    for number, exercises in LESSONS.items():
        given = dict(re.findall(r"^    (\w+) (.*)$", part(text, f"Lesson {number}"), re.MULTILINE))
        for kind, exercise in exercises.items():
            extra = [MORSKIN] if isinstance(exercise, Run) else []
            assert exercise.reply(given[kind], *extra) is None, f"lesson {number}, {kind}"


def test_no_page_gives_an_answer_away():
    found = list(student.leaks_of_pages())
    assert not found, "\n".join(found)
    assert len(list(student.run_answers())) == 24


def test_what_is_given_away_is_found():
    sentence = next(student.sentences_of_solutions())
    assert list(student.leaks_in(f"As said,\n  {sentence} So.", "a page"))
    assert list(student.leaks_in("see papers/solutions/4.1-seal.h", "a page"))
    assert not list(student.leaks_in("see papers/exercises/4.1-seal.h", "a page"))
    assert student.has_number("of 28,776 triangles", "28776")
    assert not student.has_number("of 128,776 or 28,776.5", "28776")


def test_sources_with_answers_are_hidden():
    for name in ("solutions/4.1-seal.h", "exercises/tests/4.1-seal.cpp", "lessons/questions.py"):
        assert student.is_hidden(PAPERS / name), name
    for path in (PAPERS / "exercises" / "4.1-seal.h", LESSON_PAGES / "exercises.py"):
        assert not student.is_hidden(path), path
        assert not list(student.leaks_in(path.read_text(encoding="utf-8"), path.name))


def test_the_archive_has_the_whole_name_of_its_folder():
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name) / "course-1.0"
        folder.mkdir()
        assert archive(folder).name == "course-1.0.zip"


if __name__ == "__main__":
    sys.exit(run_all(globals()))
