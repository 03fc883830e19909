#!/usr/bin/env python3
"""What cmake/lint.py finds by the closure of the includes, and by the length of files, on a made-up
project."""

import subprocess
import sys
import unittest
from pathlib import Path

from support.programs import temporary_folder

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import lint  # noqa: E402  (from cmake)


class MadeUpProject(unittest.TestCase):
    def setUp(self):
        self.root = lint.ROOT = temporary_folder(self)
        self.addCleanup(setattr, lint, "ROOT", ROOT)
        for cached in (lint.included, lint.reached):
            cached.cache_clear()
            self.addCleanup(cached.cache_clear)


class Closure(MadeUpProject):
    def chains(self, **headers):
        """The forbidden chains from front/a.h, given what each header of a module includes."""
        for module, includes in headers.items():
            (self.root / module).mkdir()
            lines = [f'#include "{name}"' for name in includes]
            (self.root / module / "a.h").write_text("\n".join(lines), encoding="utf-8")
        return list(lint.forbidden_chains(self.root / "front" / "a.h"))

    def test_a_forbidden_module_behind_an_allowed_one_is_found_with_the_chain_to_it(self):
        (chain,) = self.chains(front=["morse/a.h"], morse=["skin/a.h"], skin=[])
        self.assertEqual(chain, "front may not reach skin/a.h: front/a.h -> morse/a.h -> skin/a.h")

    def test_allowed_modules_may_be_reached_round_a_cycle(self):
        self.assertEqual(self.chains(front=["morse/a.h"], morse=["surface/a.h", "front/a.h"],
                                     surface=["geometry/a.h"], geometry=[]), [])

    def test_the_project_itself_has_no_such_chain(self):
        lint.ROOT = ROOT
        for module in lint.MAY_NOT_REACH:
            sources = [path for path in (ROOT / module).rglob("*") if path.suffix in (".h", ".cpp")]
            self.assertTrue(sources, module)
            for path in sources:
                self.assertEqual(list(lint.forbidden_chains(path)), [])


class Length(MadeUpProject):
    def test_a_source_may_have_300_lines_and_no_more(self):
        (self.root / "geometry").mkdir()
        for name in ("a.cpp", "a.h", "a.py"):
            path = self.root / "geometry" / name
            for lines, expected in ((300, []), (301, [(301, "301 lines; at most 300")])):
                path.write_text("\n" * lines, encoding="utf-8")
                self.assertEqual(list(lint.complaints(path)), expected)

    def test_every_source_that_git_tracks_is_looked_at(self):
        lint.ROOT = ROOT
        done = subprocess.run(["git", "-C", ROOT, "ls-files", "-z", "*.cpp", "*.h", "*.py"],
                              capture_output=True, text=True, check=False)
        if done.returncode != 0:
            self.skipTest("this is no clone")
        tracked = {ROOT / name for name in done.stdout.split("\0")[:-1]}
        self.assertEqual({path for path in tracked if path.exists()} - set(lint.files()), set())


if __name__ == "__main__":
    unittest.main()
