"""The conditions under which the flow along grad G carries the mesh one-to-one onto the skin.

  (c1) upright  N . n_t > 0 on each triangle t, n_t its unit normal;
  (c2) tube     |G| < |N|^2 there: every point flows to the skin, past no critical point;
  (c3) degree   each component has a vertex that the flow reaches from no other point of the mesh.

N changes by at most the distance, and |G| <= R^2 + g on a triangle with circumradius R and |G| <= g
at its corners."""

from fractions import Fraction

import numpy as np

from enclosure import TINY, UNIT, down, least_on_hull, length, up
from manifold import NotProved

MAX_DEPTH, MAX_CANDIDATES = 5, 16  # a triangle is cut into at most 4^5 pieces


def longest_path(n, g):
    """Above the length of a path of the flow along which G changes by at most g, from a point with
    |N| >= n: there dG/ds >= 2 (n - s), so g >= 2 n s - s^2. Infinite where that bounds nothing."""
    rest = down(down(n * n) - up(g))
    with np.errstate(all="ignore"):
        return np.where((n > 0) & (rest > 0), up(g / (n + np.sqrt(rest))), np.inf)


def in_quarters(corners, middles):
    """What is by corner of triangles, of the four parts of each, given it at the sides' middles."""
    (a, b, c), (bc, ca, ab) = (rows.swapaxes(0, 1) for rows in (corners, middles))
    return np.concatenate([np.stack(part, axis=1) for part in (
        (a, ab, ca), (b, bc, ab), (c, ca, bc), (bc, ca, ab))]).view(type(corners))


class Covering:
    """The mesh over the skin; `balls` are four by vertex, for its enclosure. Raises NotProved."""
    def __init__(self, positions, triangles, skin, balls):
        self.positions, self.triangles, self.skin = positions, triangles, skin
        self.bounds = skin.enclose(positions, balls)
        # Edges are rounded once: a cross product errs by less than 8 u |e_1| |e_2| in length.
        self.corners = positions[triangles]
        e = self.corners[:, [2, 0, 1]] - self.corners[:, [1, 2, 0]]  # opposite each corner
        self.edges = up(length(e))
        cross = np.cross(e[:, 1], e[:, 2])
        error = up(8 * UNIT * self.edges[:, 1] * self.edges[:, 2])
        doubled_area = down(down(length(cross)) - error)
        if not (doubled_area > 0).all():
            raise NotProved(f"upright: triangle {doubled_area.argmin()} has no area")
        self.R = up(self.edges.prod(1) / (2 * doubled_area))
        self.G = up(self.R**2 + self.bounds.g[triangles].max(1))
        self.normal = cross / length(cross)[:, None]
        # Vectors a distance d apart have directions at most 2 d / length apart.
        self.normal_error = up(2 * error / doubled_area + 8 * UNIT)

    def upright(self, at, t):
        """Below N . n_t, point by point, for the triangles t."""
        dot = (at.n * self.normal[t]).sum(-1)
        return down(dot - up(at.high * (self.normal_error[t] + 4 * UNIT)) - at.r)

    def prove_tube(self):
        """(c1) and (c2), for the triangles, then for smaller pieces of those too coarse. At depth k
        a midpoint's coordinates err by k u |p|."""
        t, pieces, R, off = np.arange(len(self.triangles)), self.corners, self.R, 0
        at = self.bounds[self.triangles]
        self.path = np.zeros(len(t))  # above the longest from a triangle to the skin
        for _ in range(MAX_DEPTH + 1):
            coarse = ~self.hold(t, pieces, at, R, off)
            if not coarse.any():
                return
            pieces, at = pieces[coarse], at[coarse]
            middles = (pieces[:, [1, 2, 0]] + pieces[:, [2, 0, 1]]) / 2  # opposite each corner
            seen = self.skin.enclose(middles.reshape(-1, 3), at.balls[:, [1, 2, 0]].reshape(-1, 4))
            t, R = np.tile(t[coarse], 4), np.tile(R[coarse] / 2, 4)
            pieces, at = in_quarters(pieces, middles), in_quarters(at, seen.reshape(at.shape))
            off = 2.0**-49 * np.abs(self.positions).max() + TINY
        raise NotProved(f"upright or tube: triangle {t.min()} is too big")

    def hold(self, t, corners, at, R, off):
        """Whether (c1) and (c2) hold on a piece of each triangle t, given bounds `at` its corners,
        which are no farther than `off` from where they should be. A point p = sum l_i c_i of it has

            |N(p) - sum l_i N(c_i)|^2 <= sum l_i l_j (|c_i - c_j|^2 - |N(c_i) - N(c_j)|^2),

        i < j, for |N(p) - N(c_i)| <= |p - c_i|; sum l_i l_j <= 1/3. That is R^2 at most."""
        upright = self.upright(at, t[:, None])
        wrong = (~(upright > 0) | ~(at.g < at.low**2)).any(1)
        if wrong.any():
            raise NotProved(f"upright or tube: triangle {t[wrong.argmax()]}")
        doubt = at.r.max(1) + off
        fold = np.max([up((c * c).sum(1)) - down((n * n).sum(1)) for c, n in (
            (corners[:, k] - corners[:, k - 1], at.n[:, k] - at.n[:, k - 1]) for k in range(3))], 0)
        # Sides are known to 2 d, N's differences too, and both are shorter than 2 (R + d).
        bend = np.minimum(R, up(np.sqrt(
            (np.maximum(up(fold), 0) + 16 * doubt * (R + doubt)) / 3)))
        low = np.maximum(down(at.low.min(1) - off), 0)
        affine = down(np.sqrt(np.maximum(down(low**2) - up(R**2), 0)))
        G = up(at.g.max(1) + (2 * at.high.max(1) + off) * off + R**2)
        path = longest_path(down(affine - bend), G)
        holds = (down(upright.min(1) - off - bend) > 0) & np.isfinite(path)
        np.maximum.at(self.path, t[holds], path[holds])
        return holds

    def winding_number(self, p):
        """How often the skin that is covered goes round p, three Fractions: as often as the mesh,
        if no path between them meets p. Triangles above p count, exactly, by the way they face."""
        at = np.array(p, dtype=float)
        slack = 2.0**-50 * np.abs(at).max()
        arms, path, xy = self.corners - at, up(self.path + slack), self.corners[:, :, :2]
        near = ~(down(length(arms[:, 0]) - up(2 * self.R)) > path)
        if not (distance_below(arms[near], arms[near]) > path[near]).all():
            raise NotProved(f"degree: a triangle is too near to {at} to tell which part it bounds")
        turns = 0
        above = ((xy.min(1) <= at[:2] + slack) & (xy.max(1) >= at[:2] - slack)).all(1)
        for t in self.corners[above].tolist():
            a, b, c = ([Fraction(v) - o for v, o in zip(corner, p)] for corner in t)
            crossed = [(e[0] * f[1] - f[0] * e[1], (f[1] > 0) - (e[1] > 0))
                       for e, f in ((a, b), (b, c), (c, a))]
            turn = sum(way for side, way in crossed if side * way > 0)
            volume = sum(a[i] * (b[i - 2] * c[i - 1] - b[i - 1] * c[i - 2]) for i in range(3))
            turns += turn if turn * volume > 0 else 0
        return turns

    def prove_degree(self, label, wanted):
        """(c3), at the vertices wanted or others; `label` is by vertex its component's least."""
        for component in np.unique(label):
            members = np.flatnonzero(label == component)
            spread = members[np.arange(MAX_CANDIDATES) * len(members) // MAX_CANDIDATES]
            tried = [*(v for v in wanted if label[v] == component), *spread]
            if not any(self.is_covered_once(v) for v in tried):
                raise NotProved(f"degree: the component of vertex {component} may cover the skin "
                                "more than once, or together with another")

    def is_covered_once(self, v):
        at, own = self.bounds[[v]], np.flatnonzero((self.triangles == v).any(1))
        # To a point p over the same point of the skin G changes by at most |G(p)| + |G(v)|. On so
        # short a path one does not come back to the plane of a triangle at v.
        path = longest_path(at.low, up(self.G + at.g))
        if not (path[own] < self.upright(at, own)).all():
            return False
        arms, axis = self.corners - self.positions[v], at.n[0] / length(at.n[0])
        # On a path of length s from v, N turns by s at most: the path leaves the line along n by
        # at most the integral of (s + r) / |n|.
        seen = arms - (arms @ axis)[:, :, None] * axis
        if not turn_once(arms[own], seen[own], axis):
            return False
        path = np.minimum(path, up(self.path + longest_path(at.low, at.g)))
        is_near = ~(down(length(arms[:, 0]) - up(2 * self.R)) > path)
        is_near[own] = False
        arms, seen, path = arms[is_near], seen[is_near], path[is_near]
        aside = up((path / 2 + at.r) * path / at.low)
        return ((distance_below(arms, arms) > path) |
                (distance_below(seen, arms, axis) > aside)).all()


def turn_once(arms, seen, axis):
    """Whether triangles with a corner at 0, turning forward seen along the axis, go round it once.
    An angle in (0, pi) is found to 2^-20, or to that less 2 pi, if its sides are not too short."""
    corner = (arms == 0).all(2).argmax(1)
    a, b = (np.take_along_axis(seen, ((corner + k) % 3)[:, None, None], 1)[:, 0] for k in (1, 2))
    angles = np.arctan2(np.cross(a, b) @ axis, (a * b).sum(1))
    is_long = length(seen) >= 2.0**-20 * length(arms)
    return is_long.all() and (angles > 0).all() and angles.sum() < 3 * np.pi


def distance_below(seen, arms, axis=None):
    """Below the distance from 0, or an axis through it, to triangles with the corners `arms`: for
    any unit vector y at least the least y . arm. It points to the nearest point of `seen`, the same
    or their projections."""
    y = (least_on_hull(seen, np.zeros((len(seen), 3)))[:, :, None] * seen).sum(1)
    along = 0.0  # of y along the axis, where arms tell nothing
    with np.errstate(all="ignore"):
        y /= length(y)[:, None]
        if axis is not None:
            y -= (y @ axis)[:, None] * axis
            y /= length(y)[:, None]
            along = np.abs(y @ axis)[:, None] + 16 * UNIT
    return down(((arms * y[:, None]).sum(2) - up(length(arms) * (8 * UNIT + along))).min(1))
