#!/usr/bin/env python3
"""What cmake/lint.py finds by the closure of the includes, on a made-up project."""

import sys
import unittest
from pathlib import Path

from support.programs import temporary_folder

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "cmake"))
import lint  # noqa: E402  (from cmake)


class Closure(unittest.TestCase):
    def setUp(self):
        self.root = lint.ROOT = temporary_folder(self)
        self.addCleanup(setattr, lint, "ROOT", ROOT)
        for cached in (lint.included, lint.reached):
            cached.cache_clear()
            self.addCleanup(cached.cache_clear)

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
            for path in (ROOT / module).glob("*.h"):
                self.assertEqual(list(lint.forbidden_chains(path)), [])


if __name__ == "__main__":
    unittest.main()
