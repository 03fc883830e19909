"""Atoms, and the shortest way from them to a mesh."""

from __future__ import annotations

from dataclasses import dataclass
from os import PathLike
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from ._morskin import Mesh, Skin, read_molecule

Model = Literal["vdw", "sas", "ses-like", "paper"]


@dataclass(frozen=True, eq=False)
class Molecule:
    """Atoms of a molecule.

    positions  (n, 3) float64, Angstrom
    radii      (n,) float64, van der Waals, Angstrom
    """

    positions: NDArray[np.float64]
    radii: NDArray[np.float64]

    def __len__(self) -> int:
        return len(self.radii)

    def skin(self, model: Model = "vdw", **options: Any) -> Skin:
        """The skin of these atoms; the options are those of `Skin`."""
        return Skin(self.positions, self.radii, model, **options)

    def mesh(self, *, model: Model = "vdw", probe: float = 1.4, drop_voids_below: float = 0,
             **options: Any) -> Mesh:
        """A mesh of their skin; the other options are those of `Skin.mesh`."""
        skin = self.skin(model, probe=probe, drop_voids_below=drop_voids_below)
        return skin.mesh(**options)


def read(file: str | PathLike[str]) -> Molecule:
    """The atoms of a PDB, mmCIF, PQR, XYZ or XYZR file, gzipped or not: of its first model,
    without water.

    Raises UnreadableInput or RefusedInput.
    """
    return Molecule(*read_molecule(file))
