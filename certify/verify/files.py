"""Reads balls, meshes and certificates. Raises various errors where they are none."""

import json
import re
from pathlib import Path

import numpy as np

LARGEST = 2.0**100  # of coordinates and weights: no product can overflow
PLY = re.compile(rb"ply\nformat binary_little_endian 1.0\n(?:comment.*\n)*element vertex (\d+)\n"
                 rb"((?:property [a-z]+ \w+\n)+)element face (\d+)\nproperty list uchar int "
                 rb"vertex_indices\n((?:property [a-z]+ \w+\n)*)end_header\n")
NUMBERS = {b"double": "<f8", b"float": "<f4", b"int": "<i4", b"uchar": "u1"}


def read_balls(path):
    """The rows x y z w of an XYZW file; w is the weight, Angstrom^2."""
    balls = np.loadtxt(path, ndmin=2)
    if balls.shape[1] != 4 or not (np.abs(balls) <= LARGEST).all():
        raise ValueError(f"{path}: not one ball x y z w on each line, or too large")
    return balls


def fields(properties):
    """Names and NumPy types of PLY's scalar properties."""
    rows = [line.split() for line in properties.splitlines()]
    return [(name.decode(), NUMBERS[kind]) for _, kind, name in rows]


def read_mesh(path):
    """Positions, V x 3, and triangles, T x 3, of an OFF file or a PLY file like morskin's,
    where more data may stand beside both."""
    data = Path(path).read_bytes()
    header = PLY.match(data)
    if header:
        vertices, at_vertices, faces, at_faces = header.groups()
        table = np.frombuffer(data, fields(at_vertices), int(vertices), header.end())
        positions = np.column_stack([table["x"], table["y"], table["z"]]).astype(float)
        list_and_more = [("size", "u1"), ("corners", "<i4", 3)] + fields(at_faces)
        at = header.end() + table.nbytes
        table = np.frombuffer(data, list_and_more, int(faces), at)
        if data[at + table.nbytes:].strip(b"\0 \t\r\n"):
            raise ValueError(f"{path}: goes on behind the last face that its header counts")
        faces = np.column_stack([table["size"], table["corners"]]).astype(np.int64)
    else:
        text = re.sub(rb"#.*", b"", data)
        off, vertices, faces, _, *words = text.split()
        if off != b"OFF" or b"_" in text:  # Python alone takes 1_0 for 10
            raise ValueError(f"{path}: neither OFF nor PLY like morskin's")
        cut = 3 * int(vertices)
        if cut < 0:  # which would count from the end
            raise ValueError(f"{path}: fewer than no vertices")
        positions = np.array([float(word) for word in words[:cut]]).reshape(-1, 3)
        faces = np.array([int(word) for word in words[cut:]]).reshape(int(faces), 4)
    corners = faces[:, 1:]
    if not ((faces[:, 0] == 3).all() and (corners >= 0).all() and (corners < len(positions)).all()):
        raise ValueError(f"{path}: a face is no triangle, or names a vertex that is not there")
    return positions, corners


def read_certificate(path, balls, vertices, triangles):
    """The witness, with the right sizes and indices that exist; no more is believed of it. The
    balls of a vertex are four, one of them several times if there are fewer."""
    witness = json.loads(Path(path).read_text(encoding="utf-8"))
    head = [witness[key] for key in ("format", "balls", "vertices", "triangles")]
    if head != ["morskin-certificate-1", balls, vertices, triangles]:
        raise ValueError(f"{path}: not the certificate of these balls and this mesh")
    simplices = tuple(tuple(int(i) for i in s) for s in witness["simplices"])
    rows = [(row * 4)[:4] for row in witness["vertex_atoms"]]
    atoms = np.array(rows, dtype=np.int64).reshape(len(rows), 4)
    chosen = [int(v) for v in witness["component_vertices"]]
    indices = [i for s in simplices for i in s] + [*atoms.min(1), *atoms.max(1)]
    if not (atoms.shape == (vertices, 4) and all(0 <= i < balls for i in indices) and
            all(0 <= v < vertices for v in chosen)):
        raise ValueError(f"{path}: an index is wrong")
    return {"simplices": simplices, "vertex_atoms": atoms, "component_vertices": chosen,
            "dropped_voids": int(witness["dropped_voids"])}
