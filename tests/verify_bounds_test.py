#!/usr/bin/env python3
"""The bounds of the second checker, certify/verify/, each against exact or sampled values, and
meshes that break one condition only. Usage: verify_bounds_test.py path/to/morskin (not run)"""

import random
import sys
import unittest
from fractions import Fraction
from math import isqrt
from pathlib import Path

import numpy as np

from support.command import main

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
import covering  # noqa: E402
import verify  # noqa: E402
from covering import Covering  # noqa: E402
from enclosure import Skin  # noqa: E402
from manifold import NotProved, check_manifold  # noqa: E402
from skin_components import Balls, skin_components  # noqa: E402
from support.exact_skin import exact_values, nasty_set  # noqa: E402
from support.told_skin import sphere, told  # noqa: E402

ONE, TWO = np.array([[0., 0, 0, 2]]), np.array([[0., 0, 0, 2], [9, 0, 0, 2]])


def reason(balls, p, t):
    witness = {"simplices": (), "vertex_atoms": np.zeros((len(p), 4), dtype=np.int64),
               "component_vertices": [], "dropped_voids": 0}
    try:
        verify.prove(balls, p, t, witness, {})
    except NotProved as error:
        return str(error)
    return None


class VerifyBounds(unittest.TestCase):
    def test_a_path_is_no_shorter_than_a_straight_one_and_unbounded_beyond(self):
        n = np.array([1.0, 1e-3, 1e3, 1.0])
        for share in (1e-12, 0.1, 0.5, 0.99, 1 - 1e-12):
            found, g = covering.longest_path(n, share * n * n), share * n * n
            self.assertTrue((found >= (1 - 2e-16) * g / (n + np.sqrt(n * n - g))).all())
            self.assertTrue(np.isfinite(found).all())
        self.assertTrue((covering.longest_path(n, n * n) == np.inf).all())
        self.assertEqual(covering.longest_path(np.float64(-1.0), np.float64(0.1)), np.inf)

    def test_circumradii_and_normals_of_needles_are_bounded(self):
        chance = np.random.default_rng(1)
        p, bounded = [], 0
        for _ in range(400):
            a, e, f = chance.normal(size=(3, 3))
            thin = 10.0**chance.uniform(-13, 0)
            p += [1e3 * a, 1e3 * a + e, 1e3 * a + 0.4 * e + thin * f]
        for i in range(0, len(p), 3):
            corners = np.array(p[i:i + 3])
            try:
                found = Covering(corners, np.array([[0, 1, 2]]), Skin(ONE),
                                 np.zeros((3, 4), dtype=np.int64))
            except NotProved:
                continue
            bounded += 1
            x, y, z = ([Fraction(v) for v in row] for row in corners.tolist())
            e, f = ([v - u for u, v in zip(x, other)] for other in (y, z))
            n = [e[k - 2] * f[k - 1] - e[k - 1] * f[k - 2] for k in range(3)]
            self.assertGreaterEqual(Fraction(float(found.R[0]))**2, self.square_of_radius(corners))
            root = self.root(sum(u * u for u in n))
            m = [Fraction(v) for v in found.normal[0].tolist()]
            off = sum((u / root - v)**2 for u, v in zip(n, m))
            self.assertGreaterEqual(Fraction(float(found.normal_error[0]))**2, off)
        self.assertGreater(bounded, 300)

    def test_circumradii_are_bounded_where_edges_are_rounded_and_hardly_an_area_is_left(self):
        chance = np.random.default_rng(0)
        p, exact = [], []
        for _ in range(4000):
            x, y = chance.normal(size=3) * 10.0**chance.uniform(-4, -1), chance.uniform(0.5, 1, 3)
            z = x + chance.uniform(0.3, 0.9) * (y - x) + chance.normal(size=3) * 1e-13
            corners = chance.permutation([x, y, z])
            square = self.square_of_radius(corners)
            if square < 1e26:
                p.append(corners)
                exact.append(square)
        every = np.arange(3 * len(p)).reshape(-1, 3)
        found = Covering(np.concatenate(p), every, Skin(ONE), np.zeros((every.size, 4), int))
        self.assertTrue(all(Fraction(R)**2 >= square for R, square in zip(found.R.tolist(), exact)))
        self.assertGreater(len(p), 3000)

    def square_of_radius(self, corners):
        x, y, z = ([Fraction(v) for v in row] for row in corners.tolist())
        e, f, g = ([v - u for u, v in zip(*ends)] for ends in ((x, y), (x, z), (y, z)))
        n = [e[k - 2] * f[k - 1] - e[k - 1] * f[k - 2] for k in range(3)]
        nn, ee, ff, gg = (sum(u * u for u in v) for v in (n, e, f, g))
        return ee * ff * gg / (4 * nn)

    def test_no_rounding_makes_upright_what_is_not(self):
        chance = np.random.default_rng(7)
        p, t = sphere(2)
        found = Covering(p, t, Skin(ONE), np.zeros((len(p), 4), dtype=np.int64))
        found.normal_error[:] = 0
        for k, normal in enumerate(found.normal):
            aside = np.cross(normal, chance.normal(size=3))
            n = aside + normal * chance.normal() * 1e-16
            exact = sum(Fraction(a) * Fraction(b) for a, b in zip(n.tolist(), normal.tolist()))
            self.assertLessEqual(found.upright(told(n[None]), [k])[0], exact)

    def test_a_triangle_whose_area_rounding_hides_is_refused(self):
        needle = np.array([[1e3, 0, 0], [1e3, 1, 2], [1e3, 2, 4 + 1e-15], [1e3, 2, 5]])
        with self.assertRaisesRegex(NotProved, "^upright: triangle 1 has no area$"):
            Covering(needle, np.array([[0, 1, 3], [0, 1, 2]]), Skin(ONE),
                     np.zeros((4, 4), dtype=np.int64))

    def root(self, x):
        """Of a Fraction, to some 50 digits."""
        scale = 10**60
        while x * scale < 10**100:
            scale *= 10**20
        return Fraction(isqrt(int(x * scale * scale)), scale)

    def test_only_triangles_in_the_tube_of_a_ball_are_proved(self):
        # |G| = R^2 and |N|^2 = 1 - R^2 at the circumcentre.
        for R in (0.3, 0.6, 0.7, 0.7065):
            self.assertTrue(self.is_proved(R), R)
        for R in (0.7072, 0.72, 0.8, 0.95):
            self.assertFalse(self.is_proved(R), R)

    def is_proved(self, R):
        turn = 2 * np.pi / 3 * np.arange(3)
        p = np.column_stack([R * np.cos(turn), R * np.sin(turn), np.full(3, np.sqrt(1 - R * R))])
        found = Covering(p, np.array([[0, 1, 2]]), Skin(ONE), np.zeros((3, 4), dtype=np.int64))
        try:
            found.prove_tube()
        except NotProved:
            return False
        self.assertGreaterEqual(found.path[0], 1 - np.sqrt(1 - R * R))
        return True

    def test_what_is_proved_of_a_triangle_holds_at_each_of_its_points(self):
        chance = np.random.default_rng(2)
        skin = Skin(np.array([[0., 0, 0, 2], [1.1, 0, 0, 1.5], [0, 1.2, 0.3, 2.2]]))
        count, points = 3000, 12
        p = chance.normal(size=(count, 1, 3)) + np.array([0.4, 0.4, 0.1])
        p = p + chance.uniform(0.05, 0.6, (count, 1, 1)) * chance.normal(size=(count, 3, 3))
        every = np.arange(3 * count).reshape(-1, 3)
        found = Covering(p.reshape(-1, 3), every, skin, np.zeros((3 * count, 4), dtype=np.int64))
        at, found.path = found.bounds[every], np.zeros(count)
        t = np.flatnonzero(((found.upright(at, np.arange(count)[:, None]) > 0) &
                            (at.g < at.low**2)).all(1))
        t = t[found.hold(t, p[t], at[t], found.R[t], 0)]
        self.assertGreater(len(t), 100)
        inside = np.einsum("tij,tjk->tik", chance.dirichlet([0.3] * 3, (len(t), points)), p[t])
        seen = skin.enclose(inside.reshape(-1, 3), np.zeros((len(t) * points, 4), dtype=np.int64))
        normal = found.normal[t].repeat(points, 0)
        self.assertTrue(((seen.n * normal).sum(1) > -seen.r).all())
        self.assertTrue((seen.least < seen.high**2).all())

    def test_sheets_one_over_the_other_are_no_proof_of_two_components(self):
        for levels in (2, 3):
            p, t = sphere(levels)
            self.assertRegex(reason(TWO, p, t) or "", "^degree")
            for off, turn in ((0, 0.3), (1e-4, 0.1), (0.03, 0), (0.03, 0.3)):
                c, s = np.cos(turn), np.sin(turn)
                q = p @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]]) * (1 + off)
                both = np.vstack([p * (1 - off), q]), np.vstack([t, t + len(p)])
                with self.subTest(levels=levels, off=off, turn=turn):
                    self.assertRegex(reason(TWO, *both) or "", "^degree: .* more than once")

    def test_a_component_covered_once_does_not_answer_for_another(self):
        p, t = sphere(2)
        q = np.vstack([p, p + [9, 0, 0], p + [9, 0, 0]])
        three = np.vstack([t, t + len(p), t + 2 * len(p)])
        found = Covering(q, three, Skin(TWO), np.repeat([[0], [1], [1]], len(p), 0).repeat(4, 1))
        found.prove_tube()
        label = np.repeat([0, len(p), 2 * len(p)], len(p))
        found.prove_degree(label[:len(p)], [])
        with self.assertRaisesRegex(NotProved, f"component of vertex {len(p)} "):
            found.prove_degree(label, [])
        with self.assertRaisesRegex(NotProved, f"component of vertex {len(p)} "):
            found.prove_degree(label, [0, 1, 2])  # what proves one is no witness of another

    def test_triangles_turn_once_round_a_corner_or_not(self):
        axis = np.array([0., 0, 1])

        def once(angles, height=0.1):
            ring = np.column_stack([np.cos(angles), np.sin(angles), np.full(len(angles), height)])
            arms = np.array([[[0, 0, 0], a, b] for a, b in zip(ring, np.roll(ring, -1, 0))])
            return covering.turn_once(arms, arms * [1, 1, 0], axis)
        circle = np.arange(7) * 2 * np.pi / 7
        self.assertTrue(once(circle))
        self.assertFalse(once(2 * circle))
        self.assertFalse(once(-circle))
        self.assertFalse(once(circle, 1e7))  # too steep to tell
        back = circle.copy()
        back[3] = circle[1] - 0.1
        self.assertFalse(once(back))

    def test_no_point_of_a_triangle_is_nearer_than_its_bound_nor_to_an_axis(self):
        chance = np.random.default_rng(3)
        arms = chance.normal(size=(300, 3, 3)) * 0.7 + chance.normal(size=(300, 1, 3))
        shares = chance.dirichlet([0.4] * 3, 300)
        points = np.einsum("ij,njk->nik", shares, arms)
        near = np.linalg.norm(points, axis=2).min(1)
        self.assertTrue((covering.distance_below(arms, arms) <= near).all())
        axis = np.array([1., 2, 2]) / 3
        seen = arms - (arms @ axis)[:, :, None] * axis
        across = points - (points @ axis)[:, :, None] * axis
        near = np.linalg.norm(across, axis=2).min(1)
        found = covering.distance_below(seen, arms, axis)
        self.assertTrue((found <= near).all())
        self.assertTrue((found[near > 0.5] > 0).any())

    def test_wrong_gluings_are_named(self):
        def refused(why, vertices, triangles):
            with self.assertRaisesRegex(NotProved, why):
                check_manifold(vertices, np.array(triangles))
        four = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
        check_manifold(4, np.array(four))
        refused("a vertex is unused", 0, np.zeros((0, 3), dtype=int))
        refused("a vertex is unused", 5, four)
        refused("twice in a triangle", 4, four + [[0, 0, 1], [0, 1, 0]])
        refused("not there once", 4, four + four)
        other = [[{0: 0}.get(v, v + 3) for v in row] for row in four]
        refused("several fans", 7, four + other)

    def test_an_angle_is_no_larger_than_it_is(self):
        p, t = sphere(2)
        report = {}
        verify.prove(ONE, p, t, {"simplices": (), "vertex_atoms": np.zeros((len(p), 4), int),
                                 "component_vertices": [], "dropped_voids": 0}, report)
        arms = p[t][:, [1, 2, 0]] - p[t]
        cosine = -(arms * arms[:, [2, 0, 1]]).sum(2) / (
            np.linalg.norm(arms, axis=2) * np.linalg.norm(arms[:, [2, 0, 1]], axis=2))
        smallest = np.degrees(np.arccos(cosine)).min()
        self.assertLess(report["angle"], smallest + 1e-9)
        self.assertGreater(report["angle"], smallest - 1e-6)

    def test_a_vertex_off_the_skin_by_a_little_is_named(self):
        # |G| is twice that. 2e-9 are allowed, and of floats what their rounding moves.
        for real, right, wrong in ((float, (9e-10, -9e-10), (1.1e-9, -1.1e-9, 4e-9, -4e-9, 1e-8)),
                                   (np.float32, (0,), (2.5e-7, -2.5e-7))):
            for off in right + wrong:
                p, t = sphere(3)
                p[9] *= 1 + off
                found = reason(ONE, p.astype(real).astype(float), t) or "proved"
                self.assertRegex(found, "^on skin: vertex 9 " if off in wrong else "^proved$")

    def test_enclosures_contain_the_exact_values_however_few_balls_are_tried(self):
        chance = random.Random(1)
        for number in range(160):
            balls, points = nasty_set(chance)
            skin, x = Skin(np.array(balls)), np.array(points)
            nobody = np.zeros((len(points), 4), dtype=np.int64)
            some = np.array([[chance.randrange(len(balls)) for _ in range(4)] for _ in points])
            values = [exact_values(balls, point) for point in points]
            for bounds in (skin.enclose(x, nobody), skin.bounds(x, some)):
                for (G, N), at in zip(values, bounds):
                    n, r, least, g, low, high = (
                        np.vectorize(Fraction, otypes=[object])(at[name].tolist())
                        for name in ("n", "r", "least", "g", "low", "high"))
                    with self.subTest(number=number):
                        self.assertLessEqual(least, abs(G))
                        self.assertLessEqual(abs(G), g)
                        self.assertLessEqual(sum((n - N)**2), r**2)
                        self.assertLessEqual(max(low, 0)**2, min(sum(n**2), sum(v * v for v in N)))
                        self.assertLessEqual(max(sum(n**2), sum(v * v for v in N)), high**2)

    def test_no_ball_has_less_power_than_the_least(self):
        chance, sharp = random.Random(2), 0
        for _ in range(300):
            balls, _ = nasty_set(chance)
            *z, w = balls[0]
            q = [v + chance.choice([1e-3, 0.05, 1, 1e3]) * chance.gauss(0, 1) * w**0.5 for v in z]
            least = min(sum((Fraction(a) - Fraction(b))**2 for a, b in zip(q, ball)) -
                        Fraction(ball[3]) for ball in balls)
            found = Fraction(float(Skin(np.array(balls)).least_power(np.array([q]))[0][0]))
            self.assertLessEqual(found, least)
            sharp += least - found < 2**-45 * (abs(least) + sum(Fraction(v)**2 for v in q))
        self.assertGreater(sharp, 200)

    def test_a_triangulation_covers_space_once_with_tetrahedra_that_are_not_flat(self):
        def refused(why, balls, simplices):
            with self.assertRaisesRegex(NotProved, f"^triangulation: {why}"):
                skin_components(tuple(map(tuple, balls)), simplices, ())
        corners = [(x, y, z, 0.5) for x in (0, 1) for y in (0, 1) for z in (0, 1)]
        inner, *outer = (0, 3, 5, 6), (0, 1, 3, 5), (0, 2, 3, 6), (0, 4, 5, 6), (3, 5, 6, 7)
        skin_components(tuple(corners), (inner, *outer), ())
        refused("ends or overlaps", corners, (inner, *outer, inner))
        refused("ends or overlaps", [corners[k] for k in inner], ((0, 1, 2, 3), (0, 1, 2, 3)))
        refused("tetrahedron 0 is flat", corners, ((0, 1, 2, 3),))

    def test_balls_without_a_body_overlap_nothing(self):
        balls = Balls([[0, 0, 0, -1], [0.5, 0, 0, -0.1], [0.2, 0, 0, 1], [0.4, 0, 0, 0]])
        every = np.array([(i, j) for i in range(4) for j in range(4) if i != j]).T
        self.assertFalse(balls.overlap(*every).any())


if __name__ == "__main__":
    main()
