"""Files that cannot be read, or hold numbers that cannot be used."""

import gzip
import random

from support.command import MOLECULES
from support.hostile_case import Case, all_models, mesh, xyzr


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
               says="Permission denied; ask for the right to read it", as_nobody=True, mode=0)
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
    face = PLY.format(vertices=3, faces=1) + "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"
    yield Case("a gzip file inside a gzip file",
               {"twice.pdb.gz": gzip.compress(packed, mtime=0),
                "twice.ply.gz": gzip.compress(gzip.compress(face.encode(), mtime=0), mtime=0)},
               [mesh("twice.pdb.gz"), ("check", "twice.ply.gz")], code=3,
               says="is a gzip file inside a gzip file; unpack it once")
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
    yield Case("an atom's name of nine letters in PQR",
               {"nine.pqr": "ATOM 1 C23456789 ALA 1 0 0 0 0 1.7\n"}, code=4,
               says='nine.pqr:1: atom "C23456789" has the name "C23456789"')
    yield Case("a line of ten million characters", {"long.xyzr": "0 " * 5000000}, code=4,
               says="has no atom with a radius above 0")
    yield Case("an XYZ file that announces more atoms than it has", {"few.xyz": "9\n\nC 0 0 0\n"},
               code=3, says="few.xyz:3: the atoms end after 1 of 9 announced")
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
    for word in ("1e300", "nan", "-inf"):
        yield Case(f"a coordinate {word} in PQR, XYZ and XYZW",
                   {"a.pqr": f"ATOM 1 C ALA 1 {word} 0 0 0 1\n", "a.xyz": f"1\n\nC 0 {word} 0\n",
                    "a.xyzw": f"{word} 0 0 1\n"},
                   [mesh("a.pqr"), mesh("a.xyz"), mesh("a.xyzw")], code=4,
                   says="more than 10^6" if word == "1e300" else "has a coordinate that is not")
        yield Case(f"a coordinate {word} in mmCIF", {"a.cif": MMCIF.format(residue="ALA", x=word)},
                   code=4 if word == "1e300" else 3,
                   says="more than 10^6" if word == "1e300" else "which is no number")
    for word in ("0", "-1", "nan", "inf", "1e300"):
        yield Case(f"a weight {word}", {"w.xyzw": f"0 0 0 1\n1 0 0 {word}\n"}, code=4,
                   says="w.xyzw:2: ball (line 2) has a weight that is not above 0")
    yield Case("a weight 1e-60 with all its digits", {"w.xyzw": "0 0 0 1.23e-60\n"}, code=4,
               says="has so small a weight")
    yield Case("weights and a model", {"w.xyzw": "0 0 0 1\n"},
               [mesh("w.xyzw", "--model", "vdw"), mesh("w.xyzw", "--probe", "1")], code=2,
               says="leave out --")
    yield Case("weights named as radii", {"w.xyzr": "# x y z w\n0 0 0 1\n"}, code=3,
               says="w.xyzr:1: the fourth numbers are weights")
    yield Case("weights on standard input", {},
               [("mesh", "-", "-o", "out.ply", "--model", "given")], stdin=b"# x y z w\n0 0 0 1\n")
    yield Case("the same without --model given", {}, [("mesh", "-", "-o", "out.ply")], code=2,
               says="- gives weights; add --model given", stdin=b"# x y z w\n0 0 0 1\n")
    yield Case("noise of 1e-25 in the place of 0, with a note", {"r.xyzr": "1e-25 0 -2e-30 1\n"},
               all_models("r.xyzr"))
    yield Case("the same where radii are 1e-21",
               {"r.xyzr": "0 0 0 1e-21\n1.23e-25 0 0 1e-21\n"}, [mesh("r.xyzr", "--model", "vdw")],
               code=4, says="ball (line 2) has a coordinate with digits below 2^-120")
    yield Case("radii of 1e-6 side by side, and a ball 10^6 Angstrom away",
               {"r.xyzr": xyzr([(0, 0, 0, 1e-6), (2e-6, 0, 0, 1e-6), (1e6, 0, 0, 1)])},
               [mesh("r.xyzr", "--model", "vdw")], code=4,
               says="r.xyzr: ball (line 1) has a patch over 2^36 times smaller")
    yield Case("the same, not side by side",
               {"r.xyzr": xyzr([(0, 0, 0, 1e-6), (1e-3, 0, 0, 1e-6), (1e6, 0, 0, 1)])},
               [mesh("r.xyzr", "--model", "vdw")])
    yield Case("radii of 1e-6 apart or joined by 2e-9 of their distance, 2 runs",
               {"apart.xyzr": xyzr([(0, 0, 0, 1e-6), (2.8284271304e-6, 0, 0, 1e-6)]),
                "joined.xyzr": xyzr([(0, 0, 0, 1e-6), (2.8284271190e-6, 0, 0, 1e-6)])},
               [mesh("apart.xyzr", "--model", "vdw"), mesh("joined.xyzr", "--model", "vdw")])
    thin = 1.5 + 2.0**-33
    touching = f"{-thin!r} {{0}} 0 {thin * thin!r}\n{thin!r} {{0}} 0 {thin * thin!r}\n"
    yield Case("balls 1e-10 Angstrom from touching, near the origin",
               {"w.xyzw": touching.format(1)}, [mesh("w.xyzw")])
    yield Case("the same, 10^5 Angstrom away", {"w.xyzw": touching.format(99999)},
               [mesh("w.xyzw")], code=4,
               says="the skin is thinner than coordinates resolve there")
    yield Case("a radius of 1e-9", {"r.xyzr": "1 2 3 1e-9\n"}, all_models("r.xyzr"))
    yield Case("a radius of 1e-300", {"r.xyzr": "1 2 3 1\n0 0 0 1e-300\n"},
               [mesh("r.xyzr", "--model", "vdw")], code=4,
               says="ball (line 2) has so small a radius")
    yield Case("radii that differ ten-thousandfold, side by side",
               {"r.xyzr": xyzr([(0, 0, 0, 1e4), (14143, 0, 0, 1)])}, all_models("r.xyzr"))
