#!/usr/bin/python3
"""Proves from the balls and the bytes of a mesh that it is isotopic to the balls' skin.

A second opinion on papers/certificate.md: it shares no code with morskin and believes nothing it
wrote. "proved" means that the theorem's conditions hold in exact arithmetic. Whether the vertices
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
from files import Unreadable, read_balls, read_certificate, read_mesh
from manifold import NotProved, check_manifold, components
from skin_components import Balls, Triangulation, regular_triangulation, skin_components

MOST_BALLS_ALONE = 400  # beyond, the triangulation must come from a certificate


def off_skin(positions, bounds):
    """The first vertex with |G| above 2e-9 rho^2 and what rounding of the coordinates may change:
    each by 2^-46 of the largest, or, if all are floats, each by 2^-24 of itself."""
    single = positions.astype(np.float32).astype(float)
    moved = np.full(len(positions), np.abs(positions).max() * 2.0**-46)
    if (single == positions).all():
        moved = np.linalg.norm(positions, axis=1) * 2.0**-24
    rho = np.maximum(bounds.low, 0)
    far = np.flatnonzero(~(bounds.g <= down(2e-9 * rho**2 + (2 * rho + moved) * moved)))
    return int(far[0]) if len(far) else None


def broken_size(covering, bounds, C, Q):
    """The first edge or triangle that may break [L] or [U]."""
    t, R, edges = covering.triangles, covering.shape.R, covering.shape.edges
    largest = np.maximum(bounds.high[t][:, [1, 2, 0]], bounds.high[t][:, [2, 0, 1]])
    short = ~(down(down(edges) / 2) > up(C / Q * largest)).all(1)
    if short.any():
        return f"[L]: triangle {short.argmax()} has too short an edge"
    large = ~(R < down(C * Q * bounds.low[t].min(1)))
    return f"[U]: triangle {large.argmax()} is too large" if large.any() else None


def shape_of(p):
    """Smallest angle in degrees and volume: plain floating point, no part of the proof."""
    arms = [p[:, (k + 1) % 3] - p[:, k] for k in range(3)]
    a, b = np.concatenate(arms), -np.concatenate(arms[2:] + arms[:2])
    angles = np.arctan2(np.linalg.norm(np.cross(a, b), axis=1), (a * b).sum(1))
    p = p - p.mean((0, 1))
    volume = (p[:, 0] * np.cross(p[:, 1], p[:, 2])).sum() / 6
    return float(np.degrees(angles.min())), float(volume)


def prove(balls, positions, triangles, witness, report):
    """Fills the report. Raises NotProved for the first condition that is not proved."""
    if not np.isfinite(positions).all() or np.abs(positions).max(initial=0) > 2.0**100:
        raise NotProved("manifold: a coordinate is not finite, or too large")
    check_manifold(len(positions), triangles)
    tail, head = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    label = components(len(positions), tail, head)
    report["components"] = len(np.unique(label))
    report["min_angle_deg"], report["volume"] = shape_of(positions[triangles])

    skin, atoms = Skin(balls), None
    if witness.get("vertex_atoms"):
        atoms = np.array([row + [-1] * (4 - len(row)) for row in witness["vertex_atoms"]])
    bounds = skin.enclose(positions, atoms)
    first_off = off_skin(positions, bounds)
    report["on_skin"] = first_off is None
    report["max_G"] = float(bounds.g.max())
    covering = Covering(positions, triangles, skin, bounds)
    report["triangles_by_pieces"] = len(covering.by_pieces)
    report["margins"] = {claim: float(margin) for claim, margin in covering.margins.items()}

    exact = Balls(balls)
    simplices = witness.get("simplices")
    if simplices is None:
        if len(balls) > MOST_BALLS_ALONE:
            raise NotProved("triangulation: so many balls need a certificate")
        simplices = regular_triangulation(exact)
    bodies, voids = skin_components(Triangulation(exact, simplices))
    report["bodies"], report["voids"] = bodies, voids
    if report["components"] != bodies + voids:
        raise NotProved(f"degree: {report['components']} components, {bodies + voids} of the skin")
    wanted = witness.get("component_vertices") or []
    report["component_vertices"] = covering.prove_degree(label, wanted)
    report["homeomorphic"] = True
    C, Q = report["C"], report["Q"]
    report["sizes"] = broken_size(covering, bounds, C, Q) or "hold" if C and Q else None
    if first_off is not None:
        raise NotProved(f"on skin: vertex {first_off} has |G| up to {bounds.g[first_off]:.3g}")


def verify(balls_file, mesh_file, certificate=None, C=None, Q=None):
    """The report. Raises Unreadable."""
    start = time.time()
    report = {"balls_file": balls_file, "mesh_file": mesh_file, "homeomorphic": False,
              "on_skin": None, "reason": None, "C": C, "Q": Q}
    try:
        balls = read_balls(balls_file)
        positions, triangles = read_mesh(mesh_file)
        report |= {"balls": len(balls), "vertices": len(positions), "triangles": len(triangles)}
        witness = {} if certificate is None else read_certificate(
            certificate, len(balls), len(positions), len(triangles))
    except (OSError, ValueError, IndexError, KeyError, TypeError, OverflowError) as error:
        raise Unreadable(f"{balls_file}, {mesh_file}: {error!r}") from error
    report["C"], report["Q"] = C or witness.get("C"), Q or witness.get("Q")
    try:
        prove(balls, positions, triangles, witness, report)
    except NotProved as reason:
        report["reason"] = str(reason)
    report["seconds"] = round(time.time() - start, 3)
    return report


def text_of(report):
    if report["reason"]:
        verdict = f"NOT PROVED: {report['reason']}"
        if report["homeomorphic"]:
            verdict = f"homeomorphic to the skin, but {report['reason']}"
        return f"{report['mesh_file']}: {verdict}"
    return (f"{report['mesh_file']}: proved homeomorphic to the skin of {report['balls']} balls: "
            f"{report['triangles']} triangles, {report['components']} components, |G| at most "
            f"{report['max_G']:.2g}, smallest angle {report['min_angle_deg']:.2f} degrees, volume "
            f"{report['volume']:.6g}, sizes {report['sizes']}, {report['seconds']:.1f} s")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("files", nargs="*", metavar="BALLS MESH", help="any number of pairs")
    parser.add_argument("--certificate", help="the witness of a single pair")
    parser.add_argument("--list", help="file with lines BALLS MESH [CERTIFICATE]")
    parser.add_argument("-C", type=float)
    parser.add_argument("-Q", type=float)
    parser.add_argument("--json", action="store_true", help="one report a line")
    arguments = parser.parse_args()
    jobs = [[*pair] for pair in zip(arguments.files[::2], arguments.files[1::2])]
    if len(arguments.files) % 2 or (arguments.certificate and len(jobs) != 1):
        parser.error("give pairs BALLS MESH, and a certificate with one pair only")
    if arguments.certificate:
        jobs[0].append(arguments.certificate)
    worst = 0
    try:
        if arguments.list:
            with open(arguments.list, encoding="utf-8") as file:
                jobs += [line.split() for line in file if line.strip()]
        for job in jobs:
            report = verify(*job, C=arguments.C, Q=arguments.Q)
            print(json.dumps(report) if arguments.json else text_of(report), flush=True)
            worst = max(worst, report["reason"] is not None)
    except (Unreadable, OSError, TypeError) as error:
        print(f"verify: {error}", file=sys.stderr)
        return 2
    return worst


if __name__ == "__main__":
    sys.exit(main())
