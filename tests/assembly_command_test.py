#!/usr/bin/env python3
"""Biological assemblies from outside, against coordinates computed here.
Usage: assembly_command_test.py path/to/morskin"""

import csv
import gzip
import re
import resource

from support.command import MOLECULES, CommandTest, main
from support.motions import IDENTITY, after, icosahedral, moved, turned


def remark_350(motions, chains="A", name="1"):
    lines = [f"REMARK 350 BIOMOLECULE: {name}",
             f"REMARK 350 APPLY THE FOLLOWING TO CHAINS: {chains}"]
    for number, (rotation, shift) in enumerate(motions, 1):
        for row in range(3):
            numbers = "".join(f"{x:10.6f}" for x in rotation[row])
            lines.append(f"REMARK 350   BIOMT{row + 1} {number:3d}{numbers}     {shift[row]:10.5f}")
    return "\n".join(lines) + "\n"


def cif(atoms, operators, generators):
    """@param atoms  (label chain, author's chain, element, x, y, z)"""
    lines = ["data_test", "loop_", "_pdbx_struct_assembly_gen.assembly_id",
             "_pdbx_struct_assembly_gen.oper_expression", "_pdbx_struct_assembly_gen.asym_id_list"]
    lines += [f"{name} '{expression}' {chains}" for name, expression, chains in generators]
    lines += ["loop_", "_pdbx_struct_oper_list.id"]
    lines += [f"_pdbx_struct_oper_list.matrix[{r}][{c}]" for r in "123" for c in "123"]
    lines += [f"_pdbx_struct_oper_list.vector[{r}]" for r in "123"]
    for name, (rotation, shift) in operators.items():
        lines.append(" ".join([name, *(repr(float(x)) for row in rotation for x in row),
                               *(repr(float(x)) for x in shift)]))
    lines += ["loop_", *(f"_atom_site.{tag}" for tag in (
        "label_asym_id", "auth_asym_id", "type_symbol", "Cartn_x", "Cartn_y", "Cartn_z"))]
    lines += [" ".join(map(str, atom)) for atom in atoms]
    return "\n".join(lines) + "\n"


def pdb_atoms(text, waters=False):
    return [[float(line[k:k + 8]) for k in (30, 38, 46)] for line in text.splitlines()
            if line.startswith(("ATOM  ", "HETATM")) and (waters or line[17:20] != "HOH")]


class Assemblies(CommandTest):
    def positions(self, file, *words, code=0, **options):
        done = self.run_morskin("balls", file, "-o", "balls.xyzr", "-q", *words, code=code,
                                **options)
        if code:
            return done.stderr.decode()
        return [list(map(float, line.split()[:3]))
                for line in (self.folder / "balls.xyzr").read_text().splitlines()]

    def check(self, found, expected, digits=9):
        self.assertEqual(len(found), len(expected))
        for x, y in zip(found, expected):
            for a, b in zip(x, y):
                self.assertAlmostEqual(a, b, places=digits)

    def two_fold(self):
        """A strand of DNA and the rotation that its own file says makes the other."""
        text = (MOLECULES / "9dna.pdb").read_text()
        number = r" +(-?\d+\.\d+)"
        rows = [list(map(float, numbers))
                for numbers in re.findall("^REMARK   4" + 4 * number, text, re.M)]
        self.assertEqual(len(rows), 3)
        motion = [row[:3] for row in rows], [row[3] for row in rows]
        again = after(motion, motion)
        self.check([*again[0], again[1]], [*IDENTITY[0], IDENTITY[1]])
        return text, motion

    def test_a_two_fold_axis_makes_the_second_strand_in_pdb_and_in_mmcif(self):
        text, motion = self.two_fold()
        self.input("dna.pdb", remark_350([IDENTITY, motion]) + text)
        strand = pdb_atoms(text)
        expected = [moved(m, x) for m in (IDENTITY, motion) for x in strand]
        self.check(self.positions("dna.pdb"), strand)
        self.check(self.positions("dna.pdb", "--biological-assembly", "1"), expected)
        self.input("dna.cif", cif([("X", "A", "C", *x) for x in strand],
                                  {"1": IDENTITY, "2": motion}, [("PAU", "1,2", "X")]))
        self.check(self.positions("dna.cif", "--biological-assembly", "PAU"), expected)

    def test_the_capsid_of_2buk_has_sixty_copies_where_its_operators_put_them(self):
        name = MOLECULES / "2buk.pdb.gz"
        text = gzip.decompress(name.read_bytes()).decode()
        rows = [list(map(float, line[23:].split())) for line in text.splitlines()
                if line.startswith("REMARK 350   BIOMT")]
        motions = [([row[:3] for row in rows[i:i + 3]], [row[3] for row in rows[i:i + 3]])
                   for i in range(0, len(rows), 3)]
        self.assertEqual(len(motions), 60)
        words = ("--hetatm", "none")
        unit = self.positions(name, *words)
        self.check(unit, [x for x in pdb_atoms("\n".join(
            line for line in text.splitlines() if line.startswith("ATOM  ")))])
        self.check(self.positions(name, "--biological-assembly", "1", *words),
                   [moved(m, x) for m in motions for x in unit])

    def test_products_of_operators_of_an_icosahedral_capsid_are_taken_from_the_right(self):
        rotations = icosahedral()
        self.assertEqual(len(rotations), 60)
        frame = (turned((1, 2, 3), 40)[0], [3.0, -2.0, 5.0])
        operators = {str(i): m for i, m in enumerate(rotations, 1)} | {"P": frame, "X0": IDENTITY}
        atoms = [("A", "P1", "C", 30.0, 2.0, 1.0), ("B", "P1", "O", 31.2, 2.0, 1.0),
                 ("C", "Q", "N", 0.0, 40.0, 3.0)]
        self.input("capsid.cif", cif(atoms, operators, [
            ("1", "(1-60)", "A,B"), ("2", "(P)(1-60)", "A,B"), ("3", "(1-60)(P)", "A"),
            ("4", "1,2", "A"), ("4", "(X0)(3-4,7)", "C")]))
        at = [list(atom[3:]) for atom in atoms]
        for name, expected in (
                ("1", [moved(m, x) for m in rotations for x in at[:2]]),
                ("2", [moved(after(frame, m), x) for m in rotations for x in at[:2]]),
                ("3", [moved(after(m, frame), at[0]) for m in rotations]),
                ("4", [moved(rotations[0], at[0]), moved(rotations[1], at[0]),
                       *(moved(rotations[k], at[2]) for k in (2, 3, 6))])):
            with self.subTest(name):
                self.check(self.positions("capsid.cif", "--biological-assembly", name), expected)

    def test_a_range_of_operators_may_end_at_the_largest_number(self):
        shift = ([*IDENTITY[0]], [0, 0, 50])
        last = 2 ** 63 - 1
        self.input("last.cif", cif([("A", "A", "C", 1, 2, 3)],
                                   {str(last - 1): IDENTITY, str(last): shift},
                                   [("1", f"{last - 1}-{last}", "A")]))
        self.check(self.positions("last.cif", "--biological-assembly", "1"),
                   [[1, 2, 3], [1, 2, 53]])

    def test_chains_of_copies_stay_apart_and_a_ligand_stays_with_its_protein(self):
        def names(file, *words):
            self.run_morskin("mesh", file, "-o", "m.ply", "-q", "-C", "0.3", "--areas", "a.csv",
                             "--biological-assembly", "1", *words)
            with open(self.folder / "a.csv", newline="", encoding="ascii") as table:
                return [row["chain"] for row in csv.DictReader(table) if row["of"] == "atom"]

        shift = ([*IDENTITY[0]], [0, 0, 50])
        atoms = [("A", "A", "C", 0, 0, 0), ("B", "A", "O", 1.2, 0, 0), ("C", "Q", "N", 9, 0, 0)]
        generators = [("1", "1,2", "A,B,C")]
        self.input("a.cif", cif(atoms, {"1": IDENTITY, "2": shift}, generators))
        self.assertEqual(names("a.cif"), ["A", "A", "Q", "A-2", "A-2", "Q-2"])
        self.assertEqual(names("a.cif", "--chain", "A"), ["A", "A", "A-2", "A-2"])
        # The ligand only in the second copy; the same motion twice makes nothing twice.
        self.input("b.cif", cif(atoms, {"1": IDENTITY, "2": shift},
                                [("1", "1,2", "A"), ("1", "2,2", "A,B")]))
        self.assertEqual(names("b.cif"), ["A", "A-2", "A-2"])
        report = self.mesh_json("b.cif", "-o", "m.ply", "--biological-assembly", "1", "-C", "0.3")
        self.assertEqual(report["atoms_skipped_by_reason"]["other_chains"], 1)
        # A chain that looks like a copy.
        self.input("c.cif", cif([*atoms[:1], ("D", "A-2", "C", 9, 9, 0)],
                                {"1": IDENTITY, "2": shift}, [("1", "1,2", "A,D")]))
        self.assertEqual(names("c.cif"), ["A", "A-2", "A_2", "A-2_2"])

    def test_a_mesh_of_an_assembly_is_checked_against_it_and_its_report_says_so(self):
        text, motion = self.two_fold()
        dna = self.input("dna.pdb", remark_350([IDENTITY, motion]) + text)
        report = self.mesh_json(dna, "-o", "m.ply", "-C", "0.3", "--biological-assembly", "1")
        self.assertTrue(report["certified"])
        self.assertEqual(report["selection"], {"biological_assembly": "1"})
        self.assertEqual(report["atoms_used"], 2 * len(pdb_atoms(text)))
        checked = super().check("m.ply", "--against", dna)
        self.assertTrue(checked["certified"])
        self.assertIn("biological-assembly", checked["origin"]["taken"])

    def test_what_a_file_does_not_tell_is_refused_with_what_it_has(self):
        text, motion = self.two_fold()
        self.input("dna.pdb", remark_350([IDENTITY, motion]) + remark_350(
            [IDENTITY], name="2") + text)
        asked = ("--biological-assembly", "3")
        self.assertIn('has no biological assembly "3"; choose from 1, 2',
                      self.positions("dna.pdb", *asked, code=4))
        self.assertIn("tells of no biological assembly",
                      self.positions(self.input("plain.pdb", text), *asked, code=4))
        self.assertIn("only PDB and mmCIF", self.positions(self.ring, *asked, code=4))
        self.assertIn("none of the atoms that are selected", self.positions(self.input(
            "z.pdb", remark_350([IDENTITY], "Z") + text), "--biological-assembly", "1", code=4))
        self.positions("dna.pdb", "--biological-assembly", "", code=2)

    def test_operators_that_are_no_motions_or_too_many_are_refused(self):
        text, _ = self.two_fold()
        flat = ([[1, 0, 0], [0, 1, 0], [0, 0, 0]], [0, 0, 0])
        mirror = ([[1, 0, 0], [0, 1, 0], [0, 0, -1]], [0, 0, 0])
        asked = ("--biological-assembly", "1")
        for motion, determinant in ((flat, "0"), (mirror, "-1")):
            self.input("bad.pdb", remark_350([IDENTITY, motion]) + text)
            self.assertRegex(self.positions("bad.pdb", *asked, code=4),
                             f"bad.pdb:8: .* no rotation with a shift, its determinant is "
                             f"{determinant};")
            atoms = [("A", "A", "C", 0, 0, 0)]
            self.input("bad.cif", cif(atoms, {"1": motion}, [("1", "1", "A")]))
            self.assertIn("no rotation", self.positions("bad.cif", *asked, code=4))
        self.input("bad.pdb", remark_350([IDENTITY, (IDENTITY[0], [0, float("nan"), 0])]) + text)
        said = self.positions("bad.pdb", *asked, code=4)
        self.assertRegex(said, "bad.pdb:8: .* it has a number that is not finite;")
        many = {str(i): ([*IDENTITY[0]], [i, 0, 0]) for i in range(60)}
        for expression, code, words in (
                ("(0-59)(0-59)(0-59)", 4, "more than 100,000 copies"),
                ("(0-999999999999)", 3, 'names an operator "60"'), ("(0-5", 3, "closing bracket"),
                ("", 3, "is empty"), ("(1)(Q)", 3, 'operator "Q"'), ("1,,2", 3, 'operator ""')):
            with self.subTest(expression):
                self.input("many.cif", cif(atoms, many, [("1", expression, "A")]))
                self.assertIn(words, self.positions("many.cif", *asked, code=code))
        self.input("far.cif", cif(atoms, {"1": ([*IDENTITY[0]], [2e6, 0, 0])}, [("1", "1", "A")]))
        self.assertIn("10^6 Angstrom", self.positions("far.cif", *asked, code=4))
        self.input("long.cif", cif([("A", "LONGNAME", "C", 0, 0, 0)], many, [("1", "1,2", "A")]))
        self.assertIn("more than 8 characters", self.positions("long.cif", *asked, code=4))

    def test_copies_are_limited_for_all_parts_of_an_assembly_together(self):
        text, _ = self.two_fold()
        many = {str(i): ([*IDENTITY[0]], [i, 0, 0]) for i in range(60)}
        atoms = [("A", "A", "C", 0, 0, 0), ("B", "B", "C", 0, 0, 0)]
        half = "(0-59)(0-59)(0-13)"  # 50,400 copies
        self.input("many.cif", cif(atoms, many, [("1", half, "A"), ("1", half, "B")]))
        self.input("many.pdb", 2 * remark_350(50_001 * [IDENTITY]) + text)
        for name, words in (("many.cif", "more than 100,000 copies"),
                            ("many.pdb", "more than 100,000 matrices")):
            with self.subTest(name):
                said = self.positions(name, "--biological-assembly", "1", code=4)
                self.assertIn(words, said)
        # What belongs to another assembly does not count.
        self.input("other.cif", cif(atoms, many, [("2", half, "A"), ("2", half, "B"),
                                                  ("1", "1", "A")]))
        self.assertEqual(self.positions("other.cif", "--biological-assembly", "1"), [[1, 0, 0]])

    def test_too_many_copies_are_refused_before_they_take_memory(self):
        many = {str(i): ([*IDENTITY[0]], [i, 0, 0]) for i in range(50000)}
        def little_memory():  # a motion takes 130 bytes and more
            resource.setrlimit(resource.RLIMIT_AS, (2 ** 30, 2 ** 30))
        for expression in ("1" + 5_000_000 * ",1", 400 * "(0-49999)"):
            with self.subTest(expression[:10]):
                self.input("many.cif", cif([("A", "A", "C", 0, 0, 0)], many,
                                           [("1", expression, "A")]))
                said = self.positions("many.cif", "--biological-assembly", "1", code=4,
                                      preexec_fn=little_memory)
                self.assertIn("more than 100,000 copies", said)

    def test_chains_that_a_file_names_and_does_not_have_cost_nothing(self):
        many = {str(i): ([*IDENTITY[0]], [i, 0, 0]) for i in range(300)}
        chains = ",".join(f"c{i}" for i in range(300))
        self.input("names.cif", cif([("A", "A", "C", 0, 0, 0)], many,
                                    [("1", "(0-299)(0-299)", chains), ("1", "1", "A")]))
        def little_time():  # a set of names for each of 90,000 copies takes more
            resource.setrlimit(resource.RLIMIT_CPU, (5, 5))
        self.assertEqual(self.positions("names.cif", "--biological-assembly", "1",
                                        preexec_fn=little_time), [[1, 0, 0]])

    def test_chains_that_older_files_apply_matrices_to_in_addition_have_matrices_of_their_own(self):
        text = "".join(f"HETATM    {i}  O   HOH {c}   {i}       {i}.000   2.000   3.000\n"
                       for i, c in enumerate("AB", 1))
        shift = (IDENTITY[0], [0, 0, 50])
        added = "\n".join(remark_350([shift], "B").splitlines()[1:])
        added = added.replace("APPLY", "IN ADDITION APPLY")
        self.input("old.pdb", remark_350([IDENTITY], "A") + added + "\n" + text)
        self.check(self.positions("old.pdb", "--biological-assembly", "1"),
                   [[1, 2, 3], [2, 2, 53]])

    def test_of_an_old_file_the_chain_without_a_name_is_null_and_lines_end_before_its_code(self):
        lines = remark_350([IDENTITY, (IDENTITY[0], [0, 0, 50])], "NULL").splitlines()[1:]
        lines = [f"{line:72}1ABC {number}" for number, line in enumerate(lines, 100)]
        lines.append("HETATM    1  O   HOH     1       1.000   2.000   3.000")
        self.input("old.pdb", "\n".join(lines))
        self.check(self.positions("old.pdb", "--biological-assembly", "1"), [[1, 2, 3], [1, 2, 53]])

    def test_names_of_chains_without_commas_between_are_all_taken(self):
        text = "".join(f"HETATM    {i}  O   HOH {c}   {i}       {i}.000   2.000   3.000\n"
                       for i, c in enumerate("ABC", 1))
        for chains in ("A, B", "A B", "A,B,"):
            self.input("names.pdb", remark_350([IDENTITY], chains) + text)
            self.check(self.positions("names.pdb", "--biological-assembly", "1"),
                       [[1, 2, 3], [2, 2, 3]])

    def test_by_what_others_call_it_the_option_is_found(self):
        for word in ("--assembly", "--bioassembly", "--bio-assembly", "--biounit", "--bio_unit=1"):
            said = self.run_morskin("info", self.ring, word, "1", code=2).stderr.decode()
            self.assertIn(f"{word} is no option, did you mean --biological-assembly?", said)

    def test_a_damaged_remark_is_refused_with_its_line(self):
        text, motion = self.two_fold()
        good = remark_350([IDENTITY, motion]).splitlines()
        for number, line, words in (
                (4, None, "is no row 2"), (5, good[4].replace("1.000000", "1.0x"), "that is none"),
                (3, "REMARK 350   BIOMT1   1  1.0", "is no row 1"),
                (8, None, "fewer than three rows")):
            with self.subTest(words):
                lines = [*good]
                if line is None:
                    del lines[number - 1]
                else:
                    lines[number - 1] = line
                self.input("bad.pdb", "\n".join([*lines, text]))
                said = self.positions("bad.pdb", "--biological-assembly", "1", code=3)
                self.assertRegex(said, rf"bad\.pdb:\d+: .*{words}")
                self.positions("bad.pdb")  # nobody asked


if __name__ == "__main__":
    main()
