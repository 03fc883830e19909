#!/usr/bin/env python3
"""Which atoms are read, and with which radii. Usage: read_test.py folder-of-the-package"""

from support import MOLECULES, ModuleTest, main

import os
from pathlib import Path

import morskin
import numpy as np

from pdb_texts import ASSEMBLY, MODELS  # from tests/support


class Reading(ModuleTest):
    def setUp(self) -> None:
        super().setUp()
        self.file = self.folder / "two.pdb"
        self.file.write_text(ASSEMBLY + MODELS)

    def test_each_option_keeps_the_atoms_that_it_says(self) -> None:
        for options, count in (({}, 5), ({"chains": ["A"]}, 3), ({"chains": ("A", "B")}, 5),
                               ({"hydrogens": False}, 4), ({"hetatms": []}, 4),
                               ({"hetatms": ["SO4"]}, 5), ({"waters": True}, 6),
                               ({"altloc": "all"}, 6), ({"altloc": "A"}, 5),
                               ({"model_number": 4}, 3), ({"biological_assembly": 1}, 6),
                               ({"biological_assembly": "1", "hydrogens": False}, 4)):
            with self.subTest(options):
                self.assertEqual(len(morskin.read(self.file, **options)), count)
        a, b = (morskin.read(self.file, altloc=letter).positions[2, 1] for letter in "AB")
        self.assertEqual((a, b), (0.0, 0.6))

    def test_the_second_copy_is_where_its_motion_puts_it(self) -> None:
        read = morskin.read(self.file, chains=["A"])
        both = morskin.read(self.file, chains=["A"], biological_assembly="1")
        np.testing.assert_array_equal(both.positions[:3], read.positions)
        np.testing.assert_array_equal(both.positions[3:],
                                      read.positions * [-1, -1, 1] + [0, 0, 20])
        self.assertTrue(both.mesh(C=0.3).certificate.certified)

    def test_radii_come_from_a_name_a_file_or_a_dict(self) -> None:
        table = self.folder / "mine.txt"
        table.write_text("N 1.6\nH 1.1\nC 1.9\nS 2\nSER:OG 1.45 # hydroxyl\n")
        mine = {"N": 1.6, "H": 1.1, "C": 1.9, "S": 2, "SER:OG": 1.45}
        expected = [1.6, 1.1, 1.45, 1.9, 2]
        for radii in (table, str(table), mine):
            np.testing.assert_array_equal(morskin.read(self.file, radii=radii).radii, expected)
        np.testing.assert_array_equal(morskin.read(self.file, radii="alvarez").radii,
                                      [1.66, 1.2, 1.5, 1.77, 1.89])
        np.testing.assert_array_equal(morskin.read(self.file, radii="elements").radii,
                                      morskin.read(self.file).radii)

    def test_a_path_of_radii_is_a_file_whatever_it_is_called(self) -> None:
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)
        (self.folder / "pH=7").mkdir()
        for name in (b"bondi", b"C=1.7,N=2", b"pH=7/mine.txt", b"\xff"):
            table = Path(os.fsdecode(name))
            table.write_text("N 1.6\nH 1.1\nC 1.9\nS 2\nO 1.5\n")
            for path in (table, self.folder / table):
                with self.subTest(path):
                    np.testing.assert_array_equal(morskin.read(self.file, radii=path).radii,
                                                  [1.6, 1.1, 1.5, 1.9, 2])

    def test_radii_may_be_an_entry_of_a_folder_that_is_listed_in_bytes(self) -> None:
        (self.folder / "a").mkdir()
        (self.folder / "a" / "bondi").write_text("N 1.6\nH 1.1\nC 1.9\nS 2\nO 1.5\n")
        (entry,) = os.scandir(os.fsencode(self.folder / "a"))
        self.assertEqual(morskin.read(self.file, radii=entry).radii[0], 1.6)

    def test_chains_and_hetatms_that_are_no_names_are_named_with_their_value(self) -> None:
        for name in ("chains", "hetatms"):
            for value in ("A", b"A", 5, [1], [None]):
                with self.assertRaises(TypeError) as caught:
                    morskin.read(self.file, **{name: value})
                self.assertEqual(str(caught.exception), f"{name} must be a sequence of names, as "
                                 f'in ["A"], not {value!r}')

    def test_a_radius_of_a_dict_that_is_no_number_is_named_with_its_key(self) -> None:
        for error, value in ((TypeError, None), (TypeError, [1]), (morskin.RefusedInput, "wide"),
                             (morskin.RefusedInput, 10**400)):
            with self.assertRaisesRegex(error, "^the radius of ALA:CA "):
                morskin.read(self.file, radii={"ALA:CA": value})

    def test_radii_with_a_nul_are_a_value_error_as_other_names_are(self) -> None:
        for radii in ("bondi\0", Path("mine\0.txt")):
            with self.assertRaisesRegex(ValueError, "^embedded null byte$"):
                morskin.read(self.file, radii=radii)

    def test_a_location_and_the_name_of_an_assembly_may_hold_any_byte(self) -> None:
        file = self.folder / "bytes.pdb"
        file.write_bytes(b"".join(b"ATOM      1  CA %cALA A   1    %8.3f   0.000   0.000  0.50"
                                  b"  0.00           C\n" % place for place in ((66, 1), (233, 2))))
        self.assertEqual(morskin.read(file, altloc="\udce9").positions[:, 0].tolist(), [2])
        with self.assertRaisesRegex(TypeError, r"^altloc must be a string, not b'\\xe9'$"):
            morskin.read(file, altloc=b"\xe9")
        with self.assertRaisesRegex(morskin.RefusedInput, "tells of no biological assembly"):
            morskin.read(file, biological_assembly="\udce9")

    def test_a_molecule_is_shown_in_one_line_not_as_all_its_numbers(self) -> None:
        self.assertEqual(repr(morskin.read(MOLECULES / "1crn.pdb")),
                         "<morskin.Molecule: 327 atoms>")

    def test_charges_are_those_of_a_pqr_file_in_the_order_of_its_atoms(self) -> None:
        file = self.folder / "a.pqr"
        file.write_text("ATOM 1 N ALA 1 0 0 0 -0.3 1.5\nATOM 2 H ALA 1 1 0 0 0.25 0\n"
                        "ATOM 3 C ALA 1 1.4 0 0 0.05 1.7\n")
        molecule = morskin.read(file)
        np.testing.assert_array_equal(molecule.charges, [-0.3, 0.05])  # no radius, no atom
        self.assertEqual(molecule.left_out["zero_radii"], 1)
        self.assertEqual(sum(molecule.left_out.values()), 1)
        self.assertIsNone(morskin.read(self.file).charges)
        with self.assertRaises(ValueError):
            molecule.charges[0] = 0

    def test_what_makes_no_sense_is_refused(self) -> None:
        for options in ({"chains": ["C"]}, {"altloc": "first"}, {"model_number": 2},
                        {"biological_assembly": 2}, {"radii": {"C": -1}}, {"radii": {"Qq": 1}},
                        {"radii": {"C": float("nan")}}, {"radii": {"C": 1.7}},
                        {"radii": {"N=1,H=1,C=1,S=1,O": 1}}, {"radii": {"C,N": 1}}):
            with self.subTest(options), self.assertRaises(morskin.RefusedInput):
                morskin.read(self.file, **options)
        for error, options in ((TypeError, {"chains": "A"}), (TypeError, {"hetatms": "SO4"}),
                               (ValueError, {"radii": {}}), (TypeError, {"radii": 1.7}),
                               (morskin.UnreadableInput, {"radii": "no such table"})):
            with self.subTest(options), self.assertRaises(error):
                morskin.read(self.file, **options)
        with self.assertRaises(morskin.RefusedInput):
            morskin.read(MOLECULES / "ring12.xyzr", biological_assembly=1)


if __name__ == "__main__":
    main()
