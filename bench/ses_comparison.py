"""The mesh of a skin beside the solvent-excluded surface of the same balls; numpy and scipy."""

import sys
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from ses import SolventExcludedSurface

sys.path.insert(0, str(Path(__file__).resolve().parent.parent / "certify" / "verify"))
from files import read_mesh  # noqa: E402


def check_on_two_balls():
    """The surface of two equal balls is known: two caps and a piece of a torus. Raises ValueError
    where a point lies more than 0.01 Angstrom off it, or the area is off by 1 %."""
    r, p, half = 1.7, 1.4, 1.5
    reach = r + p
    found = SolventExcludedSurface(np.array([[0, 0, -half], [0, 0, half]]), np.array([r, r]))
    ring, angle = np.sqrt(reach**2 - half**2), np.arcsin(half / reach)
    across, along = np.hypot(*found.points.T[:2]), np.abs(found.points[:, 2])
    torus, ball = p - np.hypot(across - ring, along), np.hypot(across, along - half) - r
    off = np.abs(np.where(along < half * p / reach, torus, ball)).max()
    area = 4 * np.pi * r * (r + r * half / reach) + 4 * np.pi * p * (ring * angle -
                                                                     p * np.sin(angle))
    if not (off < 0.01 and abs(found.area / area - 1) < 0.01):
        raise ValueError(f"points are {off} Angstrom off, the area is {found.area}, not {area}")


class Comparison:
    """With the balls of an XYZR file.

    @param charges  by index of those balls that have one"""

    def __init__(self, path, charges):
        table = np.loadtxt(path, ndmin=2)
        self.ses, self.charges = SolventExcludedSurface(table[:, :3], table[:, 3]), charges

    def figures(self, report, mesh):
        """By column of ses_like.py."""
        return compared(self.ses, self.charges, report, *read_mesh(mesh))


def energy(centres, charges, points, normals, weights):
    """Generalised Born, kcal/mol, in water: 1 / alpha^3 is the integral of r . n / |r|^6 over the
    surface, divided by 4 pi (Grycuk 2003; Still and others 1990)."""
    z, q = centres[[*charges]], np.array([*charges.values()])
    arms = points[None] - z[:, None]
    inverse = ((arms * normals).sum(2) / (arms**2).sum(2)**3 * weights).sum(1) / (4 * np.pi)
    alpha = np.maximum(inverse, 1e-9)**(-1 / 3)
    square = ((z[:, None] - z)**2).sum(2)
    product = alpha[:, None] * alpha
    f = np.sqrt(square + product * np.exp(-square / (4 * product)))
    return -332.06 / 2 * (1 - 1 / 78.5) * (q[:, None] * q / f).sum()


def mesh_samples(positions, triangles):
    """The vertices' normals and shares of the area."""
    a, b, c = positions[triangles].transpose(1, 0, 2)
    cross = np.cross(b - a, c - a)
    normals = np.zeros_like(positions)
    for k in range(3):
        np.add.at(normals, triangles[:, k], cross)
    areas = np.linalg.norm(cross, axis=1) / 2
    weights = np.bincount(triangles.ravel(), np.repeat(areas / 3, 3), len(positions))
    return normals / np.linalg.norm(normals, axis=1)[:, None], weights


def quantile_95(values, weights):
    order = np.argsort(values)
    total = np.cumsum(weights[order])
    return values[order][np.searchsorted(total, 0.95 * total[-1])]


def distances_to_mesh(points, positions, normals):
    """To the nearest vertex, but only across its tangent plane where that is nearly all: edges are
    some 0.2 Angstrom long, so a vertex stands up to 0.12 aside."""
    distance, nearest = cKDTree(positions).query(points, workers=-1)
    across = np.abs(((points - positions[nearest]) * normals[nearest]).sum(1))
    return np.maximum(across, distance - 0.12)


def compared(ses, charges, report, positions, triangles):
    normals, weights = mesh_samples(positions, triangles)
    to_ses = np.abs(ses.depth(positions))
    from_ses = distances_to_mesh(ses.points, positions, normals)
    even = np.full(len(ses.points), ses.area / len(ses.points))
    ratio = 1.0
    if charges:
        ratio = (energy(ses.centres, charges, positions, normals, weights) /
                 energy(ses.centres, charges, ses.points, ses.normals, even))
    return {"to_ses_mean": np.average(to_ses, weights=weights),
            "to_ses_95": quantile_95(to_ses, weights), "from_ses_mean": from_ses.mean(),
            "from_ses_95": quantile_95(from_ses, even), "area": report["area"] / ses.area,
            "volume": report["volume"] / ses.volume, "energy": ratio, "genus": report["genus"]}
