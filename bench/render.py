#!/usr/bin/env python3
"""Draws a binary PLY mesh as a PNG, with nothing but Python's own library.

Orthographic, seen from +z, y up; two lights (Lambert), z-buffer, four samples a pixel; edges are
drawn where triangles are larger than a few pixels. The picture of the README, in half a minute:

    build/morskin mesh bench/molecules/1grm_model1.pdb -o build/1grm.ply
    python3 bench/render.py build/1grm.ply -o papers/figures/1grm.png --zoom 0.453,0.352,9
"""

import argparse
import math
import struct
import zlib
from array import array

SAMPLES = 2  # an axis
LEAST_EDGE = 7  # pixels: mean side of the triangles from which on their edges are drawn
LIGHTS = [(0.70, (-0.46, 0.61, 0.65)), (0.22, (0.89, -0.18, 0.42))]  # strength, where from
AMBIENT = 0.20
RAMP = [(0, (20, 28, 52)), (70, (52, 88, 128)), (140, (120, 164, 184)), (205, (228, 222, 192)),
        (240, (255, 248, 232)), (255, (255, 255, 255))]  # from shade to colour; 255 is background


def read_ply(path):
    """Points (x, y, z) and triangles (a, b, c) of a little-endian PLY as morskin writes it."""
    with open(path, "rb") as file:
        head, _, body = file.read().partition(b"end_header\n")
    words = [line.split() for line in head.decode().splitlines()]
    if ["format", "binary_little_endian", "1.0"] not in words:
        raise SystemExit(f"{path}: not a binary little-endian PLY; let morskin write one")
    vertices, faces = (int(line[2]) for line in words if line[0] == "element")
    triangles = struct.iter_unpack("<B3i", body[24 * vertices:24 * vertices + 13 * faces])
    return list(struct.iter_unpack("<3d", body[:24 * vertices])), [t[1:] for t in triangles]


def shades(points, triangles):
    """Lambert shade of each point, 0 to 1, by the mean normal; what lies deeper is darker."""
    normals = [[0.0, 0.0, 0.0] for _ in points]
    for triangle in triangles:
        a, b, c = (points[v] for v in triangle)
        u, v = [b[k] - a[k] for k in range(3)], [c[k] - a[k] for k in range(3)]
        n = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        for corner in triangle:
            for k in range(3):
                normals[corner][k] += n[k]
    depths = [p[2] for p in points]
    near, far = max(depths), min(depths)
    result = []
    for n, z in zip(normals, depths):
        lit = AMBIENT + sum(strength * max(0.0, sum(n[k] * d[k] for k in range(3))) / math.hypot(*n)
                            for strength, d in LIGHTS)
        result.append(min(1.0, lit) * (0.6 + 0.4 * (z - far) / (near - far)))
    return result


def draw(points, triangles, light, size, scale, centre):
    """A square panel of rows of shades; scale is pixels per length, centre a place (x, y)."""
    fine, scale = size * SAMPLES, scale * SAMPLES
    at = [((x - centre[0]) * scale + fine / 2, fine / 2 - (y - centre[1]) * scale, z)
          for x, y, z in points]
    image, depth = bytearray(b"\xff") * fine**2, array("d", [-math.inf]) * fine**2
    visible = []
    for a, b, c in triangles:
        (ax, ay, _), (bx, by, _), (cx, cy, _) = at[a], at[b], at[c]
        area = (cx - ax) * (by - ay) - (bx - ax) * (cy - ay)  # doubled; y runs down
        left, top = max(0, math.ceil(min(ax, bx, cx))), max(0, math.ceil(min(ay, by, cy)))
        right, bottom = min(fine, math.ceil(max(ax, bx, cx))), min(fine, math.ceil(max(ay, by, cy)))
        if area > 0 and left < right and top < bottom:
            visible.append((a, b, c, area, range(left, right), range(top, bottom)))
    mean_side = math.sqrt(sum(t[3] for t in visible) / max(1, len(visible)))
    half_width = 0.55 * SAMPLES if mean_side > LEAST_EDGE * SAMPLES else 0
    for a, b, c, area, columns, lines in visible:
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = at[a], at[b], at[c]
        la, lb, lc = light[a], light[b], light[c]
        rim_u, rim_v, rim_w = (half_width * math.dist(at[p][:2], at[q][:2]) / area
                               for p, q in ((b, c), (c, a), (a, b)))
        for y in lines:
            for x in columns:
                u = ((cx - x) * (by - y) - (bx - x) * (cy - y)) / area
                v = ((ax - x) * (cy - y) - (cx - x) * (ay - y)) / area
                w = 1 - u - v
                if u < 0 or v < 0 or w < 0:
                    continue
                z, place = u * az + v * bz + w * cz, y * fine + x
                if z > depth[place]:
                    depth[place] = z
                    is_edge = u < rim_u or v < rim_v or w < rim_w
                    image[place] = int((105 if is_edge else 240) * (u * la + v * lb + w * lc))
    lines = [image[y * fine:(y + 1) * fine] for y in range(fine)]
    return [bytearray(sum(lines[y + j][x + i] for j in range(SAMPLES) for i in range(SAMPLES))
                      // SAMPLES**2 for x in range(0, fine, SAMPLES))
            for y in range(0, fine, SAMPLES)]


def frame(rows, x0, y0, side):
    for i in range(side + 1):
        for x, y in ((x0 + i, y0), (x0 + i, y0 + side), (x0, y0 + i), (x0 + side, y0 + i)):
            if 0 <= y < len(rows) and 0 <= x < len(rows[y]):
                rows[y][x] = 0


def in_rows(panels, columns=3):
    rows = []
    for i in range(0, len(panels), columns):
        line = panels[i:i + columns]
        blank = [bytearray(b"\xff") * len(line[0])] * len(line[0])
        line += [blank] * (columns - len(line))
        rows += [b"\xff" * 16 + (b"\xff" * 16).join(parts) for parts in zip(*line)]
    return rows


def write_png(path, rows):
    """Indexed colour: a shade is its own index into the palette that RAMP spans."""
    palette = bytearray()
    for shade in range(256):
        (s, p), (t, q) = next(pair for pair in zip(RAMP, RAMP[1:]) if shade <= pair[1][0])
        palette += bytes(round(p[k] + (q[k] - p[k]) * (shade - s) / (t - s)) for k in range(3))
    body = b"".join(b"\1" + bytes((x - y) & 255 for x, y in zip(row, b"\0" + row)) for row in rows)
    head = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 3, 0, 0, 0)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n")
        for kind, data in ((b"IHDR", head), (b"PLTE", bytes(palette)),
                           (b"IDAT", zlib.compress(body, 9)), (b"IEND", b"")):
            check = zlib.crc32(kind + data)
            file.write(struct.pack(">I", len(data)) + kind + data + struct.pack(">I", check))


def main():
    numbers = lambda text: [float(x) for x in text.split(",")]
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("mesh", nargs="+", help="binary PLY, written by morskin; of several, each "
                        "gets a panel, three in a row, framed as the last")
    parser.add_argument("-o", "--output", required=True, help="the PNG")
    parser.add_argument("--size", type=int, default=640, help="pixels of a panel (default 640)")
    parser.add_argument("--zoom", type=numbers, metavar="X,Y,FACTOR", help="a second panel: "
                        "a place of the first, 0 to 1 from the top left, and how many times larger")
    arguments = parser.parse_args()
    size = arguments.size
    points, triangles = read_ply(arguments.mesh[-1])
    middle = [(min(axis) + max(axis)) / 2 for axis in zip(*points)]
    centred = lambda some: [tuple(p[k] - middle[k] for k in range(3)) for p in some]
    points = centred(points)
    light = shades(points, triangles)
    scale = 0.48 * size / max(max(abs(p[0]), abs(p[1])) for p in points)
    rows = draw(points, triangles, light, size, scale, (0, 0))
    if len(arguments.mesh) > 1:
        panels = []
        for path in arguments.mesh[:-1]:
            part, faces = read_ply(path)
            part = centred(part)
            panels.append(draw(part, faces, shades(part, faces), size, scale, (0, 0)))
        rows = in_rows([*panels, rows])
    if arguments.zoom:
        x, y, factor = arguments.zoom
        centre = ((x - 0.5) * size / scale, (0.5 - y) * size / scale)
        panel = draw(points, triangles, light, size, scale * factor, centre)
        frame(panel, 0, 0, size - 1)
        side = round(size / factor)
        frame(rows, round(x * size - side / 2), round(y * size - side / 2), side)
        rows = [row + b"\xff" * 16 + more for row, more in zip(rows, panel)]
    write_png(arguments.output, rows)


if __name__ == "__main__":
    main()
