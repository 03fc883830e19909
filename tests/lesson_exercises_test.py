#!/usr/bin/env python3
"""The exercises of the lessons teach: right answers are taken, known mistakes get their hint, no
reply holds an answer. That no page has one is tests/student_course_test.py's."""

import re
import subprocess
import sys
from pathlib import Path
from unittest import mock

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "papers" / "lessons"))
from answers import FUNCTIONS, Formula, Number, Run, evaluated, value_or_none  # noqa: E402
from questions import LESSONS  # noqa: E402

from support.plain_tests import run_all  # noqa: E402

MORSKIN = Path(sys.argv[1] if len(sys.argv) > 1 else ROOT / "build" / "morskin").resolve()


def all_of(kind):
    return [(f"lesson {n}, {name}", e) for n, exercises in LESSONS.items()
            for name, e in exercises.items() if isinstance(e, kind)]


def plain(text):
    """Without marks, and formulas as questions.py writes them."""
    for tex, written in ((r"\cdot", "."), (r"\varphi", "phi"), (r"\lvert ", "|"),
                         (r" \rvert", "|")):
        text = text.replace(tex, written)
    return " ".join(re.sub(r"[`$\\]", "", text).split())


def test_every_lesson_asks_to_predict_to_run_and_to_explain():
    assert list(LESSONS) == list(range(1, 11))
    assert all(list(e) == ["predict", "run", "explain"] for e in LESSONS.values())


def test_the_lesson_has_the_questions():
    for number, exercises in LESSONS.items():
        page = next((ROOT / "papers" / "lessons").glob(f"{number}-*.md"))
        text = plain(page.read_text(encoding="utf-8"))
        for kind, exercise in exercises.items():
            assert plain(exercise.question) in text, f"{page.name}: no {kind}: {exercise.question}"


def test_right_answers_are_taken():
    for where, e in all_of(Number):
        assert e.reply(repr(e.right)) is None, where
        assert isinstance(e.right, int) or e.reply(f"{e.right:.3g}") is None, where
    for where, e in all_of(Formula):
        for case in e.cases:
            one = Formula(e.question, e.variables, e.right, [case], {})
            assert one.reply(repr(e.right(*case))) is None, where


def test_known_mistakes_get_their_hint_and_no_reply_holds_the_answer():
    for where, e in all_of(Number):
        for wrong, hint in e.mistakes.items():
            reply = e.reply(repr(wrong))
            assert reply and reply.endswith(hint), f"{where}: {wrong}: {reply}"
            numbers = [float(x) for x in re.findall(r"-?\d+\.?\d*", reply)]
            assert e.right not in numbers, f"{where}: {reply}"
    for where, e in all_of(Formula):
        for wrong, hint in e.mistakes.items():
            reply = e.reply(wrong)
            assert reply and reply.endswith(hint), f"{where}: {wrong}: {reply}"
            said = reply.partition(" it ")[2].split()
            assert all(f"{e.right(*case):g}" not in said for case in e.cases), reply


def test_a_formula_is_arithmetic_and_nothing_else():
    assert evaluated("2*x^2 + sqrt(4)", {"x": 3}) == 20
    for text in ("__import__('os')", "x.real", "(lambda: 1)()", "y", "1/0", "'a'*2", "[1]", "2 +",
                 "9^9^9^9"):
        try:
            evaluated(text, {"x": 1})
        except ValueError:
            continue
        raise AssertionError(f"taken: {text}")


def test_to_a_product_without_a_sign_the_error_shows_how_formulas_are_written():
    code, said = asked("1", "predict", "2 sqrt(2)")
    assert code == 2 and said.endswith("2 sqrt(2) is no formula; write one as 2*sqrt(w) + d^2\n")


def test_a_formula_without_a_value_has_none_whatever_python_calls_that():
    for text in ("sqrt(-1)", "log(0)", "floor(1e400)", "floor(1e400 - 1e400)", "1/0", "sqrt(1, 2)"):
        assert value_or_none(text, {}) is None, text
    wrong = ValueError("expected a nonnegative input, got -1.0")  # of Python 3.14
    with mock.patch.dict(FUNCTIONS, sqrt=mock.Mock(side_effect=wrong)):
        assert value_or_none("sqrt(-1)", {}) is None


def test_what_is_to_be_run_is_judged_by_running_it():
    for where, e in all_of(Run):
        right = e.right(MORSKIN)
        assert e.reply(f"{right}", MORSKIN) is None and e.reply(f"{right + 1}", MORSKIN), where


def test_the_reply_to_a_wrong_answer_of_a_run_has_the_command_as_it_is_typed():
    for where, e in all_of(Run):
        program, _, molecule, *_ = words = e.typed().split()
        assert program == "build/morskin" and (ROOT / molecule).is_file(), where
        assert ("-o" in words) == (words[1] != "info"), where
        assert e.reply("-1", MORSKIN).endswith(f"The command is: {e.typed()}"), where


def asked(*words):
    """(exit code, what is printed) of papers/lessons/exercises.py."""
    done = subprocess.run([sys.executable, ROOT / "papers" / "lessons" / "exercises.py", *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    return done.returncode, done.stdout


def test_an_answer_may_begin_with_a_minus_sign():
    assert asked("3", "explain", "-1/(2*cos(2*phi))") == (0, "Right.\n")
    assert asked("9", "predict", "-4") == (0, "Right.\n")


def test_a_number_may_have_commas_between_thousands():
    assert asked("8", "predict", "2,194") == (0, "Right.\n")
    assert asked("8", "predict", "2,147")[1].startswith("2147 is not it. ")
    assert asked("1", "predict", "2,83")[0] == 2  # that is a decimal comma


def test_to_leading_order_the_exact_formula_is_right_too():
    assert asked("6", "explain", "rho - sqrt(rho^2 - e^2/4)") == (0, "Right.\n")
    assert asked("6", "explain", "e^2/(8*rho)") == (0, "Right.\n")


def test_without_the_program_a_run_is_not_judged():
    code, said = asked("1", "run", "1", "--command", "/nowhere/morskin")
    assert code == 2 and "no /nowhere/morskin; make build first" in said, said


def test_where_the_program_fails_one_line_tells_its_exit_code():
    for lesson, verb in (("1", "info"), ("2", "mesh"), ("4", "morse")):
        code, said = asked(lesson, "run", "1", "--command", "/bin/false")
        assert code == 2 and f"error: morskin {verb} " in said, said
        assert "ends with exit code 1" in said, said


def test_a_folder_in_place_of_the_program_is_an_error_of_one_line():
    folder = str(Path(__file__).resolve().parent)
    code, said = asked("1", "run", "1", "--command", folder)
    assert code == 2 and said.endswith(f"error: cannot run {folder}: Permission denied\n"), said


if __name__ == "__main__":
    sys.exit(run_all(globals()))
