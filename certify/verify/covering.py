"""The conditions under which the flow along grad G carries the mesh one-to-one onto the skin.

  (c1) upright  N . n_t > 0 on each triangle t, n_t its unit normal;
  (c2) tube     |G| < |N|^2 there: every point flows to the skin, past no critical point;
  (c3) degree   each component has a vertex that the flow reaches from no other point of the mesh.

N changes by at most the distance, and |G(p)| <= R^2 + g at a point p of a triangle with
circumradius R and |G| <= g at its corners; p lies within R of a corner.
"""

import numpy as np

from enclosure import TINY, UNIT, down, least_on_hull, length, up
from manifold import NotProved

MAX_DEPTH = 5  # a triangle is cut into at most 4^5 pieces
MAX_PIECES = 1_000_000
MAX_CANDIDATES = 16


def longest_path(n, g):
    """Above the length of a path of the flow along which G changes by at most g, from a point with
    |N| >= n: there dG/ds >= 2 (n - s), so g >= 2 n s - s^2. Infinite where that bounds nothing."""
    rest = down(down(n * n) - up(g))
    with np.errstate(all="ignore"):
        return np.where((n > 0) & (rest > 0), up(g / (n + np.sqrt(rest))), np.inf)


class Covering:
    """The mesh over the skin, (c1) and (c2) proved. Raises NotProved."""

    def __init__(self, positions, triangles, skin):
        self.positions, self.triangles, self.skin = positions, triangles, skin
        # Edges are rounded once, so the cross product errs by 4 u (|x y'| + |x' y|) in each
        # coordinate, by less than 8 u |e_1| |e_2| in length.
        self.corners = positions[triangles]
        e = self.corners[:, [2, 0, 1]] - self.corners[:, [1, 2, 0]]  # opposite each corner
        self.edges = up(length(e))
        cross = np.cross(e[:, 1], e[:, 2])
        error = up(8 * UNIT * self.edges[:, 1] * self.edges[:, 2])
        doubled_area = down(down(length(cross)) - error)
        if not (doubled_area > 0).all():
            raise NotProved(f"upright: triangle {doubled_area.argmin()} has no area")
        self.R = up(self.edges.prod(1) / (2 * doubled_area))
        self.normal = cross / length(cross)[:, None]
        # Vectors a distance d apart have directions at most 2 d / length apart.
        self.normal_error = up(2 * error / doubled_area + 8 * UNIT)

    def upright(self, at, t):
        """Below N . n_t, point by point, for the triangles t."""
        dot = (at.n * self.normal[t]).sum(-1)
        return down(dot - up(at.high * (self.normal_error[t] + 4 * UNIT)) - at.r)

    def prove_tube(self, bounds):
        """(c1) and (c2), from the bounds at the vertices where they suffice."""
        self.bounds, t = bounds, self.triangles
        self.G = up(self.R**2 + bounds.g[t].max(1))
        n = down(bounds.low[t].min(1) - self.R)
        every = np.arange(len(t))
        upright = np.column_stack([self.upright(bounds[t[:, k]], every) for k in range(3)])
        longer = np.maximum(self.edges[:, [1, 2, 0]], self.edges[:, [2, 0, 1]])  # at each corner
        self.path = longest_path(n, self.G)
        is_proved = (upright > longer).any(1) & np.isfinite(self.path)
        self.path[~is_proved] = 0
        self.by_pieces = every[~is_proved]
        self.prove_by_pieces(self.by_pieces)

    def prove_by_pieces(self, t):
        """About each piece's centroid x, from which no point p of the piece is farther than r.
        In |G(p) - G(x)| <= 2 |N(x) . (p - x)| + r^2 only the part of N along t counts, but for what
        rounding moves x out of t's plane. A midpoint errs by k u |p| in each coordinate at depth k,
        a centroid by less than 3 u |p| more."""
        off = 2.0**-49 * np.abs(self.positions).max() + TINY
        pieces, balls = self.corners[t], self.bounds.balls[self.triangles[t, 0]]
        for depth in range(MAX_DEPTH + 1):
            if not len(t):
                return
            x = pieces.sum(1) / 3
            r = up(length(pieces - x[:, None]).max(1)) + 2 * off
            at = self.skin.enclose(x, balls)
            upright, opposite = self.upright(at, t), at.copy()
            opposite.n *= -1
            is_away = self.upright(opposite, t) > 0
            if is_away.any():
                raise NotProved(f"upright: triangle {t[is_away].min()} faces away from N")
            n = down(down(at.low - at.r) - r)
            along = length(at.n - (at.n * self.normal[t]).sum(1)[:, None] * self.normal[t])
            along = up(along + at.high * (2 * self.normal_error[t] + 16 * UNIT) + at.r)
            G = up(at.g + 2 * along * r + 2 * (at.high + at.r) * off + r * r)
            path = longest_path(n, np.minimum(self.G[t], G))
            is_upright = down(upright - r) > 0
            holds = is_upright & np.isfinite(path)
            np.maximum.at(self.path, t[holds], path[holds])
            t, balls, is_upright = t[~holds], at.balls[~holds], is_upright[~holds]
            if len(t) and (depth == MAX_DEPTH or len(t) > MAX_PIECES):
                claim = "tube" if is_upright[t.argmin()] else "upright"
                raise NotProved(f"{claim}: triangle {t.min()} is too big")
            a, b, c = pieces[~holds].transpose(1, 0, 2)
            ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
            pieces = np.concatenate([np.stack(corners, axis=1) for corners in (
                (a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
            t, balls = np.tile(t, 4), np.tile(balls, (4, 1))

    def prove_degree(self, label, wanted):
        """(c3): returns the vertices that prove it, of those wanted and some of each component.

        @param label  by vertex, its component's least vertex"""
        chosen = []
        for component in np.unique(label):
            members = np.flatnonzero(label == component)
            spread = members[np.arange(MAX_CANDIDATES) * len(members) // MAX_CANDIDATES]
            tried = [*(v for v in wanted if label[v] == component), *spread.tolist()]
            v = next((v for v in tried if self.doubt(v) is None), None)
            if v is None:
                raise NotProved(f"degree: vertex {tried[-1]} {self.doubt(tried[-1])}")
            chosen.append(v)
        return chosen

    def doubt(self, v):
        """What keeps (c3) from being proved at a vertex, if anything."""
        at, own = self.bounds[[v]], np.flatnonzero((self.triangles == v).any(1))
        if not self.turns_once(v, at, own):
            return "is not gone round once by its triangles"
        # To a point p over the same point of the skin G changes by at most |G(p)| + |G(v)|.
        path = longest_path(at.low, up(self.G + at.g))
        if not (path[own] < self.upright(at, own)).all():
            return "has a triangle that may come back over it"
        path = np.minimum(path, up(self.path + longest_path(at.low, at.g)))
        from_first = down(length(self.corners[:, 0] - self.positions[v]))
        is_near = ~(down(from_first - up(2 * self.R)) > path)
        is_near[own] = False
        near = np.flatnonzero(is_near)
        arms, path = self.corners[near] - self.positions[v], path[near]
        is_free = distance_below(arms, arms) > path
        # On a path of length s from v, N turns by s at most: the path leaves the line along n by
        # at most the integral of (s + r) / |n|.
        axis = at.n[0] / length(at.n[0])
        aside = up((path / 2 + at.r) * path / at.low)
        is_free |= distance_below(arms - (arms @ axis)[:, :, None] * axis, arms, axis) > aside
        return None if is_free.all() else f"may be reached from triangle {near[~is_free][0]}"

    def turns_once(self, v, at, own):
        """Seen along n the triangles at v all turn forward, and a functional f that vanishes on n
        rises through 0 once on the way round. (-n_y, n_x, 0) . n = 0 exactly."""
        n = at.copy()
        n.r = 0
        if not (self.upright(n, own) > 0).all():
            return False
        following = {}
        for row in self.triangles[own].tolist():
            k = row.index(v)
            following[row[k - 2]] = row[k - 1]
        ring = [row[k - 2]]
        while len(ring) < len(own):
            ring.append(following[ring[-1]])
        arms = self.positions[ring] - self.positions[v]
        x, y, z = at.n[0]
        for f in np.array([[-y, x, 0], [0, -z, y], [z, 0, -x]]):
            height = (arms * f).sum(1)
            if (np.abs(height) > 8 * UNIT * length(arms) * length(f) + TINY).all():
                return ((height < 0) & (np.roll(height, -1) > 0)).sum() == 1
        return False


def distance_below(seen, arms, axis=None):
    """Below the distance from 0 to triangles with the corners `arms`; with an axis, from the line
    along it. Whatever the unit vector y, it is at least the least y . arm; y points to the nearest
    point of `seen`, the triangles as far as y may see them."""
    l = least_on_hull(np.zeros((len(arms), 3)), seen, (seen * seen).sum(2))
    y = (l[:, :, None] * seen).sum(1)
    along = 0.0  # of y along the axis, where arms tell nothing
    with np.errstate(all="ignore"):
        y /= length(y)[:, None]
        if axis is not None:
            y -= (y @ axis)[:, None] * axis
            y /= length(y)[:, None]
            along = np.abs(y @ axis)[:, None] + 16 * UNIT
    return down(((arms * y[:, None]).sum(2) - up(length(arms) * (8 * UNIT + along))).min(1))
