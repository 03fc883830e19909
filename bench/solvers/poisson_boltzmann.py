"""The linear Poisson-Boltzmann equation of a molecule in salt water, by Galerkin boundary elements.

Unknown on the mesh are the potential phi and its derivative psi along the outer normal, inside;
both are linear on each triangle and continuous: two unknowns for each vertex. With G = 1 / (4 pi r)
inside, Y = exp(-kappa r) / (4 pi r) outside, V the integral of either times a density and K that of
its derivative along the normal at the source times a density (Yoon and Lenhoff 1990),

    phi / 2 + K_G phi -                 V_G psi = sum of q G / inner
    phi / 2 - K_Y phi + (inner / outer) V_Y psi = 0

Both are multiplied by each vertex's hat function and integrated over the mesh. The outer integral
is a sum over TEST_RULE's points on each triangle. The inner one of G over a triangle near such a
point has a closed form (panel_integrals.py), so that nothing singular is left to a rule; over one
far away, and of Y - G, which is bounded, it is a sum over SOURCE_RULE's.
"""

import numpy as np
from scipy.sparse import csr_matrix
from scipy.spatial import cKDTree
from scipy.spatial.distance import cdist

from panel_integrals import dot, panel_integrals

INNER, OUTER = 1.0, 80.0  # relative dielectric constants
KAPPA = 0.125  # 1 / Angstrom: 0.145 mol/l of salt
COULOMB = 1389.355  # kJ/mol Angstrom, of two elementary charges
# Points on a triangle, barycentric, and their weights (Strang and Fix 1973; Dunavant 1985).
SOURCE_RULE = np.array([[4, 1, 1], [1, 4, 1], [1, 1, 4]]) / 6, np.full(3, 1 / 3)  # of degree 2
P, Q = 0.445948490915965, 0.091576213509771
TEST_RULE = (np.concatenate([np.full((3, 3), x) + (1 - 3 * x) * np.eye(3) for x in (P, Q)]),
             np.repeat([0.223381589678011, 0.109951743655322], 3))  # of degree 4
NEAR = 3  # closed forms up to so many times a triangle's radius from its centroid
ROWS = 128  # points at a time


class Points:
    """The points of a rule on all triangles, and by point and vertex the hat functions there, alone
    and times the point's weight."""

    def __init__(self, rule, corners, triangles, areas, count):
        barycentric, weights = rule
        self.positions = np.einsum("qk,tki->tqi", barycentric, corners).reshape(-1, 3)
        self.owners = np.repeat(np.arange(len(triangles)), len(weights))
        self.hats = by_vertex(np.tile(barycentric, (len(triangles), 1)), triangles[self.owners],
                              np.arange(len(self.owners)), (len(self.owners), count))
        self.weighted = self.hats.multiply(np.outer(areas, weights).reshape(-1, 1)).tocsr()


def by_vertex(values, vertices, rows, shape):
    """A sparse matrix: each row of values, (k, 3), added at these vertices, (k, 3), of a row."""
    return csr_matrix((values.ravel(), (np.repeat(rows, 3), vertices.ravel())), shape)


class PoissonBoltzmann:
    """The equations on one mesh.

    @param vertices      (n, 3), Angstrom
    @param triangles     (m, 3), a closed mesh, corners counter-clockwise seen from outside
    @param outer, kappa  of the water; kappa in 1 / Angstrom
    """

    def __init__(self, vertices, triangles, outer=OUTER, kappa=KAPPA):
        self.triangles, self.count = triangles, len(vertices)
        self.ratio, self.kappa = INNER / outer, kappa
        self.corners = vertices[triangles]
        a, b, c = np.moveaxis(self.corners, 1, 0)
        cross = np.cross(b - a, c - a)
        doubled = np.linalg.norm(cross, axis=1)
        self.normals = cross / doubled[:, None]
        opposite = np.stack([c - b, a - c, b - a], axis=1)
        self.gradients = np.cross(self.normals[:, None], opposite) / doubled[:, None, None]
        self.tests, self.sources = (Points(rule, self.corners, triangles, doubled / 2, self.count)
                                    for rule in (TEST_RULE, SOURCE_RULE))

    def layers(self, points):
        """By vertex and point: V_G, K_G, V_Y, K_Y of the vertex's hat function.

        @pre  no point is one of the sources'"""
        normals = self.normals[self.sources.owners]
        r = cdist(self.sources.positions, points)
        away = dot(self.sources.positions, normals)[:, None] - normals @ points.T
        inverse, decay = 1 / r, np.exp(-self.kappa * r)
        slope = -away * inverse * inverse * inverse
        more = (decay - 1) * inverse  # what Y has more than G
        more_slope = slope * ((1 + self.kappa * r) * decay - 1)
        near, at = self.near_pairs(points)
        per_triangle = len(SOURCE_RULE[1])
        rows = near[:, None] * per_triangle + np.arange(per_triangle)
        inverse[rows, at[:, None]] = slope[rows, at[:, None]] = 0
        closed = panel_integrals(points[at], self.corners[near], self.normals[near],
                                 self.gradients[near])
        v, k, more, more_slope = (self.sources.weighted.T @ x / (4 * np.pi)
                                  for x in (inverse, slope, more, more_slope))
        shape = (len(points), self.count)
        v, k = (np.asarray(far + by_vertex(exact / (4 * np.pi), self.triangles[near], at, shape).T)
                for far, exact in zip((v, k), closed))
        return v, k, v + more, k + more_slope

    def near_pairs(self, points):
        """Indices of triangles, and of points near them."""
        centres = self.corners.mean(axis=1)
        radii = np.linalg.norm(self.corners - centres[:, None], axis=2).max(axis=1)
        found = cKDTree(points).query_ball_point(centres, NEAR * radii)
        near = np.repeat(np.arange(len(found)), [len(f) for f in found])
        return near, np.array([i for f in found for i in f], dtype=int)

    def matrix(self):
        """(2 n, 2 n), first the equations of all vertices inside, then outside."""
        n = self.count
        matrix = np.zeros((2 * n, 2 * n))
        half = (self.tests.weighted.T @ self.tests.hats).toarray() / 2
        matrix[:n, :n] = matrix[n:, :n] = half
        for begin in range(0, len(self.tests.positions), ROWS):
            rows = slice(begin, begin + ROWS)
            test = self.tests.weighted[rows]
            used = np.unique(test.indices)
            v, k, vy, ky = (test[:, used].T @ x.T for x in self.layers(self.tests.positions[rows]))
            matrix[used, :n] += k
            matrix[used, n:] -= v
            matrix[n + used, :n] -= ky
            matrix[n + used, n:] += self.ratio * vy
        return matrix

    def right_side(self, places, charges):
        """@param places  (k, 3), of the charges, inside  @param charges  (k,), elementary"""
        potential = (charges / cdist(self.tests.positions, places)).sum(axis=1)
        potential /= 4 * np.pi * INNER
        return np.concatenate([self.tests.weighted.T @ potential, np.zeros(self.count)])

    def energy(self, places, charges, solution):
        """kJ/mol, of the charges in the field that the water answers with."""
        v, k, _, _ = self.layers(places)
        reaction = solution[self.count:] @ v - solution[:self.count] @ k
        return COULOMB * 4 * np.pi * (charges @ reaction) / 2
