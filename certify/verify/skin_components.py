"""A point in every part of space that the skin bounds: bodies, of {G < 0}, and voids in them. Some
parts may have several. Exact integers.

Bodies. A convex combination c of centres has the weight w_c = sum l_i (w_i - |z_i - c|^2), and
G(y) <= |y - c|^2 - w_c / 2. From a point where G < 0 a path inside leads to a c with w_c > 0 and,
as w_c is convex in l, on to a centre of positive weight. Two are joined inside if their spheres of
radii sqrt(w) overlap.

Voids. With P the least power, G(y) >= P(q) / 2 - |y - q|^2. From a point where G > 0 a path
outside leads to a q with P(q) > 0, then uphill to infinity or a corner of the power diagram, which
is the orthocentre of a tetrahedron. Two of these are joined outside if P > 0 on the edge between
them, which is dual to their common facet. There are none if all centres lie in one plane.
The tetrahedra are checked: no ball has less power at the orthocentre of one than its corners, and
across each facet another follows, or there is no centre. So they cover the convex hull, and all
corners of the power diagram are theirs."""

from collections import defaultdict
from fractions import Fraction
from functools import lru_cache
from itertools import combinations

import numpy as np

from manifold import NotProved, components


class Balls:
    """Centres and weights as integers, all scaled by one power of two."""
    def __init__(self, balls):
        rows = [[Fraction(x) for x in row] for row in balls]
        self.scale = max(x.denominator for row in rows for x in row)
        self.z = np.array([[int(x * self.scale) for x in row[:3]] for row in rows], dtype=object)
        self.w = np.array([int(row[3] * self.scale**2) for row in rows], dtype=object)

    def arms(self, origin, i):
        """e = z_i - z_o, and h: at z_o + y ball i has h - 2 y . e more power than ball o."""
        e = self.z[i] - self.z[origin]
        return e, (e * e).sum(-1) - self.w[i] + self.w[origin]

    def orthocentres(self, corners):
        """m and D by row of three or four balls: they have one power at o = z_0 + m / 2D. A
        triangle's o lies in its plane, as if its normal were an arm with h = 0."""
        e, h = self.arms(corners[:, :1], corners[:, 1:])
        a, b, normal, g = e[:, 0], e[:, 1], np.cross(e[:, 0], e[:, 1]), h[:, :, None]
        c, last = (e[:, 2], g[:, 2]) if e.shape[1] == 3 else (normal, 0)
        m = g[:, 0] * np.cross(b, c) + g[:, 1] * np.cross(c, a) + last * normal
        return m, (normal * c).sum(1)

    def excess(self, origin, m, D, i):
        """D^2 times what ball i has more power than ball o at z_o + m / 2D."""
        e, h = self.arms(origin, i)
        return D * (D * h - (e * m).sum(-1))

    def point(self, origin, m=(0, 0, 0), D=1):
        return [Fraction(2 * D * z + a, 2 * D * self.scale) for z, a in zip(self.z[origin], m)]

    def power(self, origin, m, D):
        return Fraction(1) * (m * m).sum(-1) / (4 * D * D) - self.w[origin]

    def overlap(self, i, j):
        """Whether the distance is below sqrt(w_i) + sqrt(w_j), both positive."""
        (e, _), w, v = self.arms(i, j), self.w[i], self.w[j]
        rest = (e * e).sum(-1) - w - v
        return (w > 0) & (v > 0) & ((rest < 0) | (rest * rest < 4 * w * v))

    def are_in_plane(self):
        d = self.z - self.z[0]
        normals = np.cross(d[[(d * d).sum(1).argmax()]], d)
        return not (d @ normals[(normals * normals).sum(1).argmax()]).any()

    def facets(self, tetrahedra):
        """Each with its one or two sides, tetrahedron and apex. Raises NotProved."""
        m, D = self.orthocentres(tetrahedra)
        every, sides_of = np.arange(len(self.z)), defaultdict(list)
        for s, corners in enumerate(tetrahedra):
            if D[s] == 0 or (self.excess(corners[0], m[s], D[s], every) < 0).any():
                raise NotProved(f"triangulation: tetrahedron {s} is flat or not regular")
            for k in range(4):
                facet = tuple(sorted([*corners[:k], *corners[k + 1:]]))
                sides_of[facet].append((s, corners[k]))
        e, _ = self.arms(*np.split(np.array([*sides_of]), [1], axis=1))
        for (facet, sides), plane in zip(sides_of.items(), np.cross(e[:, 0], e[:, 1])):
            along = (self.z - self.z[facet[0]]) @ plane
            inwards = along * along[sides[0][1]]
            is_right = (inwards >= 0).all() if len(sides) == 1 else inwards[sides[1][1]] < 0
            if len(sides) > 2 or not is_right:
                raise NotProved(f"triangulation: ends or overlaps at {facet}")
        return sides_of


def deepest(depth, pairs):
    """Of each set of elements of positive depth that the pairs join, the deepest."""
    label = components(len(depth), *pairs.T)
    order = np.argsort(-depth, kind="stable")
    return [i for i in order[np.unique(label[order], return_index=True)[1]] if depth[i] > 0]


@lru_cache  # of many meshes of one skin
def skin_components(rows, simplices, nearest):
    """Points in the bodies, and in the voids. What is given of a triangulation is not believed.

    @param nearest  by ball, one that may overlap it besides"""
    balls, count = Balls(rows), len(simplices)
    pairs = [*enumerate(nearest), *(pair for s in simplices for pair in combinations(s, 2))]
    pairs = np.array(pairs, dtype=np.int64).reshape(-1, 2)
    bodies = [balls.point(i) for i in deepest(balls.w, pairs[balls.overlap(*pairs.T)])]
    if balls.are_in_plane():
        return bodies, []
    if not simplices or {len(s) for s in simplices} != {4}:
        raise NotProved("triangulation: not of tetrahedra")
    tetrahedra = np.array(simplices)
    sides_of, (m, D) = balls.facets(tetrahedra), balls.orthocentres(tetrahedra)
    P = np.array([*balls.power(tetrahedra[:, 0], m, D), np.inf])  # the last one is outside
    # P is least at the orthocentre of a facet, unless an apex has less power there.
    doors, first = [(count, count)], np.array([*sides_of])
    for facet, sides, at, E in zip(first, sides_of.values(), *balls.orthocentres(first)):
        ends = [s for s, _ in sides] + [count] * (2 - len(sides))
        if (P[ends] > 0).all() and (balls.power(facet[0], at, E) > 0 or any(
                balls.excess(facet[0], at, E, apex) < 0 for _, apex in sides)):
            doors.append(ends)
    found = [s for s in deepest(P, np.array(doors)) if s != count]
    return bodies, [balls.point(tetrahedra[s, 0], m[s], D[s]) for s in found]
