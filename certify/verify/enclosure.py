"""Rigorous bounds on G and N = grad G / 2 at stored points, from the balls alone.

With u_i = z_i - x and pi_i(y) = |y - z_i|^2 - w_i:
  above  U = (|m|^2 + sum l_i pi_i(x)) / 2 >= G(x) for any convex combination l, m = sum l_i u_i;
  below  L = min over all balls of pi_i(q) / 2 - |x - q|^2 <= G(x) for any point q;
  N      |N(x) + m| <= sqrt(2 (U - L)), for U is strongly convex in m and least at m = -N(x).
The corners of x's mixed cell give the best l and q; a bad guess makes a wide bound, no wrong one.
Rounding: u = 2^-53 bounds the relative error of + - * / sqrt. Limits on the input keep overflow
away, and what underflow adds, 2^-1075 times other factors, is below TINY; so is what it adds under
a root, some 2^-537, even in shares of what is left above TINY."""

from itertools import combinations

import numpy as np

UNIT = 2.0**-53
TINY = 1e-140
SLACK = 2.0**-45  # above the relative error of any 200 roundings in a row

# |N - n| <= r, least <= |G| <= g, low <= |N|, |n| <= high; U - L if it could be smaller, else 0;
# four balls that give these, that of least power at q.
BOUNDS = np.dtype([("n", "f8", 3), ("r", "f8"), ("least", "f8"), ("g", "f8"), ("low", "f8"),
                   ("high", "f8"), ("gap", "f8"), ("balls", "i8", 4), ("entering", "i8")])


def up(x):
    """Above the true value of an x that is exact to SLACK."""
    return x + np.abs(x) * SLACK + TINY


def down(x):
    return x - np.abs(x) * SLACK - TINY


def length(v):
    """Exact to SLACK where v is."""
    return np.sqrt((v * v).sum(-1))


def least_on_hull(u, powers):
    """By row, the convex multipliers of its points u_i for which U is least, in plain floating
    point: those of the best set of up to four."""
    best, result = np.full(len(u), np.inf), np.zeros(powers.shape)
    for chosen in (list(c) for k in range(4) for c in combinations(range(u.shape[1]), k + 1)):
        first, others = chosen[0], chosen[1:]
        l, m = np.ones((len(u), len(chosen))), u[:, first]
        if others:  # where the derivative vanishes, m = u_first + y with d_i . y = right_i
            d = u[:, others] - m[:, None]
            right = -(d * m[:, None]).sum(2) - (powers[:, others] - powers[:, [first]]) / 2
            inverse = np.linalg.pinv(d)
            y = (inverse * right[:, None]).sum(2)
            l[:, 1:] = (inverse * y[:, :, None]).sum(1)
            l[:, 0] -= l[:, 1:].sum(1)
            m = m + y
        value = (m * m).sum(1) + (l * powers[:, chosen]).sum(1)
        better = np.flatnonzero((l >= -1e-12).all(1) & (value < best))
        best[better], result[better] = value[better], 0
        result[np.ix_(better, chosen)] = np.maximum(l[better], 0)
    return result


class Skin:
    """The balls, as G's definition needs them."""
    def __init__(self, balls):
        self.z, self.w = balls[:, :3].copy(), balls[:, 3].copy()

    def least_power(self, q):
        """By point, below the least power of all balls there, and the ball. |z - q|^2 errs by 5 u
        of itself, 2 from the difference; subtracting w by u of both."""
        result, nearest = np.empty(len(q)), np.empty(len(q), dtype=np.int64)
        w = self.w + 16 * UNIT * np.abs(self.w)
        step = max(1, 2_000_000 // len(w))
        for part in (slice(begin, begin + step) for begin in range(0, len(q), step)):
            square = sum((self.z[:, k] - q[part, k, None])**2 for k in range(3))
            power = square * (1 - 16 * UNIT) - w
            nearest[part], result[part] = power.argmin(1), power.min(1)
        return result, nearest

    def bounds(self, x, balls):
        """From the N x k balls given. With S = sum l_i (|u_i|^2 + |w_i|), to first order: |u_i|^2
        errs by 5 u of itself, l_i pi_i by 7 u of l_i (|u_i|^2 + |w_i|), their sum by 10 u S; m by
        5 u sum l_i |u_i| <= 5 u sqrt(S), as |m|^2 <= S by Jensen, so |m|^2 by 13 u S; U, half of
        the sum, by 12.5 u S; in L, |x - q|^2 by 6 u of itself."""
        u, w = self.z[balls] - x[:, None], self.w[balls]
        powers = (u * u).sum(2) - w
        l = least_on_hull(u, powers)
        # Whole numbers of 2^-50, none negative, with the sum one: all exact.
        l = np.rint(l / l.sum(1, keepdims=True) * 2.0**50)
        l[np.arange(len(x)), l.argmax(1)] += 2.0**50 - l.sum(1)
        assert (l >= 0).all() and (l.sum(1) == 2.0**50).all()
        l *= 2.0**-50
        m = (l[:, :, None] * u).sum(1)
        S = (l * ((u * u).sum(2) + np.abs(w))).sum(1)
        U = ((m * m).sum(1) + (l * powers).sum(1)) / 2 + (16 * UNIT * S + TINY)
        q = x - m
        result = np.recarray(len(x), BOUNDS)
        power, result.entering = self.least_power(q)
        S2 = np.abs(power) + ((x - q)**2).sum(1)
        L = power / 2 - ((x - q)**2).sum(1) - (16 * UNIT * S2 + TINY)
        gap = up(np.maximum(U - L, 0))
        result.n, result.g = -m, np.maximum(np.abs(U), np.abs(L))
        result.least = np.maximum(np.maximum(L, -U), 0)
        result.r = up(up(np.sqrt(2 * gap)) + 8 * UNIT * np.sqrt(S))
        result.low, result.high = down(down(length(m)) - result.r), up(up(length(m)) + result.r)
        result.gap = np.where(gap > 2.0**-46 * (S + S2), gap, 0)
        most = np.argsort(-l, axis=1, kind="stable")[:, :4]
        used = np.where(np.take_along_axis(l, most, 1) > 0, most, most[:, :1])
        result.balls = np.take_along_axis(balls, used, 1)
        return result

    def enclose(self, x, balls):
        """Bounds at points, from four balls for each. While they are wide the ball of least power
        at q joins the set, which makes U smaller each time."""
        result = self.bounds(x, balls)
        for _ in range(60):
            known = (result.balls == result.entering[:, None]).any(1)
            wide = np.flatnonzero((result.gap > 0) & ~known)
            if not len(wide):
                break
            more = np.column_stack([result.balls[wide], result.entering[wide]])
            result[wide] = self.bounds(x[wide], more)
        return result
