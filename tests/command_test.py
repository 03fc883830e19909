#!/usr/bin/env python3
"""The command from outside: files and reports. Usage: command_test.py path/to/morskin"""

import json
import os
import re
import xml.etree.ElementTree

from support.command import MOLECULES, CommandTest, main

REPORT_KEYS = """input model probe atoms_used atoms_skipped patch_radius_min patch_radius_max C Q
    vertices triangles components euler_characteristic genus expected_euler_characteristic
    expected_components expected_genus min_angle_deg max_angle_deg worst_L worst_U
    max_distance_to_skin covering_degree_ok restricted_delaunay_violations certified
    minima saddles maxima operations seconds
    floor_ratio peak_memory_bytes""".split()
OPERATION_KEYS = """creation creep wing bridge seal guard_inside_protecting
    guard_outside_protecting flip contract insert""".split()
SECONDS_KEYS = """read triangulate mixed_complex critical_points sweep refine certify write
    total""".split()


class Mesh(CommandTest):
    def test_the_report_holds_every_promised_key_and_a_torus(self):
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--model", "sas", "--probe", "0")
        self.assertEqual([k for k in REPORT_KEYS if k not in report], [])
        self.assertEqual([k for k in OPERATION_KEYS if k not in report["operations"]], [])
        self.assertEqual([k for k in SECONDS_KEYS if k not in report["seconds"]], [])
        self.assertTrue(report["certified"])
        self.assertEqual((report["components"], report["genus"]), (1, 1))
        self.assertEqual(report["minima"] - report["saddles"] + report["maxima"], 0)
        self.assertEqual(report["vertices"] - report["triangles"] // 2,
                         report["euler_characteristic"])
        self.assertGreater(report["min_angle_deg"], 21.54)
        self.assertGreater(report["worst_L"], 1)
        self.assertLess(report["worst_U"], 1)
        self.assertEqual(report["certified_file"], "ring.ply")
        self.assertEqual(self.names(), ["ring.ply"])

    def test_the_report_for_people_says_certified(self):
        text = self.run_morskin("mesh", self.ring, "-o", "ring.ply").stdout.decode()
        self.assertIn("certified: homeomorphic", text)
        self.assertIn("genus", text)

    def test_a_report_for_people_names_the_probe_only_of_models_that_have_one(self):
        for model, has_probe in (("vdw", False), ("ses-like", False), ("sas", True),
                                 ("paper", True)):
            self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--model", model, "-q")
            for words in (("info", self.ring, "--model", model),
                          ("mesh", self.ring, "-o", "again.ply", "--model", model),
                          ("check", "ring.ply", "--against", self.ring)):
                text = self.run_morskin(*words).stdout.decode()
                self.assertEqual(f"model {model}, probe 1.4 A" in text, has_probe, words)
                self.assertRegex(text, rf"model {model}\b")

    def test_reports_and_files_hold_the_probe_only_of_models_that_have_one(self):
        weights = self.input("ring.xyzw", "".join(
            f"{row.rsplit(maxsplit=1)[0]} 4.5\n" for row in self.ring.read_text().splitlines()
            if row and row[0] != "#"))
        for molecule, model, has_probe in (
                (self.ring, "vdw", False), (self.ring, "ses-like", False),
                (self.ring, "sas", True), (self.ring, "paper", True), (weights, "given", False)):
            with self.subTest(model):
                words = (molecule, "--model", model)
                reports = [self.mesh_json(*words, "-o", "ring.ply"),
                           self.check("ring.ply", "--against", molecule),
                           json.loads(self.run_morskin("info", *words, "--json").stdout)]
                self.run_morskin("morse", *words, "-o", "ring.json", "-q")
                reports.append(json.loads((self.folder / "ring.json").read_text()))
                for report in (*reports, reports[0]["provenance"]):
                    self.assertEqual(report["model"], model)
                    self.assertEqual(report.get("probe"), 1.4 if has_probe else None)
                    self.assertEqual("probe" in report, has_probe)
                mesh = (self.folder / "ring.ply").read_bytes()
                self.assertEqual(b"comment morskin: probe 1.4\n" in mesh, has_probe)

    def test_the_report_file_holds_what_json_prints(self):
        printed = self.mesh_json(self.ring, "-o", "ring.off", "--report", "report.json")
        self.assertEqual(json.loads((self.folder / "report.json").read_text()), printed)
        self.assertEqual(self.names(), ["report.json", "ring.off"])

    def test_snapshots_grow_from_nothing_to_the_whole_sweep(self):
        (self.folder / "steps").mkdir()
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--snapshots", "4",
                                "--snapshot-at", "-1e9", "--snapshot-dir", "steps")
        self.assertTrue(report["certified"])
        for wrong in ("0,,1", "0,", ","):
            self.run_morskin("mesh", self.ring, "-o", "a.ply", "--snapshot-at", wrong, code=2)
        names = sorted(path.name for path in (self.folder / "steps").iterdir())
        self.assertEqual(names, sorted(f"snapshot-{k}.{ending}" for k in range(1, 6)
                                       for ending in ("ply", "vtu")))
        open_edges, triangles = [], []
        for k in range(1, 6):
            grid = xml.etree.ElementTree.parse(self.folder / "steps" / f"snapshot-{k}.vtu")
            front = next(a for a in grid.iter("DataArray") if a.get("Name") == "front")
            self.assertIsNotNone(front)
            cells = int(grid.find(".//Piece").get("NumberOfCells"))
            mesh = (self.folder / "steps" / f"snapshot-{k}.ply").read_bytes()
            faces = int(re.search(rb"element face (\d+)", mesh).group(1))
            triangles.append(faces)
            open_edges.append(cells - faces)
        self.assertEqual(triangles, sorted(triangles))
        self.assertGreater(min(open_edges[1:4]), 0)
        self.assertEqual(open_edges[4], 0)

    def test_a_ring_grows_from_balls_to_a_torus(self):
        words = ("-o", "ring.ply", "--model", "vdw", "--method", "dynamic")
        report = self.mesh_json(self.ring, *words, "--snapshots", "3")
        self.assertTrue(report["certified"])
        self.assertEqual(report["method"], "dynamic")
        growth = report["growth"]
        self.assertEqual((growth["births"], growth["necks"], growth["failed"]), (12, 12, 0))
        faces = []
        for k in range(1, 4):
            mesh = (self.folder / f"snapshot-{k}.ply").read_bytes()
            faces.append(int(re.search(rb"element face (\d+)", mesh).group(1)))
        self.assertGreater(faces[0], 0)
        # Stopped before the balls meet: twelve spheres.
        report = self.mesh_json(self.ring, *words, "--grow", "-6..-4.5")
        self.assertTrue(report["certified"])
        self.assertEqual((report["components"], report["genus"]), (12, 0))

    def test_growth_wants_two_times_and_the_dynamic_method(self):
        for words in (("--grow", "-1..0"), ("--method", "dynamic", "--grow", "0..-1"),
                      ("--method", "dynamic", "--grow", "x..0"),
                      ("--method", "dynamic", "--grow", "0..1e30")):
            said = self.run_morskin("mesh", self.ring, "-o", "ring.ply", *words, code=2).stderr
            self.assertIn(b"--grow", said)

    def test_no_certificate_is_written_of_balls_that_no_file_has(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--method", "dynamic",
                                "--grow", "-3..-0.5", "--certificate", "c.json", code=2)
        self.assertIn(b"must end at 0", done.stderr)

    def test_snapshots_want_one_front(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--snapshots", "2",
                                "--fronts", "2", code=2)
        self.assertIn(b"leave out --fronts", done.stderr)

    def test_quiet_prints_nothing(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q")
        self.assertEqual(done.stdout + done.stderr, b"")

    def test_quiet_prints_the_report_that_json_asks_for_and_nothing_else(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q", "--json",
                                "--progress", "always")
        self.assertTrue(json.loads(done.stdout)["certified"])
        self.assertEqual(done.stderr, b"")

    def test_the_same_input_gives_the_same_bytes(self):
        for name in ("a.ply", "b.ply"):
            self.run_morskin("mesh", self.ring, "-o", name, "-q")
        self.assertEqual((self.folder / "a.ply").read_bytes(), (self.folder / "b.ply").read_bytes())

    def test_topology_and_verdict_do_not_hang_on_how_the_c_library_rounds(self):
        other = {**os.environ, "GLIBC_TUNABLES": "glibc.cpu.hwcaps=-FMA,-AVX2,-FMA4"}
        for method in ("sweep", "static"):
            words = ["mesh", MOLECULES / "atp.pdb", "-o", "atp.ply", "--method", method, "--json"]
            here = self.mesh_json(*words[1:-1])
            there = json.loads(self.run_morskin(*words, env=other).stdout)
            for key in ("certified", "components", "euler_characteristic", "genus"):
                self.assertEqual(here[key], there[key])
            self.assertTrue(here["certified"])

    def test_every_format_is_written_and_the_first_exact_one_is_certified(self):
        names = ["m.stl", "m.vtu", "m.obj", "m.off", "m.ply"]
        report = self.mesh_json(self.ring, *(w for n in names for w in ("-o", n)))
        self.assertEqual(report["certified_file"], "m.vtu")
        self.assertEqual(report["outputs"], names)
        self.assertEqual(self.names(), sorted(names))

    def test_a_lone_stl_is_certified_in_memory_and_the_report_says_so(self):
        report = self.mesh_json(self.ring, "-o", "ring.stl")
        self.assertTrue(report["certified"])
        self.assertEqual(report["certified_file"], "a binary PLY copy in memory")

    def test_a_mesh_on_standard_output_is_alone_there(self):
        done = self.run_morskin("mesh", self.ring, "-o", "-")
        self.assertTrue(done.stdout.startswith(b"ply\n"))
        self.assertIn(b"certified", done.stderr)
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q")
        self.assertEqual(done.stdout, (self.folder / "ring.ply").read_bytes())

    def test_dev_null_is_an_output(self):
        self.assertTrue(self.mesh_json(self.ring, "-o", "/dev/null")["certified"])
        self.assertEqual(self.names(), [])

    def test_the_molecule_may_come_from_standard_input(self):
        self.run_morskin("mesh", "-", "-o", "ring.ply", "-q", input=self.ring.read_bytes())
        self.assertEqual(self.names(), ["ring.ply"])

    def test_the_progress_line_is_shown_only_when_asked_off_a_terminal(self):
        for words, stage in ((("mesh", self.ring, "-o", "ring.ply"), b"%"),
                             (("info", self.ring), b"mixed complex"),
                             (("check", "ring.ply", "--against", self.ring), b"certify")):
            self.assertIn(stage, self.run_morskin(*words, "--progress", "always").stderr)
            self.assertEqual(self.run_morskin(*words).stderr, b"")

    def test_a_direction_is_taken_with_a_minus_sign(self):
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--height", "-1,0.3,0.2")
        self.assertLess(report["height"][0], 0)
        self.assertEqual(report["function"]["kind"], "height")
        self.run_morskin("mesh", self.ring, "-o", "long.ply", "-q", "--function",
                         "height:-1,0.3,0.2")
        self.assertEqual((self.folder / "ring.ply").read_bytes(),
                         (self.folder / "long.ply").read_bytes())

    def test_a_coarse_mesh_is_certified_and_the_report_says_what_is_not_proved_beforehand(self):
        result = self.run_morskin("mesh", MOLECULES / "caffeine.xyz", "-o", "out.ply", "-C", "0.18",
                                  "--json")
        report = json.loads(result.stdout)
        self.assertFalse(report["C_Q_in_proved_range"])
        self.assertGreater(report["Q"], 1.8)
        self.assertIn(b"the certificate decides", result.stderr)
        self.run_morskin("check", "out.ply", "--against", MOLECULES / "caffeine.xyz", "-C", "0.18")
        people = self.run_morskin("mesh", MOLECULES / "caffeine.xyz", "-o", "out.ply", "-C", "0.18")
        self.assertIn(b"certified all the same", people.stdout)


class NotCertified(CommandTest):
    # Far outside the range of the theory: triangles as big as the surface's features.
    WORDS = ("-C", "0.9", "-Q", "1.9")

    def test_a_mesh_that_is_not_certified_is_called_unverified(self):
        self.input("ring.ply", "an older mesh")
        report = self.mesh_json(self.ring, "-o", "ring.ply", *self.WORDS, code=5)
        self.assertFalse(report["certified"])
        self.assertTrue(report["reason"])
        self.assertEqual(report["outputs"], ["ring.ply.unverified"])
        self.assertEqual(report["certified_file"], "ring.ply.unverified")  # that was looked at
        self.assertEqual((self.folder / "ring.ply").read_text(), "an older mesh")
        self.assertEqual(self.names(), ["ring.ply", "ring.ply.unverified"])

    def test_nothing_else_may_have_a_name_of_what_is_not_certified(self):
        for option in ("-o", "--areas", "--certificate"):
            name = "other.ply" if option == "-o" else "other.csv"
            done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", option, name, "--report",
                                    name + ".unverified", *self.WORDS, code=2)
            self.assertIn("goes when it is not certified", done.stderr.decode())

    def test_no_mesh_that_is_not_certified_nor_what_belongs_to_it_reaches_standard_output(self):
        done = self.run_morskin("mesh", self.ring, "-o", "-", "-q", *self.WORDS, code=5)
        self.assertEqual(done.stdout, b"")
        self.assertIn(b"not certified", done.stderr)
        for option in ("--areas", "--certificate"):
            done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", option, "-", "-q",
                                    *self.WORDS, code=5)
            self.assertEqual(done.stdout, b"")

    def test_of_many_components_not_mended_people_are_told_of_a_few(self):
        ring = (MOLECULES / "ring12.xyzr").read_text().splitlines()
        atoms = [list(map(float, line.split())) for line in ring if not line.startswith("#")]
        rings = self.input("rings.xyzr", "".join(f"{x + 100 * i} {y} {z} {r}\n"
                                                 for i in range(8) for x, y, z, r in atoms))
        words = ("mesh", rings, "-o", "rings.ply", "--report", "r.json", *self.WORDS)
        lines = self.run_morskin(*words, code=5).stdout.decode().splitlines()
        told = [line for line in lines if line.strip().startswith("fallback")]
        self.assertEqual(len(json.loads((self.folder / "r.json").read_text())["fallbacks"]), 8)
        self.assertEqual(len(told), 6)
        self.assertIn("3 components more", told[-1])

    def test_a_note_says_that_the_sizes_are_out_of_range(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", *self.WORDS, code=5)
        self.assertRegex(done.stderr, rb"C Q = 1.71 is above.*; nearly every skin .* to -C 0.4\n")


if __name__ == "__main__":
    main()
