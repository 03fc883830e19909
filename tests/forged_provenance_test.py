#!/usr/bin/env python3
"""What `check` makes of origins that are false, senseless, doubled or endless.
Usage: forged_provenance_test.py path/to/morskin"""

import json

import meshio

from support.command import main
from support.provenance import CRAMBIN, ProvenanceTest, ply_parts


class ForgedProvenance(ProvenanceTest):
    def altered(self, old, new, name="m.ply", to="altered.ply"):
        data = (self.folder / name).read_bytes()
        self.assertIn(old, data)
        return self.input(to, data.replace(old, new, 1))

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

    def test_statements_that_mean_harm_are_not_taken_and_the_verdict_is_the_mesh_s(self):
        self.meshed("-o", "m.ply")
        for key, value in [("probe", b"1e999"), ("probe", b"nan"), ("probe", b"-1"),
                           ("probe", b"1.4 1.4"), ("probe", b""), ("probe", b"0x1p3"),
                           ("model", b"other"), ("model", b"given"), ("model", b"\x1b[2J\xff\x00"),
                           ("C", b"-1"), ("C", b"inf"), ("C", b"5"), ("Q", b"0"), ("C", b"1e-300"),
                           ("voids", b"%"), ("voids", b"%zz"), ("voids", b"nan"),
                           ("voids", b"%1b[2J"), ("voids", b"k" * 10000)]:
            with self.subTest(key=key, value=value[:20]):
                header = ply_parts((self.folder / "m.ply").read_bytes())[0]
                old = next((line for line in header if line.startswith(f"comment morskin: {key} ")),
                           "comment morskin: voids keep")  # what has no probe gets one before it
                stated = f"comment morskin: {key} ".encode() + value
                if key == "probe":
                    stated += b"\n" + old.encode()
                forged = self.altered(old.encode(), stated)
                report = self.check(forged, "--against", self.ring)
                self.assertTrue(report["certified"])
                self.assertTrue(report["origin"]["not_taken"])
                self.assertNotIn(key, report["origin"]["taken"])
                said = self.run_morskin("check", forged, "--against", self.ring).stdout
                self.assertFalse(set(said) & set(range(32)) - {10})
                self.assertLess(len(said), 10000)

    def test_C_Q_and_size_are_taken_together_or_not_at_all(self):
        self.meshed("-o", "m.ply", "-C", "0.3")
        for stated in (b"C 0,3", b"C 0.3\ncomment morskin: C 0.3",
                       b"C 0.3\ncomment morskin: size x"):
            forged = self.altered(b"morskin: C 0.3\n", b"morskin: " + stated + b"\n")
            report = self.check(forged, "--against", self.ring, code=5)
            self.assertEqual((report["C"], report["Q"]), (0.08, 1.65))
            self.assertFalse({"C", "Q", "size"} & set(report["origin"]["taken"]))

    def test_of_a_C_too_large_C_is_called_wrong_and_not_the_Q_that_goes_with_it(self):
        self.meshed("-o", "m.off", "-C", "0.3")
        text = (self.folder / "m.off").read_text()
        kept = [line for line in text.splitlines(keepends=True) if "morskin: Q " not in line]
        forged = self.input("far.off", "".join(kept).replace("morskin: C 0.3", "morskin: C 1e300"))
        told = self.check(forged, "--against", self.ring, code=5)["origin"]["not_taken"]
        self.assertEqual(told, ["C: -C must be at most 1e150"])

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


if __name__ == "__main__":
    main()
