"""Reads a page of `morskin view`: its scripts, arrays and meshes.

The mesh is read by a decoder of its own, written from the description in app/front_code.h.
"""

import base64
import gzip
import html.parser
import json
import struct
from collections import Counter


class PageParser(html.parser.HTMLParser):
    """Scripts by id, and every address that a tag names."""

    def __init__(self):
        super().__init__()
        self.scripts, self.addresses, self.tags = {}, [], Counter()
        self.open_script = None

    def handle_starttag(self, tag, attributes):
        self.tags[tag] += 1
        named = dict(attributes)
        self.addresses += [named[key] for key in ("src", "href", "data", "action") if key in named]
        if tag == "script":
            self.open_script = named.get("id", "viewer")
            self.scripts[self.open_script] = ""

    def handle_data(self, data):
        if self.open_script is not None:
            self.scripts[self.open_script] += data

    def handle_endtag(self, tag):
        if tag == "script":
            self.open_script = None


class Page:
    def __init__(self, path):
        self.text = path.read_text(encoding="utf-8")
        self.parser = PageParser()
        self.parser.feed(self.text)
        self.about = json.loads(self.parser.scripts["about"])
        self.bytes = gzip.decompress(base64.b64decode(self.parser.scripts["data"], validate=True))
        self.entries = {entry["name"]: entry for entry in self.about["arrays"]}

    def array(self, name):
        entry = self.entries[name]
        kind, at, count, planes = (entry[key] for key in ("kind", "at", "count", "planes"))
        data = self.bytes[at:at + count * planes]
        if kind == "text":
            return data.decode(errors="replace")
        if kind in ("float", "double"):
            return struct.unpack(f"<{count}{kind[0]}", data)
        numbers = [sum(data[k * count + i] << 8 * k for k in range(planes)) for i in range(count)]
        if kind == "unsigned":
            return numbers
        return [n // 2 if n % 2 == 0 else -(n + 1) // 2 for n in numbers]

    def mesh(self, name="mesh"):
        """Places as whole steps of the grid, triangles, and by triangle its parent."""
        count = self.about[name]["triangles"]
        corners, parents, predictors = decode(
            self.array(f"{name}.cases"), self.array(f"{name}.references"), count)
        places = []
        axes = [self.array(f"{name}.{axis}") for axis in "xyz"]
        for v, (p, q, r) in enumerate(predictors):
            near = [0, 0, 0] if v == 0 else [a + b - c for a, b, c in
                                             zip(places[p], places[q], places[r])]
            places.append([n + axis[v] for n, axis in zip(near, axes)])
        return places, corners, parents

    def by_triangle(self, name, parents):
        values = []
        for off, parent in zip(self.array(name), parents):
            values.append(off + (values[parent] if values else 0))
        return values


def decode(cases, references, triangle_count):
    cases, references = iter(cases), iter(references)
    corners, parents, predictors, edges = [], [], [], []

    def link(e, f):
        e["next"], f["previous"] = f, e

    def edge(origin, target, apex, triangle):
        edges.append({"origin": origin, "target": target, "apex": apex, "triangle": triangle,
                      "open": True})
        return edges[-1]

    def new(*near):
        predictors.append(near)
        return len(predictors) - 1

    def old():
        return len(predictors) - 1 - next(references)

    head = 0
    while len(corners) < triangle_count:
        first = []
        for _ in range(3):
            near = max(len(predictors) - 1, 0)
            first.append(new(near, near, near) if next(cases) == 1 else old())
        parents.append(max(len(corners) - 1, 0))
        corners.append(tuple(first))
        n = len(corners) - 1
        started = [edge(first[k], first[(k + 1) % 3], first[(k + 2) % 3], n) for k in range(3)]
        for k in range(3):
            link(started[k], started[(k + 1) % 3])
        while head < len(edges):
            e = edges[head]
            head += 1
            if not e["open"]:
                continue
            e["open"] = False
            case = next(cases)
            if case == 0:
                continue
            a, b, after, before = e["origin"], e["target"], e["next"], e["previous"]
            touched = None
            if case in (2, 4):
                v = after["target"]
            elif case == 3:
                v = before["origin"]
            elif case == 1:
                v = new(a, b, e["apex"])
            elif case == 5:
                touched = edges[len(edges) - 1 - next(references)]
                v = touched["origin"]
            else:
                v = old()
            parents.append(e["triangle"])
            corners.append((b, a, v))
            n = len(corners) - 1
            if case in (2, 4):
                after["open"] = False
            if case in (3, 4):
                before["open"] = False
            if case == 4:
                link(before["previous"], after["next"])
            elif case == 2:
                f = edge(a, v, b, n)
                link(before, f)
                link(f, after["next"])
            elif case == 3:
                f = edge(v, b, a, n)
                link(before["previous"], f)
                link(f, after)
            else:
                f, g = edge(a, v, b, n), edge(v, b, a, n)
                entered = touched["previous"] if touched else None
                link(before, f)
                link(g, after)
                if touched:
                    link(f, touched)
                    link(entered, g)
                else:
                    link(f, g)
    return corners, parents, predictors


def from_smallest(corners):
    k = corners.index(min(corners))
    return corners[k:] + corners[:k]
