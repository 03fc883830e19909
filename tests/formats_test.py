#!/usr/bin/env python3
"""Formats that `mesh` only writes, and charges, read by others' readers.
Usage: formats_test.py path/to/morskin"""

import hashlib
import json
import os
import struct
import subprocess
import zipfile

import meshio
import numpy

from support.command import MOLECULES, CommandTest, main

# The charges are not physical; no other number of an atom is the same.
CHARGED = """\
ATOM  1 O  WAT A 1  0.0 0.0 0.0 -0.834 1.52
ATOM  2 H1 WAT A 1  0.95 0.0 0.0 0.417 1.1
ATOM  3 C  MET A 2  9.0 0.0 0.0 1.25 1.7
"""


def glb_parts(data):
    """The JSON and the numbers of a GLB file, read by glTF's specification."""
    magic, version, size, length, kind = struct.unpack_from("<4sIIII", data)
    assert (magic, version, size, kind) == (b"glTF", 2, len(data), 0x4E4F534A)
    root = json.loads(data[20:20 + length])
    binary_length, binary_kind = struct.unpack_from("<II", data, 20 + length)
    assert (binary_kind, 28 + length + binary_length) == (0x004E4942, len(data))
    return root, data[28 + length:]


def glb_array(root, numbers, accessor):
    a = root["accessors"][accessor]
    view = root["bufferViews"][a["bufferView"]]
    part = numbers[view["byteOffset"]:view["byteOffset"] + view["byteLength"]]
    array = numpy.frombuffer(part, {5126: "<f4", 5125: "<u4"}[a["componentType"]])
    return array.reshape(-1, 3) if a["type"] == "VEC3" else array


class Formats(CommandTest):
    def meshed(self, *words, molecule=None, code=0):
        self.run_morskin("mesh", molecule or self.ring, "-q", *words, code=code)

    def npz(self, name="m.npz"):
        with numpy.load(self.folder / name, allow_pickle=False) as archive:
            return dict(archive)

    def glb(self, name="m.glb"):
        """The JSON, and arrays by the names of attributes."""
        root, numbers = glb_parts((self.folder / name).read_bytes())
        primitive = root["meshes"][0]["primitives"][0]
        arrays = {key: glb_array(root, numbers, accessor)
                  for key, accessor in primitive["attributes"].items()}
        arrays["indices"] = glb_array(root, numbers, primitive["indices"])
        return root, arrays

    def test_npz_holds_the_mesh_to_the_last_bit_with_normals_and_all_that_is_told(self):
        self.meshed("-o", "m.npz", "-o", "m.off", "-o", "m.vtu", "--vertex-data", "all",
                    molecule=MOLECULES / "1crn.pdb")
        arrays = self.npz()
        vertices, triangles = self.read_off("m.off")
        numpy.testing.assert_array_equal(arrays["vertices"], vertices)
        numpy.testing.assert_array_equal(arrays["faces"], triangles)
        self.assertEqual((arrays["faces"].dtype, arrays["atom"].dtype), ("uint32", "int32"))
        vtu = meshio.read(self.folder / "m.vtu")
        numpy.testing.assert_array_equal(arrays["normals"], vtu.point_data["normal"])
        for name in ("curvature", "scale", "atom", "shares", "component", "residue"):
            data = vtu.point_data[name].reshape(len(vertices), -1)
            first = {"curvature": "k1", "scale": "length_scale", "shares": "share1"}.get(name, name)
            numpy.testing.assert_array_equal(arrays[first], data[:, 0])
        for name in ("component", "patch"):
            data = vtu.cell_data[name][0].reshape(len(triangles), -1)
            numpy.testing.assert_array_equal(arrays[f"face_{name}"], data[:, 0])

    def test_npz_has_numbers_of_the_run_as_scalars_and_all_metadata_as_json(self):
        report = self.mesh_json(self.ring, "-o", "m.npz", "-C", "0.2")
        arrays = self.npz()
        self.assertEqual((arrays["C"].shape, float(arrays["C"])), ((), 0.2))
        self.assertEqual(json.loads(str(arrays["metadata"])), report["provenance"])
        self.assertEqual(hashlib.sha256(arrays["vertices"].tobytes()).hexdigest(),
                         report["provenance"]["coordinates-sha256"])
        self.assertEqual(hashlib.sha256(arrays["faces"].tobytes()).hexdigest(),
                         report["provenance"]["faces-sha256"])

    def test_npz_is_the_same_in_every_time_zone_and_unzips_without_complaint(self):
        bytes_by_zone = set()
        for zone in ("UTC", "Asia/Tokyo", "America/New_York"):
            self.run_morskin("mesh", self.ring, "-q", "-o", "m.npz", env={**os.environ, "TZ": zone})
            bytes_by_zone.add((self.folder / "m.npz").read_bytes())
        self.assertEqual(len(bytes_by_zone), 1)
        with zipfile.ZipFile(self.folder / "m.npz") as archive:
            self.assertIsNone(archive.testzip())
            self.assertEqual({entry.date_time for entry in archive.infolist()},
                             {(1980, 1, 1, 0, 0, 0)})

    def test_glb_holds_the_mesh_in_single_precision_and_says_what_its_unit_is(self):
        self.meshed("-o", "m.glb", "-o", "m.npz", "--vertex-data", "all")
        root, arrays = self.glb()
        exact = self.npz()
        numpy.testing.assert_array_equal(arrays["POSITION"],
                                         exact["vertices"].astype(numpy.float32))
        numpy.testing.assert_array_equal(arrays["indices"].reshape(-1, 3), exact["faces"])
        self.assertLess(abs(numpy.linalg.norm(arrays["NORMAL"], axis=1) - 1).max(), 1e-6)
        for column in ("k1", "shape_index", "atom", "share4", "is_void", "length_scale"):
            numpy.testing.assert_array_equal(arrays[f"_{column.upper()}"],
                                             exact[column].astype(numpy.float32))
        extras = root["asset"]["extras"]
        self.assertEqual(extras["unit"], "Angstrom")
        said = extras["morskin"]
        self.assertEqual(said["verdict"], "certified before rounding")
        for key, array in (("coordinates-sha256", arrays["POSITION"]),
                           ("faces-sha256", arrays["indices"])):
            self.assertEqual(hashlib.sha256(array.tobytes()).hexdigest(), said[key])
        position = root["accessors"][0]
        numpy.testing.assert_array_equal(position["min"], arrays["POSITION"].min(axis=0))
        numpy.testing.assert_array_equal(position["max"], arrays["POSITION"].max(axis=0))

    def test_assimp_opens_glb_with_all_that_is_told(self):
        self.meshed("-o", "m.glb", "-o", "m.npz", "--vertex-data", "all")
        said = subprocess.run(["assimp", "info", "m.glb"], cwd=self.folder, capture_output=True)
        self.assertEqual(said.returncode, 0, said.stdout)
        rows = dict(row.split(":", 1) for row in said.stdout.decode().splitlines() if ":" in row)
        exact = self.npz()
        self.assertEqual(int(rows["Faces"]), len(exact["faces"]))
        self.assertEqual(int(rows["Vertices"]), len(exact["vertices"]))

    def test_assimp_opens_ply_obj_off_and_stl(self):
        names = ["m.ply", "m.obj", "m.off", "m.stl"]
        self.meshed(*(word for name in names for word in ("-o", name)))
        _, triangles = self.read_off("m.off")
        for name in names:
            with self.subTest(name):
                said = subprocess.run(["assimp", "info", name], cwd=self.folder,
                                      capture_output=True)
                self.assertRegex(said.stdout.decode(), rf"Faces: +{len(triangles)}\n")

    def test_meshio_opens_msh_with_all_that_is_told(self):
        self.meshed("-o", "m.msh", "-o", "m.npz", "--vertex-data", "all")
        mesh, exact = meshio.read(self.folder / "m.msh"), self.npz()
        numpy.testing.assert_array_equal(mesh.points, exact["vertices"])
        numpy.testing.assert_array_equal(mesh.cells_dict["triangle"], exact["faces"])
        numpy.testing.assert_array_equal(mesh.point_data["normal"], exact["normals"])
        for column in ("k1", "atom", "share1", "is_void"):
            numpy.testing.assert_array_equal(mesh.point_data[column].ravel(), exact[column])
        numpy.testing.assert_array_equal(mesh.cell_data["patch"][0].ravel(), exact["face_patch"])

    def test_msh_says_where_it_comes_from(self):
        report = self.mesh_json(self.ring, "-o", "m.msh")
        lines = (self.folder / "m.msh").read_text().splitlines()
        block = lines[lines.index("$Comments") + 1:lines.index("$EndComments")]
        said = dict(line.removeprefix("morskin: ").split(" ", 1) for line in block
                    if line.startswith("morskin: "))
        self.assertEqual(said, {k: str(v) for k, v in report["provenance"].items()})

    def test_what_is_only_written_is_certified_in_memory_and_refused_by_check(self):
        for name in ("m.glb", "m.npz"):
            with self.subTest(name):
                report = self.mesh_json(self.ring, "-o", name)
                self.assertTrue(report["certified"])
                self.assertIn("in memory", report["certified_file"])
                said = self.run_morskin("check", name, code=3).stderr
                self.assertIn(b"only written", said)

    def test_a_mesh_that_failed_says_so_inside(self):
        self.meshed("-o", "m.glb", "-o", "m.npz", "-o", "m.msh", "--method", "marching-cubes",
                    code=5)
        self.assertEqual(self.names(), ["m.glb.unverified", "m.msh.unverified",
                                        "m.npz.unverified"])
        root, _ = self.glb("m.glb.unverified")
        self.assertEqual(root["asset"]["extras"]["morskin"]["verdict"], "not certified")
        self.assertIn("not certified", str(self.npz("m.npz.unverified")["metadata"]))
        self.assertIn(b"verdict not certified", (self.folder / "m.msh.unverified").read_bytes())

    def test_columns_of_msms_files_line_up_and_hold_so_many_decimals(self):
        for decimals in (3, 5):
            self.meshed("-o", "m.vert", "-o", "m.off", "--decimals", decimals,
                        "--density", "5", molecule=MOLECULES / "1crn.pdb")
            rows = (self.folder / "m.vert").read_text().splitlines()[3:]
            width = decimals + 6
            self.assertEqual(len({len(row) for row in rows}), 1)
            vertices, _ = self.read_off("m.off")
            for row, vertex in zip(rows, vertices):
                for axis in range(3):
                    field = row[axis * (width + 1):axis * (width + 1) + width]
                    self.assertEqual(float(field), float(f"{vertex[axis]:.{decimals}f}"))
                    self.assertEqual(len(field.split(".")[1]), decimals)
            faces = (self.folder / "m.face").read_text().splitlines()[3:]
            self.assertEqual(len({len(row) for row in faces}), 1)
            origin = self.check("m.vert", code=None)["origin"]
            self.assertTrue(origin["coordinates_match"] and origin["faces_match"])

    def test_without_their_header_msms_s_files_are_tables_as_pygbe_and_pbj_read_them(self):
        for decimals in ([], ["--decimals", "3"]):
            self.meshed("-o", "m.vert", "-C", "0.3", *decimals)
            tables = []
            for name, kind in (("m.vert", float), ("m.face", int)):
                rows = (self.folder / name).read_text().split("\n", 3)[3]
                (self.folder / name).write_text(rows)
                tables.append(numpy.loadtxt(self.folder / name, dtype=kind))
            vertices, faces = tables
            self.assertEqual((vertices.shape[1], faces.shape[1]), (9, 5))
            self.assertEqual((faces[:, :3].min(), faces[:, :3].max()), (1, len(vertices)))
            self.assertEqual(self.check("m.vert", code=None)["triangles"], len(faces))

    def test_a_file_whose_digits_spoil_triangles_is_refused_and_leaves_nothing(self):
        far = "".join(f"{9e5 + 1.4 * k} 0 0 1.7\n" for k in range(3))
        (self.folder / "far.xyzr").write_text(far)
        for words in ((MOLECULES / "1crn.pdb", "-o", "m.vert", "--decimals", "1", "-C", "0.1"),
                      ("far.xyzr", "-o", "m.stl"), ("far.xyzr", "-o", "m.glb", "-o", "m.ply")):
            before = self.names()
            done = self.run_morskin("mesh", *words, code=4)
            self.assertRegex(done.stderr.decode(), r"m\.\w+: .* triangles would be turned over")
            self.assertNotIn(b"1 decimals", done.stderr)
            self.assertEqual(self.names(), before)

    def test_coordinates_that_are_wider_than_their_columns_are_refused(self):
        for x, code in ((-9998.49, 0), (-9998.51, 4), (99998.49, 0), (99998.51, 4), (9e5, 4)):
            ball = self.input("far.xyzr", f"{x} 0 0 1.5\n")
            done = self.run_morskin("mesh", ball, "-o", "m.vert", "--decimals", "3", code=code)
            self.assertEqual(b"m.vert: its columns" in done.stderr, code == 4, x)

    def test_three_decimals_are_not_called_certified_as_read_back(self):
        report = self.mesh_json(self.ring, "-o", "m.vert", "--decimals", "3")
        self.assertIn("in memory", report["certified_file"])
        self.assertIn("verdict certified before rounding", (self.folder / "m.vert").read_text())
        self.run_morskin("mesh", self.ring, "-o", "m.ply", "--decimals", "3", code=2)

    def test_an_atom_s_own_sphere_has_its_charge_and_between_atoms_it_is_interpolated(self):
        water = self.input("water.pqr", CHARGED)
        self.meshed("-o", "m.npz", "--waters", "--vertex-data", "charge,shares", molecule=water)
        a = self.npz()
        charges = numpy.array([-0.834, 0.417, 1.25, 0])  # the last for -1, no atom
        expected = sum(charges[a[f"atom{i}"]] * a[f"share{i}"] for i in (1, 2, 3, 4))
        numpy.testing.assert_allclose(a["partial_charge"], expected, atol=1e-12)
        self.assertTrue((a["partial_charge"][a["vertices"][:, 0] > 6] == 1.25).all())
        is_between = (a["share1"] > 0.1) & (a["share2"] > 0.1)
        self.assertTrue(is_between.any())
        self.assertTrue((abs(a["partial_charge"][is_between]) < 0.834).all())

    def test_charges_follow_the_atoms_that_are_kept(self):
        water = self.input("water.pqr", CHARGED)
        self.meshed("-o", "m.npz", "--vertex-data", "charge", molecule=water)
        self.assertEqual(set(self.npz()["partial_charge"]), {1.25})

    def test_charges_go_into_ply_vtu_msh_and_glb(self):
        water = self.input("water.pqr", CHARGED)
        self.meshed("-o", "m.ply", "-o", "m.vtu", "-o", "m.msh", "-o", "m.glb", "-o", "m.npz",
                    "--vertex-data", "charge", molecule=water)
        charge = self.npz()["partial_charge"]
        for name in ("m.ply", "m.vtu", "m.msh"):
            read = meshio.read(self.folder / name).point_data["partial_charge"]
            numpy.testing.assert_array_equal(read.ravel(), charge)
        numpy.testing.assert_array_equal(self.glb()[1]["_PARTIAL_CHARGE"],
                                         charge.astype(numpy.float32))

    def test_charges_of_an_input_that_has_none_are_refused_and_all_does_without(self):
        said = self.run_morskin("mesh", self.ring, "-o", "m.ply", "--vertex-data", "charge",
                                code=4).stderr
        self.assertIn(b"gives no charges", said)
        self.assertEqual(self.names(), [])
        self.meshed("-o", "m.npz", "--vertex-data", "all")
        self.assertNotIn("partial_charge", self.npz())

    def test_a_charge_that_is_no_finite_number_is_refused_by_its_line(self):
        for charge in ("nan", "inf", "-inf"):
            bad = self.input("bad.pqr", CHARGED.replace("1.25", charge))
            said = self.run_morskin("mesh", bad, "-o", "m.ply", code=4).stderr
            self.assertIn(b"bad.pqr:3: ", said)


if __name__ == "__main__":
    main()
