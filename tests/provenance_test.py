#!/usr/bin/env python3
"""What mesh files say of their origin, and what `check` makes of it.
Usage: provenance_test.py path/to/morskin"""

import gzip
import hashlib
import os
import re
import struct
import time
import urllib.parse

import meshio
import numpy

from support.command import main
from support.provenance import CRAMBIN, ProvenanceTest, entries, ply_parts

RUN = ("-C", "0.2", "--model", "sas", "--probe", "1.2", "--voids", "drop", "--hydrogens", "drop",
       "--chain", "A")


class Provenance(ProvenanceTest):
    def lines(self, name):
        return (self.folder / name).read_bytes().decode(errors="replace").splitlines()

    def ply_entries(self, name="m.ply"):
        return entries(ply_parts((self.folder / name).read_bytes())[0])

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
        self.assertIn("certified before rounding, input " + said["input-sha256"][:8] + ", corners ",
                      header)

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
        self.assertIn(f"corners {hashlib.sha256(corners).hexdigest()[:8]}", stl[:80].decode())

    def test_the_report_has_the_keys_of_the_file(self):
        report = self.mesh_json(self.ring, "-o", "m.ply")["provenance"]
        self.assertEqual({k: str(v) for k, v in report.items()}, self.ply_entries())

    def test_neither_folder_nor_output_name_nor_time_changes_a_byte(self):
        self.meshed("-o", "a.ply")
        (self.folder / "other").mkdir()
        moved = self.input("other/ring.xyzr", self.ring.read_bytes())
        time.sleep(1.1)  # another second, if any were told
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

    def test_a_probe_that_older_files_state_of_models_without_one_changes_no_verdict(self):
        self.meshed("-o", "m.ply", "-C", "0.2")
        new = (self.folder / "m.ply").read_bytes()
        self.assertEqual(new.count(b"morskin: probe"), 0)
        old = self.input("old.ply", new.replace(b"comment morskin: model vdw\n",
                                                b"comment morskin: model vdw\n"
                                                b"comment morskin: probe 1.4\n"))
        report = self.check(old, "--against", self.ring)
        self.assertTrue(report["certified"])
        self.assertNotIn("probe", report)
        self.assertEqual(report["origin"]["stated"]["probe"], "1.4")
        self.assertEqual(report["origin"]["taken"], ["model", "probe", "voids", "C", "Q"])
        self.assertEqual(report["origin"]["not_taken"], [])
        self.assertTrue(report["origin"]["coordinates_match"])
        report = self.check(old, "--against", self.ring, "--model", "sas", code=5)
        self.assertEqual((report["model"], report["probe"]), ("sas", 1.4))

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
        words = ("--against", self.ring, "-Q", "1.3")
        C = self.check("m.ply", *words, code=5)["fitting_C"]
        self.assertTrue(self.check("m.ply", *words, "-C", C)["passed"])

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

    def test_an_STL_file_tells_whether_it_was_changed(self):
        self.meshed("-o", "m.stl")
        origin = self.origin("m.stl", "--against", self.ring, code=None)
        self.assertTrue(origin["coordinates_match"] and origin["input_matches"])
        data = bytearray((self.folder / "m.stl").read_bytes())
        data[84 + 50 + 12] ^= 1
        self.input("bent.stl", bytes(data))
        self.assertFalse(self.origin("bent.stl", code=None)["coordinates_match"])
        data[18] = ord("\n")  # as a line of the report
        self.input("bent.stl", bytes(data))
        said = self.run_morskin("check", "bent.stl", code=None).stdout.decode().splitlines()[1]
        self.assertRegex(said, 'origin .*A, .ertified before rounding, input .*, corners .*"$')

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
