#!/usr/bin/env python3
"""Files of curved triangles: what meshio reads, and what `check` finds of corners and nodes.
Usage: second_order_command_test.py path/to/morskin"""

import base64

import meshio
import numpy

from support.command import MOLECULES, CommandTest, main

KINDS = {"m.vtu": "triangle6", "m.msh": "triangle6"}


class SecondOrder(CommandTest):
    def meshed(self, *words, molecule=MOLECULES / "benzene.pdb"):
        return self.mesh_json(molecule, "-C", "0.35", "--order", "2", *words)

    def test_meshio_reads_curved_triangles_over_the_flat_mesh(self):
        report = self.meshed("-o", "m.vtu", "-o", "m.msh", "-o", "m.off")
        vertices, faces = self.read_off("m.off")
        for name, kind in KINDS.items():
            with self.subTest(name):
                mesh = meshio.read(self.folder / name)
                cells = mesh.cells_dict[kind]
                numpy.testing.assert_array_equal(cells[:, :3], faces)
                numpy.testing.assert_array_equal(mesh.points[:len(vertices)], vertices)
                self.assertEqual(len(mesh.points), len(vertices) + len(faces) * 3 // 2)
                self.assertEqual(len(mesh.points), report["second_order"]["nodes"])
                # Each node in an edge is nearer to the edge's middle than the corners are.
                for k in range(3):
                    a, b = (mesh.points[cells[:, i]] for i in (k, (k + 1) % 3))
                    off = numpy.linalg.norm(mesh.points[cells[:, 3 + k]] - (a + b) / 2, axis=1)
                    self.assertTrue((off < numpy.linalg.norm(b - a, axis=1) / 2).all())

    def test_check_reads_the_corners_and_certifies_them(self):
        report = self.meshed("-o", "m.vtu", "-o", "m.msh")
        self.assertEqual(report["certified_file"], "m.vtu")
        for name in KINDS:
            with self.subTest(name):
                found = self.check(name, "--against", MOLECULES / "benzene.pdb")
                self.assertTrue(found["certified"])
                self.assertEqual(found["triangles"], report["triangles"])
                origin = found["origin"]
                self.assertTrue(origin["coordinates_match"] and origin["faces_match"])

    def test_check_refuses_files_whose_nodes_in_edges_are_wrong(self):
        report = self.meshed("-o", "m.vtu")
        mesh = meshio.read(self.folder / "m.vtu")
        cells = mesh.cells_dict["triangle6"]

        def verdicts(points, cells):
            meshio.Mesh(points, [("triangle6", cells)]).write(
                self.folder / "bad.vtu", binary=True, compression=None)
            meshio.Mesh(points, [("triangle6", cells)]).write(
                self.folder / "bad.msh", file_format="gmsh", binary=False)
            found = []
            for name in ("bad.vtu", "bad.msh"):
                told = self.check(name, "--against", MOLECULES / "benzene.pdb", "-C", "0.35",
                                  code=5)
                self.assertTrue(told["homeomorphic"])  # the corners are untouched
                self.assertFalse(told["certified"] or told["passed"])
                self.assertTrue(told["reason"])
                is_regular = all(v["holds"] for v in told["verdicts"] if "regular" in v["name"])
                self.assertEqual(told["second_order"]["least_jacobian"] is not None, is_regular)
                said = self.run_morskin("check", name, code=None).stdout
                self.assertEqual(b"Jacobians at least" in said, is_regular)
                found.append({v["name"] for v in told["verdicts"]
                              if v["required"] and not v["holds"]})
            self.assertEqual(*found)
            return found[0]

        def with_node(place):
            points = mesh.points.copy()
            points[cells[7, 3]] = place
            return points

        a, b, c, ab, bc = (mesh.points[cells[7, k]] for k in range(5))
        up = numpy.cross(b - a, c - a)
        up /= numpy.linalg.norm(up)
        self.assertEqual(verdicts(with_node(ab + 1e-6 * up), cells), {"nodes in edges on the skin"})
        self.assertIn("one node in each edge", verdicts(with_node(ab + 1e3 * up), cells))
        self.assertIn("curved triangles regular, proved",
                      verdicts(with_node(a + (c - a) * 0.7), cells))
        swapped = cells.copy()
        swapped[7, 3], swapped[7, 4] = cells[7, 4], cells[7, 3]
        self.assertIn("one node in each edge", verdicts(mesh.points, swapped))
        own = cells.copy()
        own[7, 3] = len(mesh.points)  # a node of its own, at the same place: a crack
        self.assertEqual(verdicts(numpy.vstack([mesh.points, ab]), own), {"one node in each edge"})
        self.assertEqual(report["second_order"]["nodes"], len(mesh.points))

    def test_check_tells_of_curved_triangles_what_mesh_told(self):
        report = self.meshed("-o", "m.vtu", "-o", "m.msh")
        for name in KINDS:
            with self.subTest(name):
                found = self.check(name, "--against", MOLECULES / "benzene.pdb")
                self.assertEqual(found["second_order"], report["second_order"])
                self.assertIn("nodes in edges on the skin", {v["name"] for v in found["verdicts"]})
                self.assertIn(b"nodes in edges", self.run_morskin("check", "--help").stdout)
                said = self.run_morskin("check", name).stdout
                self.assertIn(b"coordinates of corners, faces, by SHA-256", said)

    def test_flat_vtu_and_msh_files_are_read_back_and_checked_too(self):
        for name in KINDS:
            with self.subTest(name):
                report = self.mesh_json(self.ring, "-o", name)
                self.assertEqual(report["certified_file"], name)
                self.assertTrue(self.check(name, "--against", self.ring)["certified"])

    def test_check_reads_what_meshio_writes_of_curved_triangles(self):
        self.meshed("-o", "m.vtu")
        mesh = meshio.read(self.folder / "m.vtu")
        bare = meshio.Mesh(mesh.points, mesh.cells)
        bare.write(self.folder / "theirs.vtu", binary=True, compression=None)
        bare.write(self.folder / "text.vtu", binary=False)
        bare.write(self.folder / "theirs.msh", file_format="gmsh", binary=False)
        single = meshio.Mesh(mesh.points.astype(numpy.float32), mesh.cells)
        single.write(self.folder / "single.vtu", binary=True, compression=None)
        for name in ("theirs.vtu", "text.vtu", "theirs.msh", "single.vtu"):
            with self.subTest(name):
                self.assertTrue(self.check(name, "--against", MOLECULES / "benzene.pdb", "-C",
                                           "0.35")["certified"])
        bare.write(self.folder / "zipped.vtu")
        self.assertIn(b"compress", self.run_morskin("check", "zipped.vtu", code=3).stderr)

    def test_what_is_told_of_the_skin_is_told_at_every_node(self):
        self.meshed("-o", "m.vtu", "-o", "m.msh", "-o", "m.npz", "--vertex-data", "all")
        vtu, msh = (meshio.read(self.folder / name) for name in KINDS)
        with numpy.load(self.folder / "m.npz") as archive:
            flat = dict(archive)
        n = len(flat["vertices"])
        for name in ("normal", "curvature", "atom", "component"):
            self.assertEqual(len(vtu.point_data[name]), len(vtu.points))
        numpy.testing.assert_array_equal(vtu.point_data["normal"][:n], flat["normals"])
        numpy.testing.assert_array_equal(vtu.point_data["curvature"][:n, 0], flat["k1"])
        numpy.testing.assert_array_equal(msh.point_data["k1"].ravel(),
                                         vtu.point_data["curvature"][:, 0])
        self.assertEqual(set(vtu.point_data["component"][:, 0]), set(flat["component"]))
        unit = numpy.linalg.norm(vtu.point_data["normal"], axis=1)
        numpy.testing.assert_allclose(unit, 1)

    def test_curved_triangles_lack_a_twelfth_of_what_flat_ones_do_and_finer_ones_a_hundredth(self):
        def lacking(C):
            report = self.mesh_json(MOLECULES / "benzene.pdb", "-C", C, "--order", "2", "-o",
                                    "m.vtu")
            return exact - report["area"], abs(exact - report["second_order"]["area"])

        exact = self.mesh_json(MOLECULES / "benzene.pdb", "-C", "0.03", "--order", "2", "-o",
                               "fine.vtu")["second_order"]["area"]
        for C, share in ((0.35, 1 / 12), (0.15, 0.01)):
            flat, curved = lacking(C)
            self.assertGreater(flat, 0)
            self.assertLess(curved, share * flat)

    def test_where_a_triangle_might_fold_over_the_run_is_refused_and_no_file_is_left(self):
        done = self.run_morskin("mesh", MOLECULES / "1crn.pdb", "-C", "0.65", "--model", "paper",
                                "--order", "2", "-o", "m.vtu", "-o", "m.ply", code=4)
        self.assertIn(b"the Jacobian of the second-order triangle", done.stderr)
        self.assertEqual(self.names(), [])

    def test_the_mesh_is_the_same_with_and_without(self):
        self.meshed("-o", "m.vtu", "-o", "a.off")
        self.run_morskin("mesh", MOLECULES / "benzene.pdb", "-C", "0.35", "-q", "-o", "b.off")
        self.assertEqual((self.folder / "a.off").read_bytes(),
                         (self.folder / "b.off").read_bytes())

    def test_order_2_is_refused_where_no_file_can_hold_it_and_other_orders_are_too(self):
        for words in (["-o", "m.ply", "--order", "2"], ["-o", "m.vtu", "--order", "3"],
                      ["-o", "m.vtu", "--order", "0"]):
            self.run_morskin("mesh", self.ring, *words, code=2)
        self.assertEqual(self.names(), [])

    def test_damaged_files_are_refused_with_a_reason(self):
        self.meshed("-o", "m.vtu", "-o", "m.msh", molecule=self.ring)
        vtu, msh = ((self.folder / name).read_text() for name in KINDS)
        base64 = vtu.index("connectivity")
        cases = {"short.vtu": vtu[:base64 + 200], "cells.vtu": vtu.replace("offsets", "upsets"),
                 "two.vtu": vtu.replace("</Piece>", "</Piece><Piece>"),
                 "base.vtu": vtu[:base64 + 60] + "!" + vtu[base64 + 61:],
                 "short.msh": msh[:len(msh) // 2], "old.msh": msh.replace("4.1 0 8", "2.2 0 8"),
                 "type.msh": msh.replace("\n2 1 9 ", "\n2 1 3 "),
                 "late.msh": msh[:msh.index("$Nodes")] + msh[msh.index("$Elements"):],
                 "bare.msh": "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n", "bare.vtu": "<VTKFile/>"}
        for name, text in cases.items():
            with self.subTest(name):
                said = self.run_morskin("check", self.input(name, text), code=3).stderr.decode()
                self.assertIn(name, said)

    def test_hostile_numbers_of_vtu_files_are_refused(self):
        def text(points="0 0 0 1 0 0 0 1 0", corners="0 1 2", ends="3", kinds="5", kind="ascii"):
            def array(name, type_, numbers):
                return (f'<DataArray Name="{name}" type="{type_}" format="{kind}">{numbers}'
                        "</DataArray>")
            return ('<VTKFile type="UnstructuredGrid" byte_order="LittleEndian"><Piece><Points>'
                    + array("Points", "Float64", points) + "</Points><Cells>"
                    + array("connectivity", "Int64", corners) + array("offsets", "Int64", ends)
                    + array("types", "UInt8", kinds) + "</Cells></Piece></VTKFile>")

        self.run_morskin("check", self.input("open.vtu", text()), code=5)
        cases = [dict(points=p) for p in ("0 0", "nan 0 0 1 0 0 0 1 0", "1e999 0 0 1 0 0 0 1 0")]
        cases += [dict(corners=c) for c in ("0 1 -1", "0 1 3", "0 1 1e300", "0 1 0.5", "0 1", "")]
        cases += [dict(ends=e) for e in ("-3", "4", "9223372036854775807", "3 6", "0")]
        cases += [dict(kinds=k) for k in ("9", "22", "-5", "5 5", "")]
        cases += [dict(kind=k) for k in ("appended", "binary", "")]
        for case in cases:
            with self.subTest(case):
                self.run_morskin("check", self.input("bad.vtu", text(**case)), code=3)
        for size in (b"\xff" * 8, b"\0" * 7 + b"\x80", b"\0" * 8):  # not that of what follows
            encoded = base64.b64encode(size + b"\0" * 72).decode()
            said = self.run_morskin("check", self.input("bad.vtu", text(encoded, kind="binary")),
                                    code=3).stderr
            self.assertIn(b"damaged", said)


if __name__ == "__main__":
    main()
