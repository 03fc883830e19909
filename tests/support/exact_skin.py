"""Regular triangulations, G and N of a few balls by their definitions, and balls to try them on."""

import random
from fractions import Fraction
from itertools import combinations

import numpy as np

from skin_components import Balls


def tetrahedra_of(rows):
    """By the definition, ties broken by random shares."""
    exact, chance = Balls(rows), random.Random(1)
    exact.z = exact.z * 2**40
    exact.w = exact.w * 2**80 + np.array([chance.getrandbits(60) for _ in rows], dtype=object)
    corners = np.array([*combinations(range(len(rows)), 4)], dtype=np.int64).reshape(-1, 4)
    every = np.arange(len(rows))
    return tuple(tuple(s) for s, m, D in zip(corners.tolist(), *exact.orthocentres(corners))
                 if D and (exact.excess(s[0], m, D, every) >= 0).all())


def nasty_set(chance):
    """At most eight balls, and points near them."""
    kind = chance.choice(["plain", "far", "tiny", "touching", "flat", "line", "mixed", "grid"])
    offset = chance.uniform(-1e6, 1e6) if kind == "far" else 0.0
    scale = 1e-6 if kind == "tiny" else 1.0
    balls = []
    for _ in range(chance.randint(1, 8)):
        z, r = [chance.uniform(-2, 2) for _ in range(3)], chance.uniform(0.5, 2)
        if kind == "flat":
            z[2] = 0.25
        elif kind == "line":
            z[1:] = [0.5, 0.5]
        elif kind == "mixed":
            r = 10**chance.uniform(-6, 3)
        elif kind == "grid":
            z, r = [float(chance.randint(-1, 1)) for _ in range(3)], 1.0
        elif kind == "touching" and balls:
            z = [balls[0][0] + balls[0][3]**0.5 + r * (1 + 1e-12), *balls[0][1:3]]
        balls.append([offset + scale * x for x in z] + [r * r * scale * scale])
    points = []
    for _ in range(4):
        *z, w = chance.choice(balls)
        spread = chance.choice([0, 1e-9, 1e-3, 1, 3]) * w**0.5
        points.append([x + spread * chance.gauss(0, 1) for x in z])
    return balls, points


def solved(rows, right):
    """By Gauss; None for a singular matrix."""
    m, n = [[*row, b] for row, b in zip(rows, right)], len(right)
    for i in range(n):
        pivot = next((k for k in range(i, n) if m[k][i]), None)
        if pivot is None:
            return None
        m[i], m[pivot] = m[pivot], m[i]
        m[i] = [v / m[i][i] for v in m[i]]
        m = [row if k == i else [a - row[i] * b for a, b in zip(row, m[i])]
             for k, row in enumerate(m)]
    return [row[n] for row in m]


def exact_values(balls, x):
    """G and N by the definition: the least U over all subsets of up to four balls."""
    u = [[Fraction(a) - Fraction(b) for a, b in zip(ball, x)] for ball in balls]
    powers = [sum(a * a for a in v) - Fraction(ball[3]) for v, ball in zip(u, balls)]

    def dot(a, b):
        return sum(p * q for p, q in zip(a, b))

    best = None
    for k in range(1, 5):
        for first, *others in combinations(range(len(balls)), k):
            d = [[a - b for a, b in zip(u[i], u[first])] for i in others]
            right = [-(dot(e, u[first]) + (powers[i] - powers[first]) / 2)
                     for e, i in zip(d, others)]
            multipliers = solved([[dot(e, f) for f in d] for e in d], right)
            if multipliers is None or min(multipliers, default=0) < 0 or sum(multipliers) > 1:
                continue
            terms = list(zip([1 - sum(multipliers), *multipliers], [first, *others]))
            m = [sum(c * u[i][axis] for c, i in terms) for axis in range(3)]
            U = (dot(m, m) + sum(c * powers[i] for c, i in terms)) / 2
            if best is None or U < best[0]:
                best = U, [-a for a in m]
    return best
