"""Reads balls, meshes and certificates."""

import json
import math

import numpy as np

LARGEST = 2.0**100  # of coordinates and weights: no product can overflow
TYPES = {"uchar": "u1", "uint8": "u1", "int": "<i4", "int32": "<i4", "uint": "<u4",
         "uint32": "<u4", "float": "<f4", "float32": "<f4", "double": "<f8", "float64": "<f8"}


class Unreadable(Exception):
    """The input is no balls, no mesh or no certificate."""


def read_balls(path):
    """The rows x y z w; w is the weight, Angstrom^2."""
    with open(path, encoding="utf-8") as file:
        lines = [line.split() for line in file]
    rows = [[float(word) for word in words] for words in lines if words and words[0][0] != "#"]
    if not rows or not all(len(row) == 4 and all(
            math.isfinite(x) and abs(x) <= LARGEST for x in row) for row in rows):
        raise Unreadable(f"{path}: not one ball x y z w on each line, or too large")
    return np.array(rows)


def read_mesh(path):
    """Positions, V x 3, and triangles, T x 3."""
    with open(path, "rb") as file:
        data = file.read()
    if data[:3] == b"OFF":
        words = data.split()
        positions, faces = from_text(words[4:], int(words[1]), "xyz", int(words[2]))
    else:
        positions, faces = read_ply(data)
    corners = faces[:, 1:]
    if not ((faces[:, 0] == 3).all() and (corners >= 0).all() and (corners < len(positions)).all()):
        raise Unreadable(f"{path}: a face is no triangle, or names a vertex that is not there")
    return positions, corners


def from_text(words, vertices, names, faces):
    cut = vertices * len(names)
    table = np.array([float(word) for word in words[:cut]]).reshape(vertices, len(names))
    rows = np.array([int(word) for word in words[cut:cut + 4 * faces]], dtype=np.int64)
    return table[:, [names.index(axis) for axis in "xyz"]], rows.reshape(faces, 4)


def read_ply(data):
    end = data.index(b"end_header")
    lines = [line.split() for line in data[:end].decode("ascii").splitlines()]
    body = data.index(b"\n", end) + 1
    style = next(words[1] for words in lines if words[0] == "format")
    counts = {words[1]: int(words[2]) for words in lines if words[0] == "element"}
    fields = [words[1:] for words in lines if words[0] == "property" and words[1] != "list"]
    lists = [words[2:4] for words in lines if words[0] == "property" and words[1] == "list"]
    if lines[0] != ["ply"] or list(counts) != ["vertex", "face"] or len(lists) != 1:
        raise Unreadable("not a PLY file of vertices and triangles")
    names = [name for _, name in fields]
    if style == "ascii":
        return from_text(data[body:].split(), counts["vertex"], names, counts["face"])
    if style != "binary_little_endian":
        raise Unreadable("the PLY format must be ascii or binary_little_endian")
    point = np.dtype([(name, TYPES[kind]) for kind, name in fields])
    face = np.dtype([("count", TYPES[lists[0][0]]), ("corners", TYPES[lists[0][1]], 3)])
    table = np.frombuffer(data, point, counts["vertex"], body)
    rows = np.frombuffer(data, face, counts["face"], body + table.nbytes)
    positions = np.column_stack([table[axis].astype(float) for axis in "xyz"])
    return positions, np.column_stack([rows["count"], rows["corners"].astype(np.int64)])


def read_certificate(path, balls, vertices, triangles):
    """The witness, with the right sizes and indices that exist; no more is believed of it."""
    with open(path, encoding="utf-8") as file:
        witness = json.load(file)
    head = [witness.get(key) for key in ("format", "balls", "vertices", "triangles")]
    if head != ["morskin-certificate-1", balls, vertices, triangles]:
        raise Unreadable(f"{path}: not the certificate of these balls and this mesh")
    atoms, chosen = witness.get("vertex_atoms"), witness.get("component_vertices") or []
    lists = [(i, balls) for simplex in witness["simplices"] + (atoms or []) for i in simplex]
    if not (all(type(i) is int and 0 <= i < n for i, n in lists + [(v, vertices) for v in chosen])
            and (not atoms or [1 <= len(row) <= 4 for row in atoms] == [True] * vertices)):
        raise Unreadable(f"{path}: an index is wrong")
    return witness
