#!/usr/bin/env python3
"""`morskin check` from outside. Usage: check_command_test.py path/to/morskin"""

import gzip
import json

from support.command import MOLECULES, CommandTest, main


class Check(CommandTest):
    """Each mesh is made wrong in one way; the verdict that it breaks says where."""

    def setUp(self):
        super().setUp()
        self.words = ("--against", MOLECULES / "shell_hollow.xyzr", "--model", "vdw")

    def good_mesh(self, molecule=MOLECULES / "shell_hollow.xyzr"):
        self.run_morskin("mesh", molecule, "-o", "good.off", "-q", "--model", "vdw")
        vertices, triangles = self.read_off("good.off")
        return vertices, [list(t) for t in triangles]

    def write(self, vertices, triangles):
        return self.write_off("bad.off", vertices, triangles)

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

    def test_options_of_a_skin_without_one_are_refused(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        for words in (("--model", "sas"), ("-C", "0.01"), ("--voids", "drop"), ("--chain", "Z"),
                      ("--size", "1")):
            self.assertIn(b"--against", self.run_morskin("check", "m.ply", *words, code=2).stderr)

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

    def test_edges_too_short_for_L_are_no_fault_where_the_angles_are_known(self):
        self.good_mesh()
        report = self.check("good.off", *self.words, "-C", "0.2")
        self.assertTrue(report["certified"] and report["passed"])
        self.assertGreater(report["violations_L"], 0)
        self.assertEqual([v["name"] for v in report["verdicts"] if not v["holds"]], ["[L]"])
        self.run_morskin("mesh", MOLECULES / "shell_hollow.xyzr", "-o", "good.off", "-q",
                         "--model", "vdw", "--angle-goal", "0")
        report = self.check("good.off", *self.words, "-C", "0.2", code=5)
        self.assertFalse(report["certified"] or report["passed"])

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
        for far in (0.0, 1e30):  # in the void's middle, and where the bounds on G overflow
            self.write([[far, 0.0, 0.0], *vertices], [])
            self.assertIn("not known", self.broken(*self.words)["vertices on the skin"])
            report = self.check("bad.off", *self.words, code=5)
            for key in ("max_distance_to_skin", "max_relative_distance_to_skin"):
                self.assertIsNone(report[key])
                self.assertIn("no bound is known", report[key + "_reason"])

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


class CheckOfFiles(CommandTest):
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

    def test_a_model_that_was_forgotten_is_named(self):
        ring = MOLECULES / "ring12.xyzr"
        for model in ("sas", "paper", "ses-like"):
            with self.subTest(model):
                self.run_morskin("mesh", ring, "-o", "m.ply", "-q", "--model", model)
                self.forget_origin("m.ply")
                found = self.check("m.ply", "--against", ring, code=5)
                self.assertEqual(found["fitting_model"], model)
                said = self.run_morskin("check", "m.ply", "--against", ring, code=5).stdout
                self.assertIn(f"add --model {model}".encode(), said)
                self.check("m.ply", "--against", ring, "--model", model)
                told = self.check("m.ply", "--against", ring, "--model", "vdw", code=5)
                self.assertNotIn("fitting_model", told)  # it was said, and is not doubted

    def test_a_certificate_is_there_only_after_all_that_time_may_not_suffice_for(self):
        self.run_morskin("mesh", MOLECULES / "1crn.pdb", "--model", "ses-like", "-o", "m.ply", "-q")
        self.forget_origin("m.ply")  # then the other models are tried, which takes long
        for k in range(9):
            (self.folder / "c.json").unlink(missing_ok=True)
            done = self.run_morskin("check", "m.ply", "--against", MOLECULES / "1crn.pdb",
                                    "--certificate", "c.json", "--no-self-intersections",
                                    "--timeout", 0.01 * 2**k, code=None)
            self.assertIn(done.returncode, (5, 6) if k > 0 else (6,))
            self.assertEqual(self.names(), ["c.json"] * (done.returncode == 5) + ["m.ply"])

    def test_a_C_that_was_forgotten_is_found(self):
        ring = MOLECULES / "ring12.xyzr"
        self.run_morskin("mesh", ring, "-o", "m.ply", "-q", "-C", "0.2")
        self.forget_origin("m.ply")
        found = self.check("m.ply", "--against", ring, code=5)
        self.assertGreater(found["fitting_C"], 0.1)
        self.assertLessEqual(found["fitting_C"], 0.2)
        self.assertTrue(self.check("m.ply", "--against", ring, "-C", found["fitting_C"])["passed"])

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
        self.run_morskin("mesh", self.ring, "-o", "ring.off", "-o", "M.VERT", "-q")  # and M.face
        off = (self.folder / "ring.off").read_bytes()
        self.input("packed.off.gz", gzip.compress(off))
        lines = [line for line in off.decode().splitlines() if not line.startswith("#")]
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
        for name in ("packed.off.gz", "ring.vert", "ring.face", "loose.VERT", "loose.FACE.gz",
                     "M.VERT", "M.face"):
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

    def test_a_mesh_whose_triangles_all_repeat_a_corner_is_not_closed(self):
        self.input("bad.off", "OFF\n2 1 0\n0 0 0\n1 0 0\n3 0 0 1\n")
        verdicts = {v["name"]: v.get("reason") for v in self.check("bad.off", code=5)["verdicts"]}
        self.assertEqual(verdicts["closed"], "no triangle has three corners")


if __name__ == "__main__":
    main()
