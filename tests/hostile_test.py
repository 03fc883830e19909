#!/usr/bin/env python3
"""Input that means harm, or might: each with the exit code and the message it must give.

    hostile_test.py path/to/morskin            runs every case, and compares the table in
                                               papers/hostile-input.md with what came out
    hostile_test.py path/to/morskin --table    prints that table
    hostile_test.py path/to/morskin --sanitized
                                               leaves out the limits of memory, which the
                                               sanitizers' own memory exceeds
"""

import gzip
import math
import os
import random
import re
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
MOLECULES = ROOT / "bench" / "molecules"
PAGE = ROOT / "papers" / "hostile-input.md"
MORSKIN = os.path.abspath("build/morskin")
SANITIZED = False
SECONDS = 300  # for one run at most, on a busy machine with a slow build

NOBODY = 65534


def xyzr(balls):
    return "".join(" ".join(repr(float(number)) for number in ball) + "\n" for ball in balls)


def atom(x="   0.000", serial="    1", residue="ALA", name=" C  "):
    return f"ATOM  {serial} {name} {residue} A   1    {x}   0.000   0.000  1.00  0.00           C\n"


MMCIF = """data_x
loop_
_atom_site.type_symbol
_atom_site.label_comp_id
_atom_site.Cartn_x
_atom_site.Cartn_y
_atom_site.Cartn_z
C {residue} {x} 0 0
"""
PLY = """ply
format ascii 1.0
element vertex {vertices}
property float x
property float y
property float z
element face {faces}
property list uchar int vertex_indices
end_header
"""


def garbage(size):
    return random.Random(2004).randbytes(size)


def weight_root(radius, model, probe):
    """sqrt(W): two skins touch where the spheres of these radii do."""
    w = {"paper": math.sqrt(2) * (radius + probe), "sas": 2 * (radius + probe) ** 2,
         "vdw": 2 * radius ** 2}[model]
    return math.sqrt(w)


def grid(step, sides, centre=False):
    points = []
    for i in range(sides[0]):
        for j in range(sides[1]):
            for k in range(sides[2]):
                points.append((step * i, step * j, step * k))
                if centre:
                    points.append(tuple(step * (n + 0.5) for n in (i, j, k)))
    return points


def on_sphere(count, radius):
    """Points spread over a sphere along a spiral."""
    turn = math.pi * (3 - math.sqrt(5))
    for i in range(count):
        z = 1 - (2 * i + 1) / count
        r = math.sqrt(1 - z * z)
        yield (radius * r * math.cos(turn * i), radius * r * math.sin(turn * i), radius * z)


class Case:
    """One line of the table.

    files    name -> bytes or text, made beforehand; a name that ends in / is a folder
    runs     argument lists; default: mesh FIRST_FILE -o out.ply
    code     expected of every run
    says     a piece of what each says on standard error
    leaves   files that must be there afterwards, beside those made; None: out.ply if code is 0
    """

    def __init__(self, what, files=(), runs=None, code=0, says="", leaves=None, **how):
        self.what = what
        self.files = dict(files)
        first = next(iter(self.files), None)
        self.runs = runs or [("mesh", first, "-o", "out.ply")]
        self.code = code
        self.says = says
        self.leaves = set(leaves) if leaves is not None else {"out.ply"} if code == 0 else set()
        self.how = how


def mesh(name, *words):
    return ("mesh", name, "-o", "out.ply", *words)


def all_models(name, *words):
    return [mesh(name, *words, "--model", model) for model in ("paper", "sas", "vdw")]


def nearly_touching():
    files, runs = {}, []
    for model in ("paper", "sas", "vdw"):
        for exponent in range(3, 13):
            for sign in (-1, 1):
                distance = (weight_root(1.0, model, 1.4) + weight_root(1.7, model, 1.4))
                name = f"{model}{sign * exponent}.xyzr"
                files[name] = xyzr([(0, 0, 0, 1), (distance * (1 + sign * 10.0 ** -exponent),
                                                   0, 0, 1.7)])
                runs.append(mesh(name, "--model", model))
    return files, runs


def nearly_in_touch_inside():
    files, runs = {}, []
    for exponent in range(3, 13):
        for sign in (-1, 1):
            distance = math.sqrt(2) * (3.0 - 1.0) * (1 + sign * 10.0 ** -exponent)
            name = f"inside{sign * exponent}.xyzr"
            files[name] = xyzr([(0, 0, 0, 3), (distance, 0, 0, 1)])
            runs.append(mesh(name, "--model", "vdw"))
    return files, runs


def scattered(count, box, radius, seed):
    generator = random.Random(seed)
    return [(*(generator.uniform(-box, box) for _ in range(3)), radius) for _ in range(count)]


def reading_cases():
    ring = (MOLECULES / "ring12.xyzr").read_bytes()
    crambin = (MOLECULES / "1crn.pdb").read_bytes()
    packed = gzip.compress(crambin, mtime=0)
    yield Case("an empty file", {"empty.pdb": ""}, code=3, says="is empty")
    yield Case("nothing but blanks and line ends", {"blank.xyzr": " \n\t\r\n\n"}, code=3,
               says="is empty")
    yield Case("a folder", {}, [("mesh", ".", "-o", "out.ply")], code=3, says="is a folder")
    yield Case("a missing file", {}, [("mesh", "missing.pdb", "-o", "out.ply")], code=3,
               says="No such file")
    yield Case("a file that may not be read", {"secret.xyzr": ring}, code=3,
               says="Permission denied", as_nobody=True, mode=0)
    yield Case("prose without an ending", {"prose": "Once upon a time\n"}, code=3,
               says="is no molecule that can be recognised")
    for ending, says in (("pdb", "has no ATOM or HETATM record"),
                         ("cif", "is it an mmCIF file?"),
                         ("pqr", "has no ATOM or HETATM record"),
                         ("xyz", "is it an XYZ file?"),
                         ("xyzr", "expected x y z r"),
                         ("gz", "is no molecule that can be recognised")):
        yield Case(f"random bytes named .{ending}", {f"random.{ending}": garbage(4000)}, code=3,
                   says=says)
    for ending, says in (("ply", "is no PLY file"), ("off", ""), ("obj", ""), ("stl", "")):
        name = f"random.{ending}"
        yield Case(f"random bytes named .{ending}, to check", {name: garbage(4000)},
                   [("check", name)], code=3, says=says)
    yield Case("a PLY header that announces four thousand million vertices",
               {"huge.ply": PLY.format(vertices=4000000000, faces=1)}, [("check", "huge.ply")],
               code=3, says="huge.ply")
    yield Case("a PLY header that announces 2^64 vertices",
               {"huge.ply": PLY.format(vertices=2 ** 64, faces=1)}, [("check", "huge.ply")],
               code=3, says="huge.ply")
    yield Case("a mesh with a coordinate that is no number",
               {"nan.ply": PLY.format(vertices=3, faces=1) + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n"},
               [("check", "nan.ply")], code=3, says="not finite")
    yield Case("a mesh with a corner that does not exist",
               {"corner.ply": PLY.format(vertices=3, faces=1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"},
               [("check", "corner.ply")], code=3, says="corner.ply")
    yield Case("a gzipped file cut short", {"cut.pdb.gz": packed[:len(packed) // 2]}, code=3,
               says="is cut short")
    yield Case("a gzipped file with a wrong bit",
               {"bit.pdb.gz": packed[:2000] + bytes([packed[2000] ^ 16]) + packed[2001:]}, code=3,
               says="is damaged")
    bomb = gzip.compress(b"0 0 0 1\n" * (10 << 20), mtime=0)
    yield Case("a gzip bomb: 80 MiB in 80 kB", {"bomb.xyzr.gz": bomb}, code=3,
               says="unpacks from")
    yield Case("a device that never ends", {}, [("info", "/dev/zero")], code=3,
               says="holds more than 2147483648 bytes")
    yield Case("NUL bytes in a table", {"nul.xyzr": b"0 0 0 1\0\n"}, code=3,
               says='nul.xyzr:1: expected x y z r, found "1?"')
    yield Case("NUL bytes in a PDB line", {"nul.pdb": atom().replace("0.000", "0.\0\0\0", 1)},
               code=3, says="nul.pdb:1: no coordinate in columns 31-38")
    yield Case("line ends of DOS", {"dos.xyzr": "0 0 0 1\r\n1 0 0 1\r\n",
                                    "dos.pdb": atom().replace("\n", "\r\n")},
               [mesh("dos.xyzr"), mesh("dos.pdb")])
    yield Case("line ends of the first Macintosh", {"mac.xyzr": "0 0 0 1\r1 0 0 1\r"})
    yield Case("tabs instead of blanks", {"tabs.xyzr": "0\t0\t0\t1\n"})
    yield Case("a byte order mark", {"mark.xyzr": b"\xef\xbb\xbf0 0 0 1\n",
                                     "mark.pdb": b"\xef\xbb\xbf" + atom().encode()},
               [mesh("mark.xyzr"), mesh("mark.pdb")])
    yield Case("UTF-16", {"wide.xyzr": "0 0 0 1\n".encode("utf-16")}, code=3,
               says="wide.xyzr:1: expected x y z r")
    yield Case("a locale with a decimal comma, a file with points", {"point.xyzr": "0.5 0 0 1.5\n"},
               [mesh("point.xyzr", "--probe", "1.2", "-C", "0.09")], german=True)
    yield Case("a file with decimal commas", {"comma.xyzr": "0,5 0 0 1,5\n"}, code=3,
               says='comma.xyzr:1: expected x y z r, found "0,5"', german=True)
    yield Case("a PDB coordinate wider than its columns",
               {"wide.pdb": atom(x="-12345.678")}, code=3, says="no coordinate in columns")
    yield Case("a PDB serial number wider than its columns",
               {"serial.pdb": atom(serial="100000")}, code=3, says="no coordinate in columns")
    yield Case("a residue name of five characters in mmCIF",
               {"five.cif": MMCIF.format(residue="A1ABC", x="1.5")})
    yield Case("a residue name of five characters in PDB, which moves the columns",
               {"five.pdb": atom(residue="A1ABC")}, code=3, says="no coordinate in columns")
    yield Case("a line of ten million characters", {"long.xyzr": "0 " * 5000000}, code=4,
               says="has no atom with a radius above 0")
    yield Case("an XYZ file that announces more atoms than it has", {"few.xyz": "9\n\nC 0 0 0\n"},
               code=3, says="few.xyz:3: there are 1 atoms where 9 were announced")
    yield Case("an element without a radius", {"md.xyz": "1\n\nMd 0 0 0\n"}, code=4,
               says="no van der Waals radius")
    yield Case("the molecule on standard input", {}, [("mesh", "-", "-o", "out.ply")],
               stdin=ring)
    yield Case("nothing on standard input", {}, [("mesh", "-", "-o", "out.ply")], code=3,
               says="-: is empty", stdin=b"")
    yield Case("random bytes on standard input", {}, [("mesh", "-", "-o", "out.ply")], code=3,
               says="-: is no molecule", stdin=garbage(4000))


def number_cases():
    for word in ("nan", "inf"):
        yield Case(f"a coordinate {word}", {"word.xyzr": f"0 0 0 1\n{word} 0 0 1\n"}, code=4,
                   says="word.xyzr:2: ball (line 2) has a coordinate that is not finite")
        yield Case(f"a radius {word}", {"word.xyzr": f"0 0 0 {word}\n"}, code=4,
                   says="word.xyzr:1: ball (line 1) has a radius")
    yield Case("a coordinate inf in PDB", {"inf.pdb": atom(x="     inf")}, code=4,
               says="inf.pdb:1: atom C of ALA 1 chain A (line 1) has a coordinate")
    yield Case("a coordinate 1e300", {"far.xyzr": "1e300 0 0 1\n"}, code=4,
               says="more than 10^6 Angstrom from the origin")
    yield Case("a coordinate 1e400, beyond doubles", {"far.xyzr": "1e400 0 0 1\n"}, code=3,
               says='far.xyzr:1: expected x y z r, found "1e400"')
    yield Case("denormal coordinates", {"tiny.xyzr": "5e-324 0 0 1\n0 -1e-310 1 1\n"},
               all_models("tiny.xyzr"))
    yield Case("coordinates of 10^6 Angstrom",
               {"far.xyzr": xyzr([(1e6, 1e6, 1e6, 1), (1e6 - 1, 1e6, 1e6, 1.5)])},
               all_models("far.xyzr"))
    yield Case("coordinates beyond 10^6 Angstrom", {"far.xyzr": "1000001 0 0 1\n"}, code=4,
               says="more than 10^6 Angstrom from the origin")
    yield Case("a radius below 0", {"r.xyzr": "0 0 0 -1\n"}, code=4,
               says="a radius that is not between 0 and 10^6 Angstrom")
    yield Case("a radius of 0, alone", {"r.xyzr": "0 0 0 0\n"}, code=4,
               says="has no atom with a radius above 0")
    yield Case("a radius of 0 among others", {"r.xyzr": "0 0 0 0\n1 0 0 1\n"})
    yield Case("a radius above 10^6", {"r.xyzr": "0 0 0 1e7\n"}, code=4,
               says="a radius that is not between 0 and 10^6 Angstrom")
    yield Case("a radius whose weight is above 2^30",
               {"r.xyzr": "0 0 0 1e6\n"}, [mesh("r.xyzr", "--model", "vdw")], code=4,
               says="too big a radius")
    yield Case("a radius of 20,000", {"r.xyzr": "0 0 0 2e4\n"}, all_models("r.xyzr"))
    yield Case("a radius of 1e-9", {"r.xyzr": "1 2 3 1e-9\n"}, all_models("r.xyzr"))
    yield Case("a radius of 1e-300", {"r.xyzr": "1 2 3 1\n0 0 0 1e-300\n"},
               [mesh("r.xyzr", "--model", "vdw")], code=4,
               says="ball (line 2) has so small a radius")
    yield Case("radii that differ ten-thousandfold, side by side",
               {"r.xyzr": xyzr([(0, 0, 0, 1e4), (14143, 0, 0, 1)])}, all_models("r.xyzr"))


def ball_cases():
    yield Case("one ball", {"one.xyzr": "0 0 0 1.7\n"}, all_models("one.xyzr"))
    yield Case("two and three balls", {"two.xyzr": "0 0 0 1\n1 0 0 1\n",
                                       "three.xyzr": "0 0 0 1\n1 0 0 1\n0 1 0 1\n"},
               [*all_models("two.xyzr"), *all_models("three.xyzr")])
    yield Case("coincident balls, equal radii", {"same.xyzr": "0 0 0 1\n" * 5},
               all_models("same.xyzr"))
    yield Case("coincident balls, unequal radii",
               {"same.xyzr": "0 0 0 1\n0 0 0 2\n0 0 0 1.5\n3 0 0 1\n3 0 0 2\n"},
               all_models("same.xyzr"))
    yield Case("a ball in a ball", {"in.xyzr": "0 0 0 3\n1 0 0 1\n"}, all_models("in.xyzr"))
    # W = 2 r^2 is 8 and 32; (6, 6, 0) is sqrt 8 + sqrt 32 long, (2, 2, 0) their difference.
    singular = [("two balls that touch", "0 0 0 2\n6 6 0 4\n"),
                ("a chain of balls that touch", "0 0 0 2\n4 4 0 2\n8 8 0 2\n")]
    for what, text in singular:
        yield Case(what, {"touch.xyzr": text}, [mesh("touch.xyzr", "--model", "vdw")], code=4,
                   says="touch.xyzr: the skin is singular at ball (line 1)")
    # The cone's tip lies outside the cell of the edge, so the skin is smooth.
    yield Case("two balls that touch, one in the other", {"in.xyzr": "0 0 0 4\n2 2 0 2\n"},
               [mesh("in.xyzr", "--model", "vdw")])
    files, runs = nearly_touching()
    yield Case("two balls apart or overlapping by 1e-3 to 1e-12 of their distance, 60 runs", files,
               runs)
    files, runs = nearly_in_touch_inside()
    yield Case("the same from within, 20 runs", files, runs)
    yield Case("collinear, exactly and but for rounding",
               {"line.xyzr": xyzr((1.5 * i, 2.25 * i, -i, 1) for i in range(9)),
                "nearly.xyzr": xyzr((1.1 * i, 2.2 * i, 3.3 * i, 1) for i in range(9))},
               [*all_models("line.xyzr"), *all_models("nearly.xyzr")])
    yield Case("coplanar, exactly and but for rounding",
               {"plane.xyzr": xyzr((*p, 1.25) for p in grid(2, (4, 4, 1))),
                "nearly.xyzr": xyzr((0.6 * x + 0.1 * y, 0.3 * y, 0.8 * x - 0.7 * y, 1.25)
                                    for x, y, _ in grid(2, (4, 4, 1)))},
               [*all_models("plane.xyzr"), *all_models("nearly.xyzr")])
    yield Case("a square whose orthosphere has weight 0",
               {"square.xyzr": xyzr((*p, 1) for p in grid(2, (2, 2, 1)))},
               [mesh("square.xyzr", "--model", "vdw")], code=4,
               says="square.xyzr: the skin is singular at ball (line 1)")
    corners = {(x, y, z) for a in (3, -3) for b in (2, -2)
               for x, y, z in ((a, b, 0), (b, a, 0), (0, a, b), (0, b, a), (a, 0, b), (b, 0, a))}
    yield Case("cospherical", {"sphere.xyzr": xyzr((*p, 1.2) for p in sorted(corners))},
               all_models("sphere.xyzr"))
    yield Case("lattices, primitive and body-centred",
               {"cubes.xyzr": xyzr((*p, 1.3) for p in grid(2.5, (3, 3, 3))),
                "centred.xyzr": xyzr((*p, 1.1) for p in grid(2.5, (2, 2, 2), centre=True))},
               [*all_models("cubes.xyzr"), *all_models("centred.xyzr")])
    yield Case("clusters 10^6 Angstrom apart",
               {"apart.xyzr": xyzr([(x + i, y, 0, 1.5) for x, y in
                                    ((0, 0), (9e5, 9e5), (-1e6 + 9, 1e5)) for i in range(3)])},
               all_models("apart.xyzr"))
    shells = [*((*p, 1.5) for p in on_sphere(24, 3.5)), *((*p, 1.5) for p in on_sphere(120, 9)),
              (0, 0, 0, 0.4)]
    yield Case("a ball in a shell in a shell", {"shells.xyzr": xyzr(shells)},
               [mesh("shells.xyzr", "--model", "vdw")])
    far = [(5 * i, 5 * j, 5 * k, 1) for i in range(8) for j in range(8) for k in range(5)]
    yield Case("320 components", {"many.xyzr": xyzr(far)}, [mesh("many.xyzr", "--model", "vdw")])
    yield Case("30 balls of radius 3 in a clump", {"clump.xyzr": xyzr(scattered(30, 4, 3, 1))})


def output_cases():
    ring = (MOLECULES / "ring12.xyzr").read_bytes()
    files = {"ring.xyzr": ring}
    yield Case("a missing folder for the mesh", files, [("mesh", "ring.xyzr", "-o", "no/out.ply")],
               code=7, says="create the folder first")
    yield Case("a folder for the mesh", {**files, "folder.ply/": ""},
               [("mesh", "ring.xyzr", "-o", "folder.ply")], code=7,
               says="folder.ply: cannot write: Is a directory; name a file")
    yield Case("a folder that may not be written to", files, code=7, says="Permission denied",
               as_nobody=True, folder_mode=0o555)
    yield Case("a mesh that may not be overwritten", {**files, "out.ply": "older"}, code=7,
               says="Permission denied", as_nobody=True, read_only="out.ply", leaves={"out.ply"})
    yield Case("a full device", files, [("mesh", "ring.xyzr", "-o", "/dev/full"),
                                        ("mesh", "ring.xyzr", "-o", "out.ply", "-o", "/dev/full")],
               code=7, says="/dev/full: cannot write: No space left on device")
    yield Case("a full device for the report", files,
               [mesh("ring.xyzr", "--report", "/dev/full")], code=7,
               says="/dev/full: cannot write", leaves={"out.ply"})
    yield Case("a file system that takes no more (ulimit -f)", files, code=7,
               says="out.ply: cannot write: File too large", file_bytes=100000)
    yield Case("sizes far from the theory", files, [mesh("ring.xyzr", "-C", "0.9", "-Q", "1.9")],
               code=5, says="not certified", leaves={"out.ply.unverified"})
    yield Case("the name of the input for the mesh", {"ring.ply": ring},
               [("mesh", "ring.ply", "-o", "ring.ply")], code=2, says="would replace the input")


def cone(count):
    """An open cone: the boxes of all its triangles overlap, so they are all held against all."""
    rim = [(math.cos(2 * math.pi * i / count), math.sin(2 * math.pi * i / count))
           for i in range(count)]
    return ("OFF\n" + f"{count + 1} {count - 1} 0\n0 0 1\n" +
            "".join(f"{x} {y} 0\n" for x, y in rim) +
            "".join(f"3 0 {i} {i + 1}\n" for i in range(1, count)))


def limit_cases():
    crambin = {"1crn.pdb": (MOLECULES / "1crn.pdb").read_bytes()}
    fine = mesh("1crn.pdb", "-C", "0.01")
    yield Case("Ctrl-C in the middle", crambin, [fine], code=-signal.SIGINT, interrupt=True)
    yield Case("--timeout", crambin, [(*fine, "--timeout", "0.5")], code=6,
               says="the time limit of 0.5 s (--timeout) was reached")
    yield Case("--timeout of check, a mesh whose triangles all meet", {"cone.off": cone(200000)},
               [("check", "cone.off", "--timeout", "2")], code=6,
               says="the time limit of 2 s (--timeout) was reached")
    yield Case("--max-memory", crambin, [(*fine, "--max-memory", "40M")], code=6,
               says="the memory limit of 41943040 bytes (--max-memory) was reached", memory=True)
    yield Case("--max-memory of next to nothing", crambin,
               [(*fine, "--max-memory", size) for size in ("1", "1M", "2M", "4M", "8M")], code=6,
               says="bytes (--max-memory) was reached", memory=True)
    yield Case("--timeout and --max-memory that make no sense", crambin,
               [(*fine, "--timeout", word) for word in ("0", "-1", "nan", "1e300", "soon")] +
               [(*fine, "--max-memory", word) for word in ("0", "-1", "nan", "1e300", "2X")],
               code=2, says="see morskin --help")
    yield Case("a limit of the shell's (ulimit -v)", crambin, [fine], code=6,
               says="out of memory", memory=True, address_space=60 << 20)


def cases():
    for made in (reading_cases, number_cases, ball_cases, output_cases, limit_cases):
        for case in made():
            if not (SANITIZED and "memory" in case.how):
                yield case


class Runner:
    """Runs cases, each in a folder of its own, and remembers what came out for the table."""

    def __init__(self):
        self.rows = []

    def complaints(self, case):
        """What did not come out as it should; adds the table's row."""
        with tempfile.TemporaryDirectory(prefix="morskin_hostile_") as name:
            folder = Path(name)
            os.chmod(folder, 0o777)
            for file, content in case.files.items():
                if file.endswith("/"):
                    (folder / file).mkdir()
                else:
                    (folder / file).write_bytes(
                        content if isinstance(content, bytes) else content.encode())
            made = {p.name for p in folder.iterdir()}
            row = None
            wrong = []
            for words in case.runs:
                code, said = self.run(case, words, folder)
                found = {p.name for p in folder.iterdir()} - made
                expected = case.leaves - made
                is_as_said = code == case.code and case.says in said and found == expected
                if not is_as_said or (code > 0 and not said):
                    wrong.append(f"{' '.join(words)}: exit {code}, leaves {sorted(found)}, "
                                 f"says: {said}")
                for file in found:
                    (folder / file).unlink()
                row = row or (case.what, code, said)
            for file, content in case.files.items():
                if file in case.leaves and (folder / file).read_bytes() != content.encode():
                    wrong.append(f"{file} is not as it was")
        self.rows.append(row)
        return wrong

    def run(self, case, words, folder):
        """The exit code and the error, as far as it is the same everywhere."""
        how = case.how
        program, options, restore = MORSKIN, {}, []
        environment = dict(os.environ, LC_ALL="C")
        if how.get("german"):
            environment.update(german_locale())
        if how.get("as_nobody"):
            if os.geteuid() == 0:
                program = copy_for_everyone()
                options.update(user=NOBODY, group=NOBODY)
            first = folder / next(iter(case.files))
            for key, path in (("mode", first), ("folder_mode", folder)):
                if key in how:
                    restore.append((path, path.stat().st_mode & 0o777))
                    os.chmod(path, how[key])
            if "read_only" in how:
                os.chmod(folder / how["read_only"], 0o444)
        if "stdin" in how:
            options["input"] = how["stdin"]
        else:
            options["stdin"] = subprocess.DEVNULL

        def limit():
            if "file_bytes" in how:
                resource.setrlimit(resource.RLIMIT_FSIZE, (how["file_bytes"],) * 2)
            if "address_space" in how:
                resource.setrlimit(resource.RLIMIT_AS, (how["address_space"],) * 2)

        if "interrupt" in how:
            return interrupted([program, *words], folder)
        done = subprocess.run([program, *words], cwd=folder, env=environment, timeout=SECONDS,
                              stdout=subprocess.PIPE, stderr=subprocess.PIPE, check=False,
                              preexec_fn=limit, **options)
        for path, mode in restore:
            os.chmod(path, mode)
        # Notes are not errors.
        lines = [line for line in done.stderr.decode("utf-8", "strict").splitlines()
                 if not line.startswith("morskin: note:")]
        said = " / ".join(lines).replace(f"{folder}/", "")
        if "AddressSanitizer" in said or "runtime error" in said:
            return done.returncode, "SANITIZER: " + said
        return done.returncode, said


def interrupted(words, folder):
    before = len(list(folder.iterdir()))
    with subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.PIPE) as process:
        deadline = time.monotonic() + SECONDS
        while len(list(folder.iterdir())) == before and time.monotonic() < deadline:
            time.sleep(0.01)
        time.sleep(0.2)
        process.send_signal(signal.SIGINT)
        said = process.stderr.read().decode()
        return process.wait(SECONDS), said


SHARED = tempfile.TemporaryDirectory(prefix="morskin_hostile_shared_")


def copy_for_everyone():
    """The program where another user may run it."""
    copy = Path(SHARED.name) / "morskin"
    if not copy.exists():
        os.chmod(SHARED.name, 0o755)
        shutil.copy(MORSKIN, copy)
        os.chmod(copy, 0o755)
    return str(copy)


def german_locale():
    """The environment of a German user; the locale is made if there are tools for it."""
    name = "de_DE.UTF-8"
    place = Path(SHARED.name) / "locale"
    if not place.exists():
        place.mkdir()
        if shutil.which("localedef"):
            subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", str(place / name)],
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
    environment = {"LC_ALL": name, "LANG": name}
    if (place / name).exists():
        environment["LOCPATH"] = str(place)
    return environment


def table(rows):
    lines = ["| input | exit | message |", "|---|---|---|"]
    for what, code, said in rows:
        if code < 0:
            result, message = f"by {signal.Signals(-code).name}", "none; no file is left"
        else:
            result, message = str(code), said or ("certified" if code == 0 else "")
        message = re.sub(r"^morskin: ", "", message)
        message = message.replace("\\", "\\\\").replace("|", "\\|").replace("<", "&lt;")
        lines.append(f"| {what} | {result} | {message} |")
    return lines


def table_of_page():
    lines = PAGE.read_text(encoding="utf-8").splitlines()
    start = lines.index("| input | exit | message |")
    end = next((i for i in range(start, len(lines)) if not lines[i].startswith("|")), len(lines))
    return lines[start:end]


class Hostile(unittest.TestCase):
    maxDiff = None

    def test_every_case_and_the_table_of_the_page(self):
        runner = Runner()
        for case in cases():
            with self.subTest(case.what):
                self.assertEqual(runner.complaints(case), [])
        page = table_of_page()
        if SANITIZED:  # cases are missing
            page = [line for line in page if line in table(runner.rows)]
        self.assertEqual(page, table(runner.rows), "papers/hostile-input.md must hold this table "
                         "(hostile_test.py build/morskin --table prints it)")


def main():
    global MORSKIN, SANITIZED
    words = sys.argv[1:]
    SANITIZED = "--sanitized" in words
    is_table = "--table" in words
    words = [word for word in words if word not in ("--sanitized", "--table")]
    if words:
        MORSKIN = os.path.abspath(words[0])
    if not is_table:
        unittest.main(argv=[sys.argv[0], *words[1:]])
    runner = Runner()
    wrong = [line for case in cases() for line in runner.complaints(case)]
    print("\n".join(table(runner.rows)))
    sys.exit("\n".join(wrong) if wrong else 0)


if __name__ == "__main__":
    main()
