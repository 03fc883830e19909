"""A mesh of a sphere, and skins of which as much is known as a test says."""

import numpy as np

from enclosure import BOUNDS, length

OCTAHEDRON = (np.array([[1., 0, 0], [-1, 0, 0], [0, 1, 0], [0, -1, 0], [0, 0, 1], [0, 0, -1]]),
              np.array([[a, c, e] if up else [c, a, e] for a, x in ((0, 1), (1, 0))
                        for c, y in ((2, 1), (3, 0)) for e, z in ((4, 1), (5, 0))
                        for up in [(x + y + z) % 2]]))


def sphere(levels):
    """The unit sphere, an octahedron cut into four parts a few times."""
    p, t = OCTAHEDRON
    for _ in range(levels):
        a, b, c = t.T
        pairs = np.sort(np.vstack([np.column_stack(e) for e in ((a, b), (b, c), (c, a))]), axis=1)
        edges, number = np.unique(pairs, axis=0, return_inverse=True)
        middles = p[edges].sum(1)
        ab, bc, ca = number.reshape(3, -1) + len(p)
        p = np.vstack([p, middles / np.linalg.norm(middles, axis=1)[:, None]])
        t = np.vstack([np.column_stack(r) for r in ((a, ab, ca), (b, bc, ab), (c, ca, bc),
                                                    (bc, ca, ab))])
    return p, t


def told(n, r=0.0, g=0.0):
    """Bounds by point, as an enclosure has them: N lies within r of n, and |G| is up to g."""
    result = np.zeros(np.shape(n)[:-1], BOUNDS).view(np.recarray)
    result.n, result.r, result.g = n, r, g
    result.low, result.high = length(result.n) - r, length(result.n) + r
    return result


class ToldSkin:
    """@param bounds  at points, of which it is given the positions"""
    def __init__(self, bounds):
        self.bounds = bounds

    def enclose(self, x, _):
        return self.bounds(x)
