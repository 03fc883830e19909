"""Balls in degenerate positions, outputs that cannot be written, limits."""

import math
import random
import signal

from support.command import MOLECULES
from support.hostile_case import Case, all_models, mesh, xyzr


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
    corners = ((0, 0, 0), (0, 2, 2), (2, 0, 2), (2, 2, 0))  # of the lattice, in quarters
    diamond = [(*(0.75 * (4 * n + x + shift) for n, x in zip(cell, corner)), 1.7)
               for cell in grid(1, (2, 2, 2)) for corner in corners for shift in (0, 1)]
    yield Case("a diamond lattice of 64 atoms, grown", {"diamond.xyzr": xyzr(diamond)},
               [mesh("diamond.xyzr", "--method", "dynamic", "-C", "0.2", "-q")], code=6,
               says="the growing mesh has run away")
    yield Case("50 balls within a millionth of an Angstrom, grown",
               {"clump.xyzr": xyzr(scattered(50, 1e-6, 1.5, 1))},
               [mesh("clump.xyzr", "--method", "dynamic")], code=6, says="growth finds no mesh")


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
    """An open cone, whose triangles all meet."""
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
    yield Case("--timeout of check, render and view", {"cone.off": cone(200000)},
               [(*words, "--timeout", "0.01") for words in
                (("check", "cone.off"), ("render", "cone.off", "-o", "x.png"),
                 ("view", "cone.off", "-o", "x.html"))], code=6,
               says="the time limit of 0.01 s (--timeout) was reached")
    yield Case("--max-memory", crambin, [(*fine, "--max-memory", "40M")], code=6,
               says="the memory limit of 41943040 bytes (--max-memory) was reached", memory=True)
    yield Case("--max-memory of next to nothing", crambin,
               [(*fine, "--max-memory", size) for size in ("1", "1M", "2M", "4M", "8M")], code=6,
               says=" (--max-memory) was reached", memory=True)
    yield Case("--max-memory of check, render and view", {"cone.off": cone(200000)},
               [(*words, "--max-memory", "4M") for words in
                (("check", "cone.off"), ("render", "cone.off", "-o", "x.png"),
                 ("view", "cone.off", "-o", "x.html"))], code=6,
               says="the memory limit of 4194304 bytes (--max-memory) was reached", memory=True)
    yield Case("--timeout and --max-memory that make no sense", crambin,
               [(*fine, "--timeout", word) for word in ("0", "-1", "nan", "1e300", "soon")] +
               [(*fine, "--max-memory", word) for word in ("0", "-1", "nan", "1e300", "2X")],
               code=2, says="see morskin mesh --help")
    yield Case("a limit of the shell's (ulimit -v)", crambin, [fine], code=6,
               says="out of memory", memory=True, address_space=40 << 20)
    yield Case("a limit of the shell's for check", {"cone.off": cone(200000)},
               [("check", "cone.off")], code=6, memory=True, address_space=40 << 20,
               says="out of memory: the mesh is too big for this machine; leave out the search")
