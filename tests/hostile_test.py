#!/usr/bin/env python3
"""Input that means harm, or might: each with the exit code and the message it must give.

    hostile_test.py path/to/morskin            runs every case, and compares the table in
                                               papers/hostile-input.md with what came out
    hostile_test.py path/to/morskin --table    prints that table
    hostile_test.py path/to/morskin --sanitized
                                               leaves out the limits of memory, which the
                                               sanitizers' own memory exceeds
"""

import os
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

from support.hostile_files import number_cases, reading_cases
from support.hostile_runs import ball_cases, limit_cases, output_cases

ROOT = Path(__file__).resolve().parent.parent
PAGE = ROOT / "papers" / "hostile-input.md"
MORSKIN = os.path.abspath("build/morskin")
SANITIZED = False
SECONDS = 300  # for one run at most, on a busy machine with a slow build

NOBODY = 65534


def cases():
    for made in (reading_cases, number_cases, ball_cases, output_cases, limit_cases):
        for case in made():
            if not (SANITIZED and "memory" in case.how):
                yield case


class Runner:
    """Runs cases, each in a folder of its own, and remembers what came out for the table."""

    def __init__(self):
        self.rows = []

    def complaints(self, case):
        """What did not come out as it should; adds the table's row."""
        with tempfile.TemporaryDirectory(prefix="morskin_hostile_") as name:
            folder = Path(name)
            os.chmod(folder, 0o777)
            for file, content in case.files.items():
                if file.endswith("/"):
                    (folder / file).mkdir()
                else:
                    (folder / file).write_bytes(
                        content if isinstance(content, bytes) else content.encode())
            made = {p.name for p in folder.iterdir()}
            row = None
            wrong = []
            for words in case.runs:
                code, said = self.run(case, words, folder)
                found = {p.name for p in folder.iterdir()} - made
                expected = case.leaves - made
                is_as_said = code == case.code and case.says in said and found == expected
                if not is_as_said or (code > 0 and not said):
                    wrong.append(f"{' '.join(words)}: exit {code}, leaves {sorted(found)}, "
                                 f"says: {said}")
                for file in found:
                    (folder / file).unlink()
                row = row or (case.what, code, said)
            for file, content in case.files.items():
                if file in case.leaves and (folder / file).read_bytes() != content.encode():
                    wrong.append(f"{file} is not as it was")
        self.rows.append(row)
        return wrong

    def run(self, case, words, folder):
        """The exit code and the error, as far as it is the same everywhere."""
        how = case.how
        program, options, restore = MORSKIN, {}, []
        environment = dict(os.environ, LC_ALL="C")
        if how.get("german"):
            environment.update(german_locale())
        if how.get("as_nobody"):
            if os.geteuid() == 0:
                program = copy_for_everyone()
                options.update(user=NOBODY, group=NOBODY)
            first = folder / next(iter(case.files))
            for key, path in (("mode", first), ("folder_mode", folder)):
                if key in how:
                    restore.append((path, path.stat().st_mode & 0o777))
                    os.chmod(path, how[key])
            if "read_only" in how:
                os.chmod(folder / how["read_only"], 0o444)
        if "stdin" in how:
            options["input"] = how["stdin"]
        else:
            options["stdin"] = subprocess.DEVNULL

        def limit():
            if "file_bytes" in how:
                resource.setrlimit(resource.RLIMIT_FSIZE, (how["file_bytes"],) * 2)
            if "address_space" in how:
                resource.setrlimit(resource.RLIMIT_AS, (how["address_space"],) * 2)

        if "interrupt" in how:
            return interrupted([program, *words], folder)
        done = subprocess.run([program, *words], cwd=folder, env=environment, timeout=SECONDS,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                              preexec_fn=limit, **options)
        for path, mode in restore:
            os.chmod(path, mode)
        # Notes are not errors.
        lines = [line for line in done.stderr.decode("utf-8", "strict").splitlines()
                 if not line.startswith("morskin: note:")]
        said = " / ".join(lines).replace(f"{folder}/", "")
        if "AddressSanitizer" in said or "runtime error" in said:
            return done.returncode, "SANITIZER: " + said
        return done.returncode, said


def interrupted(words, folder):
    before = len(list(folder.iterdir()))
    with subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        deadline = time.monotonic() + SECONDS
        while len(list(folder.iterdir())) == before and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        said = process.stderr.read().decode()
        return process.wait(SECONDS), said


SHARED = tempfile.TemporaryDirectory(prefix="morskin_hostile_shared_")


def copy_for_everyone():
    """The program where another user may run it."""
    copy = Path(SHARED.name) / "morskin"
    if not copy.exists():
        os.chmod(SHARED.name, 0o755)
        shutil.copy(MORSKIN, copy)
        os.chmod(copy, 0o755)
    return str(copy)


def german_locale():
    """The environment of a German user; the locale is made if there are tools for it."""
    name = "de_DE.UTF-8"
    place = Path(SHARED.name) / "locale"
    if not place.exists():
        place.mkdir()
        if shutil.which("localedef"):
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(place / name)],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    environment = {"LC_ALL": name, "LANG": name}
    if (place / name).exists():
        environment["LOCPATH"] = str(place)
    return environment


def table(rows):
    lines = ["| input | exit | message |", "|---|---|---|"]
    for what, code, said in rows:
        if code < 0:
            result, message = f"by {signal.Signals(-code).name}", "none; no file is left"
        else:
            result, message = str(code), said or ("certified" if code == 0 else "")
        message = re.sub(r"^morskin: ", "", message)
        message = message.replace("\\", "\\\\").replace("|", "\\|").replace("<", "&lt;")
        lines.append(f"| {what} | {result} | {message} |")
    return lines


def table_of_page():
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    start = lines.index("| input | exit | message |")
    end = next((i for i in range(start, len(lines)) if not lines[i].startswith("|")), len(lines))
    return lines[start:end]


class Hostile(unittest.TestCase):
    maxDiff = None

    def test_every_case_and_the_table_of_the_page(self):
        runner = Runner()
        for case in cases():
            with self.subTest(case.what):
                self.assertEqual(runner.complaints(case), [])
        page = table_of_page()
        if SANITIZED:  # cases are missing
            page = [line for line in page if line in table(runner.rows)]
        self.assertEqual(page, table(runner.rows), "papers/hostile-input.md must hold this table "
                         "(hostile_test.py build/morskin --table prints it)")


def main():
    global MORSKIN, SANITIZED
    words = sys.argv[1:]
    SANITIZED = "--sanitized" in words
    is_table = "--table" in words
    words = [word for word in words if word not in ("--sanitized", "--table")]
    if words:
        MORSKIN = os.path.abspath(words[0])
    if not is_table:
        unittest.main(argv=[sys.argv[0], *words[1:]])
    runner = Runner()
    wrong = [line for case in cases() for line in runner.complaints(case)]
    print("\n".join(table(runner.rows)))
    sys.exit("\n".join(wrong) if wrong else 0)


if __name__ == "__main__":
    main()
