#!/usr/bin/env python3
"""The distribution of angles, valences and radius ratios that `mesh` and `check` tell, against a
count made here. Usage: quality_command_test.py path/to/morskin"""

import json
import math
from collections import Counter

from support.command import MOLECULES, CommandTest, main


class Quality(CommandTest):
    def angles(self, places, triangle):
        result = []
        for k in range(3):
            at, p, q = (places[triangle[(k + i) % 3]] for i in range(3))
            e, f = ([x - y for x, y in zip(other, at)] for other in (p, q))
            cosine = sum(x * y for x, y in zip(e, f)) / (math.hypot(*e) * math.hypot(*f))
            result.append(math.degrees(math.acos(cosine)))
        return sorted(result)

    def test_half_a_C_makes_as_many_times_more_triangles_as_the_help_says(self):
        said = " ".join(self.run_morskin("mesh", "--help-all").stdout.decode().split())
        self.assertIn("half makes 3 to 4 times as many. Of a C above 0.25 half makes 5 to 11", said)
        for C, least, most in ((0.08, 3, 4), (0.2, 3, 4), (0.26, 5, 11), (0.4, 5, 11)):
            whole, half = (self.mesh_json(self.ring, "-o", "m.ply", "-C", size)["triangles"]
                           for size in (C, C / 2))
            self.assertTrue(least <= round(half / whole) <= most, C)

    def test_edges_grow_without_a_grading_as_the_help_says(self):
        said = self.run_morskin("mesh", "--help-all").stdout
        self.assertIn(b"as -C allows, 0.18 with 0.08, 1.09 with 0.4", said)
        for name, C, below, above in (("caffeine.xyz", "0.08", "0.17", "0.18"),
                                      ("1crn.pdb", "0.4", "1", "1.1")):
            meshes = []
            for words in ((), ("--grading", below), ("--grading", above)):
                self.run_morskin("mesh", MOLECULES / name, "-o", "m.ply", "-q", "-C", C,
                                 "--method", "static", *words)
                meshes.append(self.without_origin("m.ply"))
            self.assertEqual([mesh == meshes[0] for mesh in meshes], [True, False, True], C)

    def counted(self, places, triangles):
        angles = [self.angles(places, t) for t in triangles]
        valences = Counter(Counter(v for t in triangles for v in t).values())
        # 2 r / R = 8 sin(A / 2) sin(B / 2) sin(C / 2)
        area = self.area(places, triangles)
        ratios = [8 * math.prod(math.sin(math.radians(x / 2)) for x in three) for three in angles]
        return {
            "triangles_below_deg": {str(d): sum(a[0] < d for a in angles) for d in (30, 35, 40)},
            "triangles_above_deg": {str(d): sum(a[2] > d for a in angles) for d in (90, 105, 120)},
            "histogram_bin_deg": 5,
            "smallest_angle_histogram": [sum(5 * k <= a[0] < 5 * k + 5 for a in angles)
                                         for k in range(12)],
            "largest_angle_histogram": [sum(5 * k < a[2] <= 5 * k + 5 for a in angles)
                                        for k in range(12, 36)],
            "min_valence": min(valences),
            "max_valence": max(valences),
            "vertices_by_valence": [valences[k] for k in range(9)] +
                                   [sum(n for k, n in valences.items() if k > 8)],
            "min_radius_ratio": math.floor(1e6 * min(ratios)) / 1e6,
            "mean_radius_ratio": float(f"{sum(ratios) / len(ratios):.6g}"),
            "edge_length_quantiles": self.quantiles(places, triangles),
            "vertices_per_square_angstrom": float(f"{len(places) / area:.6g}"),
            "triangles_per_square_angstrom": float(f"{len(triangles) / area:.6g}")}

    def quantiles(self, places, triangles):
        lengths = sorted(math.dist(places[t[k]], places[t[k - 1]])
                         for t in triangles for k in range(3))
        return {str(percent): float(f"{lengths[int(percent / 100 * (len(lengths) - 1))]:.6g}")
                for percent in (5, 50, 95)}

    def area(self, places, triangles):
        """By Heron's formula."""
        total = 0
        for t in triangles:
            sides = [math.dist(places[t[k]], places[t[k - 1]]) for k in range(3)]
            half = sum(sides) / 2
            total += math.sqrt(half * math.prod(half - side for side in sides))
        return total

    def test_mesh_and_check_tell_the_distribution_that_the_file_has(self):
        for words in (("--threads", "2"), ("-C", "0.3", "--angle-goal", "0", "--threads", "1")):
            report = self.mesh_json(self.ring, "-o", "ring.off", *words)
            places, triangles = self.read_off("ring.off")
            expected = self.counted(places, triangles)
            self.assertEqual(report["quality"], expected)
            self.assertEqual(self.check("ring.off")["quality"], expected)
            self.assertEqual(sum(expected["smallest_angle_histogram"]), report["triangles"])
            self.assertEqual(sum(expected["largest_angle_histogram"]), report["triangles"])
            self.assertEqual(sum(expected["vertices_by_valence"]), report["vertices"])

    def test_people_are_told_shares_and_a_report_file_holds_them_in_quiet_runs(self):
        done = self.run_morskin("mesh", self.ring, "-o", "ring.off", "-q", "--report", "r.json")
        self.assertEqual(done.stdout, b"")
        quality = json.loads((self.folder / "r.json").read_text())["quality"]
        below = quality["triangles_below_deg"]["40"]
        self.assertGreater(below, 0)
        share = f"{100 * below / len(self.read_off('ring.off')[1]):.3g}% below 40"
        for words in (("mesh", self.ring, "-o", "ring.off"), ("check", "ring.off")):
            text = self.run_morskin(*words).stdout.decode()
            self.assertIn(share, text)
            self.assertIn(f"valences    {quality['min_valence']} to {quality['max_valence']}", text)

    def test_people_are_told_the_steps_of_the_method_that_the_report_counts(self):
        told = self.run_morskin("mesh", MOLECULES / "5tmn_ligand.pdb", "-o", "m.ply", "-C", "0.25",
                                "--fronts", "1", "--report", "r.json").stdout.decode()
        report = json.loads((self.folder / "r.json").read_text())
        n = {name: f"{count:,}" for name, count in report["operations"].items()}
        critical, left = ([counts[kind] for kind in ("minima", "saddles", "maxima")]
                          for counts in (report, report["surviving"]))
        for minima, saddles, maxima in (critical, left):
            self.assertEqual(minima - saddles + maxima, report["euler_characteristic"])
        smoothing = report["smoothing"]
        for line in (
                "critical    {} minima - {} saddles + {} maxima; {} - {} + {} survive".format(
                    *critical, *left),
                f"sweep       {n['creation']} created, {n['creep']} crept, {n['wing']} winged, "
                f"{n['bridge']} bridged, {n['seal']} sealed",
                f"touches     {n['guard_inside_protecting']} in protecting spheres, "
                f"{n['guard_outside_protecting']} outside, of which {n['vain_inside_protecting']} "
                f"and {n['vain_outside_protecting']} futile",
                f"coarsening  {n['coarsen']} vertices taken out",
                f"refinement  {n['flip']} flips, {n['contract']} contractions, {n['insert']} ins",
                f"smoothing   {smoothing['moved']} vertices moved for angles of 30 degrees, "
                f"{smoothing['reconnected'] + smoothing['inserted']} taken out or put in"):
            self.assertIn(f"\n  {line}", told)

    def test_people_are_told_bounds_on_the_side_where_they_hold(self):
        for C in ("0.2", "0.25", "0.3", "0.35"):
            self.run_morskin("mesh", self.ring, "-C", C, "-o", "m.off", "-q")
            against = ("m.off", "--against", self.ring)
            told = self.run_morskin("check", *against).stdout.decode()
            found = self.check(*against)
            ratio = float(told.split("radius ratio ")[1].split()[0])
            turned = float(told.split("no more than ")[1].split()[0])
            self.assertLessEqual(ratio, found["quality"]["min_radius_ratio"])
            self.assertGreaterEqual(turned, found["max_normal_deviation_deg"])
        self.input("one.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
        self.assertIn(b" 0: 1 triangle, ", self.run_morskin("check", "one.off", code=5).stdout)

    def test_check_tells_the_length_of_edges_that_it_goes_by_as_mesh_does(self):
        made = self.mesh_json(self.ring, "--size", "0.6", "-o", "m.off")
        found = self.check("m.off", "--against", self.ring)
        self.assertEqual((found["edge_length"], found["C"]), (0.6, made["C"]))
        self.assertEqual(made["edge_length"], 0.6)
        self.assertNotIn("edge_length", self.check("m.off", "--against", self.ring, "-C", "0.4"))

    def test_check_tells_the_bound_on_angles_that_its_certificate_goes_by(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q")
        for words, bound in (((), "21.55"), (("-C", "0.12", "-Q", "1.2"), "30")):
            said = self.run_morskin("check", "m.ply", "--against", self.ring, *words).stdout
            self.assertIn(f"(bound {bound})\n".encode(), said)
            self.assertEqual(b"  no   [L]" in said, bound == "30")

    def test_of_no_triangle_there_is_no_radius_ratio_and_of_a_flat_one_it_is_0(self):
        self.input("points.off", "OFF\n1 0 0\n1 2 3\n")
        quality = self.check("points.off", code=5)["quality"]
        self.assertIsNone(quality["min_radius_ratio"])
        self.assertTrue(quality["min_radius_ratio_reason"])
        self.input("same.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 0 0\n")
        quality = self.check("same.off", code=5)["quality"]
        self.assertEqual(quality["min_radius_ratio"], 0)
        self.assertEqual(quality["smallest_angle_histogram"][0], 1)
        self.assertEqual(quality["largest_angle_histogram"][-1], 1)
        self.assertEqual(quality["vertices_by_valence"], [2, 0, 0, 1] + 6 * [0])

    def test_a_mesh_without_triangles_has_no_grading_to_report(self):
        pair = self.input("pair.xyzr", "0 0 0 1.7\n1.5 0 0 1.7\n")
        words = ("mesh", pair, "-o", "mesh.ply", "-C", "1", "--grading", "0.1", "--json")
        self.assertNotIn("grading", json.loads(self.run_morskin(*words, code=5).stdout))

    def test_a_goal_of_size_ends_where_the_first_mesh_has_no_triangle(self):
        pair = self.input("pair.xyzr", "0 0 0 1.7\n1.5 0 0 1.7\n")
        self.run_morskin("mesh", pair, "-o", "mesh.ply", "-q", "--method", "static", "-C", "1",
                         "--density", "0.01", code=5)

    def test_a_density_beyond_all_ids_is_refused_with_what_to_do(self):
        done = self.run_morskin("mesh", self.ring, "-o", "a.ply", "--density", "1e9", code=4)
        self.assertIn(b"; ask for less", done.stderr)

    def test_a_grading_is_reported_and_words_that_do_not_go_with_it_are_refused(self):
        words = ("mesh", MOLECULES / "9dna.pdb", "-o", "mesh.ply", "-C", "0.4", "--json")
        report = json.loads(self.run_morskin(*words, "--grading", "0.2").stdout)
        grading = report["grading"]
        self.assertTrue(report["certified"])
        self.assertEqual((grading["allowed"], report["method"]), (0.2, "static"))
        self.assertLessEqual(1, grading["median"])
        self.assertLess(grading["quantile_99"], 1.6)
        self.assertLessEqual(grading["quantile_99"], grading["largest"])
        self.assertNotIn("grading", json.loads(self.run_morskin(*words).stdout))
        fine = self.run_morskin("mesh", self.ring, "-o", "m.ply", "-C", "0.1", "--grading", "0.1")
        self.assertIn(b"static, as --grading needs", fine.stdout)
        sparse = json.loads(self.run_morskin(*words, "--grading", "0.05", "--density", "1").stdout)
        self.assertIn("--grading", sparse["missed_size"])
        for wrong in (("--grading", "0"), ("--grading", "nan"),
                      ("--grading", "0.2", "--fronts", "1"),
                      ("--grading", "0.2", "--method", "dynamic"),
                      ("--grading", "0.2", "--angle-goal", "20")):
            with self.subTest(wrong=wrong):
                self.assertIn(b"--grading", self.run_morskin(*words, *wrong, code=2).stderr)

    def test_what_bends_too_much_is_told_from_one_triangle_on(self):
        neck = self.input("neck.xyzr", "0 0 0 1.5\n4.1 0 0 1.5\n")
        words = ("mesh", neck, "-o", "neck.off", "-C", "0.4", "--size")
        self.assertNotIn(b"  bent  ", self.run_morskin(*words, "0.426").stdout)
        self.assertIn(b": 1 triangle, ", self.run_morskin(*words, "0.4285").stdout)

    def test_no_note_doubts_the_constants_that_come_with_a_size(self):
        words = ("mesh", self.ring, "-o", "ring.ply", "--size", "0.7")
        self.assertEqual(self.run_morskin(*words).stderr, b"")
        self.assertIn(b"C Q = 0.8 is above", self.run_morskin(*words, "-C", "0.35").stderr)

    def test_of_a_closed_mesh_with_a_turned_triangle_no_line_says_that_it_is_open(self):
        self.input("turned.off", "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                 "3 0 1 2\n3 0 1 3\n3 1 2 3\n3 0 3 2\n")
        told = self.run_morskin("check", "turned.off", code=5).stdout.decode()
        self.assertIn("manifold    NOT closed and oriented: edge 0-1: its triangles", told)
        self.assertIn(" A^2, not closed and oriented\n", told)
        self.assertIn("  yes  closed\n", told)

    def test_check_of_coordinates_near_the_ends_of_the_doubles(self):
        for size in ("1e300", "1e-300"):
            text = f"OFF\n4 4 0\n0 0 0\n{size} 0 0\n0 {size} 0\n0 0 {size}\n" \
                   "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n"
            self.input("far.off", text)
            report = self.check("far.off")
            self.assertTrue(report["closed_oriented_manifold"])
            self.assertEqual(report["self_intersections"], 0)
            self.assertAlmostEqual(report["min_angle_deg"], 45, 6)
            self.assertEqual([report["angle_histogram"][k] for k in (4, 6, 9)], [6, 3, 3])
            self.assertEqual(report["quality"]["triangles_below_deg"]["30"], 0)
            self.assertEqual(report["quality"]["edge_length_quantiles"]["5"], float(size))
            part, = report["component_list"]
            for found in (report, part):
                for name in ("area", "volume"):
                    self.assertEqual(found[name], None if size == "1e300" else 0)
                    self.assertIn("largest", found.get(f"{name}_reason", "the largest double"))
            said = self.run_morskin("check", "far.off").stdout
            self.assertNotIn(b"nan", said)
            self.assertIn(b"40-50: 50%, 60-70: 25%, 90-100: 25%", said)
            self.run_morskin("check", "far.off", "--against", self.ring, code=5)


if __name__ == "__main__":
    main()
