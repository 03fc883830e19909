#!/usr/bin/python3
"""Proves from the balls and the bytes of a mesh that it is isotopic to the balls' skin.

A second opinion on papers/certificate.md that shares no code with morskin and believes nothing it
wrote. "Proved" means that the theorem's conditions hold in exact arithmetic. Vertices on the skin
and a bound on all angles, in degrees, are verdicts of their own.
Exit code 0: proved, and the vertices on the skin; 1: not, with the first reason; 2: unreadable."""

import argparse
import json
import os
import sys
from concurrent.futures import Future, ProcessPoolExecutor
from concurrent.futures.process import BrokenProcessPool

try:
    import numpy as np
except ImportError as missing:  # Python's own exit code of it, 1, is a verdict here
    print(f"verify.py: {missing}; install numpy (python3-numpy)", file=sys.stderr)
    sys.exit(2)

from covering import Covering
from enclosure import Skin, down, up
from files import LARGEST, read_balls, read_certificate, read_mesh
from manifold import NotProved, check_manifold, components
from skin_components import skin_components


def are_on_skin(positions, bounds):
    """By vertex, whether |G| may be below 2e-9 rho^2 and what rounding of the coordinates changes:
    a vertex moves 2^-46 of the largest or, if all are floats, 2^-24 of its distance from 0."""
    moved = np.full(len(positions), np.abs(positions).max() * 2.0**-46)
    if (positions.astype(np.float32) == positions).all():
        moved = np.linalg.norm(positions, axis=1) * 2.0**-24
    rho = np.maximum(bounds.low, 0)
    return bounds.least <= down(2e-9 * rho**2 + (2 * rho + moved) * moved)


def in_words(voids):
    return "1 void" if voids == 1 else f"{voids} voids"


def prove(balls, positions, triangles, witness, report):
    """Fills the report. Raises NotProved for the first condition that is not proved."""
    if not (np.abs(positions) <= LARGEST).all():
        raise NotProved("manifold: a coordinate is not finite, or too large")
    label = components(len(positions), *check_manifold(len(positions), triangles))
    report["components"] = len(np.unique(label))
    skin = Skin(balls)
    covering = Covering(positions, triangles, skin, witness["vertex_atoms"])
    on_skin = are_on_skin(positions, covering.bounds)
    report["on_skin"], report["max_G"] = bool(on_skin.all()), covering.bounds.g.max()
    covering.prove_tube()
    nearest = tuple(skin.least_power(skin.z)[1].tolist())
    rows = tuple(map(tuple, balls.tolist()))
    bodies, voids = skin_components(rows, witness["simplices"], nearest)
    covering.prove_degree(label, witness["component_vertices"])
    dropped = report["dropped_voids"] = witness["dropped_voids"]
    if not 0 <= dropped <= len(voids):
        raise NotProved(f"degree: the certificate leaves out {in_words(dropped)}, of {len(voids)}")
    if dropped or report["components"] != len(bodies) + len(voids):
        # A component is covered if the mesh goes round the parts on its two sides differently.
        inside, found = ([*map(covering.winding_number, points)] for points in (bodies, voids))
        if {*inside} - {1} or sorted(found) != [0] * (len(voids) - dropped) + [1] * dropped:
            raise NotProved(f"degree: not all components but those about {in_words(dropped)}")
    report["homeomorphic"] = True
    sine = down(down(down(covering.edges)).min(1) / up(2 * covering.R)).min()
    report["angle"] = float(down(np.degrees(np.arcsin(sine))))
    if not on_skin.all():
        raise NotProved(f"on skin: vertex {on_skin.argmin()} is not, but homeomorphic")


def verify(names):
    """The report on the balls, the mesh and the certificate in three files."""
    report = {"mesh": names[1], "homeomorphic": False, "on_skin": None, "reason": None}
    try:
        balls, (positions, triangles) = read_balls(names[0]), read_mesh(names[1])
        witness = read_certificate(names[2], len(balls), len(positions), len(triangles))
    except Exception as error:  # of whatever kind: the bytes are anyone's
        return {**report, "reason": f"unreadable: {error!r}"}
    try:
        prove(balls, positions, triangles, witness, report)
    except NotProved as reason:
        report["reason"] = str(reason)
    except Exception as error:  # a witness is anyone's, too
        report.update(homeomorphic=False, reason=f"not proved: {error!r}")
    return {**report, "triangles": len(triangles)}


def submitted(pool, names):
    """The future report, or what ended a process of the pool before."""
    try:
        return pool.submit(verify, names)
    except BrokenProcessPool as error:
        future = Future()
        future.set_exception(error)
        return future


def verify_all(triples):
    """The reports, in turn. A process that the system ends takes those with it that wait."""
    with ProcessPoolExecutor(min(len(triples), os.cpu_count())) as pool:
        for names, future in [(names, submitted(pool, names)) for names in triples]:
            try:
                yield future.result()
            except BrokenProcessPool:
                yield {"mesh": names[1], "homeomorphic": False, "on_skin": None,
                       "reason": "not proved: a process was ended; is there memory?"}


def main():
    parser = argparse.ArgumentParser(description=__doc__, fromfile_prefix_chars="@")
    parser.add_argument("files", nargs="+", help="triples; @FILE for the lines of a file",
                        metavar="BALLS MESH CERTIFICATE")
    parser.add_argument("--voids-dropped", action="store_true", help="prove meshes of the skin "
                        "without as many voids as their certificates leave out")
    try:
        arguments, exit_code = parser.parse_args(), 0
    except (UnicodeDecodeError, RecursionError) as error:
        parser.error(f"a list of names is no text, or names itself: {error}")
    names = arguments.files
    if len(names) % 3:
        parser.error("a mesh takes three files")
    for report in verify_all([*zip(names[::3], names[1::3], names[2::3])]):
        if report["homeomorphic"] and report["dropped_voids"] and not arguments.voids_dropped:
            # That is no witness, but another claim: a skin without these voids.
            report.update(homeomorphic=False, reason="degree: the certificate leaves out "
                          f"{in_words(report['dropped_voids'])}; see --voids-dropped")
        print(json.dumps(report, default=float), flush=True)
        reason = report["reason"] or ""
        exit_code = max(exit_code, 2 if reason.startswith("unreadable") else bool(reason))
    return int(exit_code)


if __name__ == "__main__":
    try:
        sys.exit(main())
    except OSError as error:  # a verdict could not be printed, or no process be had for one
        print(f"verify.py: {error}", file=sys.stderr)
        os._exit(2)  # the usual end would try to print again
