"""The mesh as a closed oriented 2-manifold, and its components."""

import numpy as np


class NotProved(Exception):
    """The first condition that does not hold or could not be proved."""


def components(count, a, b):
    """By node, the smallest node joined to it by the edges a - b."""
    label = np.arange(count)
    while True:
        roots = np.sort(np.stack([label[a], label[b]]), axis=0)
        differ = roots[0] != roots[1]
        if not differ.any():
            return label
        label[roots[1, differ]] = roots[0, differ]  # a root gets a smaller label: no cycles
        while (label[label] != label).any():
            label = label[label]


def check_manifold(vertices, triangles):
    """Every vertex is used, every edge occurs once in each direction, and the triangles at each
    vertex form one fan."""
    if not len(triangles):
        raise NotProved("manifold: there are no triangles")
    unused = np.flatnonzero(np.bincount(triangles.ravel(), minlength=vertices) == 0)
    if len(unused):
        raise NotProved(f"manifold: vertex {unused[0]} is unused")
    tail, head = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    if (tail == head).any():
        raise NotProved(f"manifold: triangle {(tail == head).argmax() // 3} repeats a corner")
    edge, twin = tail * vertices + head, head * vertices + tail
    order = np.argsort(edge, kind="stable")
    ascending = edge[order]
    again = np.flatnonzero(ascending[1:] == ascending[:-1])
    if len(again):
        a, b = divmod(int(ascending[again[0]]), vertices)
        raise NotProved(f"manifold: the edge from {a} to {b} occurs twice in one direction")
    place = np.minimum(np.searchsorted(ascending, twin), len(edge) - 1)
    lonely = np.flatnonzero(ascending[place] != twin)
    if len(lonely):
        raise NotProved(f"manifold: the edge {tail[lonely[0]]} - {head[lonely[0]]} has one side")
    # The next corner at the same vertex starts with the twin of the half-edge that ends there.
    before = np.arange(len(edge)).reshape(-1, 3)[:, [2, 0, 1]].ravel()
    following = order[place][before]
    fans = components(len(edge), np.arange(len(edge)), following)
    per_vertex = np.bincount(tail[np.unique(fans)], minlength=vertices)
    if (per_vertex != 1).any():
        raise NotProved(f"manifold: the triangles at vertex {(per_vertex != 1).argmax()} "
                        "form several fans")
