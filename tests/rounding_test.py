"""Gappa proves the constant of every forward error bound, and rejects smaller ones."""

import pathlib
import re
import subprocess
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
LEMMAS = (ROOT / "tests/rounding/lemmas.txt").read_text()
DOUBLE, QUAD = "1b-53", "1b-113"


class Lemma:
    def __init__(self, paragraph):
        lines = paragraph.splitlines()
        comments = [line[2:] for line in lines if line.startswith("# ")]
        self.title = comments[0]
        self.text = "\n".join(line for line in lines if not line.startswith("#"))
        self.code = [c[len("code: "):] for c in comments if c.startswith("code: ")]
        worse = next(c[len("not with: "):] for c in comments if c.startswith("not with: "))
        self.worse = self.text.replace(*worse.split(": "))
        self.units = [DOUBLE, QUAD] if "quad" in comments else [DOUBLE]


def against_zero(goal):
    """Gappa compares with numbers only."""
    left, relation, right = re.fullmatch(r"(.*) (<=|>=) (.*)", goal, re.DOTALL).groups()
    size = re.fullmatch(r"\|(.*)\|", left, re.DOTALL)
    if size and "|" not in size[1]:
        return f"{size[1]} - ({right}) <= 0 /\\ {size[1]} + ({right}) >= 0"
    return f"{left} - ({right}) {relation} 0"


def script_of(text, unit):
    head, goals, tail = re.fullmatch(r"(.*->)(.*)(}.*)", text, re.DOTALL).groups()
    goals = " /\\ ".join(against_zero(goal.strip()) for goal in goals.split("/\\"))
    script = re.sub(r"\bE(\d+)\b", r"|e\1| <= U", f"{head} {goals} {tail}")
    return re.sub(r"\bU\b", unit, script)


def is_proved(text, unit):
    script = script_of(text, unit)
    run = subprocess.run(["gappa", "-Eprecision=600"], input=script, text=True, capture_output=True)
    if "syntax" in run.stderr:
        raise AssertionError(run.stderr + script)
    return run.returncode == 0


class Rounding(unittest.TestCase):
    lemmas = [Lemma(p) for p in LEMMAS.split("\n\n")[1:] if "{" in p]

    def test_gappa_proves_every_lemma(self):
        for lemma in self.lemmas:
            for unit in lemma.units:
                with self.subTest(lemma.title, unit=unit):
                    self.assertTrue(is_proved(lemma.text, unit))

    def test_gappa_rejects_every_lemma_with_a_smaller_constant(self):
        for lemma in self.lemmas:
            with self.subTest(lemma.title):
                self.assertNotEqual(lemma.worse, lemma.text)
                self.assertFalse(is_proved(lemma.worse, DOUBLE))

    def test_every_lemma_quotes_code_that_is_there(self):
        for lemma in self.lemmas:
            self.assertTrue(lemma.code, lemma.title)
            for quote in lemma.code:
                path, fragment = quote.split(": ", 1)
                code = " ".join((ROOT / path).read_text().replace("///", "").split())
                with self.subTest(path):
                    self.assertIn(" ".join(fragment.split()), code)


if __name__ == "__main__":
    unittest.main()
