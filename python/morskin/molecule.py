"""Atoms, and the shortest way from them to a mesh."""

from __future__ import annotations

import inspect
import math
import os
import reprlib
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from os import PathLike
from typing import Any, Literal, Optional, Union

import numpy as np
from numpy.typing import NDArray

from . import _morskin
from ._morskin import Mesh, ReadOptions, Skin, read_molecule
from .errors import RefusedInput

Model = Literal["vdw", "sas", "ses-like", "paper"]
Radii = Union[str, "PathLike[str]", Mapping[str, float], None]
Progress = Optional[Callable[[str, Optional[float]], Any]]


@dataclass(frozen=True, eq=False, repr=False)
class Molecule:
    """Atoms of a molecule.

    positions  (n, 3) float64, Angstrom
    radii      (n,) float64, van der Waals, Angstrom
    charges    (n,) float64, elementary charges, of a PQR file; None of all others
    left_out   how many atoms of the file are not there, by reason, as in the command's report.
               Charges of atoms without a radius, "zero_radii", are not there either
    """

    positions: NDArray[np.float64]
    radii: NDArray[np.float64]
    charges: Optional[NDArray[np.float64]] = None
    left_out: Mapping[str, int] = field(default_factory=dict)

    def __len__(self) -> int:
        return len(self.radii)

    def __repr__(self) -> str:
        return f"<morskin.Molecule: {len(self)} atoms>"

    def skin(self, model: Model = "vdw", **options: Any) -> Skin:
        """The skin of these atoms; `model` and the options are those of `Skin`."""
        return Skin(self.positions, self.radii, model, **options)

    def mesh(self, *, model: Model = "vdw", probe: float = 1.4, drop_voids_below: float = 0,
             threads: Optional[int] = None, progress: Progress = None, **options: Any) -> Mesh:
        """A mesh of their skin: `model`, `probe` and `drop_voids_below` as of `Skin`, `threads` and
        `progress` of both it and the mesh; the other options are those of `Skin.mesh`."""
        skin = self.skin(model, probe=probe, drop_voids_below=drop_voids_below, threads=threads,
                         progress=progress)
        return skin.mesh(threads=threads, progress=progress, **options)


def _entry(key: str, value: float) -> str:
    shown = reprlib.repr(value)
    try:
        return f"{key}={float(value)!r}"
    except TypeError:
        raise TypeError(f"the radius of {key} must be a number, not {shown}") from None
    except (ValueError, OverflowError):
        raise RefusedInput(f"the radius of {key} is {shown}, which is no number, or too large a "
                           "one") from None


def _radii_text(radii: Radii) -> bytes | None:
    """A table as the library takes it: a name, a file, or a list of entries."""
    if isinstance(radii, Mapping):
        if not radii:
            raise ValueError("radii lists none")
        # In the list they would end an entry, and what follows would pass for another.
        if wrong := [key for key in radii if set(",=") & set(str(key))]:
            raise RefusedInput(f"radii has {wrong[0]!r}, which is neither an element nor a residue "
                               "and an atom as in ALA:CA")
        return os.fsencode(",".join(_entry(key, value) for key, value in radii.items()))
    if isinstance(radii, os.PathLike):
        # Beginning like a path it is a file, even if its name is a table's or looks like a list.
        radii = os.path.join(os.curdir, os.fsdecode(radii))
    text = None if radii is None else os.fsencode(radii)
    if text is not None and 0 in text:
        raise ValueError("embedded null byte")  # as of the other names of files
    return text


def _names(names: Sequence[str], argument: str) -> list[bytes]:
    """As bytes, since files may hold any."""
    try:
        if not isinstance(names, (str, bytes)):
            return [os.fsencode(name) for name in names]
    except TypeError:
        pass  # no names, or no sequence
    raise TypeError(f"{argument} must be a sequence of names, as in [\"A\"], not "
                    + reprlib.repr(names))


def _read_options(*, chains: Sequence[str] = (), waters: bool = False,
                  hetatms: Sequence[str] | None = None, altloc: str = "likeliest",
                  hydrogens: bool = True, model_number: int | None = None,
                  biological_assembly: str | int | None = None,
                  radii: Radii = None) -> ReadOptions:
    if not isinstance(altloc, str):
        raise TypeError("altloc must be a string, not " + reprlib.repr(altloc))
    assembly = None if biological_assembly is None else os.fsencode(str(biological_assembly))
    return ReadOptions(
        chains=_names(chains, "chains"), waters=waters,
        hetatms=None if hetatms is None else _names(hetatms, "hetatms"),
        altloc=os.fsencode(altloc), hydrogens=hydrogens,
        model_number=model_number, biological_assembly=assembly, radii=_radii_text(radii))


def read(file: str | PathLike[str], *, chains: Sequence[str] = (), waters: bool = False,
         hetatms: Sequence[str] | None = None, altloc: str = "likeliest", hydrogens: bool = True,
         model_number: int | None = None, biological_assembly: str | int | None = None,
         radii: Radii = None) -> Molecule:
    """The atoms of a PDB, mmCIF, PQR, XYZ or XYZR file, gzipped or not.

    chains               only these, by the author's names, "_" for a blank; none: all
    waters               with water
    hetatms              only these residues of HETATM records, water aside; None: all
    altloc               of alternate locations "likeliest", "all" or the letter of one
    hydrogens            with hydrogen and deuterium
    model_number         of the file's models; None: the first
    biological_assembly  the copies that make up this one, of PDB and mmCIF; None: as in the file
    radii                "elements", "bondi", "alvarez", a file of lines "C 1.7" and "ALA:CA 1.9",
                         or a dict of such; None: the file's own, else "elements". A Path is a file

    Raises UnreadableInput or RefusedInput.
    """
    return Molecule(*read_molecule(file, _read_options(
        chains=chains, waters=waters, hetatms=hetatms, altloc=altloc, hydrogens=hydrogens,
        model_number=model_number, biological_assembly=biological_assembly, radii=radii)))


def features(file: str | PathLike[str], *, density: float = 2, model: Model = "ses-like",
             probe: float = 1.4, drop_voids_below: float = math.inf, C: float = 0.4,
             Q: float | None = None, angle_goal_deg: float | None = None,
             threads: int | None = None, progress: Progress = None,
             **options: Any) -> dict[str, NDArray[Any]]:
    """What learning on surfaces takes of a molecule: the arrays of the command `features`, of the
    same mesh, by their names there (papers/features.md). "vertices" (n, 3) and "faces" (m, 3) are
    the mesh; curvatures, nearest atoms, hydropathy and more are by vertex, (n,), "atom_..." by
    atom, "laplacian_..." the parts of a scipy.sparse.csr_array. Lengths are in Angstrom. Not there
    is the origin of a file: C, Q, size, probe, metadata.

    density           vertices per square Angstrom
    model, probe      as of `Skin`
    drop_voids_below  of voids, Angstrom^3; all are left out unless told otherwise
    C, Q, angle_goal_deg, threads, progress
                      as of `Skin.mesh`
    options           those of `read`

    Raises what `read` raises, and NotCertified, with the mesh.
    """
    if unknown := options.keys() - inspect.signature(read).parameters.keys():
        raise TypeError(f"features() got an unexpected keyword argument {min(unknown)!r}")
    return _morskin.features(file, _read_options(**options), density=density, model=model,
                             probe=probe, drop_voids_below=drop_voids_below, C=C, Q=Q,
                             angle_goal_deg=angle_goal_deg, threads=threads, progress=progress)
