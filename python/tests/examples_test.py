#!/usr/bin/env python3
"""The examples print what the page says, and the notebook what it shows.
Usage: examples_test.py folder-of-the-package [--all]: --all runs what needs other packages too"""

from support import ROOT, ModuleTest, main

import contextlib
import io
import json
import re
import sys
from pathlib import Path

EXAMPLES = ROOT / "examples" / "python"
sys.path.insert(1, str(ROOT / "papers" / "course"))
from page import Page  # noqa: E402  (from papers/course)
from run_commands import matches, run, sandbox_for, trimmed  # noqa: E402

RUNS_ALL = "--all" in sys.argv


def needs_packages(example):
    return "Needs " in (EXAMPLES / example).read_text("utf-8").partition("\n")[0]


class Examples(ModuleTest):
    def test_every_example_is_on_the_page_and_prints_what_it_shows(self):
        page = Page(ROOT / "papers" / "python.md")
        box = sandbox_for(page, self.folder, Path(sys.path[0]).parent / "morskin")
        commands = {found[1]: (command, shown) for _, command, shown in page.commands()
                    if (found := re.search(r"examples/python/(\w+\.py)", command))}
        self.assertEqual(set(commands), {path.name for path in EXAMPLES.glob("*.py")})
        for name, (command, shown) in commands.items():
            if needs_packages(name) and not RUNS_ALL:
                continue  # the slow tests run it
            with self.subTest(name):
                printed = run(command, box)
                self.assertTrue(matches(trimmed(shown), printed), "\n".join(printed))

    def test_every_notebook_runs_and_prints_what_it_shows(self):
        notebooks = sorted(EXAMPLES.glob("*.ipynb"))
        self.assertTrue(notebooks)
        for path in notebooks:
            self.run_notebook(path)

    def run_notebook(self, path):
        cells = json.loads(path.read_text("utf-8"))["cells"]
        names = {"__name__": "__main__"}
        with contextlib.chdir(path.parent):
            for number, cell in enumerate(cells):
                if cell["cell_type"] != "code":
                    continue
                printed = io.StringIO()
                with contextlib.redirect_stdout(printed):
                    exec(compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec"),
                         names)
                shown = "".join("".join(output["text"]) for output in cell["outputs"])
                self.assertEqual(printed.getvalue(), shown, f"{path.name}, cell {number}")


if __name__ == "__main__":
    sys.argv = [word for word in sys.argv if word != "--all"]
    main()
