#!/usr/bin/env python3
"""Numbers that pages of the course derive by hand, each found again by another way."""

import json
import math
import re
import subprocess
import sys
import tempfile
from pathlib import Path

from support.plain_tests import run_all

MORSKIN = Path(sys.argv[1] if len(sys.argv) > 1 else "build/morskin").resolve()
PAPERS = Path(__file__).resolve().parent.parent / "papers"


def close(a, b, digits=3):
    return f"{a:.{digits}g}" == f"{b:.{digits}g}"


def icosahedron(radius):
    """Its corners, and its faces with outward normals."""
    golden = (1 + math.sqrt(5)) / 2
    scale = radius / math.hypot(1, golden)
    corners = [tuple(scale * v for v in point) for s in (-1, 1) for t in (-golden, golden)
               for point in ((0, s, t), (s, t, 0), (t, 0, s))]
    edge = min(math.dist(corners[0], other) for other in corners[1:])

    def is_edge(a, b):
        return abs(math.dist(corners[a], corners[b]) - edge) < 1e-6

    def volume(a, b, c):
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners[a], corners[b], corners[c]
        return (ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx))

    faces = [(a, b, c) if volume(a, b, c) > 0 else (a, c, b)
             for a in range(12) for b in range(a) for c in range(b)
             if is_edge(a, b) and is_edge(b, c) and is_edge(c, a)]
    return corners, faces, edge


def test_a_ball_accepts_the_icosahedron():
    """20 triangles with circumradii of 0.607 length scales."""
    corners, faces, edge = icosahedron(1.5)
    assert len(faces) == 20 and close(edge / math.sqrt(3) / 1.5, 0.607)
    with tempfile.TemporaryDirectory() as name:
        ball, mesh = Path(name) / "ball.xyzr", Path(name) / "icosahedron.off"
        ball.write_text("0 0 0 1.5\n", encoding="utf-8")
        lines = ["OFF", "12 20 0", *(" ".join(map(repr, p)) for p in corners),
                 *(f"3 {a} {b} {c}" for a, b, c in faces)]
        mesh.write_text("\n".join(lines) + "\n", encoding="utf-8")
        done = subprocess.run([MORSKIN, "check", mesh, "--against", ball, "--model", "vdw",
                               "--json"], capture_output=True, text=True, check=False)
        assert json.loads(done.stdout)["homeomorphic"], done.stdout


def test_the_report_in_the_readme_is_the_one_printed():
    """Three dots, alone or in a line, stand for anything."""
    text = (PAPERS.parent / "README.md").read_text(encoding="utf-8")
    command, shown = re.search(r"^\$ build/morskin (mesh .*)\n((?:.*\n)*?)```", text,
                               re.MULTILINE).groups()
    with tempfile.TemporaryDirectory() as name:
        (Path(name) / "bench").symlink_to(PAPERS.parent / "bench")
        (Path(name) / "build").mkdir()
        done = subprocess.run([MORSKIN, *command.split()], cwd=name, capture_output=True,
                              text=True, check=True)
    pattern = ".*".join(re.escape(part) for part in shown.strip().split("..."))
    assert re.fullmatch(pattern, done.stdout.strip(), re.DOTALL), done.stdout


def test_the_counts_of_touches_have_the_names_that_the_page_of_morse_functions_tells():
    page = (PAPERS / "3.1-morse-functions.md").read_text(encoding="utf-8")
    named = set(re.findall(r"`(\w+_protecting)`", page))
    for method, is_sweep in (("sweep", True), ("static", False)):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run([MORSKIN, "mesh", PAPERS.parent / "bench/molecules/caffeine.xyz",
                                   "--method", method, "-o", Path(folder) / "x.ply", "--json"],
                                  capture_output=True, text=True, check=True)
        counts = json.loads(done.stdout)["operations"]
        assert named == {name for name in counts if name.endswith("_protecting")}, named
        assert any(counts[name] for name in named) == is_sweep, counts


def test_the_table_of_solids_in_lesson_9():
    """R and h of the platonic solids with triangles, in a ball of radius 1."""
    page = (PAPERS / "lessons" / "9-certificate.md").read_text(encoding="utf-8")
    golden = (1 + math.sqrt(5)) / 2
    for name, faces, edge in (("tetrahedron", 4, math.sqrt(8 / 3)), ("octahedron", 8, math.sqrt(2)),
                              ("icosahedron", 20, 2 / math.hypot(1, golden))):
        radius = edge / math.sqrt(3)
        squared = 1 - radius ** 2
        verdict = "holds" if 1 - squared < squared else "fails"
        row = f"| {name} | {faces} | {radius:.3f} | {squared:.3f} | {1 - squared:.3f} | {verdict} |"
        assert row in page, row


def test_a_ball_takes_13_triangles_at_least():
    """The largest spherical triangle in the tube, of circumradius 1 / sqrt 2, by sampling."""
    radius = math.sqrt(0.5)

    def area(angles):
        points = [(radius * math.cos(a), radius * math.sin(a), math.sqrt(1 - radius ** 2))
                  for a in angles]
        (a, b, c) = points
        triple = (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2])
                  + a[2] * (b[0] * c[1] - b[1] * c[0]))
        dots = sum(sum(x * y for x, y in zip(p, q)) for p, q in ((a, b), (b, c), (c, a)))
        return 2 * math.atan2(triple, 1 + dots)

    steps = [2 * math.pi * k / 180 for k in range(180)]
    largest = max(area((0, s, t)) for s in steps for t in steps if s < t)
    assert close(largest, 0.97, 2) and close(4 * math.pi / largest, 13.0)
    assert close(4 * math.pi / largest / (4 * math.pi), 1.03)
    angle = 2 * math.atan(1 / math.tan(math.pi / 3) / math.sqrt(1 - radius ** 2))
    assert close(math.degrees(angle), 78.5) and math.isclose(3 * angle - math.pi, largest)


def test_beyond_a_wall_the_function_is_off_by_twice_the_square():
    """Balls of weight 2 at 0 and 2 on a line: the sphere's formula and the edge's, at d from
    x = 1/2, the middle of the orthocentres 0 and 1."""
    for d in (0.0, 0.1, 0.3):
        for across in (0.0, 0.7):
            x = 0.5 + d
            sphere = x ** 2 + across ** 2 - 2 / 2
            edge = across ** 2 - (x - 1) ** 2 - (2 - 1) / 2
            assert math.isclose(sphere - edge, 2 * d * d, abs_tol=1e-12)


def test_four_times_g_is_power_less_the_weight_of_the_combination():
    """4 G(x) = pi(q) - W(c): two balls of weight 2 and 1, c between them, q on their wall."""
    shares = [k / 1000 for k in range(1001)]
    for share in (0.0, 0.3, 1.0):
        for height in (0.0, 0.4, 2.0):
            # pi_1 = |q|^2 - 2 and pi_2 = |q - (2, 0)|^2 - 1 agree where 4 q_x = 3 + 2.
            c, q = 2 * share, (1.25, height)
            x = ((c + q[0]) / 2, height / 2)
            weight = [4 * s * s - (1 - s) * (0 - 2) - s * (4 - 1) for s in shares]
            g = min((x[0] - 2 * s) ** 2 + x[1] ** 2 - w / 2 for s, w in zip(shares, weight))
            power = q[0] ** 2 + q[1] ** 2 - 2
            assert math.isclose(4 * g, power - weight[shares.index(share)], abs_tol=1e-12)


if __name__ == "__main__":
    sys.exit(run_all(globals()))
