#!/usr/bin/python3
"""Proves from the balls and the bytes of a mesh that it is isotopic to the balls' skin.

A second opinion on papers/certificate.md: it shares no code with morskin and believes nothing it
wrote. "Proved" means that the theorem's conditions hold in exact arithmetic. Whether the vertices
lie on the skin, and the sizes [L] and [U], are verdicts of their own.
Exit code 0: proved, and the vertices on the skin; 1: not, with the first reason; 2: unreadable.
"""

import argparse
import json
import sys
import time

import numpy as np

from covering import Covering
from enclosure import Skin, down, up
from files import LARGEST, Unreadable, read_balls, read_certificate, read_mesh
from manifold import NotProved, check_manifold, components
from skin_components import Balls, Triangulation, regular_triangulation, skin_components

MOST_BALLS_ALONE = 1000  # more need a certificate with their triangulation


def are_on_skin(positions, bounds):
    """By vertex, whether |G| is below 2e-9 rho^2 and what rounding of the coordinates may change:
    a vertex moves 2^-46 of the largest or, if all are floats, 2^-24 of its distance from 0."""
    moved = np.full(len(positions), np.abs(positions).max() * 2.0**-46)
    if (positions.astype(np.float32) == positions).all():
        moved = np.linalg.norm(positions, axis=1) * 2.0**-24
    rho = np.maximum(bounds.low, 0)
    return bounds.g <= down(2e-9 * rho**2 + (2 * rho + moved) * moved)


def sizes(covering, C, Q):
    """Whether [L] and [U] hold, in words."""
    rho, below = covering.bounds.high[covering.triangles], covering.bounds.low[covering.triangles]
    rho_ab = np.maximum(rho[:, [1, 2, 0]], rho[:, [2, 0, 1]])
    short = ~(down(down(covering.edges) / 2) > up(C / Q * rho_ab)).all(1)
    large = ~(covering.R < down(C * Q * below.min(1)))
    if not (short | large).any():
        return "hold"
    return f"{short.sum()} triangles may break [L], {large.sum()} [U]"


def prove(balls, positions, triangles, witness, report):
    """Fills the report. Raises NotProved for the first condition that is not proved."""
    if not (np.abs(positions) <= LARGEST).all():
        raise NotProved("manifold: a coordinate is not finite, or too large")
    tail, head = check_manifold(len(positions), triangles)
    label = components(len(positions), tail, head)
    report["components"] = len(np.unique(label))
    skin, atoms = Skin(balls), None
    if witness.get("vertex_atoms"):
        atoms = np.array([row + [-1] * (4 - len(row)) for row in witness["vertex_atoms"]])
    covering = Covering(positions, triangles, skin)
    a, b, c = np.sort(covering.edges, axis=1).T
    report["min_angle_deg"] = np.degrees(np.arccos((b * b + c * c - a * a) / (2 * b * c)).min())
    p, q, r = (covering.corners - positions[0]).transpose(1, 0, 2)
    report["volume"] = (p * np.cross(q, r)).sum() / 6
    bounds = skin.enclose(positions, atoms)
    on_skin, report["max_G"] = are_on_skin(positions, bounds), bounds.g.max()
    report["on_skin"] = bool(on_skin.all())
    covering.prove_tube(bounds)
    report["triangles_by_pieces"] = len(covering.by_pieces)

    exact = Balls(balls)
    if "simplices" not in witness and len(balls) > MOST_BALLS_ALONE:
        raise NotProved("triangulation: so many balls need a certificate")
    simplices = witness.get("simplices") or regular_triangulation(exact)
    report["bodies"], report["voids"] = skin_components(Triangulation(exact, simplices))
    of_skin = report["bodies"] + report["voids"]
    if report["components"] != of_skin:
        raise NotProved(f"degree: {report['components']} components, {of_skin} of the skin")
    chosen = covering.prove_degree(label, witness.get("component_vertices") or [])
    report |= {"component_vertices": chosen, "homeomorphic": True}
    if report["C"] and report["Q"]:
        report["sizes"] = sizes(covering, report["C"], report["Q"])
    if not on_skin.all():
        v = on_skin.argmin()
        raise NotProved(f"on skin: at vertex {v} |G| may be {bounds.g[v]:.3g} (homeomorphic)")


def verify(balls_file, mesh_file, certificate=None, C=None, Q=None):
    """The report. Raises Unreadable."""
    start = time.time()
    try:
        balls = read_balls(balls_file)
        positions, triangles = read_mesh(mesh_file)
        counts = len(balls), len(positions), len(triangles)
        witness = read_certificate(certificate, *counts) if certificate else {}
    except (OSError, ValueError, LookupError, TypeError, StopIteration) as error:
        raise Unreadable(f"{balls_file}, {mesh_file}: {error!r}") from error
    report = {"balls_file": balls_file, "mesh_file": mesh_file, "homeomorphic": False,
              "on_skin": None, "reason": None, "C": C or witness.get("C"),
              "Q": Q or witness.get("Q"), **dict(zip(("balls", "vertices", "triangles"), counts))}
    try:
        prove(balls, positions, triangles, witness, report)
    except NotProved as reason:
        report["reason"] = str(reason)
    report["seconds"] = round(time.time() - start, 3)
    return report


def text_of(report):
    if report["reason"]:
        return f"{report['mesh_file']}: not proved: {report['reason']}"
    return ("{mesh_file}: proved homeomorphic to the skin of {balls} balls: {triangles} triangles, "
            "{components} components, |G| at most {max_G:.2g}, smallest angle {min_angle_deg:.2f} "
            "degrees, volume {volume:.6g}, {seconds} s").format(**report)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", metavar="BALLS MESH", help="any number of pairs")
    parser.add_argument("--certificate", help="the witness, of one pair")
    parser.add_argument("--list", help="a file of lines BALLS MESH [CERTIFICATE]")
    parser.add_argument("-C", type=float)
    parser.add_argument("-Q", type=float)
    parser.add_argument("--json", action="store_true", help="one report a line")
    given = parser.parse_args()
    jobs = [[*pair, given.certificate] for pair in zip(given.files[::2], given.files[1::2])]
    if len(given.files) % 2 or (given.certificate and len(jobs) != 1):
        parser.error("give pairs BALLS MESH, and a certificate with one pair only")
    is_proved = True
    try:
        if given.list:
            with open(given.list, encoding="utf-8") as file:
                jobs += [line.split() for line in file if line.strip()]
        for job in jobs:
            report = verify(*job, C=given.C, Q=given.Q)
            print(json.dumps(report, default=float) if given.json else text_of(report), flush=True)
            is_proved = is_proved and not report["reason"]
    except (Unreadable, OSError, TypeError) as error:
        print(f"verify: {error}", file=sys.stderr)
        return 2
    return 0 if is_proved else 1


if __name__ == "__main__":
    sys.exit(main())
