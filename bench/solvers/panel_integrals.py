"""Closed forms of the potentials of a flat triangle, with a density that is linear on it.

For a point x at the height h above the plane of the triangle T, with x' its foot there, and for
each edge its unit outward normal u in the plane and f the integral of 1 / r along it:

    I = integral of 1 / r                           W = integral of h / r^3, the solid angle
    J = integral of (y - x') / r = sum of u a / 2   F = integral of (y - x') / r^3 = - sum of u f

where a = R^2 f + l1 r1 - l0 r0, with R the distance of x from the edge's line, and l and r at the
edge's ends along it and from x (Wilton and others 1984; van Oosterom and Strackee 1983). A corner's
hat function is its value at x' plus its gradient times y - x'.
"""

import numpy as np

FLAT = 2.0**-40  # of the distance to the corners: far above the rounding of coordinates


def dot(a, b):
    return np.einsum("...i,...i", a, b)


def line_integral(start, stop, r_start, r_stop):
    """Of 1 / r along an edge. Both forms are equal; each time the one that loses no digits."""
    forward = (r_stop + stop) / np.maximum(r_start + start, 1e-300)
    backward = (r_start - start) / np.maximum(r_stop - stop, 1e-300)
    return np.log(np.maximum(np.where(start + stop > 0, forward, backward), 1e-300))


def solid_angle(arms, r):
    """Of a triangle, positive from the side that its normal points to."""
    a, b, c = np.moveaxis(arms, -2, 0)
    ra, rb, rc = np.moveaxis(r, -1, 0)
    beside = ra * rb * rc + dot(a, b) * rc + dot(b, c) * ra + dot(c, a) * rb
    return -2 * np.arctan2(dot(a, np.cross(b, c)), beside)


def panel_integrals(points, corners, normals, gradients):
    """The integrals of hat / r and of hat h / r^3 over triangles, one for each point.

    @param points     (n, 3)
    @param corners    (n, 3, 3), counter-clockwise seen against the normal
    @param normals    (n, 3), unit
    @param gradients  (n, 3, 3), of the three hat functions
    @return  two of shape (n, 3), a column for each corner's hat function
    """
    arms = corners - points[:, None]
    r = np.linalg.norm(arms, axis=2)
    height = -dot(arms[:, 0], normals)
    # In the plane, but for rounding, there is none: the principal value of the double layer.
    angle = np.where(np.abs(height) > FLAT * r.max(axis=1), solid_angle(arms, r), 0)
    total = -height * angle
    first, slope = np.zeros_like(points), np.zeros_like(points)
    for k in range(3):
        m = (k + 1) % 3
        edge = corners[:, m] - corners[:, k]
        along = edge / np.linalg.norm(edge, axis=1)[:, None]
        outward = np.cross(along, normals)
        start, stop = dot(arms[:, k], along), dot(arms[:, m], along)
        aside = dot(arms[:, k], outward)
        f = line_integral(start, stop, r[:, k], r[:, m])
        f = np.where(aside**2 + height**2 > 0, f, 0)  # on the edge's line: a factor 0 beside it
        total += aside * f
        a = (aside**2 + height**2) * f + stop * r[:, m] - start * r[:, k]
        first += outward * (a / 2)[:, None]
        slope -= outward * f[:, None]
    foot = points - height[:, None] * normals
    hats = np.einsum("nki,nki->nk", gradients, foot[:, None] - corners) + 1
    single = hats * total[:, None] + np.einsum("nki,ni->nk", gradients, first)
    double = hats * angle[:, None] + np.einsum("nki,ni->nk", gradients, slope) * height[:, None]
    return single, double
