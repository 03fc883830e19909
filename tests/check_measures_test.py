#!/usr/bin/env python3
"""What `check --json` counts and measures, computed here. Usage: check_measures_test.py
path/to/morskin"""

import numpy

from support.command import CommandTest, main

CENTRE, RADIUS = numpy.array([1.0, 2.0, 3.0]), 2.0


class Measures(CommandTest):
    def test_each_kind_of_defect_is_counted_under_its_name(self):
        places = [[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]
        above = [(k, (k + 1) % 4, 4) for k in range(4)]
        below = [((k + 1) % 4, k, 5) for k in range(4)]
        ball, middle = above + below, [[0.5, 0.5, 0]]
        cut = [(0, 6, 4), (6, 1, 4), (0, 1, 6), *ball[1:]]
        tip = [(4, 7, 6), (4, 6, 8), (6, 7, 8), (4, 8, 7)]
        beside = [[1, 0, 2], [0, 1, 2], [-1, -1, 2]]
        for triangles, more, defects in (
                (ball, [], {}),
                ([], [], {"no_triangles": 1, "unused_vertices": 6}),
                (ball[1:], [], {"boundary_edges": 3}),
                ([ball[0][::-1], *ball[1:]], [], {"disagreeing_edges": 3}),
                ([*ball, (1, 4, 0)], [], {"duplicate_triangles": 1, "crowded_edges": 3}),
                ([*ball, (3, 3, 4)], [], {"triangles_with_repeated_corners": 1}),
                (ball, [[9, 9, 9], [8, 8, 8]], {"unused_vertices": 2}),
                (cut, middle, {"triangles_with_collinear_corners": 1}),
                (ball + tip, beside, {"split_vertices": 1})):
            self.write_off("m.off", [list(map(float, p)) for p in places + more], triangles)
            found = self.check("m.off", code=5 if defects else 0)["defects"]
            self.assertEqual({name: defect["count"] for name, defect in found.items()}, defects)

    def test_what_is_found_and_what_is_expected_are_told_apart(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        self.input("apart.xyzr", "0 0 0 1\n9 0 0 2\n")
        for against, expected, code in ((self.ring, (1, 1, 0), 0), ("apart.xyzr", (2, 0, 4), 5)):
            told = self.check("m.ply", "--against", against, code=code)
            for start, counts in (("", (1, 1, 0)), ("expected_", expected)):
                self.assertEqual(tuple(told[start + name] for name in (
                    "components", "genus", "euler_characteristic")), counts)
            self.assertEqual(told["covering_degree_ok"], code == 0)
            self.assertGreater(told["proved_angle_deg"], told["min_angle_deg"] - 1e-6)
            self.assertLessEqual(told["proved_angle_deg"], told["min_angle_deg"])

    def checked_ball(self):
        """A mesh of a ball with one vertex moved out, and what `check` finds of it."""
        self.input("ball.xyzr", "{} {} {} {}\n".format(*CENTRE, RADIUS))
        self.run_morskin("mesh", "ball.xyzr", "-o", "m.off", "-q", "-C", "0.3")
        places, triangles = map(numpy.array, self.read_off("m.off"))
        places[5] += 1e-4 * (places[5] - CENTRE)
        self.write_off("m.off", places.tolist(), triangles.tolist())
        found = self.check("m.off", "--against", "ball.xyzr", "-C", "0.3", code=5)
        return places, triangles, found

    def expect_worst(self, found, key, values, of="triangle"):
        """@param values  of all, the worst of which is the largest"""
        self.assertEqual(found[0][of], values.argmax())
        self.assertAlmostEqual(found[0][key] / values.max(), 1, places=5)

    def test_what_lies_farthest_from_a_ball_is_named_and_how_far(self):
        places, triangles, found = self.checked_ball()
        from_centre = numpy.linalg.norm(places - CENTRE, axis=1)
        off = abs(from_centre - RADIUS)
        self.expect_worst(found["farthest_vertices"], "distance", off, "vertex")
        self.expect_worst(found["farthest_vertices"], "relative_distance", off / from_centre,
                          "vertex")
        self.assertAlmostEqual(found["mean_relative_distance"], (off / from_centre).mean(), 9)
        middles = numpy.linalg.norm(places[triangles].mean(axis=1) - CENTRE, axis=1)
        off = RADIUS - middles
        self.expect_worst(found["farthest_centroids"], "relative_distance", off / middles)
        for name, value in (("max_centroid_distance", off.max()),
                            ("max_centroid_relative_distance", (off / middles).max()),
                            ("mean_centroid_relative_distance", (off / middles).mean())):
            self.assertAlmostEqual(found[name] / value, 1, places=5)

    def test_the_largest_the_steepest_and_the_shortest_on_a_ball_are_named_with_their_measure(self):
        places, triangles, found = self.checked_ball()
        C, Q, scales = found["C"], found["Q"], numpy.linalg.norm(places - CENTRE, axis=1)
        a, b, c = places[triangles].transpose(1, 0, 2)
        across = numpy.cross(b - a, c - a)
        double_areas = numpy.linalg.norm(across, axis=1)
        sides = numpy.linalg.norm([b - a, c - b, a - c], axis=2)
        radii = sides.prod(axis=0) / (2 * double_areas)
        self.expect_worst(found["worst_triangles"], "U",
                          radii / scales[triangles].min(axis=1) / (C * Q))
        normals = (places - CENTRE) / scales[:, None]
        cosines = (normals[triangles] * across[:, None]).sum(axis=2).min(axis=1) / double_areas
        turned = numpy.degrees(numpy.arccos(cosines))
        self.expect_worst(found["steepest_triangles"], "normal_deviation_deg", turned)
        self.assertAlmostEqual(found["max_normal_deviation_deg"], turned.max(), places=3)
        edges = triangles[:, [[0, 1], [1, 2], [2, 0]]].transpose(1, 0, 2).reshape(-1, 2)
        lengths = sides.ravel() / scales[edges].max(axis=1)
        shortest = found["worst_edges"][0]
        self.assertAlmostEqual(shortest["L"] / (lengths.min() / 2 * Q / C), 1, places=5)
        least = edges[lengths < lengths.min() * (1 + 1e-9)]  # from both sides, or of several edges
        self.assertIn(shortest["edge"], [sorted(edge) for edge in least.tolist()])


if __name__ == "__main__":
    main()
