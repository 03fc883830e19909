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
    if not vertices or len(np.unique(tail)) < vertices or (tail == head).any():
        raise NotProved("manifold: a vertex is unused, or twice in a triangle")
    edges, twins = tail * vertices + head, head * vertices + tail
    order, back = np.argsort(edges), np.argsort(twins)
    wrong = edges[order] != twins[back]
    wrong[1:] |= edges[order[1:]] == edges[order[:-1]]
    if wrong.any():
        raise NotProved(f"manifold: an edge at vertex {tail[order[wrong.argmax()]]} is not there "
                        "once in each direction")
    # The next corner at a vertex starts with the twin of the half-edge that ends there.
    twin = np.empty_like(order)
    twin[back] = order
    every = np.arange(len(edges))
    before = every.reshape(-1, 3)[:, [2, 0, 1]].ravel()
    if len(np.unique(components(len(edges), every, twin[before]))) > vertices:
        raise NotProved("manifold: the triangles at a vertex form several fans")
    return tail, head
