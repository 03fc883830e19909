#!/usr/bin/env python3
"""The second checker, certify/verify/. Usage: verify_test.py path/to/morskin"""

import json
import re
import subprocess
import sys
from pathlib import Path

import numpy as np

from support.command import MOLECULES, CommandTest, main

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
import files  # noqa: E402
import verify  # noqa: E402
from enclosure import Skin  # noqa: E402
from manifold import NotProved  # noqa: E402
from skin_components import Balls, skin_components  # noqa: E402
from support.exact_skin import tetrahedra_of  # noqa: E402

skin_components = skin_components.__wrapped__  # without its memory

SMALL = ["two_balls.xyzr", "cube8.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "benzene.pdb",
         "caffeine.xyz", "5tmn_ligand.pdb", "c60.xyz"]


def reason(balls, positions, triangles, simplices=(), dropped=0):
    """Why a mesh is not proved, at whichever vertices; None if it is."""
    finite = np.where(np.isfinite(positions), positions, 0)
    nearest = Skin(balls).least_power(finite)[1]
    witness = {"simplices": simplices, "vertex_atoms": np.repeat(nearest[:, None], 4, axis=1),
               "component_vertices": range(len(positions)), "dropped_voids": dropped}
    try:
        verify.prove(balls, positions, triangles, witness, {})
    except NotProved as error:
        return str(error)
    return None


class Verify(CommandTest):
    """Meshes made by morskin, and the same spoilt."""

    def made(self, molecule, *words):
        """The names of the files of the balls, the mesh and the certificate."""
        self.run_morskin("mesh", molecule, "-o", "mesh.ply", "-q", "--certificate",
                         "certificate.json", *words)
        model = [*words][:2] if "--model" in words[:1] else []
        self.run_morskin("balls", molecule, "-o", "balls.xyzw", "--weights", "-q", *model)
        return [str(self.folder / name) for name in ("balls.xyzw", "mesh.ply", "certificate.json")]

    def loaded(self, molecule, *words):
        """Balls, positions, triangles and simplices."""
        names = self.made(molecule, *words)
        balls, mesh = files.read_balls(names[0]), files.read_mesh(names[1])
        witness = files.read_certificate(names[2], len(balls), len(mesh[0]), len(mesh[1]))
        return balls, *mesh, witness["simplices"]

    def refused(self, expected, *mesh):
        self.assertRegex(reason(*mesh) or "proved", expected)

    def test_meshes_of_all_kinds_are_proved(self):
        kinds = [("--model", model, "-C", C) for model in ("vdw", "sas", "paper")
                 for C in ("0.2", "0.3")]
        kinds.append(("--model", "vdw", "-C", "0.2", "--method", "static"))
        for k, molecule in enumerate(SMALL):
            for words in [*kinds[k % 2::2], *kinds[-1:]]:
                with self.subTest(molecule=molecule, words=words):
                    report = verify.verify(self.made(MOLECULES / molecule, *words))
                    self.assertIsNone(report["reason"])
                    self.assertTrue(report["homeomorphic"] and report["on_skin"])

    def test_a_mesh_is_proved_in_both_formats_whatever_the_witness_of_its_vertices(self):
        balls, mesh, certificate = self.made(MOLECULES / "two_balls.xyzr", "--model", "vdw", "-o",
                                             "mesh.off", "-C", "0.08")
        witness = json.loads(Path(certificate).read_text())
        self.assertEqual(len(witness["component_vertices"]), 1)
        witness |= {"component_vertices": [0, 0, 7], "vertex_atoms": [[1]] * witness["vertices"]}
        other = str(self.input("other.json", json.dumps(witness)))
        for name in (mesh, str(self.folder / "mesh.off")):
            for its in (certificate, other):
                self.assertIsNone(verify.verify([balls, name, its])["reason"])
        for wrong in ({"component_vertices": [-1]}, {"vertex_atoms": [[2]] * witness["vertices"]},
                      {"vertex_atoms": [[]]}, {"simplices": 3}, {"simplices": [[0, 1.5e300]]},
                      {"dropped_voids": None}, {"balls": 3}, {"format": None}):
            other = str(self.input("other.json", json.dumps(witness | wrong)))
            self.assertRegex(verify.verify([balls, mesh, other])["reason"], "^unreadable")

    def test_a_mesh_with_data_beside_it_is_proved_like_the_bare_one(self):
        words = ("--model", "vdw", "-C", "0.3")
        bare = files.read_mesh(self.made(MOLECULES / "caffeine.xyz", *words)[1])
        names = self.made(MOLECULES / "caffeine.xyz", *words, "--vertex-data", "all")
        for a, b in zip(bare, files.read_mesh(names[1])):
            np.testing.assert_array_equal(a, b)
        self.assertIsNone(verify.verify(names)["reason"])

    def test_check_writes_the_certificate_that_mesh_writes(self):
        words = ("--model", "vdw", "-C", "0.3")
        names = self.made(MOLECULES / "caffeine.xyz", *words)
        against = ("--against", MOLECULES / "caffeine.xyz", *words)
        self.run_morskin("check", "mesh.ply", *against, "--certificate", "again.json")
        self.assertEqual((self.folder / "again.json").read_bytes(), Path(names[2]).read_bytes())
        done = self.run_morskin("check", "mesh.ply", *against, "--certificate", "no/folder.json",
                                code=7)
        self.assertIn(b"no/folder.json", done.stderr)
        for wrong in (["check", "mesh.ply", "--certificate", "c.json"],
                      ["check", "mesh.ply", *against, "--certificate", "mesh.ply"],
                      *(["check", f"m.vert{end}", *against, "--certificate", f"./m.face{end}"]
                        for end in ("", ".gz", ".unverified", ".unverified.gz")),
                      ["mesh", self.ring, "-o", "a.ply", "--certificate", "a.ply"]):
            self.run_morskin(*wrong, code=2)

    def test_the_command_prints_a_verdict_for_each_mesh(self):
        names = self.made(MOLECULES / "two_balls.xyzr", "--model", "vdw", "-C", "0.3")
        script = Path(verify.__file__)
        self.input("list.txt", "\n".join(names * 3) + "\n")
        done = self.run_python(script, f"@{self.folder / 'list.txt'}")
        self.assertEqual((done.returncode, done.stdout.count('"homeomorphic": true')), (0, 3))
        self.assertEqual(self.run_python(script, names[0], names[0], names[2]).returncode, 2)
        self.assertEqual(self.run_python(script, *names[:2]).returncode, 2)
        self.input("balls.xyzw", "0 0 0 1\n9 0 0 1\n")
        self.assertEqual(self.run_python(script, *names).returncode, 1)

    def test_a_certificate_that_asks_for_memory_costs_no_other_mesh_its_verdict(self):
        names = self.made(MOLECULES / "two_balls.xyzr", "--model", "vdw", "-C", "0.3")
        text = Path(names[2]).read_text()
        wrongs = []
        for number in ("2147483648", "1000000000000", "1e300", "-1"):
            wrong = re.sub(r'("dropped_voids": *)0', rf"\g<1>{number}", text)
            self.assertNotEqual(wrong, text)
            wrongs.append(str(self.input(f"wrong{number}.json", wrong)))
        words = [word for wrong in wrongs for word in (*names[:2], wrong)] + names
        done = self.run_python(Path(verify.__file__), *words)
        verdicts = [json.loads(line)["homeomorphic"] for line in done.stdout.splitlines()]
        self.assertEqual((done.returncode, verdicts), (1, [False] * len(wrongs) + [True]))

    def test_vertices_at_a_neck_too_thin_for_doubles_are_not_said_to_be_off(self):
        for gap in ("1.999999", "2.00000001"):
            self.input("thin.xyzw", f"0 0 0 1\n{gap} 0 0 1\n")
            names = self.made(self.folder / "thin.xyzw", "--model", "given", "-C", "0.3")
            done = self.run_python(Path(verify.__file__), *names)
            self.assertEqual(json.loads(done.stdout)["on_skin"], True, done.stdout)

    def run_python(self, script, *words):
        return subprocess.run([sys.executable, script, *map(str, words)], capture_output=True,
                              text=True, check=False)

    def test_wrong_meshes_are_refused_for_the_right_reason(self):
        balls, p, t, pair = self.loaded(MOLECULES / "two_balls.xyzr", "--model", "vdw", "-C", "0.2")
        n = len(p)
        self.assertIsNone(reason(balls, p, t, pair))
        self.refused("^manifold: an edge at vertex", balls, p, t[1:])
        flipped = t.copy()
        flipped[5] = flipped[5, ::-1]
        self.refused("^manifold: an edge at vertex", balls, p, flipped)
        self.refused("^upright or tube: ", balls, p, t[:, ::-1])
        self.refused("^manifold: a vertex is unused", balls, np.vstack([p, p[:1]]), t)
        moved = p.copy()
        moved[7] += 0.1 * (p[7] - p.mean(0)) / np.linalg.norm(p[7] - p.mean(0))
        self.refused("^on skin: vertex 7", balls, moved, t, pair)
        for coordinate in (np.nan, np.inf, -2.0**101):
            wrong = p.copy()
            wrong[3, 1] = coordinate
            self.refused("^manifold: a coordinate", balls, wrong, t)
        self.refused("^degree: .* more than once", balls, np.vstack([p, p]),
                     np.vstack([t, t + n]), pair)
        self.refused("^degree: .* more than once", balls, *self.slit(p, t), pair)
        swapped = np.column_stack([balls[::-1, :3], balls[:, 3]])
        self.refused("^(on skin|upright or tube): ", swapped, p, t, pair)
        self.assertIsNone(reason(balls, p.astype(np.float32).astype(float), t, pair))

    def slit(self, p, t):
        """Two copies joined crosswise along a path of two edges, a - m - b: connected, and with the
        counts of one sphere."""
        m, n = 0, len(p)
        fan = [np.roll(row, -row.tolist().index(m)).tolist() for row in t if m in row]
        ring = [fan[0][1]]
        following = {row[1]: row[2] for row in fan}
        while len(ring) < len(fan):
            ring.append(following[ring[-1]])
        a, b, right = ring[0], ring[len(ring) // 2], set(ring[:len(ring) // 2])
        other = t + n
        for copy in (t := t.copy(), other):
            for row in copy:
                local = [v % n for v in row]
                if m in local and local[(local.index(m) + 1) % 3] in right:
                    row[local.index(m)] = m + n - row[local.index(m)] + m
        other[other == a + n], other[other == b + n] = a, b
        used, triangles = np.unique(np.vstack([t, other]), return_inverse=True)
        return np.vstack([p, p])[used], triangles.reshape(-1, 3)

    def test_components_must_be_covered_once_each(self):
        balls, p, t, simplices = self.loaded(MOLECULES / "shell_hollow.xyzr", "--model", "vdw",
                                             "-C", "0.2")
        self.assertIsNone(reason(balls, p, t, simplices))
        label = verify.components(len(p), t.ravel(), t[:, [1, 2, 0]].ravel())
        parts = [self.compact(p, t[label[t[:, 0]] == c]) for c in np.unique(label)]
        self.assertEqual(len(parts), 2)
        for q, own in parts:
            self.refused("^degree: not all components but those about 0 voids", balls, q, own,
                         simplices)
            twice = np.vstack([q, q]), np.vstack([own, own + len(q)])
            self.refused("^degree: .* more than once", balls, *twice, simplices)

    def test_the_components_are_those_but_for_the_voids_that_are_dropped(self):
        # Two like voids; which of them is missing is not said, only that one is.
        a, w = 1.0, 2.98
        signs = [(1, 1), (1, -1), (-1, 1), (-1, -1)]
        balls = [(s * a + x, t * a, s * t * a, w) for x in (0, 8) for s, t in signs]
        name = self.input("two.xyzw", "".join("%r %r %r %r\n" % ball for ball in balls))
        for voids, dropped in (("keep", 0), ("drop", 2)):
            names = self.made(name, "--model", "given", "-C", "0.2", "--voids", voids)
            self.assertEqual(verify.verify(names)["reason"], None)
            for option in ([], ["--voids-dropped"]):  # else another claim than that of the skin
                done = self.run_python(Path(verify.__file__), *option, *names)
                self.assertEqual(done.returncode, 1 if dropped and not option else 0)
            witness, (p, t) = json.loads(Path(names[2]).read_text()), files.read_mesh(names[1])
            self.assertEqual(witness["dropped_voids"], dropped)
            loaded = np.array(balls), p, t, tuple(map(tuple, witness["simplices"]))
            for other in {0, 1, 2} - {dropped}:
                told = f"degree: not all components but those about {other} voids"
                self.assertEqual(reason(*loaded, other), told.replace(" 1 voids", " 1 void"))
        whole = self.loaded(name, "--model", "given", "-C", "0.2")
        p, t = whole[1:3]
        label = verify.components(len(p), t.ravel(), t[:, [1, 2, 0]].ravel())
        for component in np.unique(label):
            some = (whole[0], *self.compact(p, t[label[t[:, 0]] != component]), whole[3])
            is_wall = (label == component).sum() < 0.1 * len(p)
            self.assertEqual(reason(*some, 1) is None, is_wall)

    def compact(self, p, t):
        used, t = np.unique(t, return_inverse=True)
        return p[used], t.reshape(-1, 3)

    def test_a_spoilt_triangulation_is_refused(self):
        balls = self.loaded(MOLECULES / "c60.xyz", "--model", "vdw", "-C", "0.3")[0]
        # C60's balls lie on a sphere; one more inside makes inner facets that are not ties.
        balls = np.vstack([balls, [0.1, 0.2, 0.3, 3.0], [1.5, 0.2, 0.3, 3.0], [0.1, -1.4, 1, 3]])
        good, without_last = (self.triangulated(rows) for rows in (balls, balls[:-1]))
        (bodies, voids), again = (skin_components(balls, s, ()) for s in (good, good[::-1]))
        self.assertEqual(bodies, again[0])
        self.assertCountEqual(voids, again[1])
        spoilt = {
            "a missing tetrahedron": good[1:],
            "one twice": (*good, good[0]),
            "one without a corner": (*good[1:], good[0][:3]),
            "a flat one": (*good, (0, 0, 1, 2)),
            "none": (),
            "all of them twice": (*good, *good),
            "a corner exchanged": tuple(((s[0] + 1) % 60, *s[1:]) if k == 7 else s
                                        for k, s in enumerate(good)),
            "a ball wrongly hidden": without_last}
        for name, simplices in spoilt.items():
            with self.subTest(name), self.assertRaisesRegex(NotProved, "^triangulation: "):
                skin_components(balls, simplices, ())

    def triangulated(self, rows):
        self.input("given.xyzw", "# x y z w\n" + "\n".join(
            " ".join(map(repr, row)) for row in rows.tolist()) + "\n")
        return self.loaded("given.xyzw", "--model", "given", "-C", "0.3")[3]

    def test_a_flip_makes_a_triangulation_irregular(self):
        five = [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1], [0.3, 0.3, 1, 1], [0.3, 0.3, -1, 1]]
        two, three = [[0, 1, 2, 3], [0, 1, 2, 4]], [[0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]]
        for weight, right, wrong in ((3, three, two), (-2, two, three)):
            balls = Balls(five[:3] + [[*z, weight] for *z, _ in five[3:]])
            balls.facets(np.array(right))
            with self.assertRaisesRegex(NotProved, "^triangulation: "):
                balls.facets(np.array(wrong))

    def test_components_of_small_sets(self):
        for expected, balls in [
                ((1, 0), [[0, 0, 0, 1]]), ((0, 0), [[0, 0, 0, -1]]),
                ((1, 0), [[0, 0, 0, 1], [0, 0, 0, 2]]),
                ((2, 0), [[0, 0, 0, 1], [3, 0, 0, 1]]), ((1, 0), [[0, 0, 0, 1], [1, 0, 0, 1]]),
                ((2, 0), [[0, 0, 0, 1], [2, 0, 0, 1]]),  # they touch: no skin is covered
                ((1, 0), [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]),
                ((1, 0), [[0, 0, 0, 1], [1, 1, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1]]),
                ((8, 0), [[x, y, z, 1] for x in (0, 3) for y in (0, 3) for z in (0, 3)]),
                ((1, 1), [[x, y, z, 0.65] for x in (0, 1) for y in (0, 1) for z in (0, 1)]),
                ((1, 0), [[x, y, z, 0.80] for x in (0, 1) for y in (0, 1) for z in (0, 1)]),
                # At 3/4 the power at the centre is 0, and no void; at 1/2 those at faces, no doors.
                ((1, 0), [[x, y, z, 0.75] for x in (0, 1) for y in (0, 1) for z in (0, 1)]),
                ((1, 1), [[x, y, z, 0.50] for x in (0, 1) for y in (0, 1) for z in (0, 1)]),
                # The outside comes in by a facet at whose orthocentre another ball is.
                ((1, 0), [[0, 2, -2, 14], [-1, 0, 3, 16], [-2, -2, -4, 17], [1, 4, -3, 16],
                          [-4, 3, -4, 11]]),
                # Two such facets of one tetrahedron join nothing if the power is below 0 within.
                ((1, 1), [[x, y, 0, w] for x in (0.375, -0.375) for y, w in ((2.5, 5.5625),
                                                                             (-3.5, 11.5))] +
                 [[0, -0.5, 1, 2], [0, -0.5, -1, 2], [-5, -0.25, 1.75, 9], [-3, 1.75, 3.75, 15],
                  [-3.25, -1.5, -3.75, 14], [-2.25, 3.75, -3, 19.5]])]:
            every = range(len(balls))
            lower = tuple((i, j) for i in every for j in range(i + 1))
            found = skin_components(balls, tetrahedra_of(balls) or lower, every)
            self.assertEqual(tuple(map(len, found)), expected, balls)


if __name__ == "__main__":
    main()
