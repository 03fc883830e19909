#!/usr/bin/env python3
"""The command from outside: exit codes, files, reports. Usage: command_test.py path/to/morskin"""

import base64
import collections
import gzip
import json
import os
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import xml.etree.ElementTree
from pathlib import Path

MOLECULES = Path(__file__).resolve().parent.parent / "bench" / "molecules"
MORSKIN = "build/morskin"

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


class CommandTest(unittest.TestCase):
    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.folder = Path(temporary.name)
        self.ring = self.input("ring.xyzr", (MOLECULES / "ring12.xyzr").read_bytes())

    def input(self, name, content):
        path = self.folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def run_morskin(self, *words, code=0, **options):
        done = subprocess.run([MORSKIN, *map(str, words)], capture_output=True, cwd=self.folder,
                              timeout=120, **options)
        self.assertEqual(done.returncode, code, repr(done.stderr + done.stdout[-2000:]))
        return done

    def names(self):
        return sorted(p.name for p in self.folder.iterdir() if p.name != "ring.xyzr")

    def check(self, *words, code=0):
        return json.loads(self.run_morskin("check", *words, "--json", code=code).stdout)

    def mesh_json(self, *words, code=0):
        return json.loads(self.run_morskin("mesh", *words, "--json", code=code).stdout)


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

    def test_the_report_file_holds_what_json_prints(self):
        printed = self.mesh_json(self.ring, "-o", "ring.off", "--report", "report.json")
        self.assertEqual(json.loads((self.folder / "report.json").read_text()), printed)
        self.assertEqual(self.names(), ["report.json", "ring.off"])

    def test_snapshots_grow_from_nothing_to_the_whole_sweep(self):
        (self.folder / "steps").mkdir()
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--snapshots", "4",
                                "--snapshot-at", "-1e9", "--snapshot-dir", "steps")
        self.assertTrue(report["certified"])
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
                      ("--method", "dynamic", "--grow", "x..0")):
            self.run_morskin("mesh", self.ring, "-o", "ring.ply", *words, code=2)

    def test_snapshots_want_one_front(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--snapshots", "2",
                                "--fronts", "2", code=2)
        self.assertIn(b"--fronts 2", done.stderr)

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

    def test_every_format_is_written_and_the_first_exact_one_is_certified(self):
        names = ["m.stl", "m.vtu", "m.obj", "m.off", "m.ply"]
        report = self.mesh_json(self.ring, *(w for n in names for w in ("-o", n)))
        self.assertEqual(report["certified_file"], "m.obj")
        self.assertEqual(report["outputs"], names)
        self.assertEqual(self.names(), sorted(names))

    def test_a_lone_stl_is_certified_in_memory_and_the_report_says_so(self):
        report = self.mesh_json(self.ring, "-o", "ring.stl")
        self.assertTrue(report["certified"])
        self.assertIn("in memory", report["certified_file"])

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
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--progress", "always")
        self.assertIn(b"%", done.stderr)
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply")
        self.assertEqual(done.stderr, b"")

    def test_a_direction_is_taken_with_a_minus_sign(self):
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--height", "-1,0.3,0.2")
        self.assertLess(report["height"][0], 0)
        self.assertEqual(report["function"]["kind"], "height")
        self.run_morskin("mesh", self.ring, "-o", "long.ply", "-q", "--function",
                         "height:-1,0.3,0.2")
        self.assertEqual((self.folder / "ring.ply").read_bytes(),
                         (self.folder / "long.ply").read_bytes())

    def test_waters_are_kept_when_asked(self):
        words = (MOLECULES / "9dna.pdb", "--json")
        dry = json.loads(self.run_morskin("info", *words).stdout)
        wet = json.loads(self.run_morskin("info", *words, "--waters").stdout)
        self.assertEqual(wet["atoms"], dry["atoms"] + dry["skipped_waters"])
        self.assertGreater(dry["skipped_waters"], 0)


class NotCertified(CommandTest):
    # Far outside the range of the theory: triangles as big as the surface's features.
    WORDS = ("-C", "0.9", "-Q", "1.9")

    def test_a_mesh_that_is_not_certified_is_called_unverified(self):
        self.input("ring.ply", "an older mesh")
        report = self.mesh_json(self.ring, "-o", "ring.ply", *self.WORDS, code=5)
        self.assertFalse(report["certified"])
        self.assertTrue(report["reason"])
        self.assertEqual(report["outputs"], ["ring.ply.unverified"])
        self.assertEqual((self.folder / "ring.ply").read_text(), "an older mesh")
        self.assertEqual(self.names(), ["ring.ply", "ring.ply.unverified"])

    def test_a_mesh_that_is_not_certified_does_not_reach_standard_output(self):
        done = self.run_morskin("mesh", self.ring, "-o", "-", "-q", *self.WORDS, code=5)
        self.assertEqual(done.stdout, b"")
        self.assertIn(b"not certified", done.stderr)

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
        self.assertIn(b"C Q = 1.71 is above", done.stderr)


class Morse(CommandTest):
    def morse_json(self, molecule, *words):
        self.run_morskin("morse", molecule, "-o", "complex.json", "-q", *words)
        return json.loads((self.folder / "complex.json").read_text())

    def check_complex(self, complex_):
        """Points, arcs and regions belong together; returns the counts of survivors by index."""
        points = complex_["critical_points"]
        self.assertEqual([p["id"] for p in points], list(range(len(points))))
        left = collections.Counter(p["index"] for p in points if p["survives"])
        self.assertEqual(left[0] - left[1] + left[2], complex_["euler_characteristic"])
        self.assertEqual((len(complex_["arcs"]), len(complex_["regions"])),
                         (4 * left[1], 2 * left[1]))
        arcs = set()
        for arc in complex_["arcs"]:
            saddle, extremum = points[arc["saddle"]], points[arc["extremum"]]
            self.assertTrue(saddle["survives"] and extremum["survives"])
            self.assertEqual(saddle["index"], 1)
            self.assertIn(extremum["index"], (0, 2))
            self.assertEqual(arc["points"][0], saddle["position"])
            self.assertEqual(arc["points"][-1], extremum["position"])
            arcs.add((arc["saddle"], arc["extremum"]))
        for low, first, high, second in complex_["regions"]:
            self.assertEqual([points[i]["index"] for i in (low, first, high, second)], [0, 1, 2, 1])
            self.assertLessEqual({(a, e) for a in (first, second) for e in (low, high)}, arcs)
        return left

    def test_the_raw_complex_of_a_torus_has_every_promised_key_and_belongs_together(self):
        torus = self.morse_json(self.ring, "--model", "sas", "--probe", "0", "--raw")
        for key in """critical_points arcs regions hierarchy cancelled euler_characteristic
                components function model input before after shrunk_radii""".split():
            self.assertIn(key, torus)
        self.assertEqual((torus["euler_characteristic"], torus["components"]), (0, 1))
        for point in torus["critical_points"]:
            self.assertEqual(set(point), {"id", "index", "value", "position", "length_scale",
                                          "patch", "survives", "radius"})
            self.assertIn(point["patch"], ("vertex", "edge", "triangle", "tetrahedron"))
            self.assertTrue(point["survives"])
            height = sum(a * b for a, b in zip(torus["function"]["direction"], point["position"]))
            self.assertAlmostEqual(height, point["value"])
        left = self.check_complex(torus)
        # What no cancellation can remove: a minimum, a maximum, and two saddles for the handle.
        self.assertEqual(left[1] - len(torus["hierarchy"]), 2)
        self.assertEqual(torus["before"], torus["after"])
        self.assertEqual(self.names(), ["complex.json"])

    def test_simplified_by_spheres_or_persistence_the_complex_still_belongs_together(self):
        molecule = MOLECULES / "1grm_model1.pdb"
        raw = self.morse_json(molecule, "--raw")
        self.check_complex(raw)
        pairs = {(p["saddle"], p["extremum"]): p["persistence"] for p in raw["hierarchy"]}
        by_spheres = self.morse_json(molecule)
        self.check_complex(by_spheres)
        gone = [(c["saddle"], c["extremum"]) for c in by_spheres["cancelled"]]
        self.assertGreater(len(gone), 10)
        self.assertLessEqual(set(gone), set(pairs))
        self.assertLess(by_spheres["overlaps_left"], by_spheres["overlaps_before"])
        limit = sorted(pairs.values())[len(pairs) // 2]
        by_persistence = self.morse_json(molecule, "--persistence", repr(limit))
        self.check_complex(by_persistence)
        self.assertEqual({(c["saddle"], c["extremum"]) for c in by_persistence["cancelled"]},
                         {pair for pair, persistence in pairs.items() if persistence <= limit})
        left = self.check_complex(self.morse_json(molecule, "--persistence", "inf"))
        genus = raw["components"] - raw["euler_characteristic"] // 2
        self.assertEqual((left[0], left[1], left[2]),
                         (raw["components"], 2 * genus, raw["components"]))

    def test_the_vtu_holds_critical_points_as_vertices_and_arcs_as_lines(self):
        complex_ = self.morse_json(self.ring)
        self.run_morskin("morse", self.ring, "-o", "complex.vtu", "-q")
        piece = xml.etree.ElementTree.parse(self.folder / "complex.vtu").getroot()[0][0]
        arrays = {}
        for group in piece:
            for array in group:
                data = base64.b64decode(array.text, validate=True)
                letter = {"Float64": "d", "Int64": "q", "UInt8": "B"}[array.get("type")]
                (size,) = struct.unpack("<Q", data[:8])
                self.assertEqual(size, len(data) - 8)
                arrays[group.tag, array.get("Name")] = list(
                    value for value, in struct.iter_unpack("<" + letter, data[8:]))
        points, arcs = complex_["critical_points"], complex_["arcs"]
        lines = sum(len(arc["points"]) - 1 for arc in arcs)
        cells = len(points) + lines
        self.assertEqual(int(piece.get("NumberOfCells")), cells)
        self.assertEqual(arrays["Cells", "types"], [1] * len(points) + [3] * lines)
        self.assertEqual(len(arrays["PointData", "value"]), int(piece.get("NumberOfPoints")))
        for name in ("index", "value", "id", "arc", "survives"):
            self.assertEqual(len(arrays["CellData", name]), cells)
        self.assertEqual(arrays["CellData", "index"][:len(points)], [p["index"] for p in points])
        self.assertEqual(arrays["CellData", "value"][:len(points)], [p["value"] for p in points])
        positions = arrays["Points", "Points"]
        ends = [0, *arrays["Cells", "offsets"]]
        cell = len(points)
        for number, arc in enumerate(arcs):
            walked = []
            while cell < cells and arrays["CellData", "arc"][cell] == number:
                walked.append(arrays["Cells", "connectivity"][ends[cell]:ends[cell + 1]])
                cell += 1
            self.assertTrue(all(a[1] == b[0] for a, b in zip(walked, walked[1:])))
            corners = [walked[0][0], *(segment[1] for segment in walked)]
            self.assertEqual([positions[3 * c:3 * c + 3] for c in corners], arc["points"])
        self.assertEqual(cell, cells)

    def test_distances_are_functions_too(self):
        ball = self.input("ball.xyzr", "1 2 3 1.5\n")
        complex_ = self.morse_json(ball, "--function", "distance:5,2,3", "--model", "vdw")
        self.assertEqual(complex_["function"], {"kind": "distance", "origin": [5, 2, 3]})
        values = sorted(p["value"] for p in complex_["critical_points"])
        self.assertEqual(len(values), 2)
        self.assertAlmostEqual(values[0], 2.5 ** 2)
        self.assertAlmostEqual(values[1], 5.5 ** 2)

    def test_the_complex_on_standard_output_is_alone_there_and_json(self):
        done = self.run_morskin("morse", self.ring, "-o", "-")
        self.assertEqual(json.loads(done.stdout)["components"], 1)
        self.assertIn(b"saddles", done.stderr)
        done = self.run_morskin("morse", self.ring, "-o", "complex.JSON")
        self.assertIn(b"saddles", done.stdout)
        done = self.run_morskin("morse", self.ring, "-o", "complex.vtu", "-q")
        self.assertEqual(done.stdout + done.stderr, b"")

    def test_the_same_input_gives_the_same_bytes(self):
        for name in ("a.json", "b.json", "a.vtu", "b.vtu"):
            self.run_morskin("morse", self.ring, "-o", name, "-q")
        for ending in ("json", "vtu"):
            self.assertEqual((self.folder / f"a.{ending}").read_bytes(),
                             (self.folder / f"b.{ending}").read_bytes())

    def test_a_degenerate_function_of_the_user_gives_2_and_the_place(self):
        for command, out in (("morse", "out.json"), ("mesh", "out.ply")):
            done = self.run_morskin(command, MOLECULES / "cube8.xyzr", "-o", out, "--function",
                                    "height:0,1,0", code=2)
            self.assertRegex(done.stderr.decode(), r"degenerate.* at \(.*\).*--function")
        self.assertEqual(self.names(), [])


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
                      (*good, "-C", "1e-22"), (*good, "--size", "1e-22"),
                      (*good, "--method", "static", "--snapshots", "3"),
                      (*good, "--method", "static", "--fronts", "1"),
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
                      ("morse", self.ring, "-o", self.ring),
                      ("balls", self.ring, "-o", self.ring)]:
            with self.subTest(words=words):
                done = self.run_morskin(*words, code=2)
                self.assertTrue(done.stderr.startswith(b"morskin: "))
                self.assertEqual(done.stdout, b"")
        self.assertEqual(self.names(), [])

    def test_help_and_version_are_no_failure(self):
        self.assertIn(b"Exit codes", self.run_morskin("--help").stdout)
        for command in ("mesh", "morse", "balls", "info", "check"):
            self.assertIn(b"Usage", self.run_morskin(command, "--help").stdout)
        self.assertTrue(self.run_morskin("--version").stdout.startswith(b"morskin "))

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
        self.input("huge.xyzr", "0 0 0 900000\n")
        self.run_morskin("mesh", "huge.xyzr", "-o", "out.ply", "--model", "vdw", code=4)

    def test_a_report_on_standard_output_is_all_that_is_there(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--report", "-")
        self.assertTrue(json.loads(done.stdout)["certified"])
        self.assertIn(b"certified", done.stderr)

    def test_an_uncertified_mesh_needs_its_place_as_well(self):
        (self.folder / "b.ply.unverified").mkdir()
        done = self.run_morskin("mesh", self.ring, "-o", "a.ply", "-o", "b.ply", code=7)
        self.assertIn(b"b.ply.unverified", done.stderr)
        self.assertEqual(self.names(), ["b.ply.unverified"])

    def test_an_unwritable_output_gives_7(self):
        (self.folder / "folder.ply").mkdir()
        for name in ("no/such/folder/out.ply", "folder.ply"):
            with self.subTest(name=name):
                self.run_morskin("mesh", self.ring, "-o", name, code=7)
        self.run_morskin("mesh", self.ring, "-o", "a.ply", "--report", "no/report.json", code=7)
        self.run_morskin("balls", self.ring, "-o", "no/out.xyzr", code=7)
        self.run_morskin("morse", self.ring, "-o", "no/out.json", code=7)
        self.assertEqual(self.names(), ["folder.ply"])

    @unittest.skipUnless(Path("/dev/full").exists(), "needs /dev/full")
    def test_a_full_disk_gives_7(self):
        self.run_morskin("mesh", self.ring, "-o", "/dev/full", code=7)
        with open("/dev/full", "w") as full:
            done = subprocess.run([MORSKIN, "info", self.ring], stdout=full,
                                  stderr=subprocess.PIPE, check=False)
        self.assertEqual(done.returncode, 7)

    def test_an_interrupted_run_leaves_nothing(self):
        molecule = MOLECULES / "1crn.pdb"
        for number in (signal.SIGINT, signal.SIGTERM):
            process = subprocess.Popen([MORSKIN, "mesh", str(molecule), "-o", "crambin.ply", "-q",
                                        "-C", "0.02"], cwd=self.folder)
            deadline = time.monotonic() + 30
            while not self.names() and time.monotonic() < deadline:
                time.sleep(0.01)
            process.send_signal(number)
            self.assertEqual(process.wait(30), -number)
            self.assertEqual(self.names(), [])


class Check(CommandTest):
    """Each mesh is made wrong in one way; the verdict that it breaks says where."""

    def setUp(self):
        super().setUp()
        self.words = ("--against", MOLECULES / "shell_hollow.xyzr", "--model", "vdw")

    def good_mesh(self, molecule=MOLECULES / "shell_hollow.xyzr"):
        self.run_morskin("mesh", molecule, "-o", "good.off", "-q", "--model", "vdw")
        lines = (self.folder / "good.off").read_text().splitlines()
        count = int(lines[1].split()[0])
        vertices = [[float(w) for w in line.split()] for line in lines[2:2 + count]]
        return vertices, [[int(w) for w in line.split()[1:]] for line in lines[2 + count:]]

    def write(self, vertices, triangles):
        lines = ["OFF", f"{len(vertices)} {len(triangles)} 0"]
        lines += [" ".join(map(repr, v)) for v in vertices]
        lines += ["3 " + " ".join(map(str, t)) for t in triangles]
        return self.input("bad.off", "\n".join(lines) + "\n")

    def component(self, triangles, number):
        part = self.check("good.off")["component_list"][number]
        start = part["first_triangle"]
        corners = set(triangles[start])
        while True:  # as many rounds as the component is wide
            more = {v for t in triangles if not corners.isdisjoint(t) for v in t}
            if more == corners:
                return [t for t in triangles if t[0] in corners]
            corners = more

    def compact(self, vertices, triangles):
        names = {v: i for i, v in enumerate(sorted({v for t in triangles for v in t}))}
        return [vertices[v] for v in names], [[names[v] for v in t] for t in triangles]

    def broken(self, *words):
        report = self.check("bad.off", *words, code=5)
        self.assertFalse(report["passed"])
        self.assertTrue(report["reason"])
        return {v["name"]: v["reason"] for v in report["verdicts"]
                if v["required"] and not v["holds"]}

    def test_a_right_mesh_passes_every_verdict(self):
        self.good_mesh()
        for words in ((), self.words):
            report = self.check("good.off", *words)
            self.assertTrue(report["passed"])
            self.assertEqual([v for v in report["verdicts"] if not v["holds"]], [])
            self.assertEqual(report["components"], 2)
            volumes = sorted(c["volume"] for c in report["component_list"])
            self.assertLess(volumes[0], 0)
            self.assertAlmostEqual(sum(volumes), report["volume"], 6)
            self.assertEqual(sum(report["angle_histogram"]), 3 * report["triangles"])
        self.assertEqual(report["restricted_delaunay_violations"], 0)
        self.assertEqual(len(report["worst_triangles"]), 10)
        text = self.run_morskin("check", "good.off", *self.words).stdout
        self.assertNotIn(b"NO", text)

    def test_a_flipped_triangle(self):
        vertices, triangles = self.good_mesh()
        triangles[9] = triangles[9][::-1]
        self.write(vertices, triangles)
        self.assertIn("disagree on orientation", self.broken()["oriented"])
        broken = self.broken(*self.words)
        self.assertIn("triangle 9 ", broken["triangles face the way the skin does"])
        self.assertNotIn("vertices on the skin", broken)

    def test_a_hole(self):
        vertices, triangles = self.good_mesh()
        a, b, _ = sorted(triangles.pop(9))
        self.write(vertices, triangles)
        self.assertEqual(list(self.broken()), ["closed"])
        self.assertIn(f"edge {a}-{b} has only one triangle (the first of 3)",
                      self.broken()["closed"])

    def test_a_missing_void_a_missing_surface_and_a_doubled_one(self):
        vertices, triangles = self.good_mesh()
        parts = [self.component(triangles, i) for i in (0, 1)]
        name = "every component once"
        self.write(*self.compact(vertices, parts[0]))
        broken = self.broken(*self.words)
        self.assertRegex(broken[name], "the wall of the void at .* is missing")
        self.assertIn("components is 1, the skin's is 2",
                      broken["components, Euler characteristic and genus of the skin"])
        self.write(*self.compact(vertices, parts[1]))
        self.assertRegex(self.broken(*self.words)[name], "the outer surface of .* is missing")
        shift = len(vertices)
        self.write(vertices + vertices, triangles + [[v + shift for v in t] for t in parts[1]] +
                   [[v + shift for v in t] for t in parts[0]])
        broken = self.broken(*self.words)
        self.assertRegex(broken[name], "outer surface of .* is covered by components ")
        self.assertIn("covers the skin once", broken)
        self.assertIn("meet where they should not", broken["without self-intersections"])

    def test_a_dropped_handle(self):
        # The mesh of a chain with one ball less than the ring: no handle.
        balls = self.ring.read_text().splitlines()
        chain = self.input("chain.xyzr", "\n".join(balls[:-1]) + "\n")
        self.good_mesh(chain)
        (self.folder / "good.off").rename(self.folder / "bad.off")
        broken = self.broken("--against", self.ring, "--model", "vdw")
        self.assertIn("the genus is 0, the skin's is 1",
                      broken["components, Euler characteristic and genus of the skin"])

    def test_a_vertex_off_the_surface(self):
        vertices, triangles = self.good_mesh()
        vertices[20][0] += 1e-4
        self.write(vertices, triangles)
        broken = self.broken(*self.words)
        self.assertIn("vertex 20 lies ", broken["vertices on the skin"])
        report = self.check("bad.off", *self.words, code=5)
        self.assertEqual(report["farthest_vertices"][0]["vertex"], 20)

    def test_a_self_intersection(self):
        vertices, triangles = self.good_mesh(MOLECULES / "two_balls.xyzr")
        middle = [sum(v[k] for v in vertices) / len(vertices) for k in range(3)]
        vertices[20] = [1.5 * m - 0.5 * x for m, x in zip(middle, vertices[20])]
        vertices[20] = [3 * x - 2 * m for m, x in zip(middle, vertices[20])]
        self.write(vertices, triangles)
        self.assertEqual(list(self.broken()), ["without self-intersections"])
        report = self.check("bad.off", code=5)
        self.assertGreater(report["self_intersections"], 0)
        at_20 = [t for t, corners in enumerate(triangles) if 20 in corners]
        self.assertTrue(all(s in at_20 or t in at_20 for s, t in report["self_intersecting_pairs"]))
        self.check("bad.off", "--no-self-intersections")

    def test_duplicate_and_degenerate_triangles(self):
        vertices, triangles = self.good_mesh()
        self.write(vertices, triangles + [triangles[5]])
        self.assertIn("triangles 5 and", self.broken()["without duplicate triangles"])
        self.write(vertices, triangles + [[3, 3, 4]])
        self.assertIn(f"triangle {len(triangles)} repeats",
                      self.broken()["without degenerate triangles"])


class OtherCommands(CommandTest):
    def test_check_agrees_with_mesh(self):
        report = self.mesh_json(self.ring, "-o", "ring.ply", "--model", "vdw")
        checked = json.loads(self.run_morskin("check", "ring.ply", "--against", self.ring,
                                              "--model", "vdw", "--json").stdout)
        for key in ("certified", "vertices", "triangles", "components", "genus", "min_angle_deg",
                    "worst_L", "worst_U", "area", "volume", "max_distance_to_skin"):
            self.assertEqual(checked[key], report[key], key)

    def test_check_refuses_the_mesh_of_another_surface(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q")
        self.run_morskin("check", "ring.ply", "--against", self.ring, "--model", "sas", code=5)
        self.run_morskin("check", "ring.ply", "--against", MOLECULES / "cube8.xyzr", code=5)

    def test_check_alone_tells_a_closed_mesh_from_an_open_one(self):
        tetrahedron = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\n"
        self.input("open.obj", tetrahedron)
        self.input("closed.obj", tetrahedron + "f 1 4 3\n")
        shape = json.loads(self.run_morskin("check", "closed.obj", "--json").stdout)
        self.assertTrue(shape["closed_oriented_manifold"])
        self.assertEqual((shape["components"], shape["genus"]), (1, 0))
        self.assertAlmostEqual(shape["volume"], 1 / 6)
        self.assertIn(b"manifold    NO", self.run_morskin("check", "open.obj", code=5).stdout)

    def test_an_stl_file_passes_as_far_as_single_precision_goes(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.stl", "-o", "ring.ply", "-q")
        report = self.check("ring.stl", "--against", self.ring)
        self.assertTrue(report["single_precision"])
        self.assertGreater(report["max_distance_to_skin"], 1e-9)
        self.assertFalse(self.check("ring.ply", "--against", self.ring)["single_precision"])

    def test_check_reads_gzipped_meshes_and_msms_pairs_by_either_name(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.off", "-q")
        off = (self.folder / "ring.off").read_bytes()
        self.input("packed.off.gz", gzip.compress(off))
        lines = off.decode().splitlines()
        count = int(lines[1].split()[0])
        vertices = "".join(f"{line} 0 0 1 0 1 2\n" for line in lines[2:2 + count])
        triangles = [[int(w) + 1 for w in line.split()[1:]] for line in lines[2 + count:]]
        faces = "".join(f"{a} {b} {c} 1 1\n" for a, b, c in triangles)
        title = "# MSMS solvent excluded surface\n#vertex #sphere density probe_r\n"
        self.input("ring.vert", f"{title}{count} 12 3.0 1.4\n{vertices}")
        self.input("ring.face", f"{title}{len(triangles)} 12 3.0 1.4\n{faces}")
        self.input("loose.VERT", vertices)
        self.input("loose.FACE.gz", gzip.compress(faces.encode()))
        whole = self.check("ring.off", "--against", self.ring)
        for name in ("packed.off.gz", "ring.vert", "ring.face", "loose.VERT", "loose.FACE.gz"):
            with self.subTest(name=name):
                checked = self.check(name, "--against", self.ring)
                for key in ("triangles", "area", "volume", "worst_L", "worst_U", "passed"):
                    self.assertEqual(checked[key], whole[key])
        self.input("alone.vert", vertices)
        self.input("short.vert", f"{count + 1} 12 3.0 1.4\n{vertices}")
        self.input("short.face", faces)
        self.input("beyond.vert", vertices)
        self.input("beyond.face", f"{faces}1 2 {count + 1} 1 1\n")
        for name, words in (("alone.vert", b"alone.face"), ("short.face", b"promises"),
                            ("beyond.vert", b"does not exist")):
            self.assertIn(words, self.run_morskin("check", name, code=3).stderr)

    def test_check_refuses_what_is_no_mesh_with_a_clear_message(self):
        header = "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n" \
                 "property float z\nelement face 1\nproperty list uchar int vertex_indices\n" \
                 "end_header\n"
        for name, content, code, words in [
                ("empty.ply", "", 3, b"empty"),
                ("nan.ply", header + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", 3, b"not finite"),
                ("inf.off", "OFF\n3 1 0\n0 0 inf\n1 0 0\n0 1 0\n3 0 1 2\n", 3, b"not finite"),
                ("none.off", "OFF\n0 0 0\n", 5, b"no triangles"),
                ("points.off", "OFF\n1 0 0\n1 2 3\n", 5, b"no triangles"),
                ("cut.off.gz", gzip.compress(b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")[:-9], 3,
                 b"cut short"),
                ("same.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 0 0\n", 5, b"repeats a corner"),
                ("point.off", "OFF\n4 4 0\n" + 4 * "1 1 1\n" +
                 "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n", 5, b"on one line"),
                ("crowd.off", "OFF\n5 3 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n0 -1 0\n"
                 "3 0 1 2\n3 0 1 3\n3 1 0 4\n", 5, b"edge 0-1 has 3 triangles")]:
            with self.subTest(name=name):
                self.input(name, content)
                done = self.run_morskin("check", name, code=code)
                self.assertIn(words, done.stdout + done.stderr)
                self.run_morskin("check", name, "--against", self.ring, code=code)

    def test_check_of_a_mesh_without_triangles_has_no_angles_and_still_looks_at_the_vertices(self):
        self.input("ball.xyzr", "0 0 0 1.5\n")
        self.input("points.off", "OFF\n1 0 0\n1 2 3\n")
        for against in ([], ["--against", "ball.xyzr"]):
            done = self.run_morskin("check", "points.off", *against, code=5)
            self.assertNotIn(b"\n  angles ", done.stdout)
            report = json.loads(
                self.run_morskin("check", "points.off", *against, "--json", code=5).stdout)
            self.assertIsNone(report["min_angle_deg"])
        verdicts = {v["name"]: v for v in report["verdicts"]}
        self.assertIn("vertex 0 lies", verdicts["vertices on the skin"]["reason"])

    def test_check_of_coordinates_near_the_ends_of_the_doubles(self):
        for size in ("1e300", "1e-300"):
            text = f"OFF\n4 4 0\n0 0 0\n{size} 0 0\n0 {size} 0\n0 0 {size}\n" \
                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
            self.input("far.off", text)
            self.assertTrue(self.check("far.off")["closed_oriented_manifold"])
            self.assertEqual(self.check("far.off")["self_intersections"], 0)
            self.run_morskin("check", "far.off", "--against", self.ring, code=5)

    def test_the_balls_are_those_of_the_model(self):
        self.input("ball.xyzr", "1 2 3 1.5\n")
        for model, radius in (("vdw", 1.5), ("sas", 2.9), ("paper", (2 ** 0.5 * 2.9 / 2) ** 0.5)):
            self.run_morskin("balls", "ball.xyzr", "-o", "out.xyzr", "--model", model)
            numbers = [float(w) for w in (self.folder / "out.xyzr").read_text().split()]
            self.assertEqual(numbers[:3], [1, 2, 3])
            self.assertAlmostEqual(numbers[3], radius)

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

    def test_info_counts_the_elements(self):
        info = json.loads(self.run_morskin("info", MOLECULES / "caffeine.xyz", "--json").stdout)
        self.assertEqual(info["elements"], {"C": 8, "H": 10, "N": 4, "O": 2})
        self.assertEqual(info["atoms"], 24)
        self.assertGreater(info["estimated_triangles"], 0)
        self.assertIn(b"about", self.run_morskin("info", MOLECULES / "caffeine.xyz").stdout)


if __name__ == "__main__":
    if len(sys.argv) > 1:
        MORSKIN = os.path.abspath(sys.argv.pop(1))
    unittest.main()
