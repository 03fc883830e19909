#!/usr/bin/env python3
"""`mesh --surface` and `check` of what it writes. Usage: surface_command_test.py path/to/morskin"""

import json
import os
import shutil
import subprocess
import zipfile

from support.command import MOLECULES, CommandTest, main, morskin

USERS = "formula:x^4+y^4+z^4-1-sin(2*x)*cos(y)/4"
COARSE = ("-C", "0.2")
#           surface, components, genus
KNOWN = [("sphere:2", 1, 0), ("torus:2.5,1", 1, 1), ("genus2", 1, 2), (USERS, 1, 0)]


class Surfaces(CommandTest):
    def meshed(self, surface, *words):
        """Writes mesh.ply, which says of which surface it is, and mesh.off, which does not."""
        return self.mesh_json("--surface", surface, "-o", "mesh.ply", "-o", "mesh.off", *COARSE,
                              *words)

    def check_mutant(self, surface, vertices, triangles):
        self.write_off("mutant.off", vertices, triangles)
        return self.check("mutant.off", "--surface", surface, *COARSE, code=5)

    def refused(self, surface, code, *words):
        before = self.names()
        done = self.run_morskin("mesh", "--surface", surface, "-o", "mesh.ply", *words, code=code)
        self.assertEqual(self.names(), before)
        return done.stderr.decode()

    def test_of_other_surfaces_than_skins_files_have_no_normals(self):
        for words, has_normals in (((self.ring,), True), (("--surface", "sphere:2"), False)):
            self.run_morskin("mesh", *words, "-o", "m.npz", "-o", "m.glb", "-q", *COARSE)
            with zipfile.ZipFile(self.folder / "m.npz") as archive:
                self.assertEqual("normals.npy" in archive.namelist(), has_normals)
            self.assertEqual(b'"NORMAL"' in (self.folder / "m.glb").read_bytes(), has_normals)

    def test_known_surfaces_are_certified_from_their_files_and_mutants_are_not(self):
        for surface, components, genus in KNOWN:
            with self.subTest(surface=surface):
                report = self.meshed(surface)
                self.assertTrue(report["certified"])
                self.assertEqual((report["components"], report["genus"]), (components, genus))
                checked = self.check("mesh.ply")
                self.assertEqual(checked["surface"], surface)
                self.assertTrue(checked["homeomorphic"] and checked["certified"])
                vertices, triangles = self.read_off("mesh.off")
                dented = [v if k else [1.02 * x for x in v] for k, v in enumerate(vertices)]
                self.assertFalse(self.check_mutant(surface, dented, triangles)["certified"])

    def test_no_output_replaces_the_molecule_of_gaussians(self):
        self.refused(f"gaussian:{self.ring},decay=1", 2, "--report", "./ring.xyzr")
        (self.folder / "link.ply").symlink_to(self.ring)
        self.refused(f"gaussian:{self.ring},decay=1", 2, "-o", "link.ply")
        self.assertEqual(self.ring.read_bytes(), (MOLECULES / "ring12.xyzr").read_bytes())

    def test_check_of_a_surface_takes_no_options_of_molecules(self):
        self.meshed("sphere:2")
        for words in (("--model", "sas"), ("--probe", "1"), ("--radii", "bondi"), ("--chain", "A"),
                      ("--voids", "drop"), ("--waters",)):
            done = self.run_morskin("check", "mesh.ply", "--surface", "sphere:2", *words, code=2)
            self.assertIn(b"options of molecules", done.stderr)

    def test_sizes_are_of_the_surface_that_the_mesh_states(self):
        self.meshed("sphere:2")
        checked = self.check("mesh.ply", "-C", "0.25")
        self.assertEqual((checked["surface"], checked["C"]), ("sphere:2", 0.25))
        self.assertEqual(self.check("mesh.ply", "-C", "0.05", code=5)["C"], 0.05)
        lines = (self.folder / "mesh.off").read_text().splitlines(keepends=True)
        self.input("bare.off", "".join(line for line in lines if not line.startswith("#")))
        for words in (("bare.off", "-C", "0.2"), ("mesh.ply", "--model", "sas")):
            done = self.run_morskin("check", *words, code=2)
            self.assertIn(b"add --against", done.stderr)

    def test_wrong_meshes_are_not_homeomorphic(self):
        self.meshed("torus:2.5,1")
        vertices, triangles = self.read_off("mesh.off")
        count = len(vertices)
        wrong = {"open": (vertices, triangles[1:]),
                 "inside out": (vertices, [(a, c, b) for a, b, c in triangles]),
                 "twice": (vertices + vertices,
                           triangles + [tuple(v + count for v in t) for t in triangles]),
                 "far": ([[1.1 * x for x in v] for v in vertices], triangles)}
        for name, mesh in wrong.items():
            with self.subTest(mutant=name):
                self.assertFalse(self.check_mutant("torus:2.5,1", *mesh)["homeomorphic"])

    def test_a_mesh_is_not_that_of_another_surface(self):
        self.meshed("torus:2.5,1")
        near = self.check("mesh.ply", "--surface", "torus:2.6,1", *COARSE, code=5)
        self.assertTrue(near["homeomorphic"])  # so it is, but its vertices lie off that torus
        self.assertFalse(near["certified"])
        self.assertIn("off the surface", near["reason"])
        for other in ("sphere:2", "genus2"):
            with self.subTest(surface=other):
                self.assertFalse(self.check("mesh.ply", "--surface", other, *COARSE,
                                            code=5)["homeomorphic"])

    def test_a_mesh_too_coarse_to_show_a_component_covered_is_not_certified(self):
        words = ("-C", "0.6", "--angle-goal", "0")
        self.run_morskin("mesh", "--surface", "torus:2,1", "-o", "t.off", *words, code=5)
        (self.folder / "t.off.unverified").rename(self.folder / "t.off")
        checked = self.check("t.off", code=5)
        self.assertFalse(checked["homeomorphic"])
        verdicts = {v["name"]: v for v in checked["verdicts"]}
        self.assertTrue(verdicts["covers the surface once"]["holds"])
        for name in ("every component once", "components, Euler characteristic and genus of the "
                     "surface"):
            self.assertIn("near enough", verdicts[name]["reason"])

    def test_gaussian_surfaces_of_molecules_are_certified(self):
        for name in ("benzene.pdb", "two_balls.xyzr"):
            with self.subTest(molecule=name):
                shutil.copy(MOLECULES / name, self.folder)
                report = self.meshed(f"gaussian:{name},decay=0.5,level=1")
                self.assertTrue(report["certified"])
                self.assertTrue(self.check("mesh.ply")["certified"])
                vertices, triangles = self.read_off("mesh.off")
                moved = [v if k else [x + 0.01 for x in v] for k, v in enumerate(vertices)]
                self.assertFalse(
                    self.check_mutant(f"gaussian:{name}", moved, triangles)["certified"])
                (self.folder / name).unlink()
                alone = self.check("mesh.ply")  # the molecule is gone: checked as a mesh alone
                self.assertNotIn("certified", alone)
                self.assertIn(name, "".join(alone["origin"]["not_taken"]))

    def test_a_mesh_that_states_a_senseless_surface_is_checked_alone(self):
        self.meshed("sphere:2")
        mesh = (self.folder / "mesh.off").read_text().split("#")[0]
        os.mkfifo(self.folder / "pipe.xyzr")
        self.input("pair.xyzr", "0 0 0 1\n9 0 0 1\n9 0 0 3\n")
        for surface, why in (("formula:x", "not closed"), ("formula:1/0", "not closed"),
                             ("formula:x^2+y^2-z^2*(1-z^2)", "singular"),
                             ("sphere:1e-6", "scale a tiny surface up"), ("cube:1", "it must be"),
                             ("formula:x+", "column 3"), ("gaussian:pipe.xyzr", "no file"),
                             ("gaussian:-", "no file"), ("gaussian:a,b.pdb", "has no comma"),
                             ("gaussian:pair.xyzr,decay=0", "decay")):
            with self.subTest(surface=surface):
                self.input("said.off", f"{mesh}# morskin: surface {surface}\n")
                alone = self.check("said.off")
                self.assertTrue(alone["passed"])
                self.assertNotIn("certified", alone)
                self.assertIn(why, "".join(alone["origin"]["not_taken"]))

    def test_a_gaussian_surface_as_far_out_as_molecules_may_lie_is_certified(self):
        for far in ("1e5", "999990"):  # no double there has a residual of 1e-11 of the square
            self.input("far.xyzr", f"{far} {far} {far} 1\n")
            self.assertTrue(self.meshed("gaussian:far.xyzr")["certified"])
            self.assertTrue(self.check("mesh.ply")["certified"])

    def test_singular_levels_are_refused_with_the_critical_value(self):
        text = self.refused("formula:x^2+y^2-z^2*(1-z^2)", 4)
        self.assertIn("critical value", text)
        # Two unit balls at distance 4: in the middle the sum is 2 exp(-decay (4 - 1)).
        self.input("pair.xyzr", "0 0 0 1\n4 0 0 1\n")
        level = 2 * 2.718281828459045 ** (-0.5 * 3)
        text = self.refused(f"gaussian:pair.xyzr,level={level!r}", 4)
        self.assertIn(f"{level:.9g}"[:10], text)

    def test_bad_surfaces_are_refused_in_words(self):
        for surface, code, says in (("cube:1", 2, "--surface"), ("torus:1", 2, "2 values"),
                                    ("torus:1,2", 4, "R > r > 0"),
                                    ("sphere:1e200", 4, "radius"),
                                    ("sphere:5000", 4, "scale a larger surface down"),
                                    ("sphere:3000", 4, "room enough; scale it down"),
                                    ("torus:1e160,1", 4, "R^2"),
                                    ("sphere:x", 2, "no number"),
                                    ("sphere:-1", 4, "radius"), ("genus2:1", 2, "no values"),
                                    ("formula:x+", 3, "column 3"), ("formula:", 3, "column 1"),
                                    ("formula:z,within=4", 4, "not closed"),
                                    ("formula:1/x", 4, "not closed"),
                                    ("formula:sqrt(x)-1", 4, "not closed"),
                                    ("formula:log(-1)", 4, "not closed"),
                                    ("formula:1e308*x^2*1e308-1", 4, "not closed"),
                                    ("formula:nan", 3, "nan"),
                                    ("formula:x^2+y^2+z^2-1,within=0.5", 4, "within 0.5"),
                                    ("formula:sqrt(x^2+y^2+z^2)-1", 4, "roots"),
                                    ("formula:z,within=3", 2, "power of two"),
                                    ("formula:z,size=3", 2, "unknown option"),
                                    ("gaussian:none.pdb", 3, "none.pdb"),
                                    ("gaussian:a,b.pdb", 2, "has no comma"),
                                    ("gaussian:ring.xyzr,decay=0", 4, "decay"),
                                    ("gaussian:ring.xyzr,level=nan", 4, "level")):
            with self.subTest(surface=surface):
                self.assertIn(says, self.refused(surface, code))

    def test_the_report_tells_how_far_a_formula_was_searched(self):
        pair = "formula:0.3-exp(-x^2-y^2-z^2)-exp(-(x-8)^2-y^2-z^2)"
        first = self.meshed(pair)
        self.assertEqual((first["within"], first["components"]), (4, 1))
        both = self.meshed(pair + ",within=16")
        self.assertEqual((both["within"], both["components"]), (16, 2))
        done = self.run_morskin("mesh", "--surface", pair, "-o", "mesh.ply", *COARSE)
        self.assertIn(b"where |x|, |y|, |z| <= 4; what is zero beyond is left out", done.stdout)
        self.assertIn(b"where |x|, |y|, |z| <= 4", self.run_morskin("check", "mesh.ply").stdout)
        self.assertEqual(self.check("mesh.ply", "--surface", pair + ",within=16", *COARSE,
                                    code=5)["within"], 16)
        self.assertNotIn("within", self.meshed("torus:2.5,1"))
        self.assertNotIn("within", self.check("mesh.ply"))

    def test_what_only_skins_have_is_a_usage_error(self):
        for words in (("--model", "sas"), ("--chain", "A"), ("--areas", "a.csv"),
                      ("--method", "static"), ("--grading", "0.2"), ("--density", "3"),
                      ("--function", "distance:0,0,0"), ("--vertex-data", "normal"),
                      ("--trace-tasks", "t.json")):
            with self.subTest(words=words):
                self.assertIn("--surface", self.refused("sphere:1", 2, *words))
        self.run_morskin("mesh", self.ring, "--surface", "sphere:1", "-o", "mesh.ply", code=2)
        self.run_morskin("mesh", "-o", "mesh.ply", code=2)

    def test_a_report_on_standard_output_is_alone_there(self):
        done = self.run_morskin("mesh", "--surface", "sphere:1", "-o", "m.ply", *COARSE,
                                "--report", "-")
        self.assertTrue(json.loads(done.stdout)["certified"])

    def test_a_mesh_is_written_where_its_report_goes_too(self):
        done = self.run_morskin("mesh", "--surface", "sphere:1", "-o", "/dev/null", *COARSE,
                                "--report", "/dev/null", "--json")
        self.assertEqual(json.loads(done.stdout)["outputs"], ["/dev/null"])

    def test_standard_error_takes_a_mesh_where_it_is_a_file_too(self):
        with open(self.folder / "error.ply", "wb") as file:
            subprocess.run([morskin(), "mesh", "--surface", "sphere:1", "-o", "/dev/stderr", "-q",
                            *COARSE], stderr=file, check=True)
        self.check("error.ply", "--surface", "sphere:1", *COARSE)

    def test_the_same_surface_gives_the_same_bytes(self):
        for threads in ("1", "3"):
            self.run_morskin("mesh", "--surface", "sphere:2", "-o", f"{threads}.ply", *COARSE, "-q",
                             "--threads", threads)
        self.assertEqual((self.folder / "1.ply").read_bytes(),
                         (self.folder / "3.ply").read_bytes())

    def test_where_critical_points_cannot_be_decided_the_mesh_is_unverified_and_says_why(self):
        """Along its axis a torus has circles of them."""
        words = "mesh", "--surface", "torus:2,1", "--height", "0,0,1", "-o", "t.ply", *COARSE
        done = self.run_morskin(*words, code=5)
        self.assertIn(b"could not be decided; try another --height", done.stdout + done.stderr)
        self.assertFalse((self.folder / "t.ply").exists())
        self.assertTrue((self.folder / "t.ply.unverified").exists())
        self.assertTrue(self.check("t.ply.unverified")["certified"])  # along the usual height

    def test_the_report_tells_what_was_proved(self):
        report = self.meshed("torus:2.5,1", "--report", "report.json")
        self.assertEqual(json.loads((self.folder / "report.json").read_text())["surface"],
                         "torus:2.5,1")
        self.assertEqual([report[k] for k in ("minima", "saddles", "maxima")], [1, 2, 1])
        self.assertEqual(report["undecided_boxes"], 0)
        self.assertGreater(report["second_derivative_bound"], 2)


if __name__ == "__main__":
    main()
