#!/usr/bin/env python3
"""Exit codes and messages. Usage: command_failures_test.py path/to/morskin"""

import json
import os
import re
import resource
import signal
import subprocess
import time
import unittest
from pathlib import Path

from support.command import MOLECULES, CommandTest, main, morskin


class Failures(CommandTest):
    def test_marching_cubes_are_told_for_what_they_are(self):
        words = (self.ring, "--method", "marching-cubes")
        report = self.mesh_json(*words, "-o", "ring.ply", code=5)
        self.assertEqual(self.names(), ["ring.ply.unverified"])
        self.assertEqual(report["method"], "marching-cubes")
        self.assertFalse(report["certified"])
        self.assertLess(report["min_angle_deg"], 10)
        self.assertEqual(report["smoothing"]["moved"], 0)
        wide = self.mesh_json(*words, "-o", "wide.ply", "--grid", "0.6", code=5)
        self.assertEqual(wide["grid_step"], 0.6)
        self.assertLess(report["grid_step"], 0.6)
        self.assertLess(wide["triangles"], report["triangles"])

    def test_the_help_of_mesh_keeps_the_laboratory_for_those_who_ask_for_all(self):
        short, whole = (self.run_morskin("mesh", word).stdout.decode()
                        for word in ("--help", "--help-all"))
        for option in ("--output", "-C FLOAT", "--density", "--chain", "--vertex-data", "--json"):
            self.assertIn(option, short)
            self.assertIn(option, whole)
        for option in ("-Q FLOAT", "--guard", "--fronts", "--snapshot-at", "--certificate"):
            self.assertNotIn(option, short)
            self.assertIn(option, whole)
        self.assertIn("--help-all has more", short)
        self.assertNotIn("--help-all has more", whole)
        self.assertLessEqual(short.count("\n"), 48)
        self.assertLessEqual(max(map(len, short.splitlines())), 100)
        for line in re.findall(r"^  (-.*)$", short, re.M):
            is_flag = line.startswith(("--waters", "-q,--quiet", "--json", "-h,--help"))
            self.assertEqual(line.endswith("]"), not (is_flag or "REQUIRED" in line), line)
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "--fronts", "1", "-q")  # all the same
        done = self.run_morskin("mesh", self.ring, "-o", "m.ply", "--fronts", "x", code=2)
        self.assertIn(b"--fronts", done.stderr)

    def test_a_refused_option_names_its_nearest_relative_if_it_has_one(self):
        for word, meant in (("--densty", "--density"), ("-c", "-C"), ("-O", "-o"),
                            ("--anglegoal", "--angle-goal"), ("--probe_radius=1", "--probe"),
                            ("--assembly", "--biological-assembly"), ("--sise=0.7", "--size"),
                            ("--vertex-dat=all", "--vertex-data"), ("--tri", "--triangles")):
            with self.subTest(word):
                said = self.run_morskin("mesh", self.ring, "-o", "m.ply", word, code=2).stderr
                self.assertIn(f"did you mean {meant}?".encode(), said)
        for word in ("--nonsense", "-Z", "--", "--=", "--x"):
            said = self.run_morskin("mesh", self.ring, "-o", "m.ply", word, "1", code=2).stderr
            self.assertNotIn(b"did you mean", said, word)
        self.assertIn(b"did you mean --help?", self.run_morskin("--hlep", code=2).stderr)
        said = self.run_morskin("info", self.ring, "--void", "drop", "b", code=2).stderr
        self.assertIn(b"were not expected: --void drop b; --void is no option, did", said)
        self.assertEqual(self.names(), [])

    def test_a_value_that_cannot_be_converted_is_told_so(self):
        for words, told in (("-C 0,1", "a number, not 0,1; decimals follow a point;"),
                            ("--json=x", "no value, not x;"), ("--size 1A", "a number, not 1A;"),
                            ("--fronts 1.5", "a whole number,"), ("--snapshot-at 1,x", "numbers,"),
                            ("--threads 1.5", "a whole number, not 1.5;")):
            said = self.run_morskin("mesh", self.ring, "-o", "m.ply", *words.split(), code=2).stderr
            self.assertIn(f" takes {told}".encode(), said)

    def test_a_number_for_a_model_is_told_of_the_option_for_the_models_of_a_file(self):
        said = self.run_morskin("mesh", self.ring, "-o", "m.ply", "--model", "2", code=2).stderr
        self.assertIn(b"--model-number", said)

    def test_an_output_that_another_command_makes_is_told_of_it(self):
        for name, command in (("a.html", b"view"), ("a.PNG", b"render"), ("a.xyzw", b"balls")):
            said = self.run_morskin(self.ring, "-o", name, code=2).stderr
            self.assertIn(b"there is morskin " + command, said)

    def test_a_grid_of_too_many_cells_gives_6(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--method", "marching-cubes",
                         "--grid", "1e-9", code=6)
        self.assertEqual(self.names(), [])

    def test_the_angle_goal_is_met_and_0_leaves_the_mesh_as_refined(self):
        smooth, rough, more = (self.mesh_json(self.ring, "-o", "ring.ply", *words) for words in
                               ((), ("--angle-goal", "0"), ("--angle-goal", "33")))
        self.assertGreater(smooth["min_angle_deg"], 30 - 1e-9)
        self.assertEqual(rough["smoothing"]["moved"], 0)
        self.assertLess(rough["min_angle_deg"], smooth["min_angle_deg"])
        self.assertGreater(more["min_angle_deg"], 33 - 1e-9)

    def test_wrong_arguments_give_2(self):
        good = ("mesh", self.ring, "-o", "ring.ply")
        for words in [(), ("melt",), ("mesh",), ("mesh", self.ring), (*good, "--probe", "-1"),
                      (*good, "--probe", "nan"), (*good, "-C", "0"), (*good, "-C", "x"),
                      (*good, "-C", "inf"), (*good, "-Q", "1"), (*good, "-C", "1", "-Q", "1.65"),
                      (*good, "--height", "0,0,0"), (*good, "--height", "1,2"),
                      (*good, "--height", "1,2,nan"), (*good, "--model", "ball"),
                      (*good, "--method", "melt"), (*good, "--progress", "often"),
                      (*good, "--size", "0"), (*good, "--size", "nan"),
                      (*good, "-C", "1e-22"), (*good, "--size", "1e-22"), (*good, "--size", "1e-6"),
                      (*good, "--method", "static", "--snapshots", "3"),
                      (*good, "--method", "static", "--fronts", "1"),
                      (*good, "--fronts", "0"), (*good, "--fronts", "70000"),
                      (*good, "--fronts", "-1"), (*good, "--fronts", "3"),
                      (*good, "--snapshots", "-1"), (*good, "--snapshots", "4000000000"),
                      (*good, "--fronts", "x"), (*good, "--snapshot-dir", "no"),
                      (*good, "--method", "dynamic", "--guard", "spheres"),
                      (*good, "--method", "dynamic", "--angle-goal", "25"),
                      (*good, "--report", "ring.ply.unverified"),
                      ("mesh", self.ring, "-o", "snapshot-1.ply", "--snapshots", "2"),
                      ("mesh", self.ring, "-o", "ring.ply", "--snapshots", "2",
                       "--snapshot-dir", "no", "--report", "./no/../no/snapshot-2.vtu"),
                      (*good, "--method", "dynamic", "--size", "1"),
                      (*good, "--grid", "0.3"), (*good, "--angle-goal", "61"),
                      (*good, "--method", "marching-cubes", "--grid", "0"),
                      (*good, "--method", "marching-cubes", "--grid", "nan"),
                      (*good, "-o", "ring.ply"), (*good, "-o", "./ring.ply"),
                      (*good, "-o", "ring.txt"), (*good, "--threads"),
                      ("mesh", self.ring, "-o", "-", "--json"),
                      (*good, "--function", "height"), (*good, "--function", "height:1,2"),
                      (*good, "--function", "height:0,0,0"), (*good, "--function", "depth:1,2,3"),
                      (*good, "--function", "distance:1,2,x"),
                      (*good, "--function", "distance:1,2,1e300"),
                      (*good, "--function", "height:0,1,0", "--height", "0,1,0"),
                      ("morse", self.ring), ("morse", self.ring, "-o", "ring.ply"),
                      ("morse", self.ring, "-o", "a.json", "--function", "distance:1,2"),
                      ("morse", self.ring, "-o", "a.json", "--persistence", "-1"),
                      ("morse", self.ring, "-o", "a.json", "--persistence", "nan"),
                      ("morse", self.ring, "-o", "a.json", "--persistence", "1", "--raw"),
                      ("mesh", self.ring, "-o", ""), ("mesh", self.ring, "-o", "a.vert", "-o", ""),
                      ("features", self.ring, "-o", ""),
                      ("morse", self.ring, "-o", self.ring),
                      ("balls", self.ring, "-o", self.ring)]:
            with self.subTest(words=words):
                done = self.run_morskin(*words, code=2)
                self.assertTrue(done.stderr.startswith(b"morskin: "))
                self.assertEqual(done.stdout, b"")
        self.assertEqual(self.names(), [])

    def test_a_molecule_without_a_name_is_no_reason_to_check_the_mesh_alone(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        for words in (("check", "m.ply"), ("m.ply",)):
            said = self.run_morskin(*words, "--against", "", code=2).stderr
            self.assertIn(b"--against is empty", said)

    def test_numbers_that_are_not_finite_are_told_so(self):
        for words in (("-C",), ("-Q",), ("--size",), ("--density",), ("--grading",),
                      ("--method", "marching-cubes", "--grid"), ("--snapshot-at",)):
            said = self.run_morskin("mesh", self.ring, "-o", "a.ply", *words, "inf", code=2).stderr
            self.assertIn(b"finite", said)

    def test_help_and_version_are_no_failure(self):
        self.assertIn(b"Exit codes", self.run_morskin("--help").stdout)
        for command in ("mesh", "morse", "balls", "info", "check"):
            self.assertIn(b"Usage", self.run_morskin(command, "--help").stdout)
        self.assertTrue(self.run_morskin("--version").stdout.startswith(b"morskin "))

    def test_a_complaint_names_the_help_that_has_the_options(self):
        for words, command in (((), ""), (("--nope",), ""), (("mehs",), ""), (("mesh",), "mesh "),
                               ((self.ring, "-o", "a.foo"), "mesh "), (("info",), "info "),
                               (("figure", "12", "-o", "a.png"), "figure "),
                               (("check", "a.ply", "--wat"), "check "),
                               (("batch", "l", "-o", "b", "--timeout", "0"), "batch ")):
            said = self.run_morskin(*words, code=2).stderr.decode()
            self.assertTrue(said.endswith(f"; see morskin {command}--help\n"), said)
            self.assertEqual(said.count("--help"), 1)

    def test_an_unreadable_input_gives_3(self):
        self.input("empty.pdb", "")
        self.input("words.xyzr", "0 0 zero 1\n")
        for name in ("missing.pdb", "empty.pdb", "words.xyzr", "."):
            with self.subTest(name=name):
                self.run_morskin("mesh", name, "-o", "out.ply", code=3)
                self.run_morskin("info", name, code=3)
        self.run_morskin("check", "missing.ply", code=3)
        self.assertEqual(self.names(), ["empty.pdb", "words.xyzr"])

    def test_a_singular_skin_gives_4_and_names_the_atoms(self):
        # W = 2 r^2 is 8 and 32; spheres of these squared radii touch when the squared distance is
        # (sqrt 8 + sqrt 32)^2 = 72, and (6, 6, 0) is that long.
        self.input("touching.xyzr", "0 0 0 2\n90 90 90 1\n6 6 0 4\n")
        done = self.run_morskin("mesh", "touching.xyzr", "-o", "out.ply", "--model", "vdw", code=4)
        self.assertIn(b"line 1", done.stderr)
        self.assertIn(b"line 3", done.stderr)
        self.assertEqual(self.names(), ["touching.xyzr"])

    def test_an_input_without_usable_atoms_gives_4(self):
        self.input("zero.pqr", "ATOM 1 C ALA 1 0.0 0.0 0.0 0.0 0.0\n")
        self.run_morskin("mesh", "zero.pqr", "-o", "out.ply", code=4)
        self.input("x.cif", "data_x\n_atom_site.type_symbol X\n" +
                   "".join(f"_atom_site.Cartn_{axis} 0\n" for axis in "xyz"))
        done = self.run_morskin("mesh", "x.cif", "-o", "out.ply", code=4)
        self.assertIn(b"no atom of a known element", done.stderr)
        self.input("huge.xyzr", "0 0 0 900000\n")
        self.run_morskin("mesh", "huge.xyzr", "-o", "out.ply", "--model", "vdw", code=4)

    def test_what_goes_to_standard_output_is_all_that_is_there(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--report", "-")
        self.assertTrue(json.loads(done.stdout)["certified"])
        self.assertIn(b"certified", done.stderr)
        for option in ("--areas", "--certificate"):
            words = ("mesh", self.ring, "-o", "ring.ply", option)
            done = self.run_morskin(*words, "-")
            self.assertIn(b"certified", done.stderr)
            self.run_morskin(*words, "file", "-q")
            self.assertEqual(done.stdout, (self.folder / "file").read_bytes())

    def test_a_certificate_of_check_on_standard_output_is_all_that_is_there(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        words = ("check", "m.ply", "--against", self.ring, "--certificate")
        done = self.run_morskin(*words, "-")
        self.assertIn(b"homeomorphic", done.stderr)
        self.run_morskin(*words, "file")
        self.assertEqual(done.stdout, (self.folder / "file").read_bytes())
        self.run_morskin(*words, "-", "--json", code=2)

    def test_standard_input_is_one_file(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        mesh = (self.folder / "m.ply").read_bytes()
        for words in (("-",), (self.ring, "--radii", "-")):
            said = self.run_morskin("check", "-", "--against", *words, code=2, input=mesh).stderr
            self.assertIn(b"standard input", said)
        self.run_morskin("check", "-", "--against", self.ring, input=mesh)

    def test_an_uncertified_mesh_and_what_belongs_to_it_need_their_places_as_well(self):
        (self.folder / "b.ply.unverified").mkdir()
        for words in ((self.ring, "-o", "a.ply", "-o", "b.ply"),
                      (self.ring, "-o", "a.ply", "--areas", "b.ply"),
                      (self.ring, "-o", "a.ply", "--certificate", "b.ply"),
                      ("--surface", "sphere:2", "-o", "b.ply")):
            done = self.run_morskin("mesh", *words, code=7)
            self.assertIn(b"b.ply.unverified", done.stderr)
            self.assertEqual(self.names(), ["b.ply.unverified"])

    def test_an_uncertified_mesh_does_not_replace_the_input(self):
        for molecule in ("a.ply.unverified", "a.csv.unverified"):
            balls = self.ring.read_bytes()
            self.input(molecule, balls)
            done = self.run_morskin("mesh", molecule, "-o", "a.ply", "--areas", "a.csv",
                                    "--method", "marching-cubes", code=2)
            self.assertIn(b"unverified would replace the input", done.stderr)
            self.assertEqual((self.folder / molecule).read_bytes(), balls)

    def test_an_unwritable_output_gives_7(self):
        (self.folder / "folder.ply").mkdir()
        for name in ("no/such/folder/out.ply", "folder.ply"):
            with self.subTest(name=name):
                self.run_morskin("mesh", self.ring, "-o", name, code=7)
        self.run_morskin("mesh", self.ring, "-o", "a.ply", "--report", "no/report.json", code=7)
        self.run_morskin("balls", self.ring, "-o", "no/out.xyzr", code=7)
        self.run_morskin("morse", self.ring, "-o", "no/out.json", code=7)
        self.assertEqual(self.names(), ["folder.ply"])

    def test_a_working_folder_that_is_gone_is_no_place_for_outputs(self):
        def lose_folder():
            os.mkdir("gone")
            os.chdir("gone")
            os.rmdir(self.folder / "gone")
        for words in (("mesh", "-o", "a.ply"), ("morse", "-o", "a.json"), ("balls", "-o", "a.xyzr"),
                      ("view", "-o", "a.html"), ("batch", "-o", "out")):
            with self.subTest(words=words):
                self.run_morskin(words[0], self.ring, *words[1:], code=7, preexec_fn=lose_folder)

    @unittest.skipUnless(Path("/dev/full").exists(), "needs /dev/full")
    def test_a_full_disk_gives_7(self):
        self.run_morskin("mesh", self.ring, "-o", "/dev/full", code=7)
        with open("/dev/full", "w") as full:
            done = subprocess.run([morskin(), "info", self.ring], stdout=full,
                                  stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 7)

    def test_memory_that_another_limit_denies_is_not_said_to_be_max_memory_s(self):
        def little_space():
            resource.setrlimit(resource.RLIMIT_AS, (100 << 20, 100 << 20))
        done = self.run_morskin("mesh", MOLECULES / "1crn.pdb", "-o", "out.ply", "-C", "0.03",
                                "--max-memory", "50G", code=6, preexec_fn=little_space)
        self.assertIn(b"out of memory", done.stderr)
        self.assertEqual(self.names(), [])

    def test_an_interrupted_run_leaves_nothing(self):
        molecule = MOLECULES / "1crn.pdb"
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([morskin(), "mesh", str(molecule), "-o", "crambin.ply", "-q",
                                        "-C", "0.02"], cwd=self.folder)
            deadline = time.monotonic() + 30
            while not self.names() and time.monotonic() < deadline:
                time.sleep(0.01)
            process.send_signal(number)
            self.assertEqual(process.wait(30), -number)
            self.assertEqual(self.names(), [])


if __name__ == "__main__":
    main()
