"""The number of components of the skin, b0 + b2 of the dual complex, in exact arithmetic.

A triangulation is a witness, checked here: no simplex is flat, two that share a facet lie on
opposite sides of it, every other facet has no ball beyond its plane, and one point lies in one
simplex only; so they cover the balls' convex hull once. Lifted to the heights |z|^2 - w they are
convex at every inner facet, hence everywhere, and no ball lies below.

Ties. The simplices refine the regular subdivision, whichever way they cut its cospherical cells. A
simplex inside a cell has the cell's dual, and so its value; those with a value below 0 fill the
same set of cells, and b0 and b2 belong to that set.
"""

import random
from collections import defaultdict
from itertools import combinations

import numpy as np

from manifold import NotProved, components


def det(m):
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return dot(cofactors(m[:-1]), m[-1]) if m else 1


def cofactors(rows):
    """c with det(rows + [r]) = c . r, for k rows of length k + 1."""
    k = len(rows)
    return [(-1)**(k + i) * det([without(row, i) for row in rows]) for i in range(k + 1)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def without(simplex, k):
    return simplex[:k] + simplex[k + 1:]


def arms(points, simplex):
    return [minus(points[i], points[simplex[0]]) for i in simplex[1:]]


class Balls:
    """Centres and weights as integers, all scaled by one power of two."""

    def __init__(self, balls):
        rows = [[number.as_integer_ratio() for number in row] for row in balls.tolist()]
        shift = max(d for row in rows for _, d in row).bit_length()
        self.z = [[(n << shift) // d for n, d in row[:3]] for row in rows]
        self.w = [(row[3][0] << 2 * shift) // row[3][1] for row in rows]
        # Coordinates in which the balls' affine span, of dimension d, is seen one-to-one.
        self.start, columns = [0], ()
        for i in range(len(self.z)):
            span = arms(self.z, [*self.start, i])
            for choice in combinations(range(3), len(span)):
                if det([[row[c] for c in choice] for row in span]):
                    self.start, columns = [*self.start, i], choice
                    break
        self.d = len(columns)
        self.p = [[z[c] for c in columns] for z in self.z]
        self.lifted = [[*p, dot(z, z) - w] for p, z, w in zip(self.p, self.z, self.w)]


class Triangulation:
    """Checked on construction. Simplices have ascending corners."""

    def __init__(self, balls, simplices):
        self.balls, self.d = balls, balls.d
        self.simplices = [tuple(sorted(s)) for s in simplices]
        if not self.simplices or any(len(s) != self.d + 1 for s in self.simplices):
            raise NotProved(f"triangulation: not simplices of dimension {self.d}")
        self.signs = [det(arms(balls.p, s)) for s in self.simplices]
        if 0 in self.signs:
            raise NotProved(f"triangulation: simplex {self.signs.index(0)} is flat")
        self.at_facet = defaultdict(list)  # simplex and which corner lies opposite
        for s, corners in enumerate(self.simplices):
            for k in range(self.d + 1):
                self.at_facet[without(corners, k)].append((s, k))
        for facet, sides in self.at_facet.items():
            (s, k), (other, apex) = sides[0], sides[-1]
            if len(sides) == 1:
                is_right = not any(self.is_beyond(s, k, p) for p in balls.p)
            else:
                is_right = (len(sides) == 2 and self.side(s, k) * self.side(other, apex) < 0 and
                            self.lies_above(s, self.simplices[other][apex]))
            if not is_right:
                raise NotProved(f"triangulation: overlaps, ends or is not regular at {facet}")
        # How many simplices cover a point is the same all over the hull, for it could change only
        # across a facet on the hull's boundary. It is one if no other covers this barycentre.
        point = [sum(x) for x in zip(*(balls.p[i] for i in self.simplices[0]))]
        for s, corners in enumerate(self.simplices[1:], 1):
            if not any(self.is_beyond(s, k, point, self.d + 1) for k in range(len(corners))):
                raise NotProved(f"triangulation: simplices 0 and {s} overlap")
        for i in set(range(len(balls.p))) - {i for s in self.simplices for i in s}:
            if not all(self.lies_above(s, i) for s in range(len(self.simplices))):
                raise NotProved(f"triangulation: ball {i} is not hidden, and no corner")

    def side(self, s, k):
        """Positive or negative: the orientation of the facet opposite corner k, then k."""
        return self.signs[s] * (-1)**(self.d - k)

    def is_beyond(self, s, k, point, scale=1):
        """Whether point / scale lies beyond the plane of the facet opposite corner k."""
        p, facet = self.balls.p, without(self.simplices[s], k)
        if not facet:
            return False
        arm = [x - scale * y for x, y in zip(point, p[facet[0]])]
        return det([*arms(p, facet), arm]) * self.side(s, k) < 0

    def lies_above(self, s, i):
        """Whether ball i, lifted, is not below the plane of a lifted simplex."""
        return det(arms(self.balls.lifted, [*self.simplices[s], i])) * self.signs[s] >= 0


def is_in_dual_complex(balls, corners, cofaces):
    """Whether the least power over the dual cell is below 0. It is the power at the orthocentre o,
    unless the apex of a coface has less there; then it is the least of the cofaces'. With
    d_i = z_i - z_0, gram their Gram determinant and Cramer's c: 2 gram (o - z_0) = sum c_i d_i.

    @param cofaces  the apex of each, and whether it is in the dual complex"""
    if any(is_in for _, is_in in cofaces):
        return True
    z, w, first = balls.z, balls.w, corners[0]
    d = arms(z, corners)
    b = [dot(e, e) - w[i] + w[first] for e, i in zip(d, corners[1:])]
    rows = [[dot(e, f) for f in d] for e in d]
    gram, c = det(rows), [det([*rows[:k], b, *rows[k + 1:]]) for k in range(len(d))]
    power = dot(b, c) - 4 * gram * w[first]  # 4 gram times that at o
    for apex, _ in cofaces:
        e = minus(z[apex], z[first])
        if gram * (dot(e, e) - w[apex] + w[first]) < dot(c, [dot(f, e) for f in d]):
            return False
    if power == 0 and min(c, default=0) >= 0 and sum(c) <= 2 * gram:  # o in the simplex
        raise NotProved(f"singular: the skin touches itself at the balls {corners}")
    return power < 0


def count_sets(elements, pairs):
    a, b = np.array(pairs, dtype=np.int64).reshape(-1, 2).T
    return len(set(components(max(elements, default=0) + 1, a, b)[elements]))


def skin_components(triangulation):
    """b0 and b2: the bodies, and the voids in them."""
    is_in, level = {}, {s: [] for s in triangulation.simplices}
    while level:
        facets = defaultdict(list)
        for s, cofaces in level.items():
            is_in[s] = is_in_dual_complex(triangulation.balls, s, cofaces)
            for k in range(len(s) if len(s) > 1 else 0):
                facets[without(s, k)].append((s[k], is_in[s]))
        level = facets
    bodies = count_sets([s[0] for s in is_in if len(s) == 1 and is_in[s]],
                        [s for s in is_in if len(s) == 2 and is_in[s]])
    if triangulation.d < 3:
        return bodies, 0  # nothing flat encloses anything
    outside = len(triangulation.simplices)
    free = [s for s, corners in enumerate(triangulation.simplices) if not is_in[corners]]
    walls = [(sides[0][0], sides[1][0] if len(sides) > 1 else outside)
             for facet, sides in triangulation.at_facet.items() if not is_in[facet]]
    return bodies, count_sets([*free, outside], walls) - 1


def regular_triangulation(balls):
    """Simplices for Triangulation to check, by inserting one ball after another into the lower hull
    of the lifted ones, at first between d + 1 balls far outside. Quadratic in the balls."""
    if balls.d == 0:
        return [[min(range(len(balls.w)), key=lambda i: -balls.w[i])]]
    size = max(abs(x) for p in balls.p for x in p).bit_length()
    far, chance = 1 << 6 * size + 40, random.Random(0)
    outer = [[far * chance.randint(90, 99) * sign * (k in (j, balls.d)) for j in range(balls.d)]
             for k, sign in zip(range(balls.d + 1), [1] * balls.d + [-1])]
    # Random shares, too small to change the sign of a determinant that is not 0, break ties.
    lifted = [[*p, (p[-1] << 24 * size + 300) + chance.getrandbits(64)]
              for p in [*balls.lifted, *([*p, dot(p, p)] for p in outer)]]
    lifted = [[*p[:-2], p[-1]] for p in lifted]
    n = len(balls.p)
    cells = {}

    def add(cell):
        plane = cofactors(arms(lifted, cell))
        cells[cell] = plane if plane[-1] > 0 else [-x for x in plane]

    add(tuple(range(n, n + balls.d + 1)))
    for i in range(n):
        conflict = [cell for cell, plane in cells.items()
                    if dot(plane, minus(lifted[i], lifted[cell[0]])) < 0]
        times = defaultdict(int)
        for cell in conflict:
            del cells[cell]
            for ridge in combinations(cell, balls.d):
                times[ridge] += 1
        for ridge in times:
            if times[ridge] == 1:
                add(tuple(sorted([*ridge, i])))
    return [cell for cell in cells if cell[-1] < n]
