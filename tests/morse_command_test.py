#!/usr/bin/env python3
"""`morskin morse` from outside. Usage: morse_command_test.py path/to/morskin"""

import base64
import collections
import json
import math
import struct
import xml.etree.ElementTree

from support.command import MOLECULES, CommandTest, main


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
        self.check_counts(complex_)
        return left

    def check_counts(self, complex_):
        """Points before and after are as many as are told, and of each pair cancelled it is told
        which extremum its saddle's arcs lead to now."""
        points, kinds = complex_["critical_points"], ("minima", "saddles", "maxima")
        left = [p for p in points if p["survives"]]
        for told, found in ((complex_["before"], points), (complex_["after"], left)):
            count = collections.Counter(kinds[p["index"]] for p in found)
            self.assertEqual({kind: told[kind] for kind in kinds},
                             {kind: count[kind] for kind in kinds})
        for name in ("arcs", "regions"):
            self.assertEqual(complex_["after"][name], len(complex_[name]))
        self.assertEqual(complex_["cancelled_pairs"], len(complex_["cancelled"]))
        for pair in complex_["cancelled"]:
            saddle, extremum, heir = (points[pair[key]] for key in ("saddle", "extremum", "heir"))
            self.assertFalse(saddle["survives"] or extremum["survives"])
            self.assertEqual(saddle["index"], 1)
            self.assertEqual(extremum["index"], heir["index"])
            self.assertNotEqual(extremum["id"], heir["id"])
            self.assertAlmostEqual(pair["persistence"], abs(saddle["value"] - extremum["value"]))

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
                letters = {"Float64": "d", "Int64": "q", "Int32": "i", "UInt8": "B"}
                letter = letters[array.get("type")]
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
        for name in ("id", "survives"):
            self.assertEqual(arrays["CellData", name][:len(points)], [p[name] for p in points])
        self.assertEqual(arrays["PointData", "value"][:len(points)], [p["value"] for p in points])
        positions = arrays["Points", "Points"]
        ends = [0, *arrays["Cells", "offsets"]]
        cell = len(points)
        for number, arc in enumerate(arcs):
            walked = []
            while cell < cells and arrays["CellData", "arc"][cell] == number:
                self.assertEqual([arrays["CellData", name][cell] for name in ("id", "index")],
                                 [arc["saddle"], points[arc["extremum"]]["index"]])
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

    def test_points_say_on_which_patch_they_lie_and_how_much_it_bends(self):
        row = self.input("row.xyzr", "0 0 0 2\n2 0 0 2\n")
        complex_ = self.morse_json(row, "--raw", "--function", "height:0.1,1,0.2")
        found = {(p["index"], p["patch"]) for p in complex_["critical_points"]}
        self.assertEqual(found, {(0, "vertex"), (1, "edge"), (2, "vertex")})
        for point in complex_["critical_points"]:
            x, y, z = point["position"]
            if point["index"] == 1:  # on the neck, whose centre is half way
                self.assertAlmostEqual(point["length_scale"], math.hypot(x - 1, y, z))
            else:
                self.assertAlmostEqual(point["length_scale"], 2)

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

    def test_a_line_along_a_filament_arrives_however_many_pieces_it_has(self):
        row = self.folder / "row.xyzr"  # with a bump at its foot, whose saddle is joined to its top
        balls = [f"0 {i / 2} 0 1\n" for i in range(10_000)]
        row.write_text("".join(balls) + "2.6 -1.2 0.1 1\n1.3 -0.4 0 1\n")
        self.check_complex(self.morse_json(row, "--raw"))

    def test_a_degenerate_function_of_the_user_gives_2_and_the_place(self):
        for command, out in (("morse", "out.json"), ("mesh", "out.ply")):
            done = self.run_morskin(command, MOLECULES / "cube8.xyzr", "-o", out, "--function",
                                    "height:0,1,0", code=2)
            self.assertRegex(done.stderr.decode(), r"degenerate.* at \(.*\).*--function")
        self.assertEqual(self.names(), [])

    def test_values_that_rounding_does_not_tell_apart_are_refused_with_the_place(self):
        balls = self.folder / "dot.xyzw"  # of which the smaller just looks out of the other
        balls.write_text("-1.9999971389770508 0 2 9.3132257461547852e-10\n"
                         "-2.0000019073486328 2 0 8.0000000009313226\n")
        done = self.run_morskin("morse", balls, "-o", "out.json", "--function", "height:1,0,0",
                                code=2)
        self.assertRegex(done.stderr.decode(), r"agree within rounding at \(.*\).*--function")


if __name__ == "__main__":
    main()
