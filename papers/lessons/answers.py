"""What the exercises of the lessons are made of: a question, and how an answer is judged."""

import ast
import dataclasses
import json
import math
import operator
import re
import subprocess
import tempfile
from collections.abc import Callable
from pathlib import Path

MOLECULES = Path(__file__).resolve().parent.parent.parent / "bench" / "molecules"
NOT_CERTIFIED = 5  # the exit code of a mesh that is written and has a report all the same
TOLERANCE = 2e-3  # of a number that is no count

FUNCTIONS = {name: getattr(math, name) for name in
             ("sqrt", "sin", "cos", "tan", "asin", "acos", "atan", "log", "exp", "ceil", "floor")}
OPERATORS = {ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul,
             ast.Div: operator.truediv, ast.Pow: math.pow, ast.USub: operator.neg}


class NoFormula(ValueError):
    """Anything but arithmetic with the variables that there are."""


class NoValue(ValueError):
    """A division by zero, a root of a negative number and the like."""


def evaluated(text, variables):
    """A formula's value.

    Raises NoValue where it has none, NoFormula on anything but arithmetic with these variables.
    """
    names = {"pi": math.pi} | variables

    def value(node):
        match node:
            case ast.Expression():
                return value(node.body)
            case ast.Constant() if isinstance(node.value, (int, float)):
                return node.value
            case ast.Name() if node.id in names:
                return names[node.id]
            case ast.BinOp() if type(node.op) in OPERATORS:
                return OPERATORS[type(node.op)](value(node.left), value(node.right))
            case ast.UnaryOp() if type(node.op) in OPERATORS:
                return OPERATORS[type(node.op)](value(node.operand))
            case ast.Call(func=ast.Name(id=name), keywords=[]) if name in FUNCTIONS:
                return FUNCTIONS[name](*map(value, node.args))
        raise NoFormula(f"only arithmetic with {', '.join(names)} and {', '.join(FUNCTIONS)}")

    try:
        tree = ast.parse(text.strip().replace("^", "**"), mode="eval")
    except SyntaxError as error:
        raise NoFormula(f"{text} is no formula; write one as 2*sqrt(w) + d^2") from error
    try:
        return value(tree)
    except NoFormula:
        raise
    except (ArithmeticError, TypeError, ValueError) as error:
        raise NoValue(f"{text}: {error}") from error


def number_in(text):
    """The value of a text without variables, in which commas may part thousands: 2,140."""
    return evaluated(re.sub(r"(?<=\d),(?=\d{3}(?!\d))", "", text), {})


def value_or_none(text, variables):
    try:
        return evaluated(text, variables)
    except NoValue:
        return None


def agree(given, right):
    return isinstance(given, (int, float)) and abs(given - right) <= TOLERANCE * abs(right)


@dataclasses.dataclass
class Number:
    """A question with one number for an answer. A mistake is a wrong number and its hint."""
    question: str
    right: float
    mistakes: dict[float, str]

    def reply(self, text):
        """Nothing to a right answer."""
        given = number_in(text)
        if self.is_same(given, self.right):
            return None
        hint = next((h for wrong, h in self.mistakes.items() if self.is_same(given, wrong)), "")
        return f"{given:g} is not it. {hint}".strip()

    def is_same(self, given, number):
        """A count is exact; of other numbers three digits are enough."""
        if isinstance(self.right, int):
            return given == number
        return agree(given, number) or given == float(f"{number:.3g}")


@dataclasses.dataclass
class Formula:
    """A question with a formula for an answer, tried on cases. A mistake is a wrong formula."""
    question: str
    variables: str
    right: Callable
    cases: list[tuple]
    mistakes: dict[str, str]

    def reply(self, text):
        names = self.variables.split()
        for case in self.cases:
            known = dict(zip(names, case))
            given = value_or_none(text, known)
            if not agree(given, self.right(*case)):
                where = ", ".join(f"{name} = {x:g}" for name, x in known.items())
                hint = next((h for wrong, h in self.mistakes.items() if self.is_like(text, wrong)),
                            "")
                result = "has no value" if given is None else f"gives {given:g}, which is not it"
                return f"With {where} it {result}. {hint}".strip()
        return None

    def is_like(self, text, other):
        """Whether two formulas agree on all cases."""
        known = [dict(zip(self.variables.split(), case)) for case in self.cases]
        pairs = [(value_or_none(text, k), value_or_none(other, k)) for k in known]
        return all(a is b is None or (b is not None and agree(a, b)) for a, b in pairs)


@dataclasses.dataclass
class Run:
    """A question about a report of the command: words of the command, keys of the report."""
    question: str
    words: str
    keys: list[str]

    def right(self, command):
        """Raises ValueError where the command fails, OSError where there is none."""
        verb, name, *options = self.words.split()
        with tempfile.TemporaryDirectory() as folder:
            output = Path(folder) / ("out.json" if verb == "morse" else "out.ply")
            words = [command, verb, MOLECULES / name, *options]
            words += ["--json"] if verb == "info" else ["-o", output]
            words += ["--json"] if verb == "mesh" else []
            done = subprocess.run(words, capture_output=True, text=True, check=False)
            if done.returncode not in (0, NOT_CERTIFIED):
                raise ValueError(f"morskin {self.words} ends with exit code {done.returncode}: "
                                 + " ".join(done.stderr.split()))
            text = output.read_text(encoding="utf-8") if verb == "morse" else done.stdout
        value = json.loads(text)
        for key in self.keys:
            value = value[key]
        return value

    def reply(self, text, command):
        given = number_in(text)
        if given == self.right(command):
            return None
        return f"{given:g} is not it. The command is: {self.typed()}"

    def typed(self):
        """The command as it is typed in the root folder."""
        verb, name, *options = self.words.split()
        output = {"mesh": ["-o", "mesh.ply"], "morse": ["-o", "complex.json"]}.get(verb, [])
        return " ".join(["build/morskin", verb, f"bench/molecules/{name}", *options, *output])
