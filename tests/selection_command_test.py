#!/usr/bin/env python3
"""Selections of a file's atoms, from outside. Usage: selection_command_test.py path/to/morskin"""

import json

from support.command import CommandTest, main
from support.pdb_texts import ASSEMBLY, ATOMS, MODELS


class Selections(CommandTest):
    def setUp(self):
        super().setUp()
        self.input("two.pdb", MODELS)

    def info(self, *words):
        return json.loads(self.run_morskin("info", "two.pdb", *words, "--json").stdout)

    def complaint(self, *words, code, file="two.pdb"):
        return self.run_morskin("info", file, *words, code=code).stderr.decode()

    def test_an_option_without_its_value_or_given_twice_is_told_so(self):
        for words, told in (("--chain A --chain B", "--chain is given more than once"),
                            ("-C 0.1 -C 0.1", "-C is given more than once"),
                            ("--radii", "--radii wants a value"), ("--probe", "--probe wants a")):
            said = self.run_morskin("mesh", "a.pdb", "-o", "m.ply", *words.split(), code=2).stderr
            self.assertIn(f"morskin: {told}".encode(), said)

    def test_thousands_of_atoms_left_out_are_parted_by_commas_as_those_used_are(self):
        line = "{}{:5}  O   {} A   1    {:8}   0.000   0.000  1.00  0.00           O\n"
        waters = "".join(line.format("HETATM", k, "HOH", f"{k}.000") for k in range(1, 1235))
        self.input("wet.pdb", line.format("ATOM  ", 0, "GLY", "0.000") + waters)
        self.assertIn(b"left out    1,234 of water\n", self.run_morskin("info", "wet.pdb").stdout)

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

    def test_what_has_no_radius_or_no_element_is_counted_as_that_and_nothing_else(self):
        water = "ATOM 3 O HOH A 2 9 0 0 -0.8 1.5\n"
        self.input("zero.pqr", "ATOM 1 N ALA A 1 0 0 0 0.1 1.5\nATOM 2 H ALA A 1 1 0 0 0.1 0\n" +
                   water)
        unknown = "HETATM    8  UNK UNX A   9      20.000   0.000   0.000  1.00  0.00           X"
        self.input("unknown.pdb", ATOMS[:ATOMS.index("ATOM      5")] + unknown + "\n")
        for file, counts, words in (
                ("zero.pqr", {"waters": 1, "zero_radii": 1}, "1 of water, 1 of radius 0"),
                ("unknown.pdb", {"alternates": 1, "unknown_elements": 1},
                 "1 in alternate locations, 1 of unknown element")):
            told = json.loads(self.run_morskin("info", file, "--json").stdout)
            made = self.mesh_json(file, "-o", "m.ply", "-C", "0.4")["atoms_skipped_by_reason"]
            self.assertEqual({reason: count for reason, count in made.items() if count}, counts)
            self.assertEqual({reason: told[f"skipped_{reason}"] for reason in made}, made)
            self.assertIn(f" {words}\n", self.run_morskin("info", file).stdout.decode())

    def balls(self, name, text, *words):
        """Places along x and radii of what is read of a file."""
        self.input(name, text)
        self.run_morskin("balls", name, "-o", "out.xyzr", *words)
        rows = [line.split() for line in (self.folder / "out.xyzr").read_text().splitlines()
                if not line.startswith("#")]
        return [(float(row[0]), float(row[3])) for row in rows]

    def test_pqr_numbers_may_stick_to_the_word_before(self):
        text = ("ATOM   99999  N   MET A 999    0.0 0.0 0.0  0.1 1.5\n"
                "ATOM100000  N   MET A1000    9.0 0.0 0.0  0.1 1.6\n"
                "HETATM10001  O   MET B   1    20.0 0.0 0.0  0.1 1.7\n")
        self.assertEqual(self.balls("stuck.pqr", text), [(0, 1.5), (9, 1.6), (20, 1.7)])
        self.assertEqual(self.balls("stuck.pqr", text, "--chain", "A"), [(0, 1.5), (9, 1.6)])

    def test_heavy_elements_are_read_from_names_that_have_no_columns(self):
        self.input("heavy.pqr", "HETATM 1 FE HEM A 1 0 0 0 2 1\nHETATM 2 NA HEM A 1 5 0 0 0 1\n"
                                "ATOM 3 SE MSE A 3 9 0 0 0 1\nATOM 4 CA MSE A 3 13 0 0 0 1\n"
                                "HETATM 5 CL1 LIG A 4 17 0 0 0 1\nHETATM 6 MG ATP A 5 21 0 0 0 1\n"
                                "ATOM 7 CD1 LEU A 6 25 0 0 0 1\nATOM 8 HG SER A 7 29 0 0 0 1\n")
        elements = json.loads(self.run_morskin("info", "heavy.pqr", "--json").stdout)["elements"]
        self.assertEqual(elements, {"C": 2, "Cl": 1, "Fe": 1, "H": 1, "Mg": 1, "N": 1, "Se": 1})

    def test_a_location_without_a_letter_is_one_of_several(self):
        line = "ATOM      {} {:<4}{}ALA A   1    {:8.3f}   0.000   0.000{:6.2f}  0.00           C\n"
        text = (line.format(1, " CA", " ", 0, 0.6) + line.format(2, " CA", "B", 0.5, 0.4) +
                line.format(3, " CB", " ", 3, 1))
        for words, places in (((), [0, 3]), (("--altloc", "B"), [0.5, 3]),
                              (("--altloc", "all"), [0, 0.5, 3])):
            found = self.balls("blank.pdb", text, *words)
            self.assertEqual([x for x, _ in found], places)

    def test_a_note_tells_of_a_location_that_no_atom_has(self):
        self.assertIn("note: two.pdb: no atom has a location C",
                      self.complaint("--altloc", "C", code=0))
        self.assertEqual(self.complaint("--altloc", "A", code=0), "")

    def test_models_of_one_number_are_refused_where_all_are_asked_for(self):
        atom = "ATOM      1  CA  ALA A   1    {:8.3f}   0.000   0.000  1.00  0.00           C\n"
        self.input("twice.pdb", "".join(f"MODEL        1\n{atom.format(x)}ENDMDL\n"
                                        for x in (0, 9)))
        words = ("mesh", "twice.pdb", "-o", "out.ply", "-C", "0.3")
        self.assertIn(b"two of its models have the number 1",
                      self.run_morskin(*words, "--model-number", "all", code=4).stderr)
        self.run_morskin(*words, "--model-number", "1")

    def test_of_several_data_blocks_the_first_is_read_and_the_others_are_told(self):
        columns = ("group_PDB", "type_symbol", "label_atom_id", "Cartn_x", "Cartn_y", "Cartn_z")
        block = "data_{}\nloop_\n" + "".join(f"_atom_site.{c}\n" for c in columns)
        self.input("two.cif", "".join(block.format(name) + f"ATOM C CA {x} 0 0\n"
                                      for name, x in (("A", 0), ("B", 9))))
        self.assertIn(b"the first of 2", self.run_morskin("info", "two.cif").stdout)
        words = ("mesh", "two.cif", "-o", "out.ply", "-C", "0.3")
        self.assertIn(b"in several data blocks",
                      self.run_morskin(*words, "--model-number", "all", code=4).stderr)
        self.assertIn(b"its only one is number 1; those of later data blocks cannot be read",
                      self.run_morskin(*words, "--model-number", "2", code=4).stderr)
        self.run_morskin(*words, "--model-number", "1")

    def cif(self, *atoms):
        keys = ("group_PDB", "type_symbol", "label_atom_id", "label_comp_id", "label_asym_id",
                "label_seq_id", "Cartn_x", "Cartn_y", "Cartn_z")
        return "".join(["data_a\nloop_\n", *(f"_atom_site.{key}\n" for key in keys),
                        *(f"ATOM C {name} ALA {chain} 1 {x} 0 0\n" for name, chain, x in atoms)])

    def test_names_that_differ_only_beyond_what_is_kept_are_refused(self):
        for atoms in ((("C1", "Heavychain1", 0), ("C1", "Heavychain2", 9)),
                      (("CARBON_A1", "A", 0), ("CARBON_A2", "A", 9))):
            self.input("long.cif", self.cif(*atoms))
            complaint = self.complaint(code=4, file="long.cif")
            self.assertIn("differ only behind their 8th character", complaint)
        self.assertEqual(len(self.balls("long.cif", self.cif(("C1", "Heavychain1", 0)),
                                        "--chain", "Heavychain1")), 1)

    def test_an_assembly_is_of_the_block_that_the_atoms_are_of(self):
        moves = "".join(f"_pdbx_struct_oper_list.{key} {value}\n" for key, value in [
            ("id", 1), *((f"matrix[{i}][{j}]", int(i == j)) for i in (1, 2, 3) for j in (1, 2, 3)),
            ("vector[1]", 50), ("vector[2]", 0), ("vector[3]", 0)])
        assembly = ("_pdbx_struct_assembly_gen.assembly_id 1\n"
                    "_pdbx_struct_assembly_gen.oper_expression 1\n"
                    "_pdbx_struct_assembly_gen.asym_id_list A\n" + moves)
        block = self.cif(("C1", "A", 0)) + assembly
        other, without_atoms = block.replace("data_a", "data_b"), self.cif()
        for text in (block + other, without_atoms + other, block + without_atoms + other):
            found = self.balls("two.cif", text.replace("data_a", "data_c", 1),
                               "--biological-assembly", "1")
            self.assertEqual([x for x, _ in found], [50])

    def test_the_defaults_change_nothing_when_they_are_spelt_out(self):
        spelt = self.info("--altloc", "likeliest", "--hydrogens", "keep", "--hetatm", "all")
        self.assertEqual(spelt, self.info())

    def test_a_morse_smale_complex_states_the_selection(self):
        for words, stated in (((), None), (("--chain", "A", "--hydrogens", "drop"),
                                           {"chain": ["A"], "hydrogens": "drop"})):
            self.run_morskin("morse", "two.pdb", "-o", "two.json", "-q", *words)
            told = json.loads((self.folder / "two.json").read_text())
            self.assertEqual(told.get("selection"), stated)

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

    def test_each_option_of_a_selection_is_taken_from_the_mesh(self):
        self.input("two.pdb", ASSEMBLY + MODELS)
        each = (("chain", "B"), ("hetatm", "none"), ("altloc", "A"), ("altloc", "all"),
                ("hydrogens", "drop"), ("waters", None), ("model-number", "4"),
                ("biological-assembly", "1"))
        for option, value in each:
            with self.subTest(option, value=value):
                words = [f"--{option}"] + ([value] if value else [])
                made = self.mesh_json("two.pdb", "-o", "m.ply", "-C", "0.4", *words)
                checked = self.check("m.ply", "--against", "two.pdb")
                self.assertIn(option, checked["origin"]["taken"])
                self.assertEqual(checked["selection"], made["selection"])
                self.forget_origin("m.ply")
                self.check("m.ply", "--against", "two.pdb", "-C", "0.4", code=5)
                self.check("m.ply", "--against", "two.pdb", "-C", "0.4", *words)

    def test_what_the_file_does_not_have_is_refused_and_what_it_has_is_named(self):
        self.assertIn("has no chain C; choose from A, B", self.complaint("--chain", "A,C", code=4))
        self.assertIn("residue XYZ; choose from SO4", self.complaint("--hetatm", "XYZ", code=4))
        self.assertIn("has no model 2; choose from 1, 4",
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
                self.assertIn("see morskin info --help", self.complaint(*words, code=2))

    def test_info_tells_which_model_was_read(self):
        self.assertIn(b"the first of 2", self.run_morskin("info", "two.pdb").stdout)
        self.assertIn(b"number 4 of 2",
                      self.run_morskin("info", "two.pdb", "--model-number", "4").stdout)

    def test_the_report_of_a_mesh_tells_that_it_is_of_one_model_of_several(self):
        words = ("two.pdb", "-o", "two.ply", "-C", "0.4")
        for more, told in (((), b"models      the first of 2\n"),
                           (("--model-number", "4"), b"models      number 4 of 2\n")):
            with self.subTest(more):
                self.assertIn(told, self.run_morskin("mesh", *words, *more).stdout)
                self.assertEqual(self.mesh_json(*words, *more)["models_skipped"], 1)
        only = ("ring.xyzr", "-o", "ring.ply", "-C", "0.4")
        self.assertNotIn(b"models", self.run_morskin("mesh", *only).stdout)
        self.assertEqual(self.mesh_json(*only)["models_skipped"], 0)

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
