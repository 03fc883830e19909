#!/usr/bin/env python3
"""Features are what the command writes. Usage: features_test.py folder-of-the-package morskin"""

from support import BALLS, MOLECULES, ModuleTest, main

import os
import subprocess
import sys

import morskin
import numpy as np

COMMAND = os.path.abspath(sys.argv.pop(2))
ORIGIN = {"C", "Q", "size", "probe", "metadata"}


class Features(ModuleTest):
    def of_command(self, file, *words):
        """The arrays of the file that the command writes, but those of its origin."""
        subprocess.run([COMMAND, "features", file, "-o", "m.npz", "-q", *words], check=True,
                       cwd=self.folder)
        with np.load(self.folder / "m.npz", allow_pickle=False) as archive:
            return {name: archive[name] for name in archive if name not in ORIGIN}

    def expect_equal(self, features, expected):
        self.assertEqual(list(features), list(expected))
        for name, array in expected.items():
            with self.subTest(name):
                self.assertEqual(features[name].dtype, array.dtype)
                np.testing.assert_array_equal(features[name], array)

    def test_every_array_is_the_commands_to_the_last_bit(self):
        file = MOLECULES / "1crn.pdb"
        self.expect_equal(morskin.features(file), self.of_command(file))
        self.expect_equal(morskin.features(file, density=1.5, model="vdw", drop_voids_below=0,
                                           threads=2),
                          self.of_command(file, "--density", "1.5", "--model", "vdw", "--voids",
                                          "keep"))

    def test_names_may_hold_any_byte_and_chains_are_chosen_by_the_name_that_an_error_tells(self):
        file = self.folder / "bytes.pdb"
        file.write_bytes(b"ATOM      1  C\xe9  ALA \xe9   1       0.000   0.000   0.000"
                         b"  1.00  0.00           C\n")
        features = morskin.features(file)
        self.assertEqual((features["atom_name"][0], features["atom_chain"][0]), ("C\xe9", "\xe9"))
        self.expect_equal(features, self.of_command(file))
        with self.assertRaises(morskin.RefusedInput) as caught:
            morskin.read(file, chains=["A"])
        self.assertEqual(len(morskin.read(file, chains=[str(caught.exception)[-1]])), 1)

    def test_an_option_that_there_is_not_is_told_as_one_of_features(self):
        with self.assertRaisesRegex(TypeError, r"^features\(\) got .* argument 'densty'$"):
            morskin.features(MOLECULES / "benzene.pdb", densty=5)

    def test_charges_of_a_pqr_file_and_the_options_of_read_are_there_too(self):
        file = MOLECULES / "1l2y.pqr"
        features = morskin.features(file, hydrogens=False)
        self.assertIn("partial_charge", features)
        self.expect_equal(features, self.of_command(file, "--hydrogens", "drop"))
        self.assertEqual(len(features["atom_charge"]), len(morskin.read(file, hydrogens=False)))

    def test_names_of_a_file_without_any_are_empty_texts(self):
        features = morskin.features(MOLECULES / "ring12.xyzr")
        self.assertEqual(features["atom_chain"].tolist(), [""] * 12)
        self.expect_equal(features, self.of_command(MOLECULES / "ring12.xyzr"))

    def test_what_is_not_certified_is_raised_with_the_mesh_that_the_command_writes(self):
        file = MOLECULES / "benzene.pdb"
        with self.assertRaises(morskin.NotCertified) as caught:
            morskin.features(file, C=0.3, Q=1.2, angle_goal_deg=0)
        mesh = caught.exception.mesh
        self.assertEqual(str(caught.exception), mesh.certificate.reason)
        self.assertEqual(len(mesh.normals), len(mesh.vertices))
        done = subprocess.run([COMMAND, "features", file, "-o", self.folder / "m.npz", "-C", "0.3",
                               "-Q", "1.2", "--angle-goal", "0"], capture_output=True, check=False)
        self.assertEqual(done.returncode, 5, done.stderr)
        with np.load(self.folder / "m.npz.unverified") as archive:
            np.testing.assert_array_equal(mesh.vertices, archive["vertices"])
            np.testing.assert_array_equal(mesh.faces, archive["faces"])

    def test_a_coarser_c_and_an_angle_goal_are_those_of_the_command(self):
        file = MOLECULES / "caffeine.xyz"
        self.expect_equal(morskin.features(file, C=0.2, angle_goal_deg=38),
                          self.of_command(file, "-C", "0.2", "--angle-goal", "38"))

    def test_check_takes_model_and_sizes_from_a_mesh_that_was_saved(self):
        file = MOLECULES / "caffeine.xyz"
        mesh = morskin.read(file).mesh(model="sas", probe=0.5, density=5, drop_voids_below=3)
        for name in ("m.ply", "m.vtu", "m.msh"):
            done = subprocess.run([COMMAND, "check", mesh.save(self.folder / name), "--against",
                                   file], check=True, stdout=subprocess.PIPE)
            self.assertIn(b"model, probe, voids, C, Q, size from the mesh file", done.stdout)
        with np.load(mesh.save(self.folder / "m.npz")) as archive:
            self.assertEqual(archive["probe"], 0.5)

    def test_msms_s_two_files_are_saved_as_the_command_writes_them(self):
        file = MOLECULES / "caffeine.xyz"
        mesh = morskin.read(file).mesh(C=0.3)
        self.assertEqual(mesh.save(self.folder / "p.face"), self.folder / "p.face")
        subprocess.run([COMMAND, "mesh", file, "-C", "0.3", "-q", "-o", self.folder / "c.vert"],
                       check=True)
        for ending in ("vert", "face"):
            saved, written = ((self.folder / f"{name}.{ending}").read_text().splitlines()
                              for name in "pc")
            self.assertEqual(saved[1:], written[1:])  # the first line is their origin
        subprocess.run([COMMAND, "check", self.folder / "p.vert", "--against", file],
                       check=True, stdout=subprocess.DEVNULL)

    def test_of_msms_s_two_files_both_are_saved_or_none(self):
        mesh = morskin.Skin(*BALLS).mesh(C=0.9, Q=1.9, angle_goal_deg=0, allow_uncertified=True)
        self.assertEqual(mesh.save(self.folder / "u.vert"), self.folder / "u.vert.unverified")
        self.assertTrue((self.folder / "u.face.unverified").exists())
        self.assertFalse((self.folder / "u.vert").exists())
        (self.folder / "q.face").mkdir()
        with self.assertRaises(morskin.UnwritableOutput):
            mesh.save(self.folder / "q.vert")
        with self.assertRaises(morskin.RefusedInput):
            mesh.save(self.folder / "r.vert", vertex_data="all")
        names = {path.name for path in self.folder.iterdir()}
        self.assertEqual(names, {"u.vert.unverified", "u.face.unverified", "q.face"})

    def test_arrays_outlive_each_other_and_may_be_written_to(self):
        vertices = morskin.features(MOLECULES / "caffeine.xyz")["vertices"]
        first = vertices.copy()
        morskin.features(MOLECULES / "benzene.pdb")
        np.testing.assert_array_equal(vertices, first)
        vertices += 1
        np.testing.assert_array_equal(vertices, first + 1)

    def test_a_progress_function_ends_the_run_and_wrong_values_are_named(self):
        def end(stage, share):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            morskin.features(MOLECULES / "1crn.pdb", progress=end)
        for error, options in ((ValueError, {"density": 0}), (ValueError, {"model": "ses"}),
                               (ValueError, {"probe": -1}), (TypeError, {"chains": "A"}),
                               (TypeError, {"chain": ["A"]}),
                               (morskin.RefusedInput, {"chains": ["Z"]}),
                               (morskin.RefusedInput, {"drop_voids_below": float("nan")})):
            with self.subTest(options), self.assertRaises(error):
                morskin.features(MOLECULES / "1crn.pdb", **options)
        with self.assertRaises(morskin.UnreadableInput):
            morskin.features(self.folder / "missing.pdb")
        with self.assertRaises(morskin.RefusedInput):
            morskin.features(MOLECULES / "dumbbell.xyzw")


if __name__ == "__main__":
    main()
