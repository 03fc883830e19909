#!/usr/bin/env python3
"""What the lessons compute by hand, computed again. Each number is looked for as the lesson writes
it; a table row as a whole."""

import math
import sys
from pathlib import Path

import numpy as np

from support.plain_tests import run_all

ROOT = Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "papers" / "course"))
from page import LESSONS  # noqa: E402

C, Q = 0.08, 1.65


def says(number, *texts):
    page = next(LESSONS.glob(f"{number}-*.md"))
    words = " ".join(page.read_text(encoding="utf-8").split())
    for text in texts:
        assert " ".join(text.split()) in words, f"{page.name} does not say: {text}"


def test_lesson_1_the_dumbbell():
    z, w = np.array([1.0, 0, 0]), 2.0
    weight_of_edge = w - z @ z
    wall = 0.5  # half of the sum of an orthocentre at 0 and one at 1
    assert weight_of_edge == 1
    assert math.isclose(w / 2 - (1 - wall) ** 2, weight_of_edge / 2 + wall ** 2)  # r^2 on the wall
    for s in (-0.9, -0.5, -0.2, 0, 0.3, 0.8):  # G at r = 0, over the balls in between and by cell
        t = np.linspace(-1, 1, 2001)
        least = ((s - t) ** 2 - (1 + t ** 2) / 2).min()
        by_cell = -s ** 2 - 0.5 if abs(s) <= wall else (abs(s) - 1) ** 2 - 1
        assert math.isclose(least, by_cell)
    says(1, f"of radius $\\sqrt{{1/2}} = {math.sqrt(weight_of_edge / 2):.3f}$",
         f"$r^2 = 1 - (1/2)^2 = {1 - wall ** 2:.2f}$", f"radius $\\sqrt2 = {math.sqrt(w):.3f}$")
    x = np.array([0, 0.4, 0.3])
    mirror = np.diag([-1, 1, 1])
    says(1, f"$G = 0.16 + 0.09 - 0.5 = {x @ mirror @ x - weight_of_edge / 2:.2f}$")


def test_lesson_2_sizes():
    waist, wall = math.sqrt(0.5), math.hypot(0.5, math.sqrt(0.75))
    assert wall == 1
    says(2, f"$C/Q$ is {C / Q:.4f} and $CQ$ is {C * Q:.3f}",
         f"| waist | {waist:.3f} | {2 * C / Q * waist:.4f} | {C * Q * waist:.4f} |",
         f"| spheres | 1 | {2 * C / Q:.4f} | {C * Q:.3f} |",
         f"\\frac{{1}}{{Q^2}} = {1 / Q ** 2:.3f}",
         f"A > {math.degrees(math.asin(1 / Q ** 2)):.2f}^\\circ")
    for s in (0, 0.15, 0.3):
        says(2, f"x = {s:.2f}: length scale {math.sqrt(0.5 + 2 * s * s):.6f},")
    way = math.hypot(0.5, math.sqrt(0.75) - waist)
    says(2, f"grows by {wall - waist:.3f}", f"= {way:.3f}$ apart")
    area = 0.75 * math.sqrt(3) * (C * Q) ** 2
    says(2, "mesh        2,176 triangles", "mesh        7,342 triangles")
    says(2, f"= {area:.4f}$. The sphere has {4 * math.pi:.2f}, so [U] asks for about "
            f"{4 * math.pi / area:.0f} triangles", f"That is {7342 / 2176:.1f} times as many")


def critical_points(direction):
    """(kind, height) of the dumbbell's, by lesson 3's recipe."""
    V = np.array(direction, float)
    V /= np.linalg.norm(V)
    found = []
    for centre, half, mirror, low, high in ((-1, 1, np.eye(3), -math.inf, -0.5),
                                            (0, 0.5, np.diag([-1.0, 1, 1]), -0.5, 0.5),
                                            (1, 1, np.eye(3), 0.5, math.inf)):
        D = V @ mirror @ V
        for sign in (-1, 1) if half / D > 0 else ():
            scale = sign * math.sqrt(half / D)
            x = np.array([centre, 0, 0]) + scale * mirror @ V
            if low < x[0] < high:
                plane = np.linalg.svd(V[None])[2][1:]
                bends = np.linalg.eigvalsh(-plane @ mirror @ plane.T / scale)
                found.append((int((bends < 0).sum()), V @ x))
    return found


def test_lesson_3_critical_points():
    lying, standing = critical_points((0, 1, 0)), critical_points((1, 0, 0))
    assert sorted(kind for kind, _ in lying) == [0, 0, 1, 1, 2, 2]
    assert sorted(kind for kind, _ in standing) == [0, 2]
    says(3, "| edge | $V$, for $V$ stands across $a$ | 1 | $\\pm 0.707$ "
         "| $(0, \\pm 0.707, 0)$ | both |",
         "$2 - 2 + 2 = 2$", "$1 - 0 + 1 = 2$")
    heights = {kind: height for kind, height in lying if height < 0}
    says(4, f"$1 - 0.707 = {heights[1] - heights[0]:.3f}$")


def test_lesson_4_gradient():
    V, n = np.array([0, 1.0, 0]), np.array([0, -0.6, 0.8])
    g, printed = V - (n @ V) * n, V / (n @ V) - n
    assert np.allclose(g, (0, 0.64, 0.48)) and np.allclose(printed, (0, -1.0667, -0.8), atol=1e-4)
    assert np.allclose(np.cross(g, printed), 0) and g @ printed < 0
    says(4, "(0, 0.64, 0.48)", "= (0, -1.067, -0.8)$",
         f"the saddle are {math.hypot(1, 1 - math.sqrt(0.5)):.2f} apart",
         f"the radii {disk_share():.3f} and {disk_share() * math.sqrt(0.5):.3f}")


def disk_share(c=C, q=Q):
    half = c * q / (1 + 2 * c * q)
    return 2 * half * math.sqrt(1 - half ** 2)


def test_lessons_5_to_7_the_disk():
    share, used = disk_share(), 0.87 * disk_share()
    half = round(C * Q / (1 + 2 * C * Q), 4)  # as the lesson goes on with it
    cosine = math.sqrt(1 - half ** 2)
    says(7, f"= {C / (Q - 2 * C):.4f} .$$", f"= {C * Q / (1 + 2 * C * Q):.4f} .$$",
         f"${2 * half:.4f} \\cdot {cosine:.4f} = {2 * half * cosine:.4f}$",
         f"with $r = {share:.4f}$", f"= {2 * C / (Q - 2 * C):.4f}$. The window",
         f"That would give {share / 2:.4f}", f"= {used:.4f}\\, \\rho")
    for phi in (60, 75, 90):
        widths = [r / (2 * math.cos(math.radians(phi / 2))) for r in (share, used)]
        says(7, f"| {phi}° | {widths[0]:.3f} | {widths[1]:.3f} | {C * Q:.3f} |")
    says(7, f"it is $2 \\cdot 0.0583 \\cdot 0.9983 = {disk_share(0.04):.3f}$",
         f"$(0.2077/0.116)^2 = {(share / disk_share(0.04)) ** 2:.1f}$")
    rim = used / math.hypot(1, used)
    says(5, f"$r = {used:.4f}\\, \\rho$", f"\\frac{{{used:.4f}}}{{{math.hypot(1, used):.4f}}} = "
         f"{rim:.4f} .$$", f"half of it is {rim / 2:.4f}, above {C / Q:.4f}",
         f"has the circumradius ${share / math.sqrt(2):.3f}\\, \\rho$")
    says(6, f"it is {share * math.sqrt(0.5):.3f}", f"= {2 * 0.147:.2f}$ apart",
         f"edges of {used * math.sqrt(0.5):.2f}", f"= {0.18 ** 2 / 8:.3f}\\, \\rho$")


def test_lesson_8_flip_and_constants():
    a, c, d = np.array([-1, 0]), np.array([0, 0.5]), np.array([0, -0.5])
    centre = np.array([0, -0.75])
    assert np.linalg.norm(a - centre) == np.linalg.norm(c - centre) == 1.25
    assert np.linalg.norm(d - centre) == 0.25
    one, two = np.linalg.norm(c - a), np.linalg.norm(c - d)
    angle = math.degrees(math.acos(1 - 2 ** 2 / (2 * one ** 2)))
    says(8, f"under {angle:.1f} degrees", f"that is {2 * angle:.1f}",
         f"circumradius {one * one * two / (4 * two / 2):.3f}",
         f"${Q ** 2:.4f} > {2 + 4 * C * Q:.3f}$", f"$2074 + 2 \\cdot 51 = {2074 + 2 * 51}$")


def test_lesson_9_the_path():
    change = round((C * Q) ** 2, 4)  # as the lesson goes on with it
    says(9, f"R^2 = {change:.4f}$", f"= {1 - math.sqrt(1 - change):.4f}$")


def test_lesson_10_the_power():
    top, bottom = math.log(202 / 5), math.log(305186 / 24336)
    says(10, f"\\frac{{{top:.2f}}}{{{bottom:.2f}}} = {top / bottom:.2f}",
         f"is {2 ** (top / bottom):.1f} times the time")


if __name__ == "__main__":
    sys.exit(run_all(globals()))
