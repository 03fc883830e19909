#!/usr/bin/env python3
"""The second checker, certify/verify/. Usage: verify_test.py path/to/morskin"""

import random
import subprocess
import sys
from fractions import Fraction
from itertools import combinations
from pathlib import Path

import numpy as np

from support.command import MOLECULES, CommandTest, main

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
import files  # noqa: E402
import verify  # noqa: E402
from enclosure import Skin  # noqa: E402
from manifold import NotProved  # noqa: E402
from skin_components import (  # noqa: E402
    Balls, Triangulation, regular_triangulation, skin_components)

SMALL = ["two_balls.xyzr", "cube8.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "benzene.pdb",
         "caffeine.xyz", "5tmn_ligand.pdb", "c60.xyz"]


def reason(balls, positions, triangles, witness=None):
    """Why a mesh is not proved; None if it is."""
    report = {"homeomorphic": False, "C": None, "Q": None}
    try:
        verify.prove(balls, positions, triangles, witness or {}, report)
    except NotProved as error:
        return str(error)
    return None


class Verify(CommandTest):
    """Meshes made by morskin, and the same spoilt."""

    def made(self, molecule, *words):
        """The balls, the mesh and the certificate's file names."""
        self.run_morskin("mesh", MOLECULES / molecule, "-o", "mesh.ply", "-q", "--certificate",
                         "certificate.json", *words)
        model = [*words][:2] if "--model" in words[:1] else []
        self.run_morskin("balls", MOLECULES / molecule, "-o", "balls.xyzr", "-q", *model)
        lines = (self.folder / "balls.xyzr").read_text().splitlines()
        rows = [line.split() for line in lines if not line.startswith("#")]
        weighted = "\n".join(" ".join([*row[:3], repr(2 * float(row[3])**2)]) for row in rows)
        self.input("balls.txt", weighted + "\n")
        return [str(self.folder / name) for name in ("balls.txt", "mesh.ply", "certificate.json")]

    def loaded(self, molecule, *words):
        names = self.made(molecule, *words)
        balls, mesh = files.read_balls(names[0]), files.read_mesh(names[1])
        return balls, *mesh, files.read_certificate(names[2], len(balls), len(mesh[0]),
                                                    len(mesh[1]))

    def refused(self, expected, *mesh):
        self.assertRegex(reason(*mesh) or "proved", expected)

    def test_meshes_of_all_kinds_are_proved(self):
        kinds = [("--model", model, "-C", C) for model in ("vdw", "sas", "paper")
                 for C in ("0.2", "0.3")]
        kinds.append(("--model", "vdw", "-C", "0.2", "--method", "static"))
        for k, molecule in enumerate(SMALL):
            for words in [*kinds[k % 2::2], *kinds[-1:]]:
                with self.subTest(molecule=molecule, words=words):
                    report = verify.verify(*self.made(molecule, *words))
                    self.assertIsNone(report["reason"])
                    self.assertTrue(report["homeomorphic"] and report["on_skin"])
                    self.assertEqual(report["sizes"], "hold")

    def test_a_fine_mesh_is_proved_without_a_certificate_and_in_every_format(self):
        names = self.made("two_balls.xyzr", "--model", "vdw", "-o", "mesh.off", "-C", "0.08")
        certificate = names[2]
        for mesh in (names[1], str(self.folder / "mesh.off")):
            for witness in (None, certificate):
                report = verify.verify(names[0], mesh, witness)
                self.assertIsNone(report["reason"])

    def test_check_writes_the_certificate_that_mesh_writes(self):
        words = ("--model", "vdw", "-C", "0.3")
        names = self.made("caffeine.xyz", *words)
        against = ("--against", MOLECULES / "caffeine.xyz", *words)
        self.run_morskin("check", "mesh.ply", *against, "--certificate", "again.json")
        self.assertEqual((self.folder / "again.json").read_bytes(), Path(names[2]).read_bytes())
        done = self.run_morskin("check", "mesh.ply", *against, "--certificate", "no/folder.json",
                                code=7)
        self.assertIn(b"no/folder.json", done.stderr)
        for wrong in (["check", "mesh.ply", "--certificate", "c.json"],
                      ["check", "mesh.ply", *against, "--certificate", "mesh.ply"],
                      ["mesh", self.ring, "-o", "a.ply", "--certificate", "a.ply"]):
            self.run_morskin(*wrong, code=2)

    def test_the_command_prints_a_verdict_for_each_pair(self):
        names = self.made("two_balls.xyzr", "--model", "vdw", "-C", "0.3")
        script = Path(verify.__file__)
        pair = " ".join(names) + "\n"
        self.input("list.txt", pair + pair)
        done = self.run_python(script, "--list", self.folder / "list.txt")
        self.assertEqual((done.returncode, done.stdout.count(": proved homeomorphic")), (0, 2))
        self.assertEqual(self.run_python(script, names[0], names[0]).returncode, 2)
        self.input("balls.txt", "0 0 0 1\n")
        self.assertEqual(self.run_python(script, *names[:2]).returncode, 1)

    def run_python(self, script, *words):
        return subprocess.run([sys.executable, script, *map(str, words)], capture_output=True,
                              text=True, check=False)

    def test_wrong_meshes_are_refused_for_the_right_reason(self):
        balls, p, t, _ = self.loaded("two_balls.xyzr", "--model", "vdw", "-C", "0.2")
        n = len(p)
        self.assertIsNone(reason(balls, p, t))
        self.refused("^manifold: the edge .* has one side", balls, p, t[1:])
        flipped = t.copy()
        flipped[5] = flipped[5, ::-1]
        self.refused("^manifold: the edge .* twice", balls, p, flipped)
        self.refused("^upright: .* faces away", balls, p, t[:, ::-1])
        self.refused("^manifold: vertex .* unused", balls, np.vstack([p, p[:1]]), t)
        moved = p.copy()
        moved[7] += 0.1 * (p[7] - p.mean(0)) / np.linalg.norm(p[7] - p.mean(0))
        self.refused("^on skin: at vertex 7", balls, moved, t)
        wrong = p.copy()
        wrong[3, 1] = np.nan
        self.refused("^manifold: a coordinate", balls, wrong, t)
        self.refused("^degree: 2 components, 1 of the skin", balls, np.vstack([p, p]),
                     np.vstack([t, t + n]))
        self.refused("^degree: vertex .* (may be reached|once)", balls, *self.slit(p, t))
        swapped = np.column_stack([balls[::-1, :3], balls[:, 3]])
        self.refused("^(on skin|upright|tube): ", swapped, p, t)
        self.assertIsNone(reason(balls, p.astype(np.float32).astype(float), t))

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
        balls, p, t, _ = self.loaded("shell_hollow.xyzr", "--model", "vdw", "-C", "0.2")
        label = verify.components(len(p), t.ravel(), t[:, [1, 2, 0]].ravel())
        parts = [self.compact(p, t[label[t[:, 0]] == c]) for c in np.unique(label)]
        self.assertEqual(len(parts), 2)
        for q, own in parts:
            self.refused("^degree: 1 components, 2 of the skin", balls, q, own)
            twice = np.vstack([q, q]), np.vstack([own, own + len(q)])
            self.refused("^degree: .* may be reached", balls, *twice)

    def compact(self, p, t):
        used, t = np.unique(t, return_inverse=True)
        return p[used], t.reshape(-1, 3)

    def test_a_spoilt_triangulation_is_refused(self):
        balls, _, _, witness = self.loaded("c60.xyz", "--model", "vdw", "-C", "0.3")
        # C60's balls lie on a sphere; one more inside makes inner facets that are not ties.
        balls = np.vstack([balls, [0.1, 0.2, 0.3, 3.0], [1.5, 0.2, 0.3, 3.0], [0.1, -1.4, 1, 3]])
        exact = Balls(balls)
        good = regular_triangulation(exact)
        bodies = skin_components(Triangulation(exact, good))
        self.assertEqual(bodies, skin_components(Triangulation(exact, good[::-1])))
        lighter = balls.copy()
        lighter[60, 3] -= 50
        spoilt = {
            "a missing tetrahedron": good[1:],
            "one twice": [*good, good[0]],
            "one without a corner": [*good[1:], good[0][:3]],
            "a flat one": [*good, [0, 0, 1, 2]],
            "all of them twice": [*good, *good],
            "a corner exchanged": [[(s[0] + 1) % 60, *s[1:]] if k == 7 else s
                                   for k, s in enumerate(good)],
            "a ball wrongly hidden": regular_triangulation(Balls(lighter))}
        for name, simplices in spoilt.items():
            with self.subTest(name), self.assertRaisesRegex(NotProved, "^triangulation: "):
                Triangulation(exact, simplices)

    def test_a_flip_makes_a_triangulation_irregular(self):
        five = [[0, 0, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1], [0.3, 0.3, 1, 1], [0.3, 0.3, -1, 1]]
        two, three = [[0, 1, 2, 3], [0, 1, 2, 4]], [[0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]]
        for weight, right, wrong in ((3, three, two), (-2, two, three)):
            exact = Balls(np.array(five[:3] + [[*z, weight] for *z, _ in five[3:]], dtype=float))
            Triangulation(exact, right)
            with self.assertRaisesRegex(NotProved, "^triangulation: "):
                Triangulation(exact, wrong)

    def test_components_of_small_sets(self):
        for expected, balls in [
                ((1, 0), [[0, 0, 0, 1]]), ((0, 0), [[0, 0, 0, -1]]),
                ((1, 0), [[0, 0, 0, 1], [0, 0, 0, 2]]),
                ((2, 0), [[0, 0, 0, 1], [3, 0, 0, 1]]), ((1, 0), [[0, 0, 0, 1], [1, 0, 0, 1]]),
                ((1, 0), [[0, 0, 0, 1], [1, 0, 0, 1], [2, 0, 0, 1]]),
                ((1, 0), [[0, 0, 0, 1], [1, 1, 0, 1], [1, 0, 0, 1], [0, 1, 0, 1]]),
                ((8, 0), [[x, y, z, 1] for x in (0, 3) for y in (0, 3) for z in (0, 3)]),
                ((1, 1), [[x, y, z, 0.65] for x in (0, 1) for y in (0, 1) for z in (0, 1)]),
                ((1, 0), [[x, y, z, 0.80] for x in (0, 1) for y in (0, 1) for z in (0, 1)])]:
            exact = Balls(np.array(balls, dtype=float))
            found = skin_components(Triangulation(exact, regular_triangulation(exact)))
            self.assertEqual(found, expected, balls)
        touching = Balls(np.array([[0, 0, 0, 1.0], [2, 0, 0, 1]]))
        with self.assertRaisesRegex(NotProved, "singular"):
            skin_components(Triangulation(touching, regular_triangulation(touching)))

    def test_enclosures_contain_the_exact_values(self):
        chance = random.Random(1)
        for number in range(160):
            balls, points = nasty_set(chance)
            bounds = Skin(np.array(balls)).enclose(np.array(points))
            for i, x in enumerate(points):
                G, N = exact_values(balls, x)
                error = sum((Fraction(float(n)) - e)**2 for n, e in zip(bounds.n[i], N))
                self.assertLessEqual(abs(G), Fraction(float(bounds.g[i])), (number, balls, x))
                self.assertLessEqual(error, Fraction(float(bounds.r[i]))**2, (number, balls, x))


def nasty_set(chance):
    """At most eight balls, and points near them."""
    kind = chance.choice(["plain", "far", "tiny", "touching", "flat", "line", "mixed", "grid"])
    offset = chance.uniform(-1e6, 1e6) if kind == "far" else 0.0
    scale = 1e-6 if kind == "tiny" else 1.0
    balls = []
    for _ in range(chance.randint(1, 8)):
        z, r = [chance.uniform(-2, 2) for _ in range(3)], chance.uniform(0.5, 2)
        if kind == "flat":
            z[2] = 0.25
        elif kind == "line":
            z[1:] = [0.5, 0.5]
        elif kind == "mixed":
            r = 10**chance.uniform(-6, 3)
        elif kind == "grid":
            z, r = [float(chance.randint(-1, 1)) for _ in range(3)], 1.0
        elif kind == "touching" and balls:
            z = [balls[0][0] + balls[0][3]**0.5 + r * (1 + 1e-12), *balls[0][1:3]]
        balls.append([offset + scale * x for x in z] + [r * r * scale * scale])
    points = []
    for _ in range(4):
        *z, w = chance.choice(balls)
        spread = chance.choice([0, 1e-9, 1e-3, 1, 3]) * w**0.5
        points.append([x + spread * chance.gauss(0, 1) for x in z])
    return balls, points


def solved(rows, right):
    """By Gauss; None for a singular matrix."""
    m, n = [[*row, b] for row, b in zip(rows, right)], len(right)
    for i in range(n):
        pivot = next((k for k in range(i, n) if m[k][i]), None)
        if pivot is None:
            return None
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [v / m[i][i] for v in m[i]]
        m = [row if k == i else [a - row[i] * b for a, b in zip(row, m[i])]
             for k, row in enumerate(m)]
    return [row[n] for row in m]


def exact_values(balls, x):
    """G and N by the definition: the least U over all subsets of up to four balls."""
    u = [[Fraction(a) - Fraction(b) for a, b in zip(ball, x)] for ball in balls]
    powers = [sum(a * a for a in v) - Fraction(ball[3]) for v, ball in zip(u, balls)]

    def dot(a, b):
        return sum(p * q for p, q in zip(a, b))

    best = None
    for k in range(1, 5):
        for first, *others in combinations(range(len(balls)), k):
            d = [[a - b for a, b in zip(u[i], u[first])] for i in others]
            right = [-(dot(e, u[first]) + (powers[i] - powers[first]) / 2)
                     for e, i in zip(d, others)]
            multipliers = solved([[dot(e, f) for f in d] for e in d], right)
            if multipliers is None or min(multipliers, default=0) < 0 or sum(multipliers) > 1:
                continue
            terms = list(zip([1 - sum(multipliers), *multipliers], [first, *others]))
            m = [sum(c * u[i][axis] for c, i in terms) for axis in range(3)]
            U = (dot(m, m) + sum(c * powers[i] for c, i in terms)) / 2
            if best is None or U < best[0]:
                best = U, [-a for a in m]
    return best


if __name__ == "__main__":
    main()
