#!/usr/bin/env python3
"""Checks an answer to an exercise of a lesson.

    python3 papers/lessons/exercises.py 5                                  # the questions
    python3 papers/lessons/exercises.py 5 predict 4                        # a number
    python3 papers/lessons/exercises.py 5 explain "r / sqrt(1 + rho**2)"   # a formula

A wrong answer gets the first case in which it fails and, where the mistake is a known one, a hint.
The right answer is never shown. Those of "run" are not looked up: the command is run again.
"""

import argparse
import re
import sys
from pathlib import Path

from answers import Run
from questions import LESSONS

ROOT = Path(__file__).resolve().parent.parent.parent


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("lesson", type=int, choices=sorted(LESSONS))
    parser.add_argument("kind", nargs="?", choices=["predict", "run", "explain"])
    parser.add_argument("answer", nargs="?")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "morskin")
    # argparse takes a word with a blank for no option: "-1/d" is an answer.
    options = parser.parse_args([f" {word}" if re.match("-[^-h]", word) else word
                                 for word in sys.argv[1:]])
    exercises = LESSONS[options.lesson]
    if options.answer is None:
        for kind in [options.kind] if options.kind else exercises:
            print(f"{kind}: {exercises[kind].question}")
        return 0
    exercise = exercises[options.kind]
    extra = [options.command] if isinstance(exercise, Run) else []
    try:
        reply = exercise.reply(options.answer, *extra)
    except ValueError as error:
        parser.error(str(error))
    except FileNotFoundError as error:
        parser.error(f"no {error.filename}; make build first")
    except OSError as error:
        parser.error(f"cannot run {error.filename}: {error.strerror}")
    print(reply or "Right.")
    return 1 if reply else 0


if __name__ == "__main__":
    sys.exit(main())
