"""What the tests of the module share. They find it in the folder that is their first argument."""

from __future__ import annotations

import os
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
MOLECULES = ROOT / "bench" / "molecules"
sys.path.append(str(ROOT / "tests" / "support"))
from programs import temporary_folder  # noqa: E402  (from tests/support)

BALLS = ([[0, 0, 0], [1.5, 0, 0]], [1.5, 1.2])  # two that overlap, in one piece
COARSE = {"C": 0.3, "threads": 1}


class ModuleTest(unittest.TestCase):
    def setUp(self) -> None:
        self.folder = temporary_folder(self)

    def python(self, code: str, *words: str, timeout: float = 120, **environment: str) -> str:
        """What another Python prints, which must end well."""
        done = subprocess.run([sys.executable, "-c", code, *words], cwd=self.folder, text=True,
                              env={**os.environ, "PYTHONPATH": sys.path[0], **environment},
                              capture_output=True, timeout=timeout)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout


def main() -> None:
    """Runs the tests of the calling file."""
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])


if len(sys.argv) > 1:
    sys.path.insert(0, os.path.abspath(sys.argv[1]))
