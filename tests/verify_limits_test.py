#!/usr/bin/env python3
"""Up to where the second checker, certify/verify/, proves (c1), (c2) and (c3), by the bounds of
papers/certificate.md written out here: each mesh is told as much as is known, and is to count all
of it. As tests/tube_bounds_test.cpp and tests/covering_degree_test.cpp try the first checker.
Usage: verify_limits_test.py path/to/morskin (not run)"""

import sys
import unittest
from fractions import Fraction
from itertools import product
from pathlib import Path

import numpy as np

from support.command import main

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
import covering  # noqa: E402
from covering import Covering  # noqa: E402
from enclosure import down, up  # noqa: E402
from manifold import NotProved  # noqa: E402
from support.told_skin import OCTAHEDRON, ToldSkin, sphere, told  # noqa: E402

TOP = 4
# Of a limit. A root of a difference that cancels is known to seven digits.
SHARES = (0.9, 1 - 3e-6, 1 + 3e-6, 1.1)
CUBE = (np.array([*product((-1., 1.), repeat=3)]),
        np.array([[0, 1, 3], [0, 3, 2], [4, 6, 7], [4, 7, 5], [0, 4, 5], [0, 5, 1],
                  [2, 3, 7], [2, 7, 6], [0, 2, 6], [0, 6, 4], [1, 5, 7], [1, 7, 3]]))


def path(n, g):
    """The longest along which G changes by g from where |N| = n."""
    return n - np.sqrt(n * n - g)


def change(n, length):
    return (2 * n - length) * length


def covering_of(p, t, bounds):
    """@param bounds  at p, or a function of points"""
    skin = ToldSkin(bounds if callable(bounds) else lambda x: bounds)
    return Covering(p, np.asarray(t), skin, np.zeros((len(p), 4), dtype=np.int64))


def triangle(R):
    """Equilateral, in the plane z = 0, its coordinates those that are left beside 2^40."""
    turn = 2 * np.pi / 3 * np.arange(3)
    arms = np.column_stack([np.cos(turn), np.sin(turn), np.zeros(3)])
    return np.round(R * arms * 2**12) / 2**12


def square_of_distance(ends, axis):
    """Of a triangle that does not go round it from a line through 0, exactly."""
    rows, x = ([[Fraction(v) for v in row] for row in some] for some in (ends.tolist(), [axis]))
    across = [[v - dot(row, x[0]) / dot(x[0], x[0]) * u for u, v in zip(x[0], row)] for row in rows]
    found = []
    for a, b in zip(across, across[1:] + across[:1]):
        e = [v - u for u, v in zip(a, b)]
        share = min(max(-dot(a, e) / dot(e, e), 0), 1)
        nearest = [u + share * v for u, v in zip(a, e)]
        found.append(dot(nearest, nearest))
    return min(found)


def dot(a, b):
    return sum(u * v for u, v in zip(a, b))


class Piece:
    """A triangle and what is known of N at its corners."""
    def __init__(self, R, middle_n, spread, r, off, corner=0):
        """@param spread  N's differences over the corners': 1 on a sphere, 0 on a cylinder's end
        @param r, off  errors of N at one corner, and of the corners' places
        @param corner  from which that before differs by a hundredth less than told"""
        p, only = triangle(R), np.arange(3) == corner
        n = middle_n + spread * p
        n[corner - 1] += 0.01 * (n[corner] - n[corner - 1])
        self.at, self.off = told(n, r * only), off
        self.of = covering_of(p, [[0, 1, 2]], self.at)
        self.R, self.doubt = self.of.R[0], r + off
        fold = (((p - p[[1, 2, 0]])**2).sum(1) - ((n - n[[1, 2, 0]])**2).sum(1)).max()
        self.bend = min(self.R, np.sqrt((fold + 16 * self.doubt * (self.R + self.doubt)) / 3))
        self.least = np.sqrt((self.at.low.min() - off)**2 - self.R**2) - self.bend

    def holds(self, G=0.0):
        self.at.g = G
        self.of.path = np.zeros(1)
        zero = np.zeros(1, dtype=np.int64)
        return bool(self.of.hold(zero, self.of.corners, self.at[None], self.of.R, self.off)[0])


class Top:
    """A sphere about the origin and perhaps a tetrahedron over its top; (c3) is tried there."""
    def __init__(self, error, at_top, levels=1):
        self.p, self.t = sphere(levels)
        self.bounds = told(self.p)
        self.bounds[TOP] = told(self.p[TOP], error, at_top)
        self.has_tetrahedron = False

    def add_tetrahedron(self, corner, outwards, g, size=1e-6, first=0):
        """Its point nearest to the top, and to the line through it, is a corner.
        @param first  where triangles start"""
        e = np.cross(outwards, [0.6, 0.8, 0] if outwards[2] else [0, 0, 1.])
        f, turn = np.cross(outwards, e), 2 * np.pi / 3 * np.arange(3)[:, None]
        ends = corner + size * (outwards + (np.cos(turn) * e + np.sin(turn) * f) / 2)
        t = np.array([[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3]]) + len(self.p)
        self.p = np.vstack([self.p, corner, ends])
        self.t = np.vstack([self.t, np.roll(t, first, 1)])
        self.bounds = np.concatenate([self.bounds, told(self.p[-4:], 0, g)]).view(np.recarray)
        self.has_tetrahedron = True

    def is_proved(self, its_path=0.0):
        """@param its_path  bound on the paths from the tetrahedron to the skin"""
        of = covering_of(self.p, self.t, self.bounds)
        of.path = np.zeros(len(self.t))
        if self.has_tetrahedron:
            of.path[-4:] = its_path
        return bool(of.is_covered_once(TOP))


class VerifyLimits(unittest.TestCase):
    def test_up_and_down_leave_room_for_two_hundred_roundings_and_what_underflows(self):
        for x in (1.0, -3.0, 2.0**-40, -1e30, 1e-250, 0.0):
            room = 200 * abs(Fraction(x)) / 2**53
            self.assertGreater(Fraction(up(x)) - Fraction(x), room)
            self.assertGreater(Fraction(x) - Fraction(down(x)), room)

    def test_the_tiniest_triangles_are_bounded_as_others_are_or_refused(self):
        (p, t), refused = sphere(1), 0
        right = covering_of(p, t, told(p))
        for power in range(-280, -200):
            try:
                found = covering_of(p * 2.0**power, t, told(p * 2.0**power))
            except NotProved:
                refused += 1
                continue
            self.assertTrue((found.R >= right.R * 2.0**power).all(), power)
            self.assertTrue((np.abs(found.normal - right.normal) <= 1e-15).all(), power)
        self.assertTrue(0 < refused < 60)

    def test_a_path_is_bounded_by_what_g_changes_along_it_in_exact_arithmetic(self):
        chance = np.random.default_rng(4)
        n = chance.uniform(1, 2, 3000) * 2.0**chance.integers(-30, 30, 3000)
        g = n * n * (1 - 10**chance.uniform(-15, 0, 3000))
        for n, g, found in zip(n.tolist(), g.tolist(), covering.longest_path(n, g).tolist()):
            if found < n:
                s = Fraction(found)
                self.assertGreaterEqual((2 * Fraction(n) - s) * s, Fraction(g), (n, g))

    def test_a_piece_is_in_the_tube_up_to_what_its_bend_and_all_doubts_leave(self):
        for r, off, spread, corner in product((0, 0.003, 0.01), (0, 0.001), (1, 0.99), range(3)):
            piece = Piece(0.55, np.array([0, 0, 0.8]), spread, r, off, corner)
            change_on_it = piece.R**2 + (2 * piece.at.high.max() + off) * off
            largest = piece.least**2 - change_on_it
            self.assertGreater(largest, 0.02)
            for share in SHARES:
                with self.subTest(r=r, off=off, spread=spread, corner=corner, share=share):
                    self.assertEqual(piece.holds(share * largest), share < 1)
            self.assertTrue(piece.holds(largest / 2))
            expected = path(piece.least, largest / 2 + change_on_it)
            self.assertAlmostEqual(piece.of.path[0], expected, delta=1e-6)

    def test_a_piece_is_upright_while_n_along_its_normal_is_above_bend_and_all_doubts(self):
        # N is near 2, so that no tube is in question, and leans to one side.
        for r, off, spread in product((0, 0.003), (0, 0.001), (0, 0.9)):
            piece = Piece(0.25, np.array([2, 0, 0.3]), spread, r, off)
            largest = (0.3 - piece.bend - piece.doubt) / piece.at.high.max()
            for share in SHARES:
                with self.subTest(r=r, off=off, spread=spread, share=share):
                    piece.of.normal_error[:] = share * largest
                    self.assertEqual(piece.holds(), share < 1)

    def test_a_corner_that_leans_or_is_out_of_the_tube_is_named_at_once(self):
        for corner in range(3):
            off = Piece(0.01, np.array([0, 0, 1.0]), 0, 0.1, 0, corner)
            off.holds(0.8)
            leaning = Piece(0.01, np.array([2, 0, 0.1]), 0, 0.1, 0, corner)
            for piece, G in ((off, 0.9**2), (leaning, 0)):
                with self.assertRaisesRegex(NotProved, "^upright or tube: triangle 0$"):
                    piece.holds(G * (np.arange(3) == corner))

    def test_a_triangle_is_proved_by_pieces_of_a_thirty_second_their_roundings_counted(self):
        # |G| is large at one corner only, so that the others say nothing of its path.
        R = 0.3
        for x, corner in product((0, 2.0**40), range(3)):
            p = triangle(R) + [x, 0, 0]
            off = 2.0**-49 * np.abs(p).max()
            smallest = covering_of(p, [[0, 1, 2]], told(np.tile([0, 0, 1.], (3, 1)))).R[0] / 32
            least = np.sqrt((1 - off)**2 - smallest**2) - smallest
            largest = least**2 - smallest**2 - (2 + off) * off
            for share in SHARES:
                with self.subTest(x=x, corner=corner, share=share):
                    def bounds(y, g=share * largest):
                        return told(np.broadcast_to([0, 0, 1.], y.shape),
                                    g=np.where((y == p[corner]).all(-1), g, 0))
                    of = covering_of(p, [[0, 1, 2]], bounds)
                    if share < 1:
                        of.prove_tube()
                        self.assertGreater(of.path[0], path(1, share * largest))
                    else:
                        with self.assertRaisesRegex(NotProved, "tube: triangle 0"):
                            of.prove_tube()

    def test_a_triangle_that_leans_too_much_for_its_size_is_not_blamed_on_the_tube_alone(self):
        of = covering_of(triangle(0.1), [[0, 1, 2]],
                         lambda y: told(np.broadcast_to([2, 0, 1e-4], y.shape)))
        with self.assertRaisesRegex(NotProved, "^upright or tube: triangle 0 is too big$"):
            of.prove_tube()

    def test_a_vertex_is_proved_up_to_where_a_path_may_come_back_to_its_triangles_planes(self):
        for error, at_top in product((0, 0.02), (0, 0.03, 0.05)):
            farthest = change(1 - error, 1 / np.sqrt(3) - error) - 2 / 3
            for share in SHARES:
                with self.subTest(error=error, at_top=at_top, share=share):
                    for other, first in product(range(4), range(3)):
                        octahedron = Top(error, at_top, levels=0)
                        octahedron.t = np.roll(octahedron.t, first, 1)
                        octahedron.bounds.g[other] = share * farthest - at_top
                        self.assertEqual(octahedron.is_proved(), share < 1)

    def test_a_triangle_over_or_under_a_vertex_denies_its_proof_as_far_as_a_path_may_lead(self):
        at_top, there = 0.1, 0.4
        for error, its_path, way, share in product((0, 0.02), (np.inf, 0.1), (1, -1), SHARES):
            # Either |G| on both bounds it, or both ways to the skin do.
            height = min(path(1 - error, at_top + there), its_path + path(1 - error, at_top))
            aside = height * (height / 2 + error) / (1 - error)
            places = (((0, 0, 1 + share * way * height), (0, 0, way)),
                      ((share * aside, 0, 1 + way * height / 2), (1, 0, 0)))
            for size, (corner, outwards) in product((1e-6, 0.2), places):
                if size == 0.2 and its_path == np.inf:
                    continue  # for |G| is larger on it
                for first in range(3):
                    with self.subTest(error=error, its_path=its_path, share=share, size=size,
                                      corner=corner, first=first):
                        top = Top(error, at_top)
                        top.add_tetrahedron(np.array(corner), np.array(outwards), there, size,
                                            first)
                        self.assertEqual(top.is_proved(its_path), share > 1)

    def test_needles_along_an_axis_are_no_nearer_to_it_than_their_bound(self):
        # They are much longer than far, and what is rounded is of their length.
        chance, near = np.random.default_rng(5), 0
        for _ in range(800):
            axis, aside = chance.normal(size=(2, 3))
            axis /= np.linalg.norm(axis)
            w = np.cross(axis, aside)
            w *= 10**chance.uniform(-9, -1) / np.linalg.norm(w)
            ends = chance.uniform(-1, 1, (3, 1)) * axis + chance.uniform(1, 1.001, (3, 1)) * w
            ends += 1e-3 * chance.normal(size=(3, 1)) * np.cross(axis, w)
            seen = ends - (ends @ axis)[:, None] * axis
            found = covering.distance_below(seen[None], ends[None], axis)[0]
            near += found > 0.99 * np.linalg.norm(w)
            self.assertLessEqual(max(Fraction(found), 0)**2, square_of_distance(ends, axis))
        self.assertGreater(near, 400)

    def test_a_vertex_whose_triangles_go_round_it_twice_is_not_proved(self):
        for rounds in (1, 2):
            turn = rounds * 2 * np.pi / 7 * np.arange(7)
            ring = np.column_stack([0.2 * np.cos(turn), 0.2 * np.sin(turn), np.full(7, 0.96**0.5)])
            p = np.vstack([[0, 0, 1], ring])
            of = covering_of(p, [[0, 1 + k, 1 + (k + 1) % 7] for k in range(7)], told(p))
            of.path = np.zeros(7)
            self.assertEqual(of.is_covered_once(0), rounds == 1)

    def test_a_mesh_winds_round_a_point_as_often_as_it_does(self):
        for (p, t), turned in product((OCTAHEDRON, CUBE, sphere(1)), (False, True)):
            of = covering_of(p, t[:, ::-1] if turned else t, told(p))
            of.path = np.zeros(len(t))
            # Over corners and sides, too.
            for q in ((0, 0, 0), (0.25, 0.25, 0), (0.25, 0, 0), (0, 0.25, -0.25)):
                self.assertEqual(of.winding_number([*map(Fraction, q)]), -1 if turned else 1, q)
            for q in ((2, 0, 0), (0, 0, 2), (0, 0, -2), (0.25, 0.25, -2), (0.25, 0, -2)):
                self.assertEqual(of.winding_number([*map(Fraction, q)]), 0, q)

    def test_a_mesh_winds_round_no_point_that_a_path_from_it_may_meet(self):
        # Far from 0 the point's place is rounded.
        for centre, height in product((0, 2**40), (Fraction(1, 8), Fraction(-1, 8))):
            at = [Fraction(centre)] * 2 + [centre + height + Fraction(bool(centre), 2**20)]
            largest = 7 / 8 - 2.0**-50 * centre
            for share, first in product(SHARES, range(3)):
                p, t = CUBE
                of = covering_of(p + centre, np.roll(t, first, 1), told(p))
                of.path = np.full(len(t), share * largest)
                with self.subTest(centre=centre, height=height, share=share):
                    if share < 1:
                        self.assertEqual(of.winding_number(at), 1)
                    else:
                        with self.assertRaisesRegex(NotProved, "^degree: a triangle is too near"):
                            of.winding_number(at)
        # Near a corner, far from where the triangles start.
        of = covering_of(CUBE[0], CUBE[1], told(CUBE[0]))
        of.path = np.full(12, 0.3)
        with self.assertRaisesRegex(NotProved, "^degree: a triangle is too near"):
            of.winding_number([Fraction(3, 4)] * 3)


if __name__ == "__main__":
    main()
