#!/usr/bin/env python3
"""Bundles the interactive parts of the course, each into one HTML file that needs nothing else.

    papers/interactive/build.py FOLDER [NAME ...]

A part is NAME.js here, with what it imports; parts that show something of the real program have it
made by the command. Takes esbuild, which Debian has.
"""

import argparse
import json
import re
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
TITLES = {
    "skin2d": "The skin of discs",
    "certificate": "Break the certificate",
    "front": "The front, step by step",
    "guard": "With the guard and without",
    "morse": "Cancel a pair",
    "sizes": "C, Q and the tangent disk",
}


def bundled(name):
    """The part's script as one text. A script inside a page ends at what looks like its end."""
    done = subprocess.run(["esbuild", HERE / f"{name}.js", "--bundle", "--minify", "--format=iife",
                           "--target=es2021", "--charset=utf8"],
                          capture_output=True, text=True, check=False)
    if done.returncode != 0:
        sys.exit(f"papers/interactive/{name}.js: {done.stderr}")
    return done.stdout.replace("</script", "<\\/script").strip()


def data_of(name, command):
    """What a part shows of the real program, made by it."""
    makers = {"certificate": certificate_data, "front": front_data, "guard": guard_data}
    return makers[name](command) if name in makers else {}


def front_data(command):
    """The dumbbell's sweep, out of the page that `view` writes of it."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "page.html")
        dumbbell = ROOT / "bench" / "molecules" / "dumbbell.xyzw"
        subprocess.run([command, "view", dumbbell, "-C", "0.16", "-o", out, "-q"], check=True,
                       capture_output=True)
        text = out.read_text(encoding="utf-8")
    about = re.search(r'<script type="application/json" id="about">(.*?)</script>', text, re.S)[1]
    packed = re.search(r'<script type="text/plain" id="data">(.*?)</script>', text, re.S)[1]
    return {"about": json.loads(about), "packed": packed.strip()}


def guard_data(command):
    """Two sweeps of cyclohexane by one front, of which the second looks for collisions in
    protecting spheres only: triangles in the order they were laid, before any refinement."""
    molecule = ROOT / "bench" / "molecules" / "cyclohexane.pdb"
    return {"C": 0.16, "sweeps": [swept(command, molecule, "-C", "0.16", "--guard", guard)
                                  for guard in ("everywhere", "spheres")]}


def swept(command, molecule, *options):
    """The mesh that a sweep ends with, whether it is closed or not."""
    with tempfile.TemporaryDirectory() as folder:
        # No height is above this one, so the snapshot is of the end.
        done = subprocess.run([command, "mesh", molecule, "-o", Path(folder, "mesh.off"), *options,
                               "--snapshot-at", "1e9", "--snapshot-dir", folder, "-q"],
                              capture_output=True, text=True, check=False)
        if done.returncode not in (0, 5):  # not certified: that is the point
            sys.exit(f"{molecule}: {done.stderr}")
        return triangle_mesh(Path(folder, "snapshot-1.ply").read_bytes())


def triangle_mesh(ply):
    """Positions, to a ten-thousandth, and triangles of a binary PLY file with nothing else."""
    header, _, body = ply.partition(b"end_header\n")
    vertices, triangles = (int(n) for n in re.findall(rb"element \w+ (\d+)", header))
    places, corners = body[:24 * vertices], body[24 * vertices:]
    assert len(corners) == 13 * triangles, "a PLY file with more than was asked for"
    return {"positions": [[round(x, 4) for x in p] for p in struct.iter_unpack("<3d", places)],
            "triangles": [t[1:] for t in struct.iter_unpack("<B3i", corners)]}


BALLS = [([-1, 0, 0], 2), ([1, 0, 0], 2), ([0, 3.2, 0], 1.2)]


def certificate_data(command):
    """A coarse mesh of three balls, and what the program expects of their skin."""
    with tempfile.TemporaryDirectory() as folder:
        balls, mesh = Path(folder, "balls.xyzw"), Path(folder, "mesh.off")
        balls.write_text("".join(f"{x} {y} {z} {w}\n" for (x, y, z), w in BALLS), encoding="utf-8")
        done = subprocess.run([command, "mesh", balls, "-o", mesh, "-C", "0.3", "--json"],
                              capture_output=True, text=True, check=True)
        report = json.loads(done.stdout)
        rows = [line.split() for line in mesh.read_text(encoding="utf-8").splitlines()
                if line and not line.startswith("#")]
    vertices, triangles = int(rows[1][0]), int(rows[1][1])
    return {"balls": [{"z": z, "w": w} for z, w in BALLS],
            "positions": [list(map(float, row)) for row in rows[2:2 + vertices]],
            "triangles": [list(map(int, row[1:4]))
                          for row in rows[2 + vertices:2 + vertices + triangles]],
            "expected": {"components": report["expected_components"],
                         "euler": report["expected_euler_characteristic"]}}


def write_viewer(path, command):
    """The viewer's own page of the dumbbell; a lesson's link has its state after #."""
    subprocess.run([command, "view", ROOT / "bench" / "molecules" / "dumbbell.xyzw", "-o", path,
                    "-q"], check=True, capture_output=True)


def page(name, data):
    text = (HERE / "page.html").read_text(encoding="utf-8")
    style = (HERE / "style.css").read_text(encoding="utf-8").strip()
    as_json = json.dumps(data, separators=(",", ":")).replace("</", "<\\/")
    for mark, value in (("@TITLE@", TITLES[name]), ("@STYLE@", style), ("@DATA@", as_json),
                        ("@SCRIPT@", bundled(name))):
        text = text.replace(mark, value, 1)
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("folder", type=Path)
    parser.add_argument("names", nargs="*", help="by default all")
    parser.add_argument("--command", type=Path, default=ROOT / "build" / "morskin")
    parser.add_argument("--list", action="store_true", help="print the parts' names as JSON")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for name in arguments.names or [*TITLES, "viewer"]:
        if name == "viewer":
            write_viewer(arguments.folder / "viewer.html", arguments.command)
            continue
        (arguments.folder / f"{name}.html").write_text(
            page(name, data_of(name, arguments.command)), encoding="utf-8")
    if arguments.list:
        print(json.dumps(list(TITLES)))


if __name__ == "__main__":
    main()
