#!/usr/bin/env python3
"""Tables of radii from outside. Usage: radii_command_test.py path/to/morskin"""

import json

from support.command import MOLECULES, CommandTest, main

PDB = """\
ATOM      1  CA  ALA A   1       0.000   0.000   0.000  1.00  0.00           C
ATOM      2  CB  ALA A   1       1.500   0.000   0.000  1.00  0.00           C
ATOM      3  N   ALA A   1       0.000   1.500   0.000  1.00  0.00           N
ATOM      4  D   ALA A   1       0.000   2.500   0.000  1.00  0.00           D
"""
IRON = "HETATM    5 FE   HEM A   2       5.000   0.000   0.000  1.00  0.00          FE\n"


class Radii(CommandTest):
    def setUp(self):
        super().setUp()
        self.input("a.pdb", PDB)
        self.input("iron.pdb", PDB + IRON)

    def radii(self, *words, file="a.pdb"):
        self.run_morskin("balls", file, "-o", "balls.xyzr", "-q", *words)
        return [round(float(line.split()[3]), 9)
                for line in (self.folder / "balls.xyzr").read_text().splitlines()]

    def complaint(self, *words, code, file="a.pdb"):
        return self.run_morskin("balls", file, "-o", "b.xyzr", *words, code=code).stderr.decode()

    def test_a_radius_below_what_the_certificate_resolves_is_refused(self):
        self.input("small.xyzr", "0 0 0 1e-21\n")
        self.run_morskin("mesh", "small.xyzr", "-o", "small.ply")
        self.input("smaller.xyzr", "0 0 0 1e-22\n")
        done = self.run_morskin("mesh", "smaller.xyzr", "-o", "smaller.ply", code=4)
        self.assertIn(b"has so small a radius that nothing can be proved", done.stderr)

    def test_a_note_tells_of_a_probe_that_plays_no_part(self):
        for words in ((), ("--model", "ses-like")):
            self.assertIn("has no probe", self.complaint("--probe", "1.5", *words, code=0))
            self.assertEqual(self.complaint("--probe", "1.5", *words, "-q", code=0), "")
        self.assertEqual(self.radii("--model", "sas", "--probe", "1")[0], 2.7)
        self.assertEqual(self.complaint("--model", "sas", "--probe", "1", "-q", code=0), "")
        self.run_morskin("mesh", "a.pdb", "-o", "a.ply", "-q", "--model", "sas", "--probe", "1")
        done = self.run_morskin("check", "a.ply", "--against", "a.pdb", "--probe", "1")
        self.assertEqual(done.stderr, b"")
        self.input("list.txt", "a.pdb\n")
        done = self.run_morskin("batch", "list.txt", "-o", "all", "--features", "--probe", "1")
        self.assertIn(b"note: model ses-like has no probe", done.stderr)

    def test_a_note_names_listed_radii_that_no_atom_takes(self):
        said = self.complaint("--radii", "c=1.7,N=1.5,H=1.1,ALA:CAA=2,S=1.8", code=0)
        self.assertIn("note: a.pdb: no atom takes the radius of ALA:CAA, S\n", said)
        many = "C=1,N=1,H=1," + ",".join(f"ALA:X{i}=1" for i in range(7))
        self.assertIn("ALA:X4 and 2 more\n", self.complaint("--radii", many, code=0))
        for words in (("c=1.7,N=1.5,H=1.1,S=1.8", "-q"), ("C=1.7,N=1.5,D=1.1",), ("bondi",)):
            self.assertEqual(self.complaint("--radii", *words, code=0), "")
        radii = ("--radii", "C=1.7,N=1.5,H=1.1,ALA:CAA=2")
        self.run_morskin("mesh", "a.pdb", "-o", "a.ply", "-q", "-C", "0.3", *radii)
        for words in (("view", "a.pdb", "-o", "a.html", "-C", "0.3"), ("check", "a.ply"),
                      ("view", "a.ply", "-o", "a.html")):
            against = () if words[1] == "a.pdb" else ("--against", "a.pdb")
            done = self.run_morskin(*words, *against, *radii)
            self.assertEqual(done.stderr.decode(),
                             "morskin: note: a.pdb: no atom takes the radius of ALA:CAA\n")
        # What the file states is of its own atoms.
        done = self.run_morskin("check", "a.ply", "--against", "a.pdb")
        self.assertEqual(done.stderr, b"")

    def test_named_tables_give_the_published_radii(self):
        for words, expected in (((), [1.7, 1.7, 1.55, 1.2, 2.44]),
                                (("--radii", "elements"), [1.7, 1.7, 1.55, 1.2, 2.44]),
                                (("--radii", "alvarez"), [1.77, 1.77, 1.66, 1.2, 2.44])):
            self.assertEqual(self.radii(*words, file="iron.pdb"), expected)
        self.assertEqual(self.radii("--radii", "bondi"), [1.7, 1.7, 1.55, 1.2])
        said = self.complaint("--radii", "bondi", code=4, file="iron.pdb")
        self.assertIn('iron.pdb:5: atom FE of HEM 2 chain A (line 5) has element "Fe", for which '
                      "there is no van der Waals radius in the table", said)

    def test_a_file_gives_elements_and_atoms_radii_the_atom_first(self):
        for text in ("# mine\n C 1.5\r\nn\t1.6 # amid\r\n\r\nALA:CB 1.9\r\nH 1\n",
                     "\ufeffC 1.5\rN 1.6\rALA:CB 1.9\rH 1.0"):
            self.input("my.txt", text)
            self.assertEqual(self.radii("--radii", "my.txt"), [1.5, 1.9, 1.6, 1])
        self.assertEqual(self.radii("--radii", "C=1.5,N=1.6,ALA:CB=1.9,H=1,D=1.1"),
                         [1.5, 1.9, 1.6, 1.1])

    def test_what_begins_like_a_path_is_a_file_whatever_its_name_holds(self):
        (self.folder / "pH=7").mkdir()
        for name in ("./C=1.7,N=2", "./pH=7/my.txt", "./bondi", self.folder / "C=1"):
            (self.folder / name).write_text("C 1.5\nN 1.6\nH 1\n")
            self.assertEqual(self.radii("--radii", name), [1.5, 1.5, 1.6, 1])
        self.assertEqual(self.radii("--radii", "C=1.5,N=1.6,H=1,ALA:C/D=3"), [1.5, 1.5, 1.6, 1])

    def test_a_file_that_means_harm_is_refused_with_its_line(self):
        for line, words in (("C nan", 'C is "nan"'), ("C inf", "above 0"), ("C -1.7", "above 0"),
                            ("C 0", "above 0"), ("C 1e7", "at most 10^6"), ("C 1,7", "above 0"),
                            ("C", "is not an element or"), ("C 1.7 A", "is not an element or"),
                            ("Qq 1.7", '"Qq" is neither an element'), (":CA 1", "neither"),
                            ("ALA: 1", "neither"), ("ALA:CA:B 1", "neither"), ("6 1.7", "neither"),
                            ("N 1.9", "N has a radius already"), ("n 1.55", "already"),
                            ("C=1.7", "is not an element or"), ("C \0", "above 0")):
            with self.subTest(line):
                self.input("my.txt", f"# mine\r\nN 1.55\r\n{line}\r\n")
                said = self.complaint("--radii", "my.txt", code=3)
                self.assertIn("my.txt:3: ", said)
                self.assertIn(words, said)
        self.input("my.txt", "# nothing\n\n")
        self.assertIn("has no radius", self.complaint("--radii", "my.txt", code=3))
        self.assertIn("no such file.txt", self.complaint("--radii", "no such file.txt", code=3))
        self.assertNotIn("b.xyzr", self.names())

    def test_a_list_that_is_wrong_is_wrong_usage(self):
        for text in ("C=nan", "C=1.7,C=1.8", "Qq=1", "C=", "=1", "C=1.7,", "C=1.7,N", ""):
            with self.subTest(text):
                self.assertIn("--radii", self.complaint("--radii", text, code=2))

    def test_an_atom_that_the_table_lacks_is_named(self):
        said = self.complaint("--radii", "C=1.7,H=1", code=4)
        self.assertIn("a.pdb:3: atom N of ALA 1 chain A", said)

    def test_a_table_takes_the_place_of_a_file_s_radii_where_it_tells_elements(self):
        self.input("a.pqr", "ATOM 1 CA ALA 1 0 0 0 0.1 2.5\nATOM 2 N ALA 1 1.5 0 0 -0.1 2.6\n")
        self.assertEqual(self.radii(file="a.pqr"), [2.5, 2.6])
        self.assertEqual(self.radii("--radii", "bondi", file="a.pqr"), [1.7, 1.55])
        self.assertIn("does not tell elements",
                      self.complaint("--radii", "bondi", code=4, file=self.ring))

    def test_a_mesh_says_its_radii_and_check_and_view_take_them_from_there(self):
        self.input("my.txt", "C 1.5\nN 1.6\nALA:CB 1.9\nH 1.25\nO 1.4\n")
        for radii, stated in (("alvarez", "alvarez"), ("my.txt", "ALA:CB=1.9,C=1.5,H=1.25,N=1.6")):
            with self.subTest(radii):
                report = self.mesh_json("a.pdb", "-o", "m.ply", "--radii", radii)
                self.assertEqual(report["radii"], stated)
                self.assertIn(b"comment morskin: radii " + stated.replace("=", "%3D").replace(
                    ":", "%3A").encode() + b"\n", (self.folder / "m.ply").read_bytes())
                checked = self.check("m.ply", "--against", "a.pdb")
                self.assertTrue(checked["certified"])
                self.assertIn("radii", checked["origin"]["taken"])
                self.check("m.ply", "--against", "a.pdb", "--radii", "elements", code=5)
                shown = self.run_morskin("view", "m.ply", "--against", "a.pdb", "-o", "m.html")
                self.assertRegex(shown.stdout, rb"(?m)^certified")  # and not "not certified"
                self.assertIn(f'"radii": "{stated}"', (self.folder / "m.html").read_text())

    def test_a_mesh_file_does_not_make_check_read_another_file(self):
        self.run_morskin("mesh", "a.pdb", "-o", "m.ply", "-q")
        self.input("my.txt", "C 1.5\nN 1.6\nH 1.25\n")
        mesh = (self.folder / "m.ply").read_bytes()
        self.assertIn(b"radii elements", mesh)
        for value in (b"my.txt", b"C%3Dnan", b"/dev/zero"):
            self.input("forged.ply", mesh.replace(b"radii elements", b"radii " + value))
            origin = self.check("forged.ply", "--against", "a.pdb")["origin"]
            self.assertNotIn("radii", origin["taken"])
            self.assertTrue(any(why.startswith("radii: ") for why in origin["not_taken"]))

    def test_radii_of_an_unknown_name_are_told_which_there_are(self):
        said = self.complaint("--radii", "united", code=3)
        self.assertIn("united: there are no such radii, and no such file; take elements,", said)

    def test_a_batch_without_its_table_makes_no_rows_that_blame_molecules(self):
        self.input("bad.txt", "C one\n")
        for table in ("missing.txt", "bad.txt"):
            said = self.run_morskin("batch", "a.pdb", "-o", "out", "--radii", table, code=3).stderr
            self.assertIn(table.encode(), said)
            self.assertFalse((self.folder / "out").exists())

    def test_no_output_replaces_the_radii(self):
        self.input("my.off", "C 1.5\nN 1.6\nH 1.25\n")
        said = self.run_morskin("mesh", "a.pdb", "-o", "my.off", "--radii", "my.off", code=2)
        self.assertIn(b"would replace the radii", said.stderr)

    def test_check_takes_the_table_that_was_given_for_a_file_with_radii(self):
        text = "ATOM 1 CA ALA 1 0 0 0 0.1 1.9\nATOM 2 CB ALA 1 1.5 0 0 0.1 1.8\n"
        self.input("a.pqr", text)
        for words, is_taken in ((("--radii", "elements"), True), ((), False)):
            self.run_morskin("mesh", "a.pqr", "-o", "m.ply", "-q", "-C", "0.3", *words)
            for name in ("a.pqr", "-"):
                told = self.run_morskin("check", "m.ply", "--against", name, "--json",
                                        input=text.encode())
                self.assertEqual("radii" in json.loads(told.stdout)["origin"]["taken"], is_taken)

    def test_info_names_the_table(self):
        self.assertIn(b"of the table bondi",
                      self.run_morskin("info", "a.pdb", "--radii", "bondi").stdout)
        told = json.loads(self.run_morskin("info", self.ring, "--json").stdout)
        self.assertEqual(told["radii"], "input")
        self.assertIn(b"of the table elements",
                      self.run_morskin("info", MOLECULES / "benzene.pdb").stdout)


if __name__ == "__main__":
    main()
