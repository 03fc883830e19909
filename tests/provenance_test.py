#!/usr/bin/env python3
"""What mesh files say of their origin, and what `check` makes of it.
Usage: provenance_test.py path/to/morskin"""

import gzip
import hashlib
import json
import os
import re
import struct
import urllib.parse

import meshio
import numpy

from support.command import MOLECULES, CommandTest, main
from support.provenance import entries, ply_parts

CRAMBIN = MOLECULES / "1crn.pdb"
RUN = ("-C", "0.2", "--model", "sas", "--probe", "1.2", "--voids", "drop", "--hydrogens", "drop",
       "--chain", "A")


class Provenance(CommandTest):
    def meshed(self, *words, molecule=None, code=0):
        self.run_morskin("mesh", molecule or self.ring, "-q", *words, code=code)

    def lines(self, name):
        return (self.folder / name).read_bytes().decode(errors="replace").splitlines()

    def ply_entries(self, name="m.ply"):
        return entries(ply_parts((self.folder / name).read_bytes())[0])

    def altered(self, old, new, name="m.ply", to="altered.ply"):
        data = (self.folder / name).read_bytes()
        self.assertIn(old, data)
        return self.input(to, data.replace(old, new, 1))

    def origin(self, mesh, *words, code=0):
        return self.check(mesh, *words, code=code)["origin"]

    def test_all_formats_say_the_same_of_one_mesh(self):
        names = ["m.ply", "m.obj", "m.off", "m.vert", "m.vtu", "m.stl"]
        self.meshed(*RUN, *(word for name in names for word in ("-o", name)), molecule=CRAMBIN)
        said = self.ply_entries()
        self.assertEqual(entries(self.lines("m.obj")), said)
        self.assertEqual(entries(self.lines("m.off")), said)
        for name in ("m.vert", "m.face"):
            line = self.lines(name)[0]
            self.assertTrue(line.startswith("# morskin: "))
            pairs = line.split("morskin: ")[1].split("; ")
            self.assertEqual(dict(pair.split(" ", 1) for pair in pairs), said)
        fields = meshio.read(self.folder / "m.vtu").field_data
        self.assertEqual(list(fields), list(said))
        for key, value in fields.items():
            is_text = value.dtype == numpy.uint8
            self.assertEqual(bytes(value).decode() if is_text else float(value[0]),
                             said[key] if is_text else float(said[key]))
        self.assertEqual(said["verdict"], "certified")
        self.assertEqual([said[k] for k in ("input", "model", "probe", "chain", "voids", "C",
                                            "hydrogens", "radii")],
                         ["1crn.pdb", "sas", "1.2", "A", "drop", "0.2", "drop", "elements"])
        header = (self.folder / "m.stl").read_bytes()[:80].decode()
        self.assertIn(f'certified, input {said["input-sha256"][:12]}, corners ', header)
        self.assertIn(", ...", header)

    def test_another_program_computes_the_same_hashes(self):
        self.meshed("-o", "m.ply", "-o", "m.stl")
        _, coordinates, faces = ply_parts((self.folder / "m.ply").read_bytes())
        said = self.ply_entries()
        self.assertEqual(hashlib.sha256(coordinates).hexdigest(), said["coordinates-sha256"])
        self.assertEqual(hashlib.sha256(faces).hexdigest(), said["faces-sha256"])
        self.assertEqual(hashlib.sha256(self.ring.read_bytes()).hexdigest(), said["input-sha256"])
        stl = (self.folder / "m.stl").read_bytes()
        corners = b"".join(stl[84 + 50 * i + 12:84 + 50 * i + 48] for i in
                           range(struct.unpack_from("<I", stl, 80)[0]))
        self.assertIn(f"corners {hashlib.sha256(corners).hexdigest()[:12]},", stl[:80].decode())

    def test_the_report_has_the_keys_of_the_file(self):
        report = self.mesh_json(self.ring, "-o", "m.ply")["provenance"]
        self.assertEqual({k: str(v) for k, v in report.items()}, self.ply_entries())

    def test_neither_folder_nor_output_name_nor_time_changes_a_byte(self):
        self.meshed("-o", "a.ply")
        (self.folder / "other").mkdir()
        moved = self.input("other/ring.xyzr", self.ring.read_bytes())
        self.meshed("-o", "other/b.ply", molecule=moved)
        self.assertEqual((self.folder / "a.ply").read_bytes(),
                         (self.folder / "other/b.ply").read_bytes())

    def test_check_needs_no_options_for_a_mesh_that_says_how_it_was_made(self):
        self.meshed(*RUN, "-o", "m.ply", "-o", "m.off", "-o", "m.obj", "-o", "m.vert",
                    molecule=CRAMBIN)
        for name in ("m.ply", "m.off", "m.obj", "m.vert", "m.face"):
            with self.subTest(name):
                report = self.check(name, "--against", CRAMBIN)
                self.assertTrue(report["certified"])
                self.assertEqual((report["model"], report["probe"], report["C"]),
                                 ("sas", 1.2, 0.2))
                origin = report["origin"]
                self.assertEqual(origin["taken"], ["model", "probe", "voids", "chain", "hydrogens",
                                                   "C", "Q"])
                self.assertEqual(origin["not_taken"], [])
                for what in ("coordinates", "faces"):
                    self.assertTrue(origin[f"{what}_match"])
                self.assertTrue(origin["input_matches"])
        said = self.run_morskin("check", "m.ply", "--against", CRAMBIN).stdout.decode()
        for word in ("model sas", "probe 1.2 A", 'chain ["A"]', "voids dropped", "C 0.2"):
            self.assertIn(word, said)

    def test_options_of_size_and_of_triangles_are_taken_too(self):
        for words in (("--size", "0.7"), ("--triangles", "3000"), ("--density", "3")):
            with self.subTest(words):
                self.meshed("-o", "m.ply", *words)
                report = self.check("m.ply", "--against", self.ring)
                self.assertTrue(report["certified"])
                self.assertIn("size", report["origin"]["taken"])

    def test_what_is_given_goes_before_what_the_file_states(self):
        self.meshed("-o", "m.ply", "-C", "0.2")
        report = self.check("m.ply", "--against", self.ring, "-C", "0.1", code=5)
        self.assertEqual((report["C"], report["Q"]), (0.1, 1.65))
        self.assertNotIn("Q", report["origin"]["taken"])
        self.assertGreater(report["violations_U"], 0)
        report = self.check("m.ply", "--against", self.ring, "--model", "sas", code=5)
        self.assertEqual(report["model"], "sas")
        self.assertNotIn("fitting_model", report)

    def test_a_moved_vertex_and_a_turned_triangle_are_noticed_and_judged_anew(self):
        self.meshed("-o", "m.off")
        rows = self.lines("m.off")
        words = rows[2].split()
        moved = [repr(float(words[0]) + 1e-3), *words[1:]]
        self.input("moved.off", "\n".join([*rows[:2], " ".join(moved), *rows[3:]]) + "\n")
        origin = self.origin("moved.off", "--against", self.ring, code=5)
        self.assertEqual((origin["coordinates_match"], origin["faces_match"]), (False, True))
        said = self.run_morskin("check", "moved.off").stdout.decode()
        self.assertRegex(said, r"CHANGED +coordinates:")
        face = next(i for i, row in enumerate(rows) if row.startswith("3 "))
        n, a, b, c = rows[face].split()
        self.input("turned.off", "\n".join([*rows[:face], f"{n} {b} {c} {a}", *rows[face + 1:]])
                   + "\n")
        origin = self.origin("turned.off", "--against", self.ring)
        self.assertEqual((origin["coordinates_match"], origin["faces_match"]), (True, False))

    def test_a_mesh_that_failed_says_so_inside_and_a_forged_verdict_changes_nothing(self):
        names = ["m.ply", "m.obj", "m.off", "m.vert", "m.stl", "m.vtu"]
        self.meshed("--method", "marching-cubes",
                    *(word for name in names for word in ("-o", name)), code=5)
        for name in (*names, "m.face"):
            if name == "m.vtu":
                self.input("u.vtu", (self.folder / "m.vtu.unverified").read_bytes())
                said = bytes(meshio.read(self.folder / "u.vtu").field_data["verdict"])
                self.assertEqual(said, b"not certified")
                continue
            self.assertIn(b"not certified", (self.folder / f"{name}.unverified").read_bytes())
        forged = self.altered(b"verdict not certified", b"verdict certified", "m.ply.unverified")
        report = self.check(forged, "--against", self.ring, code=5)
        self.assertFalse(report["certified"])
        self.assertEqual(report["origin"]["stated"]["verdict"], "certified")

    def test_a_forged_model_is_named_and_does_not_pass_and_the_right_one_is_found(self):
        self.meshed("-o", "m.ply")
        forged = self.altered(b"morskin: model vdw", b"morskin: model sas")
        report = self.check(forged, "--against", self.ring, code=5)
        self.assertEqual((report["model"], report["fitting_model"]), ("sas", "vdw"))
        self.assertTrue(self.check(forged, "--against", self.ring, "--model", "vdw")["certified"])

    def test_a_forged_C_lets_coarse_triangles_pass_and_is_named(self):
        self.meshed("-o", "m.ply", "-C", "0.3")
        forged = self.altered(b"morskin: C 0.3\n", b"morskin: C 0.35\n")
        said = self.run_morskin("check", forged, "--against", self.ring).stdout.decode()
        self.assertIn("C 0.35", said)
        self.assertRegex(said, "taken .* C, Q from the mesh file")

    def test_another_input_of_the_same_name_is_noticed_and_the_same_one_renamed_is_not(self):
        self.meshed("-o", "m.ply")
        renamed = self.input("x.xyzr", self.ring.read_bytes())
        packed = self.input("y.xyzr.gz", gzip.compress(self.ring.read_bytes()))
        for same in (renamed, packed):
            self.assertTrue(self.origin("m.ply", "--against", same)["input_matches"])
        self.meshed("-o", "p.ply", molecule=packed)
        self.assertEqual(self.ply_entries("p.ply")["input-sha256"],
                         self.ply_entries()["input-sha256"])
        self.ring.write_bytes(self.ring.read_bytes() + b"# longer\n")
        report = self.check("m.ply", "--against", self.ring)
        self.assertFalse(report["origin"]["input_matches"])
        self.assertTrue(report["certified"])

    def test_names_of_inputs_with_any_bytes_are_spelled_in_ASCII_and_can_be_had_back(self):
        for name in (b"a\nelement vertex 0\n.xyzr", b"k\xe4se.xyzr", "å b;c\\".encode() + b".xyzr",
                     b"%41.xyzr"):
            with self.subTest(name):
                path = os.fsencode(self.folder) + b"/" + name
                os.link(self.ring, path)
                self.run_morskin("mesh", os.fsdecode(path), "-q", "-o", "m.ply", "-o", "m.obj",
                                 "-o", "m.off", "-o", "m.vert", "-o", "m.vtu")
                said = self.ply_entries()["input"]
                self.assertTrue(re.fullmatch(r"[\w.%~-]+", said, re.ASCII))
                self.assertEqual(urllib.parse.unquote_to_bytes(said), name)
                meshio.read(self.folder / "m.vtu")
                for mesh in ("m.ply", "m.obj", "m.off", "m.vert"):
                    self.assertTrue(self.check(mesh, "--against", self.ring)["certified"])

    def test_statements_that_mean_harm_are_not_taken_and_the_verdict_is_the_mesh_s(self):
        self.meshed("-o", "m.ply")
        for key, value in [("probe", b"1e999"), ("probe", b"nan"), ("probe", b"-1"),
                           ("probe", b"1.4 1.4"), ("probe", b""), ("probe", b"0x1p3"),
                           ("model", b"other"), ("model", b"given"), ("model", b"\x1b[2J\xff\x00"),
                           ("C", b"-1"), ("C", b"inf"), ("C", b"5"), ("Q", b"0"), ("C", b"1e-300"),
                           ("voids", b"%"), ("voids", b"%zz"), ("voids", b"nan"),
                           ("voids", b"%1b[2J"), ("voids", b"k" * 10000)]:
            with self.subTest(key=key, value=value[:20]):
                old = next(line for line in ply_parts((self.folder / "m.ply").read_bytes())[0]
                           if line.startswith(f"comment morskin: {key} "))
                forged = self.altered(old.encode(), f"comment morskin: {key} ".encode() + value)
                report = self.check(forged, "--against", self.ring)
                self.assertTrue(report["certified"])
                self.assertTrue(report["origin"]["not_taken"])
                self.assertNotIn(key, report["origin"]["taken"])
                said = self.run_morskin("check", forged, "--against", self.ring).stdout
                self.assertFalse(set(said) & set(range(32)) - {10})
                self.assertLess(len(said), 10000)

    def test_one_statement_that_makes_no_sense_takes_no_other_with_it(self):
        self.meshed("-o", "m.ply", "--model", "sas", "-C", "0.2", molecule=CRAMBIN)
        for key, value in (("chain", "Q"), ("voids", "-5"), ("Q", "0.1"), ("model-number", "7")):
            with self.subTest(key):
                lines = ply_parts((self.folder / "m.ply").read_bytes())[0]
                stated = f"comment morskin: {key} {value}"
                old = [line for line in lines if line.startswith(f"comment morskin: {key} ")]
                if not old:
                    old = [line for line in lines if line.startswith("comment morskin: probe ")]
                    stated = f"{old[0]}\n{stated}"
                forged = self.altered(old[0].encode(), stated.encode())
                # With the default C the triangles are too large.
                origin = self.check(forged, "--against", CRAMBIN,
                                    code=5 if key == "Q" else 0)["origin"]
                refused = "C, Q" if key == "Q" else key
                self.assertEqual([said.split(":")[0] for said in origin["not_taken"]], [refused])
                self.assertTrue({"model", "probe"} <= set(origin["taken"]))
                self.assertEqual("C" in origin["taken"], key != "Q")

    def test_a_chain_that_the_input_lacks_is_not_taken(self):
        self.meshed("-o", "m.ply", "-C", "0.2", molecule=CRAMBIN)
        for chain in (b"Z", b"%1b%0a", b",", b"A,"):
            forged = self.altered(b"comment morskin: voids", b"comment morskin: chain " + chain +
                                  b"\ncomment morskin: voids")
            said = self.run_morskin("check", forged, "--against", CRAMBIN, code=None)
            self.assertIn(b"not taken", said.stdout)
            self.assertFalse(set(said.stdout) & set(range(32)) - {10})

    def test_a_chain_of_a_byte_that_is_no_text_is_taken_and_shown(self):
        atom = b"ATOM  %5d  CA  GLY %c%4d    %8.3f   0.000   0.000  1.00  0.00           C\n"
        strange = self.input("strange.pdb", b"".join(
            atom % (i, chain, i, 9 * i) for i, chain in ((1, 0xff), (2, 0x41))))
        self.run_morskin("mesh", strange, "-q", "-o", "m.ply", "--chain", os.fsdecode(b"\xff"))
        self.assertEqual(self.ply_entries()["chain"], "%FF")
        report = self.check("m.ply", "--against", strange)
        self.assertTrue(report["certified"])
        self.assertIn("chain", report["origin"]["taken"])
        self.run_morskin("check", "m.ply", "--against", strange)

    def test_what_is_stated_twice_is_not_taken(self):
        self.meshed("-o", "m.ply")
        forged = self.altered(b"comment morskin: model vdw",
                              b"comment morskin: model sas\ncomment morskin: model vdw")
        report = self.check(forged, "--against", self.ring)
        self.assertEqual(report["origin"]["not_taken"], ["model: is stated 2 times"])
        self.assertNotIn("model", report["origin"]["stated"])
        twice = self.altered(b"comment morskin: faces-sha256",
                             b"comment morskin: faces-sha256 00\ncomment morskin: faces-sha256")
        self.assertNotIn("faces_match", self.origin(twice))

    def test_ten_megabytes_of_comments_cost_no_more_than_reading_them(self):
        self.meshed("-o", "m.ply", "-o", "m.off", "-o", "m.vert")
        long, many = b"x" * 10_000_000, b"comment morskin: x y\n" * 400_000
        for mesh in (self.altered(b"morskin: input ", b"morskin: input " + long),
                     self.altered(b"comment morskin: version", many + b"comment morskin: version",
                                  to="many.ply"),
                     self.altered(b"# morskin: version", b"# " + long + b"\n# morskin: version",
                                  "m.off", "long.off"),
                     self.altered(b"version 0", b"a b; " * 400_000 + b"version 0", "m.vert",
                                  "n.vert")):
            with self.subTest(mesh.name):
                if mesh.name == "n.vert":
                    self.input("n.face", (self.folder / "m.face").read_bytes())
                report = self.check(mesh, "--against", self.ring, "--timeout", "20")
                self.assertTrue(report["certified"])
                self.assertLess(len(json.dumps(report["origin"]["taken"])), 1000)

    def test_an_STL_file_tells_whether_it_was_changed(self):
        self.meshed("-o", "m.stl")
        origin = self.origin("m.stl", "--against", self.ring, code=None)
        self.assertTrue(origin["coordinates_match"] and origin["input_matches"])
        data = bytearray((self.folder / "m.stl").read_bytes())
        data[84 + 50 + 12] ^= 1
        self.input("bent.stl", bytes(data))
        self.assertFalse(self.origin("bent.stl", code=None)["coordinates_match"])

    def test_a_mesh_of_no_known_origin_has_none_and_is_checked_as_before(self):
        self.meshed("-o", "m.off")
        rows = [row for row in self.lines("m.off") if not row.startswith("#")]
        self.input("bare.off", "\n".join(rows) + "\n")
        report = self.check("bare.off", "--against", self.ring)
        self.assertNotIn("origin", report)
        self.assertTrue(report["certified"])

    def test_skins_of_grown_balls_say_that_check_does_not_know_them(self):
        self.meshed("-o", "m.ply", "--method", "dynamic", "--grow", "-3..-0.5", code=None)
        name = next(name for name in self.names() if name.startswith("m.ply"))
        self.assertEqual(self.ply_entries(name)["grow"], "-0.5")
        self.assertTrue(any(why.startswith("grow") for why in self.origin(
            name, "--against", self.ring, code=None)["not_taken"]))


if __name__ == "__main__":
    main()
