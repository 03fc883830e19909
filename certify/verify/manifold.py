"""The mesh as a closed oriented 2-manifold, and its components."""

import numpy as np


class NotProved(Exception):
    """The first condition that does not hold or could not be proved."""


def components(count, a, b):
    """By node, the smallest node that the edges a - b join it to."""
    label = np.arange(count)
    while True:
        low, high = np.minimum(label[a], label[b]), np.maximum(label[a], label[b])
        if (low == high).all():
            return label
        label[high[low < high]] = low[low < high]  # roots, to smaller labels: no cycles
        while (label[label] != label).any():
            label = label[label]


def check_manifold(vertices, triangles):
    """Every vertex is used, every edge occurs once in each direction, and the triangles at each
    vertex form one fan. Returns the edges' ends."""
    tail, head = triangles.ravel(), triangles[:, [1, 2, 0]].ravel()
    uses = np.bincount(tail, minlength=vertices)
    if not vertices or not uses.all():
        raise NotProved(f"manifold: vertex {uses.argmin() if vertices else 0} is unused")
    if (tail == head).any():
        raise NotProved(f"manifold: triangle {(tail == head).argmax() // 3} repeats a corner")
    order = np.argsort(tail * vertices + head)
    edges, twins = (tail * vertices + head)[order], head * vertices + tail
    again = np.flatnonzero(edges[1:] == edges[:-1])
    if len(again):
        a, b = divmod(int(edges[again[0]]), vertices)
        raise NotProved(f"manifold: the edge from {a} to {b} occurs twice in one direction")
    index = np.minimum(np.searchsorted(edges, twins), len(edges) - 1)
    lonely = edges[index] != twins
    if lonely.any():
        a, b = divmod(int(twins[lonely.argmax()]), vertices)
        raise NotProved(f"manifold: the edge from {a} to {b} has one side")
    # The next corner at a vertex starts with the twin of the half-edge that ends there.
    before = np.arange(len(edges)).reshape(-1, 3)[:, [2, 0, 1]].ravel()
    fans = np.unique(components(len(edges), np.arange(len(edges)), order[index][before]))
    fans_at = np.bincount(tail[fans], minlength=vertices)
    if fans_at.max() > 1:
        raise NotProved(f"manifold: the triangles at vertex {fans_at.argmax()} form several fans")
    return tail, head
