#!/usr/bin/env python3
"""Words without a command. Usage: implied_command_test.py path/to/morskin"""

import re

from support.command import CommandTest, main


class WithoutACommand(CommandTest):
    def test_a_molecule_and_an_output_are_meshed_wherever_the_options_stand(self):
        self.run_morskin("mesh", self.ring, "-o", "named.ply", "-q")
        named = (self.folder / "named.ply").read_bytes()
        for words in ([self.ring, "-o", "ring.ply", "-q"], ["-q", "--output=ring.ply", self.ring],
                      ["-oring.ply", self.ring, "-q"]):
            self.run_morskin(*words)
            self.assertEqual((self.folder / "ring.ply").read_bytes(), named)
            (self.folder / "ring.ply").unlink()

    def test_a_molecule_alone_is_described_and_the_next_step_makes_the_mesh_that_it_names(self):
        text = self.run_morskin("ring.xyzr").stdout.decode()
        self.assertIn(self.run_morskin("info", "ring.xyzr").stdout.decode(), text)
        step = re.search(r"next +morskin (.*?) writes", text).group(1)
        self.run_morskin(*step.split())
        self.assertEqual(self.names(), ["ring.ply"])

    def test_a_mesh_alone_is_checked(self):
        self.run_morskin(self.ring, "-o", "ring.ply", "-q")
        self.assertEqual(self.run_morskin("ring.ply").stdout,
                         self.run_morskin("check", "ring.ply").stdout)
        arrays = self.input("arrays.npz", "PK")
        self.assertIn(b"are only written", self.run_morskin(arrays, code=3).stderr)

    def test_a_mesh_in_place_of_a_molecule_is_told_which_command_checks_it(self):
        self.run_morskin(self.ring, "-o", "ring.ply", "-o", "ring.vert", "-q", "-C", "0.4")
        for name in ("ring.ply",):
            for words in (("mesh", name, "-o", "out.ply"), (name, "-o", "out.ply"), ("info", name)):
                said = self.run_morskin(*words, code=3).stderr.decode()
                self.assertTrue(said.endswith(f"; to check a mesh: morskin check {name}\n"), said)
        other = self.input("prose", "no molecule\n")
        self.assertNotIn(b"check", self.run_morskin("info", other, code=3).stderr)

    def test_an_input_behind_two_hyphens_is_described_or_checked_whatever_its_name(self):
        self.input("-x.xyzr", self.ring.read_bytes())
        text = self.run_morskin("--", "-x.xyzr").stdout.decode()
        self.assertIn(self.run_morskin("info", "--", "-x.xyzr").stdout.decode(), text)
        step = re.search(r"next +morskin (.*?) writes", text).group(1)
        self.run_morskin(*step.split())
        self.assertEqual(self.names(), ["-x.ply", "-x.xyzr"])
        self.assertEqual(self.run_morskin("--", "-x.ply").stdout,
                         self.run_morskin("check", "--", "-x.ply").stdout)
        said = self.run_morskin("--", "mesh", code=3).stderr  # no command there
        self.assertIn(b"mesh: cannot be opened", said)

    def test_a_word_that_is_neither_command_nor_file_is_refused_with_the_commands_listed(self):
        for words in (["mehs", self.ring], ["mehs", self.ring, "-o", "ring.ply"]):
            complaint = self.run_morskin(*words, code=2).stderr.decode()
            self.assertIn("'mehs' is neither a command nor a file", complaint)
            self.assertIn("mesh, features, morse, balls, info, check", complaint)
        self.assertEqual(self.names(), [])


if __name__ == "__main__":
    main()
