"""The solvent-excluded surface of a molecule, from its definition: the points at the probe's radius
from the nearest centre that a probe coming from outside can have (Richards 1977). For comparison
only; numpy and scipy.

Possible centres are sampled on the solvent-accessible surface: on the spheres, and on the circles
in which two meet, where its nearest points to the molecule's clefts lie. Cavities that a probe
cannot enter are filled.
"""

import numpy as np
from scipy import ndimage
from scipy.spatial import cKDTree

PROBE = 1.4  # Angstrom


class SolventExcludedSurface:
    """Of balls: centres, n x 3, and van der Waals radii, Angstrom."""

    def __init__(self, centres, radii, probe=PROBE, spacing=0.2, step=0.3):
        self.centres, self.radii, self.probe = centres, radii, probe
        self.reach = radii + probe
        self._make_grid(step)
        samples = np.concatenate([*self._on_spheres(spacing), *self._on_circles(spacing)])
        cells = np.rint((samples - self.low) / step).astype(int)
        near_outside = ndimage.binary_dilation(self.outside, iterations=2)
        self.samples = samples[near_outside[tuple(cells.T)]]
        self.tree = cKDTree(self.samples)
        self._measure()

    def depth(self, points):
        """By point, how deep it lies below the surface; negative above it, at least -probe."""
        return self.tree.query(points, workers=-1)[0] - self.probe

    def _make_grid(self, step):
        """The distance from the nearest ball by grid point, where it is below the probe's radius,
        and the points that a probe's centre can be at, coming from outside."""
        self.step, pad = step, self.reach.max() + 4 * step
        self.low = self.centres.min(0) - pad
        shape = np.ceil((self.centres.max(0) + pad - self.low) / step).astype(int) + 1
        self.gap = np.full(shape, self.probe)
        for z, r in zip(self.centres, self.radii):
            first = np.floor((z - r - self.probe - self.low) / step).astype(int)
            last = np.ceil((z + r + self.probe - self.low) / step).astype(int) + 1
            block = tuple(slice(*ends) for ends in zip(first, last))
            axes = [self.low[k] + step * np.arange(first[k], last[k]) - z[k] for k in range(3)]
            square = axes[0][:, None, None]**2 + axes[1][:, None]**2 + axes[2]**2
            np.minimum(self.gap[block], np.sqrt(square) - r, out=self.gap[block])
        label = ndimage.label(self.gap >= self.probe)[0]
        self.outside = label == label[0, 0, 0]

    def _neighbours(self):
        pairs = cKDTree(self.centres).query_pairs(2 * self.reach.max(), output_type="ndarray")
        both = np.concatenate([pairs, pairs[:, ::-1]])
        d = np.linalg.norm(self.centres[both[:, 0]] - self.centres[both[:, 1]], axis=1)
        both = both[d < self.reach[both].sum(1)]
        both = both[np.argsort(both[:, 0], kind="stable")]
        return np.split(both[:, 1], np.searchsorted(both[:, 0], np.arange(1, len(self.centres))))

    def _free(self, points, others):
        """The points that lie in none of the other balls, of the reach."""
        square = ((points[:, None] - self.centres[others])**2).sum(2)
        return points[(square >= self.reach[others]**2 * (1 - 1e-9)).all(1)]

    def _on_spheres(self, spacing):
        self.near = self._neighbours()
        for z, R, others in zip(self.centres, self.reach, self.near):
            count = int(4 * np.pi * R * R / spacing**2)
            k = np.arange(count) + 0.5
            polar, azimuth = np.arccos(1 - 2 * k / count), np.pi * (1 + 5**0.5) * k
            unit = np.column_stack([np.sin(polar) * np.cos(azimuth),
                                    np.sin(polar) * np.sin(azimuth), np.cos(polar)])
            yield self._free(z + R * unit, others)

    def _on_circles(self, spacing):
        for i, others in enumerate(self.near):
            for j in others[others > i]:
                e = self.centres[j] - self.centres[i]
                distance = np.linalg.norm(e)
                e /= distance
                along = (distance**2 + self.reach[i]**2 - self.reach[j]**2) / (2 * distance)
                square = self.reach[i]**2 - along**2
                if square <= 0:
                    continue
                a = np.cross(e, np.eye(3)[np.abs(e).argmin()])
                a /= np.linalg.norm(a)
                turn = np.linspace(0, 2 * np.pi, int(2 * np.pi * square**0.5 / spacing) + 4)
                ring = np.cos(turn)[:, None] * a + np.sin(turn)[:, None] * np.cross(e, a)
                yield self._free(self.centres[i] + along * e + square**0.5 * ring,
                                 others[others != j])

    def _measure(self):
        """Volume and area, and points of the surface with normals, evenly spread: those of a grid
        near the surface, moved onto it."""
        index = np.argwhere(~self.outside & (self.gap > -self.step))
        points = self.low + self.step * index
        distance, nearest = self.tree.query(points, workers=-1)
        cell = self.step**3
        deep = np.count_nonzero(~self.outside & (self.gap <= -self.step))
        self.volume = cell * (deep + np.count_nonzero(distance > self.probe))
        is_near = np.abs(distance - self.probe) < self.step
        self.area = cell * np.count_nonzero(is_near) / (2 * self.step)
        centre = self.samples[nearest[is_near]]
        self.normals = (centre - points[is_near]) / distance[is_near, None]
        self.points = centre - self.probe * self.normals
