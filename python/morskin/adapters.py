"""Atoms from other packages, none of which is imported: their objects are asked for what their
own documentation names.

Radii are those of morskin's table, `van_der_waals_radius(element)`. Water is left out unless asked
for, and of alternate locations the likeliest is taken, as `morskin.read` does.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._morskin import van_der_waals_radius
from .errors import RefusedInput
from .molecule import Molecule

_FRAME = np.dtype([("frame", np.int64), ("time", np.float64), ("area", np.float64),
                   ("volume", np.float64), ("components", np.int64), ("genus", np.int64)])


def from_gemmi(entity: Any, *, waters: bool = False) -> Molecule:
    """The atoms of a gemmi.Structure, of which it is the first model, or of a gemmi.Model."""
    model = entity if hasattr(entity, "subchains") else entity[0]
    atoms = list(_gemmi_atoms(model, waters))
    return _molecule([[a.pos.x, a.pos.y, a.pos.z] for a in atoms], [a.element.name for a in atoms])


def _gemmi_atoms(model: Any, waters: bool) -> Iterator[Any]:
    for chain in model:
        kept = (residue for residue in chain if waters or not residue.is_water())
        # Where a site may be one of several residues, they have the same number.
        for _, residues in groupby(kept, key=lambda residue: str(residue.seqid)):
            yield from _likeliest([(residue.name, atom) for residue in residues
                                   for atom in residue])


def _likeliest(site: list[tuple[str, Any]]) -> Iterator[Any]:
    """The atoms of a site: those without alternate locations, and of the likeliest residue the
    likeliest location of each."""
    located = [(residue, atom) for residue, atom in site if atom.has_altloc()]
    if not located:
        yield from (atom for _, atom in site)
        return

    def rank(atom: Any) -> tuple[float, int]:
        return atom.occ, -ord(atom.altloc)

    name = max(located, key=lambda one: rank(one[1]))[0]
    best: dict[str, Any] = {}
    for residue, atom in located:
        key = _without_deuterium(atom)
        if residue == name and (key not in best or rank(atom) > rank(best[key])):
            best[key] = atom
    chosen = {id(atom) for atom in best.values()}
    yield from (atom for _, atom in site if not atom.has_altloc() or id(atom) in chosen)


def _without_deuterium(atom: Any) -> str:
    """The name of the site, where deuterium may stand for hydrogen."""
    name: str = atom.name
    return name.replace("D", "H", 1) if atom.element.name == "D" else name


def from_biopython(entity: Any, *, waters: bool = False) -> Molecule:
    """The atoms of a Bio.PDB Structure, of which it is the first model, or of a Model, Chain or
    Residue."""
    if entity.level == "S":
        entity = next(entity.get_models())
    atoms = list(_biopython_atoms(entity, waters))
    return _molecule([a.coord for a in atoms], [a.element for a in atoms])


def _biopython_atoms(entity: Any, waters: bool) -> Iterator[Any]:
    for residue in [entity] if entity.level == "R" else entity.get_residues():
        if residue.is_disordered() == 2:  # one of several at a site; Bio.PDB shows the last
            residue = max(residue.disordered_get_list(),
                          key=lambda one: max(atom.occupancy for atom in one))
        # Bio.PDB knows no heavy water.
        if waters or not (residue.id[0] == "W" or residue.resname.strip() == "DOD"):
            yield from residue


def from_mdanalysis(atoms: Any, *, radii: ArrayLike | None = None) -> Molecule:
    """The atoms of an MDAnalysis AtomGroup or Universe at its present frame, all of them: leave
    water out by a selection, `universe.select_atoms("protein")`.

    radii  (n,), Angstrom; None: by `atoms.elements`, which the topology must have
    """
    group = atoms.atoms
    if radii is None:
        return _molecule(group.positions, group.elements)
    return Molecule(np.asarray(group.positions, float), np.asarray(radii, float))


def over_time(atoms: Any, *, frames: slice = slice(None), radii: ArrayLike | None = None,
              **options: Any) -> NDArray[Any]:
    """Areas and volumes of an MDAnalysis AtomGroup or Universe along its trajectory.

    frames   of the trajectory, slice(0, None, 10) for every tenth
    radii    as of from_mdanalysis
    options  those of Molecule.mesh

    Returns an array with a row for each frame and the fields frame, time (ps), area (Angstrom^2),
    volume (Angstrom^3), components and genus. Raises what meshing a frame does.
    """
    rows = []
    for step in atoms.universe.trajectory[frames]:
        found = from_mdanalysis(atoms, radii=radii).mesh(**options).certificate
        rows.append((step.frame, step.time, found.area, found.volume, found.components,
                     found.genus))
    return np.array(rows, dtype=_FRAME)


def _molecule(positions: ArrayLike, elements: Sequence[str]) -> Molecule:
    """Raises RefusedInput for an element without a radius."""
    table = {element: van_der_waals_radius(element) for element in set(elements)}
    unknown = sorted(element for element, radius in table.items() if radius is None)
    if unknown:
        error = RefusedInput(f"no van der Waals radius is known of {unknown[0]!r}")
        error.atoms = tuple(i for i, element in enumerate(elements) if element in unknown)
        raise error
    radii = np.array([table[element] for element in elements], float)
    return Molecule(np.asarray(positions, float).reshape(-1, 3), radii)
