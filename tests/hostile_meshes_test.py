#!/usr/bin/env python3
"""Meshes that mean harm: strict JSON whatever they hold, and no more time than they are long.

    hostile_meshes_test.py path/to/morskin
"""

import itertools
import json
import math
import random

from support.command import CommandTest, main

LIMIT = ("--timeout", "60")  # seconds, on a busy machine; each of the inputs took over 100


def off(points, faces):
    return (f"OFF\n{len(points)} {len(faces)} 0\n" +
            "".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in points) +
            "".join(f"{len(face)} {' '.join(map(str, face))}\n" for face in faces))


def tetrahedron(size):
    points = [(size, 0.0, 0.0), (0.0, size, 0.0), (0.0, 0.0, size), (0.0, 0.0, 0.0)]
    return off(points, [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)])


def circle(count, z=0.0):
    return [(10 * math.cos(2 * math.pi * i / count), 10 * math.sin(2 * math.pi * i / count), z)
            for i in range(count)]


def strict(text):
    def refuse(word):
        raise AssertionError(f"{word} is not JSON")
    return json.loads(text, parse_constant=refuse)


def nulls_without_reason(value, path=""):
    """The fields that are null and have no reason beside them."""
    if isinstance(value, list):
        return [bad for i, item in enumerate(value)
                for bad in nulls_without_reason(item, f"{path}[{i}]")]
    if not isinstance(value, dict):
        return []
    bare = [f"{path}.{name}" for name, field in value.items()
            if field is None and not value.get(f"{name}_reason")]
    return bare + [bad for name, field in value.items()
                   for bad in nulls_without_reason(field, f"{path}.{name}")]


class HostileMeshes(CommandTest):
    def assert_strict(self, *words, code):
        report = strict(self.run_morskin(*words, code=code).stdout)
        self.assertEqual(nulls_without_reason(report), [])
        return report

    def test_reports_are_strict_json_and_each_null_has_its_reason(self):
        self.input("one.xyzr", "0 0 0 1\n")
        flat = [(0.0, 0.0, 0.0)] * 3 + [(1.0, 0.0, 0.0)]
        meshes = [tetrahedron(10.0 ** e) for e in (-320, -200, 100, 150, 155, 200, 300, 308)]
        meshes += [off([], []), off(flat, []), off(flat, [(0, 1, 2)]), off(flat, [(0, 1, 3)]),
                   off(flat, [(0, 0, 0)]), off([(-1e308, 0.0, 0.0), (1e308, 1.0, 0.0), flat[0]],
                                               [(0, 1, 2)])]
        for number, text in enumerate(meshes):
            with self.subTest(number):
                self.input("x.off", text)
                for words in ((), ("--against", "one.xyzr")):
                    done = self.run_morskin("check", "x.off", "--json", *words, code=None)
                    self.assertIn(done.returncode, (0, 5), done.stderr)
                    self.assertEqual(nulls_without_reason(strict(done.stdout)), [])

    def test_what_overflows_says_so(self):
        self.input("x.off", tetrahedron(1e200))
        report = self.assert_strict("check", "x.off", "--json", code=0)
        self.assertIsNone(report["area"])
        self.assertEqual(report["area_reason"], "beyond the largest double, 1.8e308")
        self.input("x.off", off([], []))
        report = self.assert_strict("check", "x.off", "--json", code=5)
        self.assertEqual(report["min_angle_deg_reason"], "the mesh has no triangle")

    def test_of_a_mesh_that_is_no_manifold_no_genus_is_told(self):
        self.input("one.xyzr", "0 0 0 1\n")
        self.input("x.off", off([(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)], [(0, 1, 2)]))
        words = ("check", "x.off", "--against", "one.xyzr")
        report = self.assert_strict(*words, "--json", code=5)
        self.assertEqual(report["components"], 1)
        self.assertNotIn("components_reason", report)
        for name in ("genus", "euler_characteristic"):
            self.assertIsNone(report[name])
            self.assertIn("no closed oriented 2-manifold", report[name + "_reason"])
        said = self.run_morskin(*words, code=5).stdout
        self.assertRegex(said, rb"topology +not counted.*\n  expected +1 component, genus 0")

    def test_each_edge_of_an_open_mesh_is_measured_however_it_is_numbered(self):
        self.input("one.xyzr", "0 0 0 1\n")
        places = [(math.sin(t), 0.0, math.cos(t)) for t in (0, 0.1)]
        places.append((0.0, math.sin(0.001), math.cos(0.001)))  # too near to the first
        for order in itertools.permutations(range(3)):
            corners = [order.index(k) for k in range(3)]
            self.input("x.off", off([places[k] for k in order], [corners]))
            report = self.check("x.off", "--against", "one.xyzr", code=5)
            self.assertEqual(report["violations_L"], 1)
            self.assertEqual(len(report["worst_edges"]), 3)
            short = sorted((corners[0], corners[2]))
            self.assertEqual(report["worst_edges"][0]["edge"], short)
            reason = next(v["reason"] for v in report["verdicts"] if v["name"] == "[L]")
            self.assertIn("edge {}-{} has".format(*short), reason)

    def test_a_mesh_that_is_not_closed_has_no_volume(self):
        self.input("one.xyzr", "0 0 0 1\n")
        points = [(1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0), (0.0, 0.0, 0.0)]
        faces = [(0, 2, 1), (0, 1, 3), (1, 2, 3), (2, 0, 3)]
        for name, some, code in (("closed.off", faces, 0), ("open.off", faces[1:], 5)):
            self.input(name, off(points, some))
            said = self.run_morskin("check", name, code=code).stdout
            self.assertEqual(b", volume " in said, code == 0)
            report = self.assert_strict("check", name, "--json", code=code)
            self.assertEqual("volume" in report, code == 0)
        report = self.assert_strict("check", "open.off", "--against", "one.xyzr", "--json", code=5)
        self.assertIsNone(report["volume"])
        self.assertIn("no closed oriented 2-manifold", report["volume_reason"])

    def test_reports_of_mesh_are_strict(self):
        for words in (("-C", "0.9", "-Q", "1.9"), ("--method", "marching-cubes")):
            self.run_morskin("mesh", self.ring, "-o", "x.ply", "-q", "--report", "x.json", *words,
                             code=5)
            self.assertEqual(nulls_without_reason(strict((self.folder / "x.json").read_text())),
                             [])

    def long_ones(self):
        many = 100000
        yield "a polygon of 100,000 corners", "x.off", off(circle(many), [range(many)])
        one = [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)]
        yield "one triangle 100,000 times", "x.off", off(one, [(0, 1, 2)] * many)
        yield ("the same with its own corners each time", "x.off",
               off(one * many, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(many)]))
        yield ("an OBJ face of 8 MB", "x.obj",
               "v 0 0 0\nv 1 0 0\nv 0 1 0\nf " + "1 2 3 " * 1400000 + "\n")
        axis = [(0.0, 0.0, -10.0), (0.0, 0.0, 10.0)]
        yield ("100,000 triangles about one edge", "x.off",
               off(axis + circle(many), [(0, 1, i + 2) for i in range(many)]))

    def test_long_meshes_are_checked_drawn_and_shown_in_time(self):
        self.input("one.xyzr", "0 0 0 1\n")
        for what, name, text in self.long_ones():
            with self.subTest(what):
                self.input(name, text)
                self.assert_strict("check", name, "--json", *LIMIT, code=5)
                if "edge" not in what:  # it has 200,000 long boundary edges to draw, 20 seconds
                    self.run_morskin("render", name, "-o", "x.png", "--size", "200", *LIMIT)
                self.run_morskin("view", name, "-o", "x.html", "-q", *LIMIT)
                self.run_morskin("view", name, "--against", "one.xyzr", "-o", "x.html", "-q",
                                 *LIMIT)

    def test_balls_that_hold_half_the_vertices_are_searched_for_one_of_them(self):
        self.input("one.xyzr", "0 0 0 1\n")
        chance, many = random.Random(1), 200000
        points = []
        for _ in range(3 * many):
            x, y, z = (chance.gauss(0, 1) for _ in range(3))
            r = math.hypot(x, y, z)
            points.append((x / r, y / r, z / r))
        self.input("x.off", off(points, [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(many)]))
        report = self.assert_strict("check", "x.off", "--against", "one.xyzr", "--json",
                                    "--no-self-intersections", *LIMIT, code=5)
        self.assertGreater(report["restricted_delaunay_violations"], many // 4)

    def test_contacts_beyond_the_limit_are_counted_as_at_least_so_many(self):
        self.input("x.off", off([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0)],
                                [(0, 1, 2)] * 1000))
        report = self.assert_strict("check", "x.off", "--json", code=5)
        self.assertEqual(report["self_intersections"], 100000)
        self.assertFalse(report["self_intersections_complete"])
        reason = next(v["reason"] for v in report["verdicts"]
                      if v["name"] == "without self-intersections")
        self.assertIn("at least 100,000 such pairs", reason)
        self.assertEqual(report["self_intersecting_pairs"][0], [0, 1])


if __name__ == "__main__":
    main()
