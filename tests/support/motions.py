"""Rotations and shifts of space: a matrix by rows, and a vector."""

import math

IDENTITY = ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], [0, 0, 0])


def moved(motion, x):
    rotation, shift = motion
    return [sum(r * c for r, c in zip(row, x)) + s for row, s in zip(rotation, shift)]


def after(first, second):
    """The motion that does `second` and then `first`."""
    columns = [moved((first[0], [0, 0, 0]), column) for column in zip(*second[0])]
    return [list(row) for row in zip(*columns)], moved(first, second[1])


def turned(axis, degrees):
    """The rotation about an axis through the origin."""
    norm = math.hypot(*axis)
    x, y, z = (a / norm for a in axis)
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return ([[c + x * x * (1 - c), x * y * (1 - c) - z * s, x * z * (1 - c) + y * s],
             [y * x * (1 - c) + z * s, c + y * y * (1 - c), y * z * (1 - c) - x * s],
             [z * x * (1 - c) - y * s, z * y * (1 - c) + x * s, c + z * z * (1 - c)]], [0, 0, 0])


def icosahedral():
    """The sixty rotations, closed up from one of order 5 and one of order 2."""
    golden = (1 + math.sqrt(5)) / 2
    generators = turned((0, 1, golden), 72), turned((0, 0, 1), 180)
    found = {}
    new = [IDENTITY]
    while new:
        for motion in new:
            found[tuple(round(x, 6) + 0.0 for row in motion[0] for x in row)] = motion
        new = [m for g in generators for m in (after(g, f) for f in new)
               if tuple(round(x, 6) + 0.0 for row in m[0] for x in row) not in found]
    return list(found.values())
