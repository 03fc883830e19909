#!/usr/bin/env python3
"""Selections of a file's atoms, from outside. Usage: selection_command_test.py path/to/morskin"""

import json

from support.command import CommandTest, main
from support.pdb_texts import ATOMS, MODELS


class Selections(CommandTest):
    def setUp(self):
        super().setUp()
        self.input("two.pdb", MODELS)

    def info(self, *words):
        return json.loads(self.run_morskin("info", "two.pdb", *words, "--json").stdout)

    def complaint(self, *words, code, file="two.pdb"):
        return self.run_morskin("info", file, *words, code=code).stderr.decode()

    def test_each_option_leaves_out_what_it_says_and_counts_it(self):
        whole = self.info()
        self.assertEqual((whole["atoms"], whole["skipped"]), (5, 2))
        self.assertNotIn("selection", whole)
        for words, atoms, reason, count in (
                (("--chain", "A"), 3, "skipped_other_chains", 3),
                (("--chain", "A,B"), 5, "skipped_other_chains", 0),
                (("--hydrogens", "drop"), 4, "skipped_hydrogens", 1),
                (("--hetatm", "none"), 4, "skipped_hetatms", 1),
                (("--hetatm", "SO4"), 5, "skipped_hetatms", 0),
                (("--altloc", "all"), 6, "skipped_alternates", 0),
                (("--altloc", "A"), 5, "skipped_alternates", 1),
                (("--waters", "--hetatm", "none"), 5, "skipped_waters", 0),
                (("--model-number", "4"), 3, "skipped_models", 1)):
            with self.subTest(words):
                info = self.info(*words)
                self.assertEqual((info["atoms"], info[reason]), (atoms, count))
                self.assertIn("selection", info)

    def test_the_defaults_change_nothing_when_they_are_spelt_out(self):
        spelt = self.info("--altloc", "likeliest", "--hydrogens", "keep", "--hetatm", "all")
        self.assertEqual(spelt, self.info())

    def test_the_report_states_the_selection_and_what_it_left_out(self):
        words = ("two.pdb", "-o", "two.ply", "--chain", "A", "--altloc", "A", "--hydrogens", "drop",
                 "--hetatm", "none", "--model-number", "1")
        report = self.mesh_json(*words)
        self.assertTrue(report["certified"])
        self.assertEqual(report["selection"],
                         {"model_number": 1, "chain": ["A"], "hetatm": "none", "altloc": "A",
                          "hydrogens": "drop"})
        self.assertEqual(report["atoms_used"], 2)
        self.assertEqual(report["atoms_skipped_by_reason"],
                         {"other_chains": 3, "waters": 0, "hetatms": 0, "alternates": 1,
                          "hydrogens": 1, "zero_radii": 0, "unknown_elements": 0})
        self.assertEqual(report["atoms_skipped"], 5)
        people = self.run_morskin("mesh", *words).stdout.decode()
        self.assertIn("5 left out (3 of other chains, 1 in alternate locations, 1 of hydrogen)",
                      people)

    def test_the_mesh_of_a_chain_is_that_of_a_file_with_nothing_else(self):
        self.input("a.pdb", "".join(line for line in ATOMS.splitlines(True) if line[21] == "A"))
        self.run_morskin("mesh", "a.pdb", "-o", "alone.ply", "-q")
        self.run_morskin("mesh", "two.pdb", "--chain", "A", "-o", "chosen.ply", "-q")
        self.assertEqual(self.without_origin("alone.ply"), self.without_origin("chosen.ply"))

    def test_a_mesh_is_checked_against_the_selection_that_it_was_made_of(self):
        self.run_morskin("mesh", "two.pdb", "--chain", "A", "-o", "a.ply", "-q")
        checked = self.check("a.ply", "--against", "two.pdb", "--chain", "A")
        self.assertEqual(checked["selection"], {"chain": ["A"]})
        self.assertEqual(self.check("a.ply", "--against", "two.pdb")["selection"],
                         {"chain": ["A"]})
        self.forget_origin("a.ply")
        self.check("a.ply", "--against", "two.pdb", code=5)
        self.run_morskin("balls", "two.pdb", "--chain", "A", "-o", "a.xyzr")
        self.assertEqual(len((self.folder / "a.xyzr").read_text().splitlines()), 3)
        self.run_morskin("morse", "two.pdb", "--chain", "A", "-o", "a.json", "-q")
        self.run_morskin("view", "a.ply", "--against", "two.pdb", "--chain", "A", "-o", "a.html",
                         "-q")

    def test_what_the_file_does_not_have_is_refused_and_what_it_has_is_named(self):
        self.assertIn("has no chain C; choose from A, B", self.complaint("--chain", "A,C", code=4))
        self.assertIn("residue XYZ; choose from SO4", self.complaint("--hetatm", "XYZ", code=4))
        self.assertIn("has no model 2; choose from 1 to 4",
                      self.complaint("--model-number", "2", code=4))
        self.assertIn("does not tell an atom's chain",
                      self.complaint("--chain", "A", code=4, file="ring.xyzr"))

    def test_a_selection_of_nothing_is_refused_with_the_reason(self):
        self.input("dry.pdb", ATOMS.splitlines(True)[5])
        self.assertIn("no atom is left without the HETATM records",
                      self.complaint("--hetatm", "none", code=4, file="dry.pdb"))

    def test_a_value_that_no_option_takes_is_wrong_usage(self):
        for words in (("--chain", ""), ("--chain", "A,"), ("--chain", "A, B"),
                      ("--altloc", "AB"), ("--altloc", "first"), ("--altloc", "?"),
                      ("--hydrogens", "no"), ("--hetatm", "SO4,,LIG"), ("--hetatm", "HOH"),
                      ("--model-number=-1",), ("--model-number", "1-3"),
                      ("--model-number", "1.5"), ("--model-number", "+1")):
            with self.subTest(words):
                self.assertIn("see morskin --help", self.complaint(*words, code=2))

    def test_info_tells_which_model_was_read(self):
        self.assertIn(b"the first of 2", self.run_morskin("info", "two.pdb").stdout)
        self.assertIn(b"number 4 of 2",
                      self.run_morskin("info", "two.pdb", "--model-number", "4").stdout)

    def test_help_states_every_default(self):
        text = self.run_morskin("mesh", "--help").stdout.decode()
        for option, default in (("--model-number", "[the first]"), ("--chain", "[all chains]"),
                                ("--hetatm", "[all]"), ("--altloc", "[likeliest]"),
                                ("--hydrogens", "[keep]"), ("--biological-assembly", "[none]"),
                                ("--radii", "[elements or INPUT's]"), ("--probe", "[1.4]")):
            line = next(line for line in text.splitlines() if option + " " in line)
            self.assertIn(default, line)


if __name__ == "__main__":
    main()
