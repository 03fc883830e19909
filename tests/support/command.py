"""The command, run from outside in an empty folder. A test's first argument is the path to it."""

import json
import os
import subprocess
import sys
import unittest
from pathlib import Path

from support.programs import temporary_folder

MOLECULES = Path(__file__).resolve().parent.parent.parent / "bench" / "molecules"
PROGRAM = ["build/morskin"]


def morskin():
    return PROGRAM[0]


def main():
    if len(sys.argv) > 1:
        PROGRAM[0] = os.path.abspath(sys.argv.pop(1))
    unittest.main()


class CommandTest(unittest.TestCase):
    def setUp(self):
        self.folder = temporary_folder(self)
        self.ring = self.input("ring.xyzr", (MOLECULES / "ring12.xyzr").read_bytes())

    def input(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_morskin(self, *words, code=0, **options):
        """@param code  None for any"""
        done = subprocess.run([morskin(), *map(str, words)], capture_output=True, cwd=self.folder,
                              timeout=120, **options)
        if code is not None:
            self.assertEqual(done.returncode, code, repr(done.stderr + done.stdout[-2000:]))
        return done

    def names(self):
        return sorted(p.name for p in self.folder.iterdir() if p.name != "ring.xyzr")

    def check(self, *words, code=0):
        return json.loads(self.run_morskin("check", *words, "--json", code=code).stdout)

    def mesh_json(self, *words, code=0):
        return json.loads(self.run_morskin("mesh", *words, "--json", code=code).stdout)

    def without_origin(self, name):
        """The bytes of a PLY file but for what it says of its origin."""
        lines = (self.folder / name).read_bytes().split(b"\n")
        return b"\n".join(line for line in lines if not line.startswith(b"comment morskin: "))

    def forget_origin(self, name):
        """Takes it out of the file, so that `check` knows only what it is told."""
        (self.folder / name).write_bytes(self.without_origin(name))

    def write_off(self, name, places, triangles):
        lines = ["OFF", f"{len(places)} {len(triangles)} 0"]
        lines += [" ".join(map(repr, place)) for place in places]
        lines += [f"3 {a} {b} {c}" for a, b, c in triangles]
        return self.input(name, "\n".join(lines) + "\n")

    def read_off(self, name):
        """Places and triangles of a file that the command wrote."""
        rows = [line.split() for line in (self.folder / name).read_text().splitlines()]
        vertices, triangles = int(rows[1][0]), int(rows[1][1])
        return ([[float(x) for x in row] for row in rows[2:2 + vertices]],
                [tuple(map(int, row[1:4])) for row in rows[2 + vertices:2 + vertices + triangles]])
