"""Atoms from other packages, none of which is imported: their objects are asked for what their
own documentation names.

Radii are those of morskin's table, `van_der_waals_radius(element)`. Water is left out unless asked
for, and of alternate locations the likeliest is taken, as `morskin.read` does; of MDAnalysis's
atoms all are taken, for it has selections of its own. `read` leaves out atoms of the unknown
element X too, as files say; here they are refused, with their numbers, for X may be what another
package could not tell, and the skin would lack atoms without a word.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import groupby
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._morskin import van_der_waals_radius
from .errors import RefusedInput
from .molecule import Molecule

_FRAME = np.dtype([("frame", np.int64), ("time", np.float64), ("area", np.float64),
                   ("volume", np.float64), ("components", np.int64), ("genus", np.int64)])
# What `morskin.read` takes for water; the other packages know three or four of these names.
_WATERS = frozenset(("HOH", "DOD", "WAT", "H2O", "D2O", "SOL", "SPC", "TIP", "TP3", "TP4", "TP5",
                     "T3P", "TIP3", "TIP4", "TIP5"))


class _Site(NamedTuple):
    """An atom at one of its locations."""

    position: Any
    element: str
    name: str
    residue: str
    letter: str  # of the location, a blank where there is none
    occupancy: float


def from_gemmi(entity: Any, *, waters: bool = False) -> Molecule:
    """The atoms of a gemmi.Structure, of which it is the first model, or of a gemmi.Model."""
    try:
        model = entity if hasattr(entity, "subchains") else _first(entity)
        places = list(_gemmi_places(model))
    except (AttributeError, TypeError) as error:  # of a Chain, say, which has subchains too
        raise TypeError("from_gemmi takes a gemmi.Structure or gemmi.Model, not "
                        + type(entity).__name__) from error
    return _molecule_of(places, waters)


def _gemmi_places(model: Any) -> Iterator[list[_Site]]:
    for chain in model:
        # Where a site may be one of several residues, they have the same number.
        for _, residues in groupby(chain, key=lambda residue: str(residue.seqid)):
            yield [_Site([a.pos.x, a.pos.y, a.pos.z], a.element.name, a.name, residue.name,
                         a.altloc if a.has_altloc() else " ", a.occ)
                   for residue in residues for a in residue]


def from_biopython(entity: Any, *, waters: bool = False) -> Molecule:
    """The atoms of a Bio.PDB Structure, of which it is the first model, or of a Model, Chain or
    Residue."""
    if getattr(entity, "level", None) not in ("S", "M", "C", "R"):
        raise TypeError("from_biopython takes a Bio.PDB Structure, Model, Chain or Residue, not "
                        + type(entity).__name__)
    if entity.level == "S":
        entity = _first(entity.get_models())
    return _molecule_of(_biopython_places(entity), waters)


def _biopython_places(entity: Any) -> Iterator[list[_Site]]:
    # Where a site may be one of several residues, Bio.PDB makes one of those of one kind, of which
    # it would show the last, and leaves apart what is HETATM in part, as a cysteine and its oxide.
    for _, residues in groupby([entity] if entity.level == "R" else entity.get_residues(),
                               key=lambda residue: (residue.get_parent(), *residue.id[1:])):
        several = [one for residue in residues
                   for one in (residue.disordered_get_list() if residue.is_disordered() == 2
                               else [residue])]
        yield [_Site(a.coord, a.element, a.name, one.resname.strip(), a.altloc or " ",
                     1.0 if a.occupancy is None else a.occupancy)
               for one in several for a in one.get_unpacked_list()]


def _first(models: Iterable[Any]) -> Any:
    for model in models:
        return model
    raise RefusedInput("the structure has no model")


def _molecule_of(places: Iterable[list[_Site]], waters: bool) -> Molecule:
    """@param places  the atoms of each residue, or of all those of which one is there"""
    every = list(places)
    # As in `morskin.read` water is left out of what is more than water.
    left_out = _WATERS if not waters else frozenset()
    if all(site.residue in left_out for place in every for site in place):
        left_out = frozenset()
    sites = [site for place in every
             for site in _likeliest([s for s in place if s.residue not in left_out])]
    return _molecule([site.position for site in sites], [site.element for site in sites])


def _likeliest(place: list[_Site]) -> Iterator[_Site]:
    """Those without alternate locations, and of the likeliest residue the likeliest location of
    each. As in `morskin.read` one without a letter is a location too if its name has others."""
    lettered = {_without_deuterium(site) for site in place if site.letter != " "}
    located = [site for site in place if _without_deuterium(site) in lettered]
    if not located:
        yield from place
        return

    def rank(site: _Site) -> tuple[float, str]:
        return -site.occupancy, site.letter

    residue = min(located, key=rank).residue
    best: dict[tuple[str, int], _Site] = {}
    copies: Counter[tuple[str, str]] = Counter()  # files made by symmetry repeat name and letter
    for site in located:
        if site.residue != residue:
            continue
        name = _without_deuterium(site)
        key = name, copies[name, site.letter]
        copies[name, site.letter] += 1
        if key not in best or rank(site) < rank(best[key]):
            best[key] = site
    chosen = {id(site) for site in best.values()}
    yield from (site for site in place
                if _without_deuterium(site) not in lettered or id(site) in chosen)


def _without_deuterium(site: _Site) -> str:
    """The name of the atom, where deuterium may stand for hydrogen."""
    letters = site.name.lstrip("0123456789")
    if site.element != "D" or not letters.startswith("D"):
        return site.name
    return site.name[:-len(letters)] + "H" + letters[1:]


def from_mdanalysis(atoms: Any, *, radii: ArrayLike | None = None) -> Molecule:
    """The atoms of an MDAnalysis AtomGroup or Universe at its present frame, all of them: leave
    water and alternate locations out by a selection,
    `universe.select_atoms("protein and not altloc B")`.

    radii  (n,), Angstrom; None: by `atoms.elements`, which the topology must have
    """
    group = _group(atoms)
    if radii is None:
        return _molecule(group.positions, group.elements)
    # Masked radii stay masked, and are refused with the skin.
    found = Molecule(np.asarray(group.positions, float), np.asanyarray(radii, float))
    if found.radii.shape != (len(found.positions),):
        raise ValueError("radii must have the shape (n,), with one radius for each of the "
                         f"{len(found.positions)} atoms")
    return found


def _group(atoms: Any) -> Any:
    group = getattr(atoms, "atoms", None)
    if group is None:
        raise TypeError("an MDAnalysis AtomGroup or Universe is taken, not "
                        + type(atoms).__name__)
    return group


def over_time(atoms: Any, *, frames: slice = slice(None), radii: ArrayLike | None = None,
              **options: Any) -> NDArray[Any]:
    """Areas and volumes of an MDAnalysis AtomGroup or Universe along its trajectory.

    frames   of the trajectory, slice(0, None, 10) for every tenth
    radii    as of from_mdanalysis
    options  those of Molecule.mesh

    Returns an array with a row for each frame and the fields frame, time (ps), area (Angstrom^2),
    volume (Angstrom^3), components and genus. Raises what meshing a frame does.
    """
    if isinstance(frames, (int, np.integer)):
        raise TypeError("frames is a slice of the trajectory, as in slice(0, 1), not a number")
    rows = []
    for step in _group(atoms).universe.trajectory[frames]:
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
