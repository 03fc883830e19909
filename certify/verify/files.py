"""Reads balls, meshes and certificates."""

import json
import math

import numpy as np

# Coordinates and weights beyond this are refused: no product below can then overflow.
LARGEST = 2.0**100

PLY_TYPES = {"char": "i1", "uchar": "u1", "short": "i2", "ushort": "u2", "int": "i4", "uint": "u4",
             "float": "f4", "double": "f8", "int8": "i1", "uint8": "u1", "int16": "i2",
             "uint16": "u2", "int32": "i4", "uint32": "u4", "float32": "f4", "float64": "f8"}


class Unreadable(Exception):
    """The input is no balls, no mesh or no certificate."""


def read_balls(path):
    """The rows x y z w; w is the weight, Angstrom^2."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split() for line in file]
    rows = [[float(word) for word in words] for words in lines if words and words[0][0] != "#"]
    if not rows or any(len(row) != 4 for row in rows):
        raise Unreadable(f"{path}: not one ball x y z w on each line")
    if not all(math.isfinite(number) and abs(number) <= LARGEST for row in rows for number in row):
        raise Unreadable(f"{path}: a number is not finite or too large")
    return np.array(rows)


def read_mesh(path):
    """Positions, V x 3, and triangles, T x 3."""
    with open(path, "rb") as file:
        data = file.read()
    positions, triangles = (read_ply if data[:3] == b"ply" else read_off)(data)
    if len(triangles) and not (0 <= triangles.min() and triangles.max() < len(positions)):
        raise Unreadable(f"{path}: a triangle names a vertex that is not there")
    return positions, triangles


def read_off(data):
    words = data.split()
    if words[0] != b"OFF":
        raise Unreadable("neither PLY nor OFF")
    vertices, faces = int(words[1]), int(words[2])
    body = words[4:]
    return positions_of(body[:3 * vertices], 3), triangles_of(body[3 * vertices:], faces, 4)


def positions_of(words, width, axes=(0, 1, 2)):
    return np.array([float(word) for word in words]).reshape(-1, width)[:, axes]


def triangles_of(words, count, width):
    rows = np.array([int(word) for word in words[:width * count]], dtype=np.int64)
    rows = rows.reshape(count, width)
    if not (rows[:, 0] == 3).all():
        raise Unreadable("a face is no triangle")
    return rows[:, 1:4]


def read_ply(data):
    end = data.index(b"end_header")
    body = data.index(b"\n", end) + 1
    style, elements = None, []
    for line in data[:end].decode("ascii").splitlines():
        words = line.split()
        if words[0] == "format":
            style = words[1]
        elif words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property":
            elements[-1][2].append(words[1:])
    if [name for name, _, _ in elements[:2]] != ["vertex", "face"]:
        raise Unreadable("the PLY file must begin with vertices and faces")
    (_, vertices, fields), (_, faces, lists) = elements[:2]
    names = [field[-1] for field in fields]
    if len(lists) != 1 or lists[0][0] != "list":
        raise Unreadable("a face must have one list of vertices and nothing else")
    axes = [names.index(axis) for axis in "xyz"]
    if style == "ascii":
        words = data[body:].split()
        cut = vertices * len(names)
        return positions_of(words[:cut], len(names), axes), triangles_of(words[cut:], faces, 4)
    if style != "binary_little_endian":
        raise Unreadable("the PLY format must be ascii or binary_little_endian")
    point = np.dtype([(name, "<" + PLY_TYPES[kind]) for kind, name in fields])
    face = np.dtype([("count", "<" + PLY_TYPES[lists[0][1]]),
                     ("corners", "<" + PLY_TYPES[lists[0][2]], 3)])
    table = np.frombuffer(data, point, vertices, body)
    rows = np.frombuffer(data, face, faces, body + table.nbytes)
    if not (rows["count"] == 3).all():
        raise Unreadable("a face is no triangle")
    positions = np.stack([table[axis].astype(float) for axis in "xyz"], axis=1)
    return positions, rows["corners"].astype(np.int64)


def read_certificate(path, balls, vertices, triangles):
    """The witness, of the right sizes and with indices that exist; no more is believed of it."""
    with open(path, encoding="utf-8") as file:
        witness = json.load(file)
    if not isinstance(witness, dict) or witness.get("format") != "morskin-certificate-1":
        raise Unreadable(f"{path}: not a morskin-certificate-1")
    if [witness.get(key) for key in ("balls", "vertices", "triangles")] != [
            balls, vertices, triangles]:
        raise Unreadable(f"{path}: the certificate of other balls or another mesh")

    def are_indices(rows, end):
        return isinstance(rows, list) and all(
            isinstance(row, list) and 1 <= len(row) <= 4 and
            all(type(i) is int and 0 <= i < end for i in row) for row in rows)

    atoms = witness.get("vertex_atoms")
    if not (are_indices(witness.get("simplices"), balls) and
            (atoms is None or are_indices(atoms, balls) and len(atoms) == vertices) and
            (not witness.get("component_vertices") or
             are_indices([[v] for v in witness["component_vertices"]], vertices))):
        raise Unreadable(f"{path}: a list of the certificate is malformed")
    return witness
