#!/usr/bin/env python3
"""The boundary element solver of bench/solvers: its integrals against brute force, its energies
against the closed forms of Born and Kirkwood, its condition numbers against NumPy's, and the
angles of tetrahedra. Needs NumPy and SciPy. Usage: solvers_test.py path/to/morskin"""

import math
import subprocess
import sys
import unittest

import numpy as np

from support.command import MOLECULES, CommandTest, main

SOLVERS = MOLECULES.parent / "solvers"
sys.path.insert(0, str(SOLVERS))
import conditioning  # noqa: E402
import molecule  # noqa: E402
import spheres  # noqa: E402
from panel_integrals import panel_integrals  # noqa: E402
from poisson_boltzmann import INNER, PoissonBoltzmann  # noqa: E402
from tetrahedra import dihedral_angles  # noqa: E402

CENTRE = np.zeros((1, 3)), np.ones(1)
ASIDE = np.array([[0.8, 0, 0], [-0.3, 0.7, 0.2]]), np.array([1, -0.5])
RADIUS = 2.0


def random_panels(count):
    """Points, corners, normals and gradients of the hat functions."""
    random = np.random.default_rng(1)
    corners = random.normal(size=(count, 3, 3))
    cross = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    doubled = np.linalg.norm(cross, axis=1)
    normals = cross / doubled[:, None]
    edges = np.roll(corners, 1, axis=1) - np.roll(corners, -1, axis=1)
    gradients = np.cross(normals[:, None], edges) / doubled[:, None, None]
    return random.normal(size=(count, 3)), corners, normals, gradients


def by_brute_force(point, corners, normal, pieces=300):
    """The middles of pieces^2 small triangles."""
    i, j = np.indices((pieces, pieces)).reshape(2, -1)
    middles = np.concatenate([np.stack([i, j])[:, i + j < pieces] + 1 / 3,
                              np.stack([i, j])[:, i + j < pieces - 1] + 2 / 3], axis=1) / pieces
    u, v = middles
    hats = np.stack([1 - u - v, u, v], axis=1)
    arms = hats @ corners - point
    r = np.linalg.norm(arms, axis=1)
    a, b, c = corners
    weight = np.linalg.norm(np.cross(b - a, c - a)) / 2 / len(u)
    return weight * hats.T @ (1 / r), -weight * hats.T @ (arms @ normal / r**3)


class Makefile(unittest.TestCase):
    def test_tables_in_another_folder_leave_the_picture_of_the_pages_as_it_is(self):
        for words, draws in (("", True), ("balls", True), ("balls --results x", False)):
            done = subprocess.run(["make", "-n", "solvers", f"SOLVERS={words}"], check=True,
                                  cwd=MOLECULES.parent.parent, capture_output=True, text=True)
            self.assertIn(f"run.py {words}".strip(), done.stdout)
            self.assertEqual("plot.py" in done.stdout, draws, words)


class Solvers(CommandTest):
    def ball(self, density, **water):
        """The equations on a mesh of a ball."""
        self.input("ball.xyzr", f"0 0 0 {RADIUS}\n")
        self.run_morskin("mesh", "ball.xyzr", "-q", "--density", density, "-o", "ball.off")
        places, triangles = map(np.array, self.read_off("ball.off"))
        return PoissonBoltzmann(places, triangles, **water)

    def energy(self, equations, charges, matrix=None):
        matrix = equations.matrix() if matrix is None else matrix
        solution = np.linalg.solve(matrix, equations.right_side(*charges))
        return equations.energy(*charges, solution)

    def test_the_closed_forms_are_the_integrals(self):
        panels = random_panels(12)
        for one, single, double in zip(zip(*panels), *panel_integrals(*panels)):
            expected = by_brute_force(*one[:3])
            np.testing.assert_allclose(single, expected[0], rtol=1e-3, atol=1e-4)
            np.testing.assert_allclose(double, expected[1], rtol=1e-3, atol=1e-4)

    def test_of_a_point_in_the_plane_only_1_over_r_is_left(self):
        points, corners, normals, gradients = random_panels(50)
        inside = corners.mean(axis=1)
        single, double = panel_integrals(inside, corners, normals, gradients)
        self.assertLess(np.abs(double).max(), 1e-12)
        self.assertTrue((single > 0).all())
        on_an_edge = corners[:, :2].mean(axis=1)
        self.assertTrue(np.isfinite(panel_integrals(on_an_edge, corners, normals,
                                                    gradients)).all())

    def test_of_a_constant_potential_a_closed_surface_has_a_charge_of_dipoles_inside_alone(self):
        equations = self.ball(2.5)
        points = np.array([[0, 0, 0], [1.2, -1, 0.5], [0, 9, 0]])
        _, double, _, _ = equations.layers(points)
        np.testing.assert_allclose(double.sum(axis=0), [-1, -1, 0], atol=1e-3)

    def test_on_the_surface_itself_it_has_half_of_that(self):
        """The double layer's principal value: rounding puts points above their own triangle's plane
        or below it, where the solid angle jumps by all of a sphere."""
        equations = self.ball(2.5)
        _, double, _, _ = equations.layers(equations.tests.positions)
        np.testing.assert_allclose(double.sum(axis=0), -0.5, atol=1e-3)

    def test_energies_are_born_s_and_kirkwood_s_and_come_nearer_with_the_square_of_the_size(self):
        errors = []
        for density in (2.5, 10):
            equations = self.ball(density)
            matrix = equations.matrix()
            found = [self.energy(equations, charges, matrix) for charges in (CENTRE, ASIDE)]
            exact = spheres.born(RADIUS), spheres.kirkwood(RADIUS, *ASIDE)
            errors.append([f / e - 1 for f, e in zip(found, exact)] + [equations.count])
            self.assertLess(max(np.abs(errors[-1][:2])), 8.5 / equations.count)
        (born, kirkwood, few), (finer_born, finer_kirkwood, many) = errors
        for coarse, fine in ((born, finer_born), (kirkwood, finer_kirkwood)):
            order = 2 * math.log(coarse / fine) / math.log(many / few)
            self.assertTrue(1.6 < order < 2.4, order)

    def test_a_ball_of_flat_triangles_errs_by_its_volume(self):
        equations = self.ball(5)
        volume = np.linalg.det(equations.corners).sum() / 6
        radius = (volume / (4 / 3 * math.pi)) ** (1 / 3)
        self.assertLess(radius, RADIUS)
        found = self.energy(equations, CENTRE)
        self.assertLess(abs(found / spheres.born(radius) - 1), 0.002)

    def test_without_a_difference_between_inside_and_outside_hardly_any_energy_is_found(self):
        equations = self.ball(2.5, outer=INNER, kappa=0)
        water = self.energy(self.ball(2.5), ASIDE)
        self.assertLess(abs(self.energy(equations, ASIDE)), 0.002 * abs(water))

    def test_the_energy_grows_with_the_square_of_the_charges(self):
        equations = self.ball(2.5)
        matrix = equations.matrix()
        places, charges = ASIDE
        self.assertAlmostEqual(self.energy(equations, (places, -2 * charges), matrix) /
                               self.energy(equations, ASIDE, matrix), 4, places=8)

    def test_kirkwood_s_series_is_born_s_formula_for_a_charge_in_the_centre(self):
        for kappa in (0, 0.125, 2):
            self.assertAlmostEqual(spheres.kirkwood(RADIUS, *CENTRE, kappa=kappa),
                                   spheres.born(RADIUS, kappa=kappa), places=8)
        turned = ASIDE[0] @ np.linalg.qr(np.arange(9).reshape(3, 3) ** 2 + np.eye(3))[0]
        self.assertAlmostEqual(spheres.kirkwood(RADIUS, turned, ASIDE[1]),
                               spheres.kirkwood(RADIUS, *ASIDE), places=8)

    def test_condition_numbers_are_numpy_s(self):
        from scipy.linalg import lu_factor
        matrix = self.ball(2.5).matrix()
        blocks = conditioning.VertexBlocks(matrix)
        plain, scaled = conditioning.condition_numbers(matrix, lu_factor(matrix), blocks)
        self.assertAlmostEqual(plain / np.linalg.cond(matrix), 1, places=2)
        solved = np.array([blocks.solve(column) for column in matrix.T]).T
        self.assertAlmostEqual(scaled / np.linalg.cond(solved), 1, places=2)

    def test_gmres_ends_in_fewer_steps_than_there_are_unknowns_and_says_when_it_does_not(self):
        equations = self.ball(2.5)
        matrix, right = equations.matrix(), equations.right_side(*ASIDE)
        blocks = conditioning.VertexBlocks(matrix)
        self.assertLess(conditioning.gmres_steps(matrix, right, blocks), 40)
        self.assertEqual(conditioning.gmres_steps(matrix, right, blocks, tolerance=0), math.inf)

    def test_dihedral_angles_of_known_tetrahedra(self):
        regular = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]])
        corner = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]])
        angles = dihedral_angles(np.array([regular, corner, corner[[0, 2, 1, 3]]]))
        np.testing.assert_allclose(angles[0], math.degrees(math.acos(1 / 3)))
        for of_corner in angles[1:]:
            np.testing.assert_allclose(sorted(of_corner), [math.degrees(math.acos(3**-0.5))] * 3
                                       + [90] * 3)

    def test_the_bundled_protein_has_a_charge_of_1(self):
        places, charges = molecule.atoms()
        self.assertEqual(places.shape, (304, 3))
        self.assertAlmostEqual(charges.sum(), 1)


if __name__ == "__main__":
    main()
