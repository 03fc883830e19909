"""The linear Poisson-Boltzmann equation of a molecule in water, by boundary elements: the potential
and its normal derivative are constant on each triangle and the equations hold at the centroids.

With G = 1 / (4 pi r) inside, Y = exp(-kappa r) / (4 pi r) outside, V the integral of either times a
density and K that of its derivative along the outer normal at the source times a density,

    phi / 2 + K_G phi -             V_G psi = sum of q G / inner constant
    phi / 2 - K_Y phi + (in / out)  V_Y psi = 0

(Yoon & Lenhoff 1990). The integrals of 1 / r over a flat triangle have closed forms for any point,
and are taken so from near; from afar, and for what Y adds, which is smooth, one point is enough.
Needs python3-numpy and python3-scipy.
"""

import numpy as np
from scipy.linalg import get_lapack_funcs, lu_factor, lu_solve
from scipy.sparse.linalg import LinearOperator, gmres

INNER, OUTER = 4.0, 78.5  # relative dielectric constants
KAPPA = 0.125  # 1 / Angstrom: 0.145 mol/l of salt
COULOMB = 332.06  # kcal/mol Angstrom
FAR = 8  # by how many of its sizes one point of a triangle is enough: some 1e-3 off
ROWS = 256  # at a time


def single_and_double(points, corners, normals):
    """By pair of a point and a triangle the integral of 1 / r over it, and its solid angle from the
    point, positive from the side that the normal points to. Wilton and others 1984; van Oosterom
    and Strackee 1983."""
    arms = corners - points[:, None]  # pair, corner, xyz
    far = np.linalg.norm(arms, axis=2)
    height = -(arms[:, 0] * normals).sum(1)
    a, b, c = arms.transpose(1, 0, 2)
    la, lb, lc = far.T
    above = (a * np.cross(b, c)).sum(1)
    beside = la * lb * lc + (a * b).sum(1) * lc + (b * c).sum(1) * la + (c * a).sum(1) * lb
    angle = -2 * np.arctan2(above, beside)
    total = -height * angle
    for k in range(3):
        m = (k + 1) % 3
        edge = corners[:, m] - corners[:, k]
        along = edge / np.linalg.norm(edge, axis=1)[:, None]
        outward = np.cross(along, normals)
        start, stop = (arms[:, k] * along).sum(1), (arms[:, m] * along).sum(1)
        # Both forms are equal; one of them does not lose digits.
        forward = (far[:, m] + stop) / np.maximum(far[:, k] + start, 1e-300)
        backward = (far[:, k] - start) / np.maximum(far[:, m] - stop, 1e-300)
        ratio = np.where(start + stop > 0, forward, backward)
        total += (arms[:, k] * outward).sum(1) * np.log(ratio)
    return total, angle


class PoissonBoltzmann:
    """@param positions, triangles  a closed mesh, corners counter-clockwise seen from outside"""

    def __init__(self, positions, triangles):
        self.corners = positions[triangles]
        a, b, c = self.corners.transpose(1, 0, 2)
        cross = np.cross(b - a, c - a)
        doubled = np.linalg.norm(cross, axis=1)
        self.areas, self.normals = doubled / 2, cross / doubled[:, None]
        self.centres = self.corners.mean(axis=1)
        self.sizes = np.linalg.norm(self.corners - self.centres[:, None], axis=2).max(axis=1)
        self.size = len(triangles)

    def layers(self, points, own=None):
        """V_G, K_G, V_Y, K_Y at points. @param own  the triangles whose centroids the points are"""
        arms = self.centres[None] - points[:, None]
        r = np.maximum(np.linalg.norm(arms, axis=2), 1e-12)
        away = (arms * self.normals).sum(2) * self.areas
        single, angle = self.areas / r, -away / r**3
        at, near = np.nonzero(r < FAR * self.sizes)
        single[at, near], angle[at, near] = single_and_double(points[at], self.corners[near],
                                                              self.normals[near])
        decay = np.exp(-KAPPA * r)
        more = (decay - 1) / r * self.areas
        # The derivative of Y - G along the normal at the source.
        slope = (1 - (1 + KAPPA * r) * decay) / r**3 * away
        if own is not None:
            rows = np.arange(len(own))
            angle[rows, own] = slope[rows, own] = 0  # seen from within its plane
            more[rows, own] = -KAPPA * self.areas[own]
        scale = 1 / (4 * np.pi)
        return scale * single, scale * angle, scale * (single + more), scale * (angle + slope)

    def matrix(self):
        n = self.size
        matrix = np.empty((2 * n, 2 * n))
        half = np.eye(n) / 2
        for begin in range(0, n, ROWS):
            own = np.arange(begin, min(begin + ROWS, n))
            v, k, vy, ky = self.layers(self.centres[own], own)
            matrix[own, :n], matrix[own, n:] = half[own] + k, -v
            matrix[n + own, :n], matrix[n + own, n:] = half[own] - ky, INNER / OUTER * vy
        return matrix

    def right_side(self, sources, charges):
        r = np.linalg.norm(self.centres[:, None] - sources, axis=2)
        return np.concatenate([(charges / r).sum(1) / (4 * np.pi * INNER), np.zeros(self.size)])

    def energy(self, sources, charges, solution):
        """kcal/mol, of the charges in the field that the water answers with."""
        v, k, _, _ = self.layers(sources)
        reaction = v @ solution[self.size:] - k @ solution[:self.size]
        return COULOMB * 4 * np.pi * (charges @ reaction) / 2


def condition(matrix, factors):
    """An estimate in the 1-norm, nearly always within a factor of 3 (Higham 1988)."""
    norm = np.abs(matrix).sum(0).max()
    estimate, info = get_lapack_funcs(("gecon",), (matrix,))[0](factors[0], norm)
    return 1 / estimate if info == 0 and estimate > 0 else np.inf


def iterations(matrix, right, tolerance=1e-6):
    """Of GMRES without restarts; each triangle's two equations are solved for its two unknowns
    first."""
    n = len(right) // 2
    one = np.arange(n)
    blocks = np.stack([np.stack([matrix[one, one], matrix[one, n + one]], 1),
                       np.stack([matrix[n + one, one], matrix[n + one, n + one]], 1)], 1)
    inverse = np.linalg.inv(blocks)

    def solve_blocks(x):
        pair = np.stack([x[:n], x[n:]], 1)[:, :, None]
        return (inverse @ pair)[:, :, 0].T.ravel()
    steps = []
    _, info = gmres(matrix, right, M=LinearOperator(matrix.shape, solve_blocks), restart=500,
                    maxiter=4, atol=0, callback=steps.append, callback_type="pr_norm",
                    **{tolerance_name(): tolerance})
    return len(steps) if info == 0 else float("inf")


def tolerance_name():
    """scipy has renamed it."""
    import inspect
    return "rtol" if "rtol" in inspect.signature(gmres).parameters else "tol"


def solved(positions, triangles, sources, charges):
    """By figure: the condition number, steps of GMRES, and the solvation energy."""
    problem = PoissonBoltzmann(positions, triangles)
    matrix, right = problem.matrix(), problem.right_side(sources, charges)
    steps = iterations(matrix, right)
    factors = lu_factor(matrix)
    solution = lu_solve(factors, right)
    return {"condition": condition(matrix, factors), "steps": steps,
            "energy": problem.energy(sources, charges, solution)}


def born_energy(radius, charge=1.0):
    """Of a charge in the middle of a ball, in water with salt."""
    water = 1 / (OUTER * (1 + KAPPA * radius))
    return COULOMB / 2 * charge**2 / radius * (water - 1 / INNER)
