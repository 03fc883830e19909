#!/usr/bin/env python3
"""What `mesh --for PURPOSE` sets, what overrides it, and what the report says of it; and words
that set nothing, but are refused. Usage: preset_command_test.py path/to/morskin"""

from support.command import MOLECULES, CommandTest, main


class Presets(CommandTest):
    def set_by(self, *words, source=None):
        return self.mesh_json(source or self.ring, *words)["preset"]

    def test_bem_is_density_5_without_voids_as_msms_files(self):
        report = self.mesh_json(MOLECULES / "shell_hollow.xyzr", "--for", "bem", "-o", "shell")
        self.assertEqual(report["preset"], {"for": "bem", "set": {
            "density": "5", "voids": "drop", "output": "shell.vert"}})
        self.assertEqual(self.names(), ["shell.face", "shell.vert"])
        self.assertAlmostEqual(report["quality"]["vertices_per_square_angstrom"], 5, delta=0.5)
        self.assertEqual(report["components"], 1)

    def test_a_preset_writes_the_very_mesh_that_its_options_do(self):
        self.run_morskin("mesh", self.ring, "--for", "bem", "-o", "a.ply", "-q")
        self.run_morskin("mesh", self.ring, "--density", "5", "--voids", "drop", "--vertex-data",
                         "normal", "-o", "b.ply", "-q")
        self.assertEqual((self.folder / "a.ply").read_bytes(),
                         (self.folder / "b.ply").read_bytes())

    def test_learning_has_all_data_as_arrays(self):
        found = self.set_by("--for", "learning", "-o", "ring")
        self.assertEqual(found["set"], {"density": "2", "voids": "drop", "output": "ring.npz",
                                        "vertex-data": "all"})
        self.assertEqual(self.names(), ["ring.npz"])

    def test_an_explicit_option_overrides_what_a_preset_sets(self):
        shell = MOLECULES / "shell_hollow.xyzr"
        words = ("--voids", "keep", "--vertex-data", "normal", "--density", "3")
        found = self.set_by("--for", "learning", "-o", "a.vtu", *words, source=shell)
        self.assertEqual(found, {"for": "learning", "set": {}})
        self.run_morskin("mesh", shell, "-o", "b.vtu", "-q", *words)
        self.assertEqual((self.folder / "a.vtu").read_bytes(),
                         (self.folder / "b.vtu").read_bytes())

    def test_a_size_of_any_kind_takes_the_place_of_the_density(self):
        for size in (["-C", "0.2"], ["--size", "1"], ["--triangles", "2000"],
                     ["--method", "marching-cubes", "--grid", "1"]):
            report = self.mesh_json(self.ring, "--for", "bem", "-o", "r.off", *size, code=None)
            self.assertEqual(report["preset"]["set"], {"voids": "drop"}, size)

    def test_formats_without_data_get_none(self):
        self.assertNotIn("vertex-data", self.set_by("--for", "learning", "-o", "r.stl")["set"])

    def test_the_report_for_people_has_a_line_of_it(self):
        done = self.run_morskin("mesh", self.ring, "--for", "bem", "-o", "r")
        self.assertIn(b"preset      bem: --density 5 --voids drop --output r.vert", done.stdout)

    def test_a_batch_has_it_for_each_molecule_but_not_for_features(self):
        self.run_morskin("batch", self.ring, "-o", "all", "--for", "learning", "-q")
        self.run_morskin("mesh", self.ring, "--for", "learning", "-o", "one", "-q")
        self.assertEqual((self.folder / "all" / f"{self.ring.name}.npz").read_bytes(),
                         (self.folder / "one.npz").read_bytes())
        self.run_morskin("batch", self.ring, "-o", "bem", "--for", "bem", "--format", "ply", "-q")
        self.assertTrue((self.folder / "bem" / f"{self.ring.name}.ply").exists())
        done = self.run_morskin("batch", self.ring, "-o", "no", "--for", "bem", "--features",
                                code=2)
        self.assertIn(b"--for is of mesh", done.stderr)

    def test_another_purpose_is_refused(self):
        done = self.run_morskin("mesh", self.ring, "--for", "fem", "-o", "r.ply", code=2)
        self.assertIn(b"--for", done.stderr)
        self.assertEqual(self.names(), [])

    def test_a_surface_that_is_no_skin_has_none(self):
        done = self.run_morskin("mesh", "--surface", "sphere:2", "--for", "bem", "-o", "s.ply",
                                code=2)
        self.assertIn(b"--surface goes without the options of molecules, --for,", done.stderr)

    def test_without_a_purpose_an_output_needs_its_ending(self):
        self.run_morskin("mesh", self.ring, "-o", "r", code=2)


class EmptyWords(CommandTest):
    def test_an_empty_number_is_not_taken_for_none(self):
        mesh, batch = ("mesh", self.ring, "-o", "a.ply"), ("batch", self.ring, "-o", "folder")
        for words, option in ((mesh, "-C"), (mesh, "--density"), (mesh, "--fronts"),
                              (mesh, "--snapshot-at"), (mesh, "--timeout"), (mesh, "--max-memory"),
                              (("info", self.ring), "--size"),
                              (("morse", self.ring, "-o", "a.json"), "--persistence"),
                              (batch, "-C"), (batch, "--timeout"), (batch, "--chain")):
            with self.subTest(words=words, option=option):
                said = self.run_morskin(*words, option, "", code=2).stderr
                self.assertTrue(said.startswith(b"morskin: " + option.encode()), said)
        self.assertEqual(self.names(), [])

    def test_an_empty_name_of_a_file_to_read_is_called_so(self):
        for words in (("info", ""), ("check", ""), ("render", "", "-o", "a.png"),
                      ("batch", "", "-o", "folder"), ("view", "", "-o", "a.html")):
            with self.subTest(words=words):
                said = self.run_morskin(*words, code=3).stderr
                self.assertEqual(said, b"morskin: the name of a file to read is empty; give one\n")
        self.assertEqual(self.names(), [])

    def test_an_empty_text_is_not_taken_for_none(self):
        render = ("render", "a.ply", "-o", "a.png")
        for words, option in ((("batch", self.ring, "-o", "folder"), "--only"),
                              (("mesh", self.ring, "-o", "a.ply"), "--snapshot-dir"),
                              *((render, option) for option in ("--size", "--view", "--up", "--at",
                                                                "--inset", "--colour"))):
            with self.subTest(words=words, option=option):
                said = self.run_morskin(*words, option, "", code=2).stderr
                self.assertIn(option.encode() + b" is empty; leave it out or fill it", said)
        self.assertEqual(self.names(), [])

    def test_numbers_of_triangles_that_no_mesh_has_are_told_how_many_there_may_be(self):
        for n in ("1e11", "3", "100.7"):
            done = self.run_morskin("mesh", self.ring, "-o", "a.ply", "--triangles", n, code=2)
            self.assertRegex(done.stderr, rb"--triangles must be a whole number from 4 to \d{9,}")


if __name__ == "__main__":
    main()
