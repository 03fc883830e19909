#!/usr/bin/env python3
"""examples/shell/mesh_all.sh, and what packaging/engines/batch.slurm asks of its array; slow
engines_test.py runs that on Slurm. Usage: shell_scripts_test.py path/to/morskin"""

import os
import shutil
import subprocess
from pathlib import Path

from support.command import MOLECULES, CommandTest, main, morskin

ROOT = Path(__file__).resolve().parent.parent


class ShellScript(CommandTest):
    def run_script(self, script, *words, code=0, **environment):
        done = subprocess.run(["sh", ROOT / script, *map(str, words)], cwd=self.folder, text=True,
                              capture_output=True, env={**os.environ, **environment}, check=False)
        self.assertEqual(done.returncode, code, done.stderr + done.stdout)
        return done


class MeshAll(ShellScript):
    def mesh_all(self, *words, command=None, code=0):
        box = self.folder / "bin"
        box.mkdir(exist_ok=True)
        if command:
            (box / "morskin").write_text("#!/bin/sh\n" + command)
            (box / "morskin").chmod(0o755)
        else:
            (box / "morskin").symlink_to(morskin())
        return self.run_script("examples/shell/mesh_all.sh", *words, code=code,
                               PATH=f"{box}:{os.environ['PATH']}")

    def test_what_cannot_be_meshed_is_named_and_the_others_are_meshed(self):
        shutil.copy(MOLECULES / "benzene.pdb", self.folder / "-a b.pdb")
        self.input("empty.pdb", "")
        said = self.mesh_all("out", "empty.pdb", "-a b.pdb", "nowhere.pdb", self.ring).stdout
        self.assertEqual(said.splitlines(), [
            "empty.pdb: no molecule with a smooth skin",
            "-a b.pdb: certified, and again from the file",
            "nowhere.pdb: no molecule with a smooth skin",
            "ring.xyzr: certified, and again from the file"])
        self.assertTrue((self.folder / "out/-a b.pdb.ply").exists())

    def test_a_limit_ends_no_other_molecule(self):
        said = self.mesh_all("out", "big.pdb", "small.pdb",
                             command='case "$*" in *big*) exit 6 ;; esac').stdout
        self.assertEqual(said.splitlines(), ["big.pdb: a limit was reached",
                                             "small.pdb: certified, and again from the file"])

    def test_two_molecules_of_one_name_are_refused_before_any_is_meshed(self):
        done = self.mesh_all("out", "a/x y.pdb", "b/x y.pdb", "b/z.pdb", command="exit 0", code=2)
        self.assertEqual((done.stdout, done.stderr.count("x y.pdb")), ("", 1))

    def test_an_option_in_place_of_the_folder_is_refused_with_the_usage(self):
        for words in ((), ("-d", "a.pdb"), ("--help",)):
            done = self.mesh_all(*words, command="exit 0", code=2)
            self.assertRegex(done.stderr, "^usage: mesh_all.sh FOLDER MOLECULE ...; [^\n]*\n$")
        self.mesh_all("./-d", "a.pdb", command="exit 0")
        self.assertEqual(self.names(), ["-d", "bin"])


class Slurm(ShellScript):
    def shard(self, first, last, count, number=1, code=0):
        return self.run_script("packaging/engines/batch.slurm", "a list", "out", code=code,
                               MORSKIN="echo", SLURM_ARRAY_TASK_MIN=str(first),
                               SLURM_ARRAY_TASK_MAX=str(last), SLURM_ARRAY_TASK_COUNT=str(count),
                               SLURM_ARRAY_TASK_ID=str(number))

    def test_an_array_from_1_without_a_gap_is_taken_and_no_other(self):
        self.assertIn("batch a list -o out -q --shard 3/16", self.shard(1, 16, 16, 3).stdout)
        self.assertIn("--shard 1/1", self.shard(1, 1, 1).stdout)
        for first, last, count in ((0, 15, 16), (3, 3, 1), (1, 15, 8), (1, 5, 3)):
            said = self.shard(first, last, count, first, code=2)
            self.assertIn("must be 1 to N", said.stderr)
            self.assertEqual(said.stdout, "")


if __name__ == "__main__":
    main()
