#!/usr/bin/env python3
"""Errors: bad values, and exceptions named like the exit codes.
Usage: errors_test.py folder-of-the-package"""

from support import BALLS, MOLECULES, ROOT, ModuleTest, main

import copy
import math
import os
import pickle
import shutil
import subprocess
from decimal import Decimal

import morskin
import numpy as np


class Errors(ModuleTest):
    def test_bad_values_are_value_errors(self):
        nan = math.nan
        for positions, radii in (
                ([], []), (np.zeros((0, 3)), []), ([[0, 0]], [1]), ([0, 0, 0], [1]),
                ([[0, 0, 0]], 1), ([[0, 0, 0]], [[1]]), ([[0, 0, 0]], [1, 2]), ([[0, 0, 0]], [0]),
                ([[0, 0, 0]], [-1]), ([[0, 0, 0]], [nan]), ([[0, nan, 0]], [1]),
                ([[0, 1e12, 0]], [1]), ([[0, 0, 0]], [math.inf]), ([[0, 0, 0], [0]], [1, 1])):
            with self.assertRaises(ValueError, msg=(positions, radii)):
                morskin.Skin(positions, radii)
        skin = morskin.Skin(*BALLS)
        for options in (
                {"C": 0}, {"C": nan}, {"C": 0.9, "Q": 1.2}, {"Q": 1}, {"density": 0},
                {"density": -3}, {"density": 5, "triangles": 100}, {"triangles": 1},
                {"max_length_scale": 0}, {"edge_length": -1}, {"edge_length": 1, "density": 1},
                {"angle_goal_deg": 61}, {"fronts": 0}, {"fronts": -1}, {"method": "fast"},
                {"grading": 0}, {"edge_length": math.inf}, {"edge_length": nan},
                {"direction": [0, 0, 0]}, {"direction": [0, nan, 0]}, {"direction": 1},
                {"direction": []}, {"threads": 0}, {"threads": -1}):
            with self.assertRaises(ValueError, msg=options):
                skin.mesh(**options)
        for options in ({"model": "VDW"}, {"probe": -1}, {"probe": nan}, {"drop_voids_below": -1}):
            with self.assertRaises(ValueError, msg=options):
                morskin.Skin(*BALLS, **options)
        for direction in ([0, 0, 0], [nan, 0, 0]):
            with self.assertRaises(ValueError):
                skin.critical_points(direction)
            with self.assertRaises(ValueError):
                skin.morse_smale(direction)
        for vertices, faces in (([[0, 0, 0]], [[0, 1, 2]]), ([[0, 0, 0]], [[0, 0, -1]]),
                                ([[0, 0, 0]], [[0, 0, 2**32]]), ([[0, 0, 0]], [0, 0, 0]),
                                ([[0, 0]], [[0, 0, 0]])):
            with self.assertRaises(ValueError):
                morskin.check(vertices, faces, skin)

    def test_a_direction_of_other_than_three_numbers_has_an_error_of_one_line(self):
        skin = morskin.Skin(*BALLS)
        for direction in ([1, 2], [1, 2, 3, 4], [[1, 2, 3]]):
            for call in (skin.critical_points, skin.morse_smale,
                         lambda along: skin.mesh(direction=along)):
                with self.assertRaisesRegex(ValueError, r"^direction must have the shape \(3,\)$"):
                    call(direction)

    def test_what_an_array_raises_on_its_way_is_the_cause_or_goes_on_if_it_is_no_fault_of_it(self):
        class Far:
            def __init__(self, raised):
                self.raised = raised

            def __array__(self, dtype=None):
                raise self.raised

        skin = morskin.Skin(*BALLS)
        for call, name in ((lambda far: morskin.Skin(far, [1]), "positions"),
                           (lambda far: morskin.check([[0, 0, 0]], far, skin), "faces")):
            for raised in (KeyboardInterrupt(), MemoryError()):
                with self.assertRaises(type(raised)):
                    call(Far(raised))
            reason = RuntimeError("no numpy() of what requires a gradient")
            with self.assertRaisesRegex(ValueError, f"^{name} cannot be made an array$") as caught:
                call(Far(reason))
            self.assertIs(caught.exception.__cause__, reason)

    def test_masked_values_are_refused_and_an_empty_mask_is_none(self):
        positions, radii = np.array(BALLS[0], float), np.array(BALLS[1], float)
        skin = morskin.Skin(positions, radii)
        mesh = skin.mesh(C=0.3)
        first = np.arange(mesh.faces.size).reshape(-1, 3) == 0
        for name, count, call in (
                ("positions", "3 are", lambda: morskin.Skin(
                    np.ma.array(positions, mask=np.arange(len(radii))[:, None] == [1] * 3), radii)),
                ("radii", "1 is", lambda: morskin.Skin(
                    positions, np.ma.masked_less(radii, radii.max()))),
                ("direction", "1 is", lambda: skin.critical_points(
                    np.ma.masked_equal([1, 2, 3], 2))),
                ("faces", "1 is", lambda: morskin.check(
                    mesh.vertices, np.ma.array(mesh.faces.astype("u8"), mask=first), skin))):
            with self.assertRaisesRegex(
                    ValueError, f"^{name} must have no masked values, and {count} masked$"):
                call()
        self.assertEqual(morskin.Skin(np.ma.array(positions), np.ma.array(radii)).components, 1)

    def test_a_value_of_a_wrong_type_has_an_error_of_one_line_with_its_argument(self):
        skin, file = morskin.Skin(*BALLS), MOLECULES / "benzene.pdb"
        calls = {"a number": (lambda **of: morskin.Skin(*BALLS, **of), "probe drop_voids_below"),
                 "a number or None": (skin.mesh, "C Q edge_length density triangles grading"),
                 "a string": (lambda **of: morskin.Skin(*BALLS, **of), "model"),
                 "a string or None": (skin.mesh, "method"),
                 "True or False": (lambda **of: morskin.read(file, **of), "hydrogens waters"),
                 "a whole number of at most 64 bits or None": (skin.mesh, "fronts")}
        bad = {"a string": [1, None, b"sas"], "a string or None": [1, b"\xe9"],
               "True or False": [None, "no"]}
        for kind, (call, names) in calls.items():
            for name in names.split():
                for value in bad.get(kind, ["1", [1], 1j]):
                    with self.subTest(name, value=value), self.assertRaises(TypeError) as caught:
                        call(**{name: value})
                    self.assertEqual(str(caught.exception), f"{name} must be {kind}, not {value!r}")
        for value, text in ((2**63, str(2**63)), (np.zeros((9, 9)), r"array\(\[\[0\..{1,30}"),
                            (np.float32(2.5), r".*2\.5\)?"), (Decimal("2.5"), ".*'2.5'.")):
            with self.assertRaisesRegex(TypeError, f"^fronts must be a .* or None, not {text}$"):
                skin.mesh(fronts=value)
        for name, call in (("simplify", skin.morse_smale), ("allow_uncertified", skin.mesh)):
            with self.assertRaisesRegex(TypeError, f"^{name} must be True or False, not None$"):
                call(**{name: None})
        with self.assertRaisesRegex(TypeError, "^density must be a number, not None$"):
            morskin.features(file, density=None)
        mesh = skin.mesh(C=0.3)
        for value in (1, None, ["normal", 1]):
            with self.assertRaises(TypeError) as caught:
                mesh.save(self.folder / "a.ply", vertex_data=value)
            self.assertEqual(str(caught.exception), "vertex_data must be a string or a sequence of "
                             f"strings, not {value!r}")
        with self.assertRaisesRegex(TypeError, "^skin must be a Skin, not None$"):
            morskin.check(mesh.vertices, mesh.faces, None)
        with self.assertRaisesRegex(TypeError, "^element must be a string, not 6$"):
            morskin.van_der_waals_radius(6)

    def test_threads_are_any_whole_number_from_1_on(self):
        skin = morskin.Skin(*BALLS)
        vertices = skin.mesh(C=0.3).vertices
        for threads in (np.uint8(2), 2**31, 2**40, 2**70):
            np.testing.assert_array_equal(skin.mesh(C=0.3, threads=threads).vertices, vertices)
        for threads in (0, -2**40, -2**70):
            with self.assertRaisesRegex(ValueError, "^threads must be at least 1$"):
                skin.mesh(threads=threads)
        for threads in ("2", 2.0):
            with self.assertRaisesRegex(TypeError, "cannot be interpreted as an integer"):
                morskin.Skin(*BALLS, threads=threads)

    def test_a_corner_out_of_range_is_named_as_it_was_given(self):
        skin = morskin.Skin(*BALLS)
        for corner, kind in ((2**64 - 1, "u8"), (2**63, "u8"), (2**32 - 1, "u4"), (-1, "i8")):
            with self.assertRaisesRegex(ValueError, f"face 0 has a corner {corner},"):
                morskin.check([[0, 0, 0]], np.array([[0, 0, corner]], kind), skin)

    def test_check_refuses_sizes_that_make_no_sense(self):
        skin = morskin.Skin(*BALLS)
        mesh = skin.mesh(C=0.3)
        for options in ({"C": -1}, {"C": math.inf}, {"C": math.nan}, {"Q": math.inf},
                        {"max_length_scale": math.nan}, {"max_length_scale": -1}):
            with self.assertRaises(morskin.RefusedInput, msg=options):
                morskin.check(mesh.vertices, mesh.faces, skin, **options)

    def test_the_help_says_what_a_certificate_has_of_a_mesh_that_is_no_manifold_or_far_off(self):
        skin = morskin.Skin(*BALLS)
        mesh = skin.mesh(C=0.3)
        found = morskin.check(mesh.vertices, mesh.faces[1:], skin)
        self.assertEqual((found.components, found.genus), (0, 0))
        self.assertTrue(math.isnan(found.volume))
        far = morskin.check(mesh.vertices * 0, mesh.faces, skin)
        self.assertEqual(far.max_distance_to_skin, math.inf)
        for name, text in (("components", "0 where the mesh is no closed manifold"),
                           ("genus", "0 where the mesh is no closed manifold"),
                           ("volume", "nan where the mesh is no closed manifold"),
                           ("max_distance_to_skin", "inf where none is known")):
            self.assertIn(text, getattr(morskin.Certificate, name).__doc__)

    def test_a_refused_atom_is_named(self):
        for atom, radius in (([0, 0, 0], -1), ([0, math.nan, 0], 1), ([0, 1e12, 0], 1),
                             ([0, 0, 0], 1e6), ([0, 0, 0], 3e-22)):
            with self.assertRaises(morskin.RefusedInput) as caught:
                morskin.Skin([[9, 0, 0], atom], [1, radius])
            self.assertEqual(caught.exception.atoms, (1,))

    def test_what_is_not_certified_can_be_told_to_another_process_without_its_mesh(self):
        with self.assertRaises(morskin.NotCertified) as caught:
            morskin.Skin(*BALLS).mesh(C=0.9, Q=1.9, angle_goal_deg=0)
        caught.exception.file = "a.pdb"
        told = pickle.loads(pickle.dumps(caught.exception))
        self.assertIs(type(told), morskin.NotCertified)
        self.assertEqual(str(told), str(caught.exception))
        self.assertEqual(vars(told), {"file": "a.pdb"})
        for copied in (copy.copy(caught.exception), copy.deepcopy(caught.exception)):
            self.assertEqual((str(copied), vars(copied)), (str(told), vars(caught.exception)))

    def test_values_of_a_wrong_type_are_type_errors(self):
        skin = morskin.Skin(*BALLS)
        for call in (lambda: morskin.Skin([["a", "b", "c"]], [1]), lambda: morskin.Skin(None, None),
                     lambda: morskin.Skin([[1j, 0, 0]], [1]), lambda: morskin.Skin(),
                     lambda: morskin.Skin([[0, 0, 0]], [True]),
                     lambda: skin.mesh(C="coarse"), lambda: skin.mesh(0.2),
                     lambda: skin.mesh(densty=5), lambda: skin.mesh(direction="abc"),
                     lambda: skin.critical_points(np.ones(3, complex)),
                     lambda: morskin.check([[0, 0, 0]], [[0.5, 0, 0]], skin),
                     lambda: morskin.check([[0, 0, 0]], [[0, 0, 0]], None)):
            with self.assertRaises(TypeError):
                call()

    def test_an_object_that_no_init_has_filled_raises_a_type_error_whatever_is_asked_of_it(self):
        asked = (("Skin", "components"), ("Skin", "mesh"), ("Skin", "__repr__"),
                 ("Mesh", "vertices"), ("Mesh", "normals"), ("Mesh", "__repr__"),
                 ("Certificate", "reason"), ("CriticalPoints", "positions"),
                 ("CriticalPoints", "__len__"), ("MorseSmaleComplex", "arcs"),
                 ("MorseSmaleComplex", "points"))
        for name, attribute in asked:
            made = getattr(morskin, name).__new__(getattr(morskin, name))
            # A value that is there would raise a TypeError as well, when it is called.
            with (self.subTest(name, attribute=attribute),
                  self.assertRaisesRegex(TypeError, "made without its __init__")):
                getattr(made, attribute)()

    def test_errors_are_named_like_the_exit_codes(self):
        text = (ROOT / "app" / "exit_codes.h").read_text("utf-8")
        for name in ("UnreadableInput", "RefusedInput", "NotCertified", "LimitReached",
                     "UnwritableOutput", "InternalError"):
            self.assertIn(name + " =", text)
            self.assertTrue(issubclass(getattr(morskin, name), morskin.Error))
        with self.assertRaises(morskin.UnreadableInput):
            morskin.read("no such file.pdb")
        with self.assertRaises(OSError):
            morskin.read_mesh("no such file.ply")
        (self.folder / "bad.xyzr").write_text("0 0 0 1\n1 2 three 4\n")
        with self.assertRaisesRegex(morskin.UnreadableInput, r"bad\.xyzr:2: "):
            morskin.read(self.folder / "bad.xyzr")
        (self.folder / "weights.xyzw").write_text("0 0 0 1\n")
        with self.assertRaises(morskin.RefusedInput):
            morskin.read(self.folder / "weights.xyzw")

    def test_a_file_may_have_any_name_and_the_error_has_it(self):
        for name in ("Ähre.xyzr", "a\udcff.xyzr"):
            with self.assertRaises(morskin.UnreadableInput) as caught:
                morskin.read(self.folder / name)
            self.assertIn(name, str(caught.exception))

    def test_a_name_with_a_nul_and_what_is_no_name_have_errors_of_one_line(self):
        mesh = morskin.Skin(*BALLS).mesh(C=0.3)
        for call in (morskin.read, morskin.read_mesh, morskin.features, mesh.save):
            with self.assertRaisesRegex(ValueError, "^embedded null byte$"):
                call("a\0.ply")
            with self.assertRaisesRegex(TypeError, "^expected str, bytes or os.PathLike object"):
                call(3)
        path = self.folder / "a.ply"
        self.assertEqual(mesh.save(os.fsencode(path)), path)

    def test_messages_have_a_decimal_point_in_any_locale(self):
        german = self.folder / "de_DE.UTF-8"
        if shutil.which("localedef"):
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", german], check=False,
                           capture_output=True)
        if not (german / "LC_NUMERIC").exists():
            self.skipTest("no German locale can be made")
        said = self.python("""
import locale, sys
import morskin
locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
assert locale.str(0.5) == "0,5"
skin = morskin.Skin([[0, 0, 0], [1.5, 0, 0]], [1.5, 1.2])
mesh = skin.mesh(C=0.2)
print(morskin.check(mesh.vertices * 1.01, mesh.faces, skin, C=0.2).reason)
try:
    morskin.read(sys.argv[1]).skin().critical_points([1, 0, 0])  # degenerate
except morskin.RefusedInput as error:
    print(error)
""", str(MOLECULES / "cube8.xyzr"), LOCPATH=str(self.folder))
        self.assertRegex(said, r"lies about 0\.0\d+ Angstrom off the skin\n")
        self.assertRegex(said, r" at \(-?\d+\.\d+, ")

    def test_a_skin_that_touches_itself_names_its_atoms(self):
        with self.assertRaises(morskin.RefusedInput) as caught:
            morskin.Skin([[-50, 0, 0], [0, 0, 0], [2, 2, 0]], [1, 1, 1])
        self.assertEqual(caught.exception.atoms, (1, 2))
        self.assertEqual(morskin.RefusedInput("x").atoms, ())

    def test_memory_that_runs_out_is_a_limit_and_a_memory_error(self):
        said = self.python("""
import resource
import numpy, morskin
skin = morskin.Skin([[0, 0, 0]], [100.0])
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 200 * 2**20, resource.RLIM_INFINITY))
try:
    skin.mesh(C=0.001, threads=1)
except MemoryError as error:
    print(type(error).__name__)
""")
        self.assertEqual(said, "LimitReached\n")


if __name__ == "__main__":
    main()
