"""The conditions under which the flow along grad G carries the mesh one-to-one onto the skin.

  (c1) upright  N . n_t > 0 on each triangle t, n_t its unit normal;
  (c2) tube     |G| < |N|^2 there: every point flows to the skin, past no critical point;
  (c3) degree   each component has a vertex that the flow reaches from no other point of the mesh.

N changes by at most the distance, and |G(p)| <= R^2 + g at a point p of a triangle with
circumradius R and |G| <= g at its corners; p lies within R of a corner.
"""

import numpy as np

from enclosure import TINY, UNIT, down, least_on_hull, up
from manifold import NotProved

MAX_DEPTH = 5  # a triangle is cut into at most 4^5 pieces
MAX_PIECES = 2_000_000
MAX_CANDIDATES = 16


def longest_path(n, g):
    """Above the length of a path of the flow along which G changes by at most g, from a point with
    |N| >= n: there dG/ds >= 2 (n - s), so g >= 2 n s - s^2. Infinite where that bounds nothing."""
    with np.errstate(invalid="ignore", divide="ignore"):
        rest = down(down(n * n) - up(g))
        return np.where((n > 0) & (rest > 0), up(g / (n + np.sqrt(np.maximum(rest, 0)))), np.inf)


class Triangles:
    """Bounds on lengths and normals. The edges are single roundings, so the cross product errs by
    4 u (|x y'| + |x' y|) in each coordinate, by less than 8 u |e1| |e2| in length."""

    def __init__(self, positions, triangles):
        self.p = positions[triangles]
        e = self.p[:, [2, 0, 1]] - self.p[:, [1, 2, 0]]  # opposite each corner
        self.edges = up(np.sqrt((e * e).sum(2)))
        cross = np.cross(e[:, 1], e[:, 2])
        error = up(8 * UNIT * self.edges[:, 1] * self.edges[:, 2])
        size = np.sqrt((cross * cross).sum(1))
        doubled_area = down(down(size) - error)
        with np.errstate(all="ignore"):
            is_flat = ~(doubled_area > 0)
            self.R = np.where(is_flat, np.inf,
                              up(self.edges.prod(1) / (2 * np.maximum(doubled_area, TINY))))
            self.normal = np.where(is_flat[:, None], 0, cross / size[:, None])
            # Two vectors a distance d apart: their directions differ by at most 2 d / length.
            self.normal_error = np.where(
                is_flat, np.inf, up(2 * error / np.maximum(doubled_area, TINY) + 8 * UNIT))

    def upright(self, bounds, t, sign=1):
        """Below N . n_t or its opposite, point by point, for the triangles t."""
        dot = sign * (bounds.n * self.normal[t]).sum(-1)
        return down(dot - up(bounds.high * (self.normal_error[t] + 4 * UNIT)) - bounds.r)


class Covering:
    """The mesh over the skin. Raises NotProved."""

    def __init__(self, positions, triangles, skin, bounds):
        self.positions, self.triangles, self.skin, self.bounds = positions, triangles, skin, bounds
        self.shape = Triangles(positions, triangles)
        corners = bounds.low[triangles], bounds.g[triangles].max(1)
        self.G = up(self.shape.R**2 + corners[1])
        n = down(corners[0].min(1) - self.shape.R)
        everything = np.arange(len(triangles))
        upright = np.stack([self.shape.upright(bounds[triangles[:, k]], everything)
                            for k in range(3)], axis=1)
        edges = self.shape.edges
        longer = np.maximum(edges[:, [1, 2, 0]], edges[:, [2, 0, 1]])  # of the two at each corner
        is_proved = (upright > longer).any(1) & (n > 0) & (self.G < down(n * n))
        self.path = np.where(is_proved, longest_path(n, self.G), 0.0)
        self.by_pieces = np.flatnonzero(~is_proved)
        if not np.isfinite(self.shape.R).all():
            raise NotProved(f"upright: triangle {np.isinf(self.shape.R).argmax()} has no area")
        self.prove_by_pieces(self.by_pieces)
        # How much of N . n_t and of |N|^2 is left, for the report.
        rest = everything[is_proved]
        self.margins = {
            "upright": ((upright - longer).max(1)[rest] / corners[0].min(1)[rest]).min(initial=1),
            "tube": (1 - self.G[rest] / n[rest]**2).min(initial=1)}

    def prove_by_pieces(self, t):
        """(c1) and (c2) about each piece's centroid x, which no point p of the piece is farther
        from than r. In |G(p) - G(x)| <= 2 |N(x) . (p - x)| + r^2 only the part of N along t
        counts, but for what rounding moves x out of t's plane.

        The midpoints are rounded: at depth k a corner is off by k u |p| in each coordinate."""
        off = 2.0**-49 * np.abs(self.positions).max() + TINY
        pieces, atoms = self.shape.p[t], self.bounds.atoms[self.triangles[t, 0]]
        for depth in range(MAX_DEPTH + 1):
            if not len(t):
                return
            x = pieces.sum(1) / 3
            r = up(np.sqrt(((pieces - x[:, None])**2).sum(2)).max(1)) + 2 * off
            at = self.skin.enclose(x, atoms)
            normal = self.shape.normal[t]
            upright = self.shape.upright(at, t)
            is_away = self.shape.upright(at, t, -1) > 0
            if is_away.any():
                raise NotProved(f"upright: triangle {t[is_away].min()} faces away from N")
            n = down(down(at.low - at.r) - r)
            along = at.n - (at.n * normal).sum(1)[:, None] * normal
            along = up(np.sqrt((along * along).sum(1))) + up(
                at.high * (2 * self.shape.normal_error[t] + 16 * UNIT) + at.r)
            G = up(at.g + 2 * along * r + 2 * (at.high + at.r) * off + r * r)
            G = np.minimum(self.G[t], G)
            is_upright, is_in_tube = down(upright - r) > 0, (n > 0) & (G < down(n * n))
            holds = is_upright & is_in_tube
            np.maximum.at(self.path, t[holds], longest_path(n, G)[holds])
            t, pieces, atoms, is_upright = (a[~holds] for a in (t, pieces, at.atoms, is_upright))
            if depth == MAX_DEPTH or len(t) > MAX_PIECES:
                break
            a, b, c = pieces[:, 0], pieces[:, 1], pieces[:, 2]
            ab, bc, ca = (a + b) / 2, (b + c) / 2, (c + a) / 2
            pieces = np.concatenate([np.stack(corners, axis=1) for corners in (
                (a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca))])
            t, atoms = np.tile(t, 4), np.tile(atoms, (4, 1))
        if len(t):
            worst = t.argmin()
            claim = "tube" if is_upright[worst] else "upright"
            raise NotProved(f"{claim}: triangle {t[worst]} is too big")

    def prove_degree(self, label, wanted):
        """(c3), with the vertices wanted or up to MAX_CANDIDATES of each component's.

        @param label  by vertex, its component's least vertex"""
        chosen = []
        for component in np.unique(label):
            members = np.flatnonzero(label == component)
            spread = members[np.arange(MAX_CANDIDATES) * len(members) // MAX_CANDIDATES]
            own = [v for v in wanted if label[v] == component]
            for v in [*own, *dict.fromkeys(spread.tolist())]:
                reason = self.doubt(v)
                if reason is None:
                    chosen.append(int(v))
                    break
            else:
                raise NotProved(f"degree: the component of vertex {component}: vertex {v} {reason}")
        return chosen

    def doubt(self, v):
        """What keeps (c3) from being proved at a vertex, if anything."""
        at, shape = self.bounds[np.array([v])], self.shape
        own = np.flatnonzero((self.triangles == v).any(1))
        if not self.turns_once(v, at, own):
            return "has triangles that do not go round it once"
        # Between v and a point p over the same point of the skin |G| changes by |G(p) - G(v)|.
        path = longest_path(at.low, up(self.G + at.g))
        if not (path[own] < shape.upright(at, own)).all():
            return "has a triangle that may come back over it"
        path = np.minimum(path, up(self.path + longest_path(at.low, at.g)))
        arm = shape.p[:, 0] - self.positions[v]
        reach = down(np.sqrt((arm * arm).sum(1))) - up(2 * shape.R)
        is_near = ~(down(reach) > path)
        is_near[own] = False
        near = np.flatnonzero(is_near)
        arms, path = shape.p[near] - self.positions[v], path[near]
        is_free = distance_below(arms, arms) > path
        # On a path of length s from v, N turns by s at most: the path leaves the line along n by
        # at most the integral of (s + r) / |n|.
        n = at.n[0] / np.linalg.norm(at.n[0])
        flat = arms - (arms @ n)[:, :, None] * n
        aside = up(path * path / (2 * at.low) + at.r * path / at.low)
        is_free |= distance_below(flat, arms, n) > aside
        if not is_free.all():
            return f"may be reached from triangle {near[~is_free][0]}"
        return None

    def turns_once(self, v, at, own):
        """Seen along n the triangles at v all turn forward, and a functional f that vanishes on n
        rises through 0 once on the way round. (-n_y, n_x, 0) . n = 0 exactly."""
        if not (self.shape.upright(Fixed(at), own) > 0).all():
            return False
        t = self.triangles[own]
        first, rows = (t == v).argmax(1), np.arange(len(t))
        following = dict(zip(t[rows, (first + 1) % 3], t[rows, (first + 2) % 3]))
        ring = [next(iter(following))]
        while len(ring) < len(t):
            ring.append(following[ring[-1]])
        arms = self.positions[ring] - self.positions[v]
        x, y, z = at.n[0]
        for f in np.array([[-y, x, 0], [0, -z, y], [z, 0, -x]]):
            height = (arms * f).sum(1)
            error = 8 * UNIT * np.sqrt((arms * arms).sum(1)) * np.linalg.norm(f) + TINY
            if (np.abs(height) > error).all():
                return ((height < 0) & (np.roll(height, -1) > 0)).sum() == 1
        return False


class Fixed:
    """A vector n itself, in place of an N near it."""

    def __init__(self, bounds):
        self.n, self.high, self.r = bounds.n, bounds.high, 0.0


def distance_below(shown, arms, axis=None):
    """Below the distance from 0 to triangles with the corners `arms`; with an axis, from the line
    along it. Whatever the unit vector y, it is at least the least y . arm; y points to the nearest
    point of `shown`, the triangles as far as plain floating point sees them."""
    l = least_on_hull(np.zeros((len(arms), 3)), shown, (shown * shown).sum(2))
    y = (l[:, :, None] * shown).sum(1)
    with np.errstate(all="ignore"):
        y /= np.sqrt((y * y).sum(1))[:, None]
    length = up(np.sqrt((arms * arms).sum(2)))
    along = 0.0  # the share of y along the axis, of which arms tell nothing
    if axis is not None:
        y -= (y @ axis)[:, None] * axis
        y /= np.sqrt((y * y).sum(1))[:, None]
        along = np.abs(y @ axis)[:, None] + 16 * UNIT
    return down(((arms * y[:, None]).sum(2) - up(length * (8 * UNIT + along))).min(1))
