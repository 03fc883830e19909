#!/usr/bin/env python3
"""`morskin view` from outside: pages are whole, load nothing from elsewhere, and hold the mesh.

What the page does in a browser is tried by `make test-viewer`. Usage: view_test.py path/to/morskin
"""

import itertools
import json
import math
import random

from support.command import MOLECULES, main
from support.viewer_case import ViewTest


class Pages(ViewTest):
    def test_options_of_a_skin_are_refused_with_a_mesh_and_no_molecule(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        for words in (("--model", "sas"), ("-C", "0.2"), ("--size", "1"), ("--chain", "A"),
                      ("--function", "distance:0,0,0")):
            done = self.run_morskin("view", "m.ply", "-o", "m.html", *words, code=2)
            self.assertIn(b"--against", done.stderr)
        self.assertEqual(self.names(), ["m.ply"])

    def test_a_page_is_one_file_that_loads_nothing(self):
        page = self.view(self.ring)
        self.assertTrue(page.text.startswith("<!doctype html>"))
        self.assertTrue(page.text.rstrip().endswith("</html>"))
        self.assertEqual(page.parser.addresses, ["data:,"])
        self.assertEqual(set(page.parser.scripts), {"about", "data", "viewer"})
        self.assertEqual([page.parser.tags[tag] for tag in ("img", "iframe", "object", "embed")],
                         [0, 0, 0, 0])
        for sign in ("@import", "url(http", "import(", "importScripts(", "XMLHttpRequest", "fetch(",
                     "WebSocket", "EventSource", "sendBeacon"):
            self.assertFalse(sign in page.text, sign)
        self.assertIn("The MIT License", page.text)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), ["page.html", "ring.xyzr"])

    def test_a_file_name_cannot_break_out_of_the_page(self):
        nasty = self.folder / "<b>&\"'<script>x"
        nasty.mkdir()
        ring = nasty / "a<!--<script>b.xyzr"
        ring.write_bytes(self.ring.read_bytes())
        page = self.view(ring)
        self.assertEqual(page.about["title"], "a<!--<script>b.xyzr")
        self.assertEqual(set(page.parser.scripts), {"about", "data", "viewer"})

    def test_the_same_input_gives_the_same_page_for_any_number_of_threads(self):
        page = self.view(MOLECULES / "caffeine.xyz", "--threads", "1")
        self.assertEqual(page.text, self.view(MOLECULES / "caffeine.xyz", "--threads", "2").text)

    def test_a_page_takes_few_bytes_to_a_triangle(self):
        mesh = self.view(MOLECULES / "5tmn_ligand.pdb")
        packed = len(mesh.parser.scripts["data"])
        # 5 MB for 300,000 triangles leave 13 beside the viewer's 0.6 MB.
        self.assertLess(packed / mesh.about["mesh"]["triangles"], 9)
        self.assertLess(len(mesh.text) - packed, 800_000)


class Meshes(ViewTest):
    def test_a_page_holds_the_mesh_of_one_front_and_says_that_it_is_certified(self):
        page = self.view(self.ring)
        self.run_morskin("mesh", self.ring, "-o", "ring.off", "--fronts", "1", "-q")
        places, triangles = self.read_off("ring.off")
        self.assertEqual(page.about["mesh"]["triangles"], len(triangles))
        self.check_same_mesh(page, places, triangles)
        self.assertIs(page.about["certified"], True)

    def test_the_cell_of_a_vertex_on_an_atoms_sphere_is_that_atoms(self):
        page = self.view(MOLECULES / "5tmn_ligand.pdb")
        places, _, _ = page.mesh()
        grid = page.about["mesh"]["grid"]
        balls = page.array("atoms.balls")
        atoms = list(itertools.accumulate(page.array("complex.vertices")))
        cells = list(itertools.accumulate(page.array("mesh.cell")))
        self.assertEqual(len(cells), len(places))
        seen = 0
        for place, cell in zip(places, cells):
            if cell >= len(atoms):
                continue
            *centre, weight = balls[4 * atoms[cell]:4 * atoms[cell] + 4]
            x = [o + grid["step"] * p for o, p in zip(grid["origin"], place)]
            self.assertAlmostEqual(math.dist(x, centre), math.sqrt(weight / 2), delta=grid["step"])
            seen += 1
        self.assertGreater(seen, 500)

    def test_a_mesh_of_another_tool_comes_out_as_it_went_in(self):
        tetrahedron = ([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
                       [(0, 2, 1), (0, 1, 3), (1, 2, 3), (0, 3, 2)])
        page = self.view(self.write_off("closed.off", *tetrahedron))
        self.check_same_mesh(page, *tetrahedron)
        self.assertEqual(page.about["kind"], "mesh")
        self.assertEqual(set(page.entries), {f"mesh.{name}" for name in
                                             ("cases", "references", "x", "y", "z")})

    def test_whatever_the_connectivity_every_triangle_is_kept(self):
        """Borders, edges with three triangles, doubled, reversed and degenerate triangles."""
        for seed in range(40):
            chance = random.Random(seed)
            count = chance.choice([3, 4, 6, 9, 20])
            places = [[chance.randrange(1000) / 64 for _ in range(3)] for _ in range(count)]
            triangles = [tuple(chance.randrange(count) for _ in range(3))
                         for _ in range(chance.randrange(1, 4 * count))]
            with self.subTest(seed=seed):
                page = self.view(self.write_off("soup.off", places, triangles))
                self.check_same_mesh(page, places, triangles)

    def test_places_are_rounded_to_a_64th_of_the_shortest_edge(self):
        page = self.view(MOLECULES / "caffeine.xyz")
        places, corners, _ = page.mesh()
        shortest = min(sum((a - b) ** 2 for a, b in zip(places[t[k]], places[t[k - 1]])) ** 0.5
                       for t in corners for k in range(3))
        self.assertGreater(shortest, 63)


class Layers(ViewTest):
    def test_a_page_names_residue_and_atom_as_the_file_does(self):
        crambin = MOLECULES / "1crn.pdb"
        page = self.view(crambin, "-C", "0.3")
        labels = page.array("atoms.labels").split("\0")
        self.assertEqual(labels.pop(), "")
        told = [(row[21].strip(), row[17:20].strip(), row[22:27].strip(), row[12:16].strip())
                for row in crambin.read_text().splitlines() if row.startswith("ATOM")]
        self.assertEqual(list(zip(*[iter(labels)] * 4)), told)
        self.assertNotIn("atoms.labels", self.view(self.ring).entries)

    def test_critical_points_and_lines_are_those_of_the_morse_command(self):
        page = self.view(self.ring)
        self.run_morskin("morse", self.ring, "-o", "ring.json", "-q")
        told = json.loads((self.folder / "ring.json").read_text())
        self.assertEqual(page.about["critical"]["found"],
                         [told["before"][name] for name in ("minima", "saddles", "maxima")])
        self.assertEqual(page.about["critical"]["left"],
                         [told["after"][name] for name in ("minima", "saddles", "maxima")])
        self.assertEqual(page.about["lines"]["count"], told["before"]["arcs"])
        self.assertEqual(page.about["kept_lines"]["count"], told["after"]["arcs"])
        points = page.array("critical.points")
        for i, point in enumerate(told["critical_points"]):
            for k in range(3):
                self.assertAlmostEqual(points[6 * i + k], point["position"][k], places=4)

    def test_spheres_of_an_undecided_complex_are_apart_as_those_of_the_front(self):
        c60 = MOLECULES / "c60.xyz"  # two saddles are joined along this height
        page = self.view(c60, "--function", "height:1,0,0", "-C", "0.3")
        self.assertNotIn("lines", page.about)
        numbers = page.array("critical.points")
        spheres = [numbers[i:i + 6] for i in range(0, len(numbers), 6)]
        self.assertEqual(len(spheres), sum(page.about["critical"]["found"]))
        for *p, _, _, r in spheres:
            for *q, _, _, s in spheres:
                self.assertTrue(p == q or r + s < math.dist(p, q) + 1e-5)

    def test_lines_of_something_tiny_are_as_curved_as_those_of_something_large(self):
        rows = [line.split() for line in self.ring.read_text().splitlines()[1:]]
        path = self.folder / "tiny.xyzr"
        path.write_text("".join(" ".join(repr(float(x) / 2**16) for x in row) + "\n"
                                for row in rows))
        lengths = self.view(path).array("lines.lengths")
        self.assertGreater(sum(lengths) / len(lengths), 8)

    def test_lines_of_molecules_far_apart_keep_their_places(self):
        rows = [line.split() for line in self.ring.read_text().splitlines()[1:]]
        away = 9.9e5
        path = self.folder / "far.xyzr"
        path.write_text("".join(" ".join([repr(float(x) + side * away), *rest]) + "\n"
                                for side in (-1, 1) for x, *rest in rows))
        page = self.view(path)
        grid, at, seen = page.about["lines"]["grid"], 0, set()
        self.assertGreater(page.about["lines"]["count"], 0)
        for step in page.array("lines.x"):
            self.assertLess(abs(step), 2 ** 30)
            at += step
            x = grid["origin"][0] + grid["step"] * at
            side = 1 if x > 0 else -1
            seen.add(side)
            self.assertLess(abs(x - side * away), 20)
        self.assertEqual(seen, {-1, 1})

    def test_regions_lie_between_a_minimum_and_a_maximum(self):
        page = self.view(self.ring)
        _, corners, parents = page.mesh()
        region = page.by_triangle("mesh.region", parents)
        index = page.array("critical.index")
        self.assertTrue(all(index[i] == 0 for i in page.array("regions.minimum")))
        self.assertTrue(all(index[i] == 2 for i in page.array("regions.maximum")))
        self.assertEqual(set(region), set(range(len(page.array("regions.minimum")))))

    def test_a_mesh_with_its_molecule_shows_all_but_the_sweep(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.stl", "-q")
        page = self.view("ring.stl", "--against", self.ring)
        for name in ("mesh.cell", "mesh.region", "atoms.balls", "critical.index", "lines.x"):
            self.assertIn(name, page.entries)
        self.assertNotIn("mesh.birth", page.entries)
        self.assertIs(page.about["certified"], True)

    def test_a_mesh_is_shown_against_what_it_says_it_was_made_of(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "-q", "--model", "sas", "--probe",
                         "0.5", "-C", "0.2")
        page = self.view("ring.ply", "--against", self.ring)
        self.assertEqual([page.about[k] for k in ("model", "probe", "C", "certified")],
                         ["sas", 0.5, 0.2, True])
        self.assertEqual(page.about["taken"], ["model", "probe", "voids", "C", "Q"])
        page = self.view("ring.ply", "--against", self.ring, "--model", "vdw")
        self.assertEqual((page.about["model"], page.about["certified"]), ("vdw", False))
        self.assertNotIn("probe", page.about)

    def test_a_mesh_without_its_voids_is_certified_on_its_page_too(self):
        shell = MOLECULES / "shell_hollow.xyzr"
        self.run_morskin("mesh", shell, "-o", "shell.ply", "-q", "--voids", "drop")
        self.assertIs(self.view("shell.ply", "--against", shell).about["certified"], True)

    def test_a_page_states_the_selection_and_the_radii(self):
        dna = MOLECULES / "9dna.pdb"
        page = self.view(dna, "--chain", "A", "--radii", "bondi", "-C", "0.3")
        self.assertEqual(page.about["selection"], {"chain": ["A"]})
        self.assertEqual(page.about["radii"], "bondi")
        page = self.view(self.ring)
        self.assertNotIn("selection", page.about)
        self.assertEqual(page.about["radii"], "input")

    def test_frames_of_a_growing_skin_come_in_the_order_given(self):
        small = ([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [(0, 1, 2)])
        large = ([[0, 0, 0], [3, 0, 0], [0, 3, 0], [3, 3, 0]], [(0, 1, 2), (1, 3, 2)])
        first, second = self.write_off("b.off", *small), self.write_off("a.off", *large)
        page = self.view(second, "--frames", first, second)
        frames = page.about["growth"]["frames"]
        self.assertEqual([(f["label"], f["triangles"]) for f in frames], [("b", 1), ("a", 2)])
        self.check_same_mesh(page, *small, name="growth.0")
        self.check_same_mesh(page, *large, name="growth.1")

    def test_a_folder_of_snapshots_is_taken_in_the_order_of_their_numbers(self):
        self.run_morskin("mesh", self.ring, "-o", "ring.ply", "--snapshots", "11", "-q")
        page = self.view("ring.ply", "--frames", ".")
        frames = page.about["growth"]["frames"]
        self.assertEqual([f["label"] for f in frames], [f"snapshot-{k}" for k in range(1, 12)])
        triangles = [f["triangles"] for f in frames]
        self.assertEqual(triangles, sorted(triangles))
        # What is still open is kept too.
        _, corners, _ = page.mesh("growth.4")
        self.assertEqual(len(corners), triangles[4])


class Failures(ViewTest):
    def failure(self, *words, code):
        done = self.run_morskin("view", *words, code=code)
        self.assertEqual(sorted(p.name for p in self.folder.iterdir()), self.before)
        self.assertTrue(done.stderr.startswith(b"morskin: "), done.stderr)
        return done.stderr.decode()

    def test_standard_output_gets_no_page_that_is_not_certified_and_the_message_says_so(self):
        done = self.run_morskin("view", MOLECULES / "ring12.xyzr", "-C", "0.7", "-Q", "1.5", "-o",
                                "-", code=5)
        self.assertEqual(done.stdout, b"")
        self.assertIn(b"nothing is written", done.stderr)
        self.assertNotIn(b"see -", done.stderr)

    def test_a_mesh_without_an_ending_is_refused_with_a_word_on_endings(self):
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "-q", "-C", "0.3")
        mesh = (self.folder / "m.ply").rename(self.folder / "m").read_bytes()
        for words in (("m",), ("-",)):
            done = self.run_morskin("view", *words, "-o", "m.html", code=3, input=mesh)
            self.assertIn(b"a mesh is known by its name's ending", done.stderr)

    def test_each_failure_has_its_exit_code_and_leaves_nothing(self):
        (self.folder / "broken.ply").write_text("ply\nnonsense\n")
        (self.folder / "empty.off").write_text("OFF\n0 0 0\n")
        (self.folder / "arrays.npz").write_text("PK")
        for size in (1e-60, 1e60):
            self.write_off(f"{size}.off", [(0, 0, 0), (size, 0, 0), (0, size, 0)], [(0, 1, 2)])
        self.before = sorted(p.name for p in self.folder.iterdir())
        self.failure(self.ring, "-o", "page.txt", code=2)
        self.failure(self.ring, "-o", self.ring, code=2)
        self.failure(self.ring, "-o", "page.html", "--against", self.ring, code=2)
        self.failure(self.ring, "-o", "page.html", "--function", "height:0,0,0", code=2)
        self.failure(self.ring, "-o", "page.html", "--density", "2", "--size", "1", code=2)
        self.failure(self.ring, "-o", "page.html", "--density", "0", code=2)
        self.failure("broken.ply", "-o", "page.html", "--triangles", "99", code=2)
        self.failure("missing.pdb", "-o", "page.html", code=3)
        self.failure(self.ring, "-o", "page.html", "--frames", ".", code=3)
        self.failure(self.ring, "-o", "page.html", "--frames", "missing.ply", code=3)
        self.failure(self.ring, "-o", "page.html", "--frames", "x" * 300, code=3)
        self.failure("broken.ply", "-o", "page.html", code=3)
        self.assertIn("are only written", self.failure("arrays.npz", "-o", "page.html", code=3))
        self.failure("empty.off", "-o", "page.html", code=4)
        for name in ("1e-60.off", "1e+60.off"):
            for words in ([name], [self.ring, "--frames", name]):
                complaint = self.failure(*words, "-o", "page.html", code=4)
                self.assertIn(f"{name}: the mesh is too large or too small", complaint)
        self.failure(self.ring, "-o", "nowhere/page.html", code=7)
        (self.folder / "page.html.unverified").mkdir()
        self.before = sorted([*self.before, "page.html.unverified"])
        self.assertIn("is a folder", self.failure(self.ring, "-o", "page.html", code=7))


if __name__ == "__main__":
    main()
