"""The number of components of the skin, b0 + b2 of the dual complex, in exact arithmetic.

A triangulation is a witness, checked here: simplices that are no worse than flat are refused, those
that share a facet lie on opposite sides of it, every other facet has no ball beyond its plane, and
one point lies in one simplex only. So they cover the balls' convex hull once. Lifted to the
heights |z|^2 - w they are convex at every inner facet, hence everywhere, and no ball lies below.

Ties. The simplices then refine the regular subdivision, whichever way they cut a cospherical cell.
Each simplex inside a cell has the same dual cell of least powers as the cell, so the same value;
the simplices with a value below 0 fill the same set of cells. b0 and b2 belong to that set.
"""

import random
from collections import defaultdict
from itertools import combinations

from manifold import NotProved

INFINITY = -1


def det(m):
    if not m:
        return 1
    if len(m) == 1:
        return m[0][0]
    if len(m) == 2:
        return m[0][0] * m[1][1] - m[0][1] * m[1][0]
    return sum(x * c for x, c in zip(m[-1], cofactors(m[:-1])))


def cofactors(rows):
    """c with det(rows + [r]) = c . r, for k rows of length k + 1."""
    k = len(rows)
    return [(-1)**(k + i) * det([row[:i] + row[i + 1:] for row in rows]) for i in range(k + 1)]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def minus(a, b):
    return [x - y for x, y in zip(a, b)]


def sign(x):
    return (x > 0) - (x < 0)


def without(simplex, k):
    return simplex[:k] + simplex[k + 1:]


class Balls:
    """Centres and weights as integers, all scaled by one power of two."""

    def __init__(self, balls):
        ratios = [[number.as_integer_ratio() for number in row] for row in balls.tolist()]
        shift = max(max(d for _, d in row[:3]).bit_length() for row in ratios)
        shift = max(shift, max(row[3][1].bit_length() for row in ratios) // 2 + 1)
        self.z = [[(n << shift) // d for n, d in row[:3]] for row in ratios]
        self.w = [(row[3][0] << 2 * shift) // row[3][1] for row in ratios]
        self.height = [dot(z, z) - w for z, w in zip(self.z, self.w)]
        # Coordinates in which the balls' affine span, of dimension d, is seen one-to-one.
        self.start, columns = [0], ()
        for i in range(len(self.z)):
            rows = [minus(self.z[j], self.z[0]) for j in [*self.start[1:], i]]
            for choice in combinations(range(3), len(rows)):
                if det([[row[c] for c in choice] for row in rows]):
                    self.start, columns = [*self.start, i], choice
                    break
        self.dimension = len(columns)
        self.p = [[z[c] for c in columns] for z in self.z]
        self.lifted = [[*p, h] for p, h in zip(self.p, self.height)]


class Triangulation:
    """Checked on construction. Simplices have ascending corners."""

    def __init__(self, balls, simplices):
        self.balls, self.d = balls, balls.dimension
        self.simplices = [tuple(sorted(s)) for s in simplices]
        if not self.simplices or any(len(set(s)) != self.d + 1 or len(s) != self.d + 1
                                     for s in self.simplices):
            raise NotProved(f"triangulation: not simplices of dimension {self.d}")
        self.signs = [sign(det(self.arms(balls.p, s))) for s in self.simplices]
        if 0 in self.signs:
            raise NotProved(f"triangulation: simplex {self.signs.index(0)} is flat")
        self.at_facet = defaultdict(list)  # simplex and which corner lies opposite
        for s, corners in enumerate(self.simplices):
            for k in range(self.d + 1):
                self.at_facet[without(corners, k)].append((s, k))
        for facet, sides in self.at_facet.items():
            self.check_facet(facet, sides)
        self.check_covering_once()
        corners = {corner for s in self.simplices for corner in s}
        for i in sorted(set(range(len(balls.p))) - corners):
            self.check_hidden(i)

    def arms(self, points, simplex):
        return [minus(points[i], points[simplex[0]]) for i in simplex[1:]]

    def side(self, s, k):
        """The orientation of the facet opposite corner k with that corner last."""
        return self.signs[s] * (-1)**(self.d - k)

    def lies_above(self, s, i):
        """Whether ball i, lifted, is not below the plane of a lifted simplex."""
        p = self.balls.lifted
        corners = self.simplices[s]
        plane = cofactors(self.arms(p, corners))
        return dot(plane, minus(p[i], p[corners[0]])) * self.signs[s] >= 0

    def check_facet(self, facet, sides):
        if len(sides) > 2 or len(sides) == 2 and self.side(*sides[0]) == self.side(*sides[1]):
            raise NotProved(f"triangulation: simplices overlap at the facet {facet}")
        (s, k), last = sides[0], sides[-1]
        if len(sides) == 2:
            if not self.lies_above(s, self.simplices[last[0]][last[1]]):
                raise NotProved(f"triangulation: not regular at the facet {facet}")
        elif self.d > 0:
            p = self.balls.p
            plane = cofactors(self.arms(p, facet))
            if any(dot(plane, minus(q, p[facet[0]])) * self.side(s, k) < 0 for q in p):
                raise NotProved(f"triangulation: a ball lies beyond the facet {facet}")

    def outer_facets(self, s, point, scale=1):
        """The facets beyond whose planes point / scale lies; None for one on whose plane it is."""
        p, corners = self.balls.p, self.simplices[s]
        for k in range(self.d + 1):
            facet = without(corners, k)
            rows = self.arms(p, facet) if facet else []
            base = [scale * x for x in p[facet[0]]] if facet else []
            if det([*rows, minus(point, base)]) * self.side(s, k) < 0:
                yield facet

    def check_covering_once(self):
        """How many simplices cover a point is the same all over the hull, for it could only change
        across a facet on the hull's boundary. At the first one's barycentre it is one."""
        if self.d == 0:
            if len(self.simplices) != 1:
                raise NotProved("triangulation: several simplices at one position")
            return
        barycentre = [sum(x) for x in zip(*(self.balls.p[i] for i in self.simplices[0]))]
        for s in range(1, len(self.simplices)):
            if next(self.outer_facets(s, barycentre, self.d + 1), None) is None:
                raise NotProved(f"triangulation: simplices 0 and {s} overlap")

    def check_hidden(self, i):
        """Walks to a simplex that contains ball i; in random order, so as not to cycle in ties."""
        chance, s = random.Random(i), 0
        while facets := list(self.outer_facets(s, self.balls.p[i])) if self.d else []:
            s = next(t for t, _ in self.at_facet[chance.choice(facets)] if t != s)
        if not self.lies_above(s, i):
            raise NotProved(f"triangulation: ball {i} is not hidden, and no corner")


class Simplex:
    """The orthocentre o: of equal power to all corners, in their span. 2 det (o - z_0) = sum c_i d_i
    with d_i = z_i - z_0, det the Gram determinant of the d_i and c by Cramer's rule."""

    def __init__(self, balls, corners):
        z, w = balls.z, balls.w
        self.z0, self.w0 = z[corners[0]], w[corners[0]]
        self.balls = balls
        self.d = [minus(z[i], self.z0) for i in corners[1:]]
        b = [dot(d, d) - w[i] + self.w0 for d, i in zip(self.d, corners[1:])]
        gram = [[dot(d, e) for e in self.d] for d in self.d]
        self.det = det(gram)
        self.c = [det(gram[:k] + [b] + gram[k + 1:]) for k in range(len(b))]
        self.power = dot(b, self.c) - 4 * self.det * self.w0  # 4 det times the power at o

    def is_attached(self, apex):
        """Whether a ball has less power at o than the corners."""
        e = minus(self.balls.z[apex], self.z0)
        power = dot(e, e) - self.balls.w[apex] + self.w0
        return self.det * power < sum(c * dot(d, e) for c, d in zip(self.c, self.d))

    def contains_orthocentre(self):
        return all(c >= 0 for c in self.c) and sum(self.c) <= 2 * self.det


def is_in_dual_complex(balls, corners, cofaces):
    """Whether the least power over the dual cell is below 0. It is the power at o, unless an apex
    of a coface has less there; then the least of the cofaces'.

    @param cofaces  the apex of each, and whether it is in the dual complex"""
    if any(is_in for _, is_in in cofaces):
        return True
    simplex = Simplex(balls, corners)
    if simplex.power > 0 or any(simplex.is_attached(apex) for apex, _ in cofaces):
        return False
    if simplex.power == 0 and simplex.contains_orthocentre():
        raise NotProved(f"singular: the skin touches itself at the balls {corners}")
    return simplex.power < 0


def count_sets(elements, pairs):
    root = {e: e for e in elements}

    def find(e):
        while root[e] != e:
            root[e] = e = root[root[e]]
        return e

    for a, b in pairs:
        root[find(a)] = find(b)
    return sum(root[e] == e for e in elements)


def skin_components(triangulation):
    """b0 + b2: the bodies, and the voids in them."""
    balls, d = triangulation.balls, triangulation.d
    is_in = {}
    level = {s: [] for s in triangulation.simplices}
    for _ in range(d + 1):
        below = defaultdict(list)
        for s, cofaces in level.items():
            is_in[s] = is_in_dual_complex(balls, s, cofaces)
            for k in range(len(s) if len(s) > 1 else 0):
                below[without(s, k)].append((s[k], is_in[s]))
        level = below
    vertices = [s for s in is_in if len(s) == 1 and is_in[s]]
    edges = [((s[0],), (s[1],)) for s in is_in if len(s) == 2 and is_in[s]]
    bodies = count_sets(vertices, edges)
    if d < 3:
        return bodies, 0  # nothing flat encloses anything
    free = [s for s, corners in enumerate(triangulation.simplices) if not is_in[corners]]
    walls = [[s for s, _ in sides] + [INFINITY] * (2 - len(sides))
             for facet, sides in triangulation.at_facet.items() if not is_in[facet]]
    return bodies, count_sets([*free, INFINITY], walls) - 1


def regular_triangulation(balls):
    """Simplices for Triangulation to check: the lower convex hull of the lifted balls, by inserting
    one after the other, with a vertex at infinity above. Time grows with the square of the balls."""
    d = balls.dimension
    if d == 0:
        return [[min(range(len(balls.w)), key=lambda i: balls.height[i])]]
    # Random shares, too small to change the sign of a determinant that is not 0, break ties.
    size = max(abs(x) for p in balls.p for x in p).bit_length()
    chance, shift = random.Random(0), 3 * (size + 2) + 80
    lifted = [[*p, (h << shift) + chance.getrandbits(64)] for p, h in zip(balls.p, balls.height)]
    cells, ridges = {}, defaultdict(set)

    def add(cell):
        for ridge in combinations(cell, d):
            ridges[ridge].add(cell)
        finite = [i for i in cell if i != INFINITY]
        points = lifted if len(finite) > d else balls.p
        cells[cell] = points, finite[0], cofactors(
            [minus(points[i], points[finite[0]]) for i in finite[1:]])

    def height(cell, i):
        points, base, plane = cells[cell]
        return dot(plane, minus(points[i], points[base]))

    def is_in_conflict(cell, i):
        if cell[0] != INFINITY:
            return height(cell, i) * cells[cell][2][-1] < 0
        beside = next(c for c in ridges[cell[1:]] if c != cell)
        value = height(cell, i)
        if value == 0:
            return is_in_conflict(beside, i)
        inner = next(j for j in beside if j not in cell)
        return (value > 0) != (height(cell, inner) > 0)

    for cell in combinations([INFINITY, *sorted(balls.start)], d + 1):
        add(cell)
    for i in sorted(set(range(len(balls.p))) - set(balls.start)):
        conflict = {cell for cell in cells if is_in_conflict(cell, i)}
        horizon = [ridge for cell in conflict for ridge in combinations(cell, d)
                   if not ridges[ridge] <= conflict]
        for cell in conflict:
            del cells[cell]
            for ridge in combinations(cell, d):
                ridges[ridge].discard(cell)
        for ridge in horizon:
            add(tuple(sorted([*ridge, i])))
    return [cell for cell in cells if cell[0] != INFINITY]
