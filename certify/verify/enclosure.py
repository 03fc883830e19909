"""Rigorous bounds on G and N = grad G / 2 at stored points, from the balls alone.

With u_i = z_i - x and pi_i(y) = |y - z_i|^2 - w_i:
  above  U = (|m|^2 + sum l_i pi_i(x)) / 2 >= G(x) for any convex combination l, m = sum l_i u_i;
  below  L = min over all atoms of pi_i(q) / 2 - |x - q|^2 <= G(x) for any point q;
  N      |N(x) + m| <= sqrt(2 (U - L)), for U is strongly convex in m and least at m = -N(x).
Which l and q are good, the corners of x's mixed cell tell. A bad guess makes a wide bound, not a
wrong one.

Rounding: u = 2^-53 bounds the relative error of each + - * / sqrt. Limits on the input keep
overflow away, and whatever underflow adds, some 2^-1075 times other factors, is below TINY.
"""

from itertools import combinations

import numpy as np

UNIT = 2.0**-53
TINY = 1e-200
SLACK = 2.0**-45  # above the relative error of any 200 roundings in a row


def up(x):
    """Above the true value of an x that is exact to SLACK."""
    return x + np.abs(x) * SLACK + TINY


def down(x):
    return x - np.abs(x) * SLACK - TINY


class Bounds:
    """By point: |N - n| <= r, |G| <= g, low <= |N|, |n| <= high; the balls used, and the next."""

    def __init__(self, n, r, g, gap, atoms, entering):
        self.fields = n, r, g, gap, atoms, entering
        self.n, self.r, self.g, self.gap, self.atoms, self.entering = self.fields
        size = np.linalg.norm(n, axis=1)
        self.low, self.high = down(down(size) - r), up(up(size) + r)

    def __getitem__(self, index):
        return Bounds(*(field[index] for field in self.fields))


def blocks(points, size=128):
    """Cuts the points into blocks of near ones; yields their indices."""
    stack = [np.arange(len(points))]
    while stack:
        block = stack.pop()
        if len(block) <= size:
            if len(block):
                yield block
            continue
        part = points[block]
        half = len(block) // 2
        order = np.argpartition(part[:, np.ptp(part, axis=0).argmax()], half)
        stack += [block[order[:half]], block[order[half:]]]


def dual_basis(d):
    """e with e_i . d_j = 1 if i = j, else 0, in the span of the one to three vectors d."""
    if d.shape[1] == 1:
        return d / (d * d).sum(2, keepdims=True)
    if d.shape[1] == 2:
        normal = np.cross(d[:, 0], d[:, 1])
        e = np.stack([np.cross(d[:, 1], normal), np.cross(normal, d[:, 0])], axis=1)
        return e / (normal * normal).sum(1)[:, None, None]
    e = np.stack([np.cross(d[:, (k + 1) % 3], d[:, (k + 2) % 3]) for k in range(3)], axis=1)
    return e / (e[:, 0] * d[:, 0]).sum(1)[:, None, None]


def least_on_span(x, z, w):
    """Where U is least among affine combinations of k balls: multipliers and U, to rounding."""
    u = z - x[:, None]
    d = u[:, 1:] - u[:, :1]
    multipliers = np.ones(w.shape)
    m = u[:, 0]
    if d.shape[1]:
        right = -2 * (d * u[:, :1]).sum(2) - ((d * d).sum(2) - w[:, 1:] + w[:, :1]) / 2
        e = dual_basis(d)
        y = (right[:, :, None] * e).sum(1)
        multipliers[:, 1:] = (e * y[:, None]).sum(2)
        multipliers[:, 0] = 1 - multipliers[:, 1:].sum(1)
        m = m + y
    powers = (u * u).sum(2) - w
    return multipliers, ((m * m).sum(1) + (multipliers * powers).sum(1)) / 2


def least_on_hull(x, z, w, with_last=False):
    """The same for convex combinations, over all sets of at most four; NaN balls are left out."""
    count = z.shape[1]
    best, result = np.full(len(x), np.inf), np.zeros(w.shape)
    with np.errstate(all="ignore"):
        for k in range(1, min(count, 4) + 1):
            for chosen in map(list, combinations(range(count), k)):
                if with_last and chosen[-1] != count - 1:
                    continue
                multipliers, value = least_on_span(x, z[:, chosen], w[:, chosen])
                better = np.flatnonzero((multipliers >= -1e-12).all(1) & (value < best))
                best[better], result[better] = value[better], 0
                result[np.ix_(better, chosen)] = multipliers[better]
    return result


class Skin:
    """The balls, as G's definition needs them."""

    def __init__(self, balls):
        self.z, self.w = balls[:, :3].copy(), balls[:, 3].copy()
        self.w_above = self.w + 16 * UNIT * np.abs(self.w)

    def lower_power(self, v, atoms):
        """Below |v*|^2 - w if v is v* rounded once: 5 u for the square, 1 for the difference."""
        square = v[..., 0]**2 + v[..., 1]**2 + v[..., 2]**2
        return square * (1 - 16 * UNIT) - self.w_above[atoms]

    def least_power(self, q):
        """By point, a lower bound on the least power of all atoms there, and the atom to blame.

        Atoms far from a block of points are bounded all at once, by the block's box.
        """
        result, nearest = np.empty(len(q)), np.empty(len(q), dtype=np.int64)
        for block in blocks(q):
            part = q[block]
            below, above = part.min(0) - self.z, self.z - part.max(0)
            to_box = self.lower_power(np.maximum(np.maximum(below, above), 0), slice(None))
            farthest = np.maximum(np.abs(self.z - part.min(0)), np.abs(self.z - part.max(0)))
            is_near = to_box <= ((farthest**2).sum(1) - self.w).min() + TINY
            near = np.flatnonzero(is_near)
            powers = self.lower_power(self.z[near] - part[:, None], near)
            best = powers.argmin(1)
            rest = to_box[~is_near].min(initial=np.inf)
            result[block] = np.minimum(powers[np.arange(len(part)), best], rest)
            nearest[block] = near[best]
        return result, nearest

    def convex_combination(self, x, atoms):
        """Multipliers near the least U of the atoms, N x 4: each a whole number of 2^-50, none
        negative, and their sum exactly one. -1 stands for no atom."""
        result = np.zeros(atoms.shape)
        counts = (atoms >= 0).sum(1)
        for k in range(1, 5):
            rows = np.flatnonzero(counts == k)
            chosen = atoms[rows, :k]
            with np.errstate(all="ignore"):
                multipliers, _ = least_on_span(x[rows], self.z[chosen], self.w[chosen])
                multipliers = np.clip(multipliers, 0, 1)
                multipliers /= multipliers.sum(1, keepdims=True)
            multipliers[~np.isfinite(multipliers).all(1)] = np.eye(k)[0]
            result[rows, :k] = np.rint(multipliers * 2.0**50)
        largest = np.arange(len(x)), result.argmax(1)
        result[largest] += 2.0**50 - result.sum(1)  # whole numbers below 2^53: exact
        assert (result >= 0).all() and (result.sum(1) == 2.0**50).all()
        return result * 2.0**-50

    def bounds(self, x, atoms):
        """With S = sum l_i (|u_i|^2 + |w_i|), to first order in u, by Jensen |m|^2 <= S:
        |u_i|^2 errs by 5 u of itself, l_i pi_i by 7 u of l_i (|u_i|^2 + |w_i|), their sum by
        10 u S; m by 5 u sum l_i |u_i| <= 5 u sqrt(S), |m|^2 by 13 u S; U, half of the sum, by
        12.5 u S. In L, |x - q|^2 errs by 6 u of itself and the difference by u of both."""
        l = self.convex_combination(x, atoms)
        used = np.maximum(atoms, 0)
        u, w = self.z[used] - x[:, None], self.w[used]
        square = (u * u).sum(2)
        S = (l * (square + np.abs(w))).sum(1)
        m = (l[:, :, None] * u).sum(1)
        U = ((m * m).sum(1) + (l * (square - w)).sum(1)) / 2
        U = U + (16 * UNIT * S + TINY)
        q = x - m
        power, entering = self.least_power(q)
        p = x - q
        p2 = (p * p).sum(1)
        L = power / 2 - p2 - (16 * UNIT * (np.abs(power) + p2) + TINY)
        gap = up(np.maximum(U - L, 0))
        r = up(up(np.sqrt(2 * gap)) + 8 * UNIT * np.sqrt(S))
        is_wide = gap > 2.0**-46 * (S + np.abs(power) + p2)
        return Bounds(-m, r, np.maximum(np.abs(U), np.abs(L)), np.where(is_wide, gap, 0), atoms,
                      entering)

    def enclose(self, x, atoms=None):
        """Bounds at points. While an atom of less power at q widens a bound, it joins the set and
        the least U over the set's hull gives the next."""
        if atoms is None:
            atoms = np.full((len(x), 4), -1)
            atoms[:, 0] = self.least_power(x)[1]
        result = self.bounds(x, atoms.copy())
        active = np.flatnonzero(result.gap)
        for _ in range(60):
            active = active[(result.atoms[active] != result.entering[active, None]).all(1)]
            if not len(active):
                break
            five = np.column_stack([result.atoms[active], result.entering[active]])
            z = np.where(five[:, :, None] < 0, np.nan, self.z[five])
            l = least_on_hull(x[active], z, self.w[five], with_last=True)
            order = np.argsort(-l, axis=1, kind="stable")[:, :4]
            rows = np.arange(len(active))[:, None]
            four = np.where(l[rows, order] > 0, five[rows, order], -1)
            better = self.bounds(x[active], four)
            is_better = (better.gap < result.gap[active]) & (four[:, 0] >= 0)
            active = active[is_better]
            for old, new in zip(result.fields, better.fields):
                old[active] = new[is_better]
            active = active[result.gap[active] > 0]
        return Bounds(*result.fields)
