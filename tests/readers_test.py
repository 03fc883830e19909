#!/usr/bin/env python3
"""Files of `mesh` opened by the programs they are for: VTK and Gmsh, which are large
(cmake/readers_packages.txt). Usage: readers_test.py path/to/morskin"""

import gmsh
import numpy
import vtk
from vtk.util.numpy_support import vtk_to_numpy

from support.command import MOLECULES, CommandTest, main


class Readers(CommandTest):
    @classmethod
    def setUpClass(cls):
        gmsh.initialize()
        gmsh.option.setNumber("General.Terminal", 0)

    @classmethod
    def tearDownClass(cls):
        gmsh.finalize()

    def setUp(self):
        super().setUp()
        names = ["m.vtu", "m.msh", "m.ply", "m.obj", "m.stl", "m.npz"]
        self.run_morskin("mesh", MOLECULES / "benzene.pdb", "-q", "--vertex-data", "all",
                         *(word for name in names for word in ("-o", name)))
        with numpy.load(self.folder / "m.npz") as archive:
            self.exact = dict(archive)

    def read_by(self, reader, name):
        reader.SetFileName(str(self.folder / name))
        reader.Update()
        return reader.GetOutput()

    def test_vtk_opens_vtu_with_all_that_is_told_and_where_it_comes_from(self):
        grid = self.read_by(vtk.vtkXMLUnstructuredGridReader(), "m.vtu")
        numpy.testing.assert_array_equal(vtk_to_numpy(grid.GetPoints().GetData()),
                                         self.exact["vertices"])
        self.assertEqual(grid.GetNumberOfCells(), len(self.exact["faces"]))
        normal = vtk_to_numpy(grid.GetPointData().GetArray("normal"))
        numpy.testing.assert_array_equal(normal, self.exact["normals"])
        patch = vtk_to_numpy(grid.GetCellData().GetArray("patch"))
        numpy.testing.assert_array_equal(patch, self.exact["face_patch"])
        fields = grid.GetFieldData()
        self.assertEqual(bytes(vtk_to_numpy(fields.GetArray("verdict"))), b"certified")
        self.assertEqual(fields.GetArray("C").GetValue(0), self.exact["C"])

    def test_vtk_opens_ply_obj_and_stl(self):
        for reader, name in ((vtk.vtkPLYReader(), "m.ply"), (vtk.vtkOBJReader(), "m.obj"),
                             (vtk.vtkSTLReader(), "m.stl")):
            with self.subTest(name):
                mesh = self.read_by(reader, name)
                self.assertEqual(mesh.GetNumberOfPolys(), len(self.exact["faces"]))

    def test_gmsh_opens_msh_with_all_that_is_told(self):
        gmsh.open(str(self.folder / "m.msh"))
        tags, positions, _ = gmsh.model.mesh.getNodes()
        numpy.testing.assert_array_equal(tags, numpy.arange(len(self.exact["vertices"])) + 1)
        numpy.testing.assert_array_equal(positions.reshape(-1, 3), self.exact["vertices"])
        kinds, _, corners = gmsh.model.mesh.getElements(2)
        self.assertEqual(list(kinds), [2])  # triangles of three nodes
        numpy.testing.assert_array_equal(corners[0].reshape(-1, 3), self.exact["faces"] + 1)
        views = {gmsh.option.getString(f"View[{gmsh.view.getIndex(tag)}].Name"): tag
                 for tag in gmsh.view.getTags()}
        for column in ("k1", "length_scale", "atom", "share1"):
            data = numpy.array(gmsh.view.getModelData(views[column], 0)[2]).ravel()
            numpy.testing.assert_array_equal(data, self.exact[column])
        data = numpy.array(gmsh.view.getModelData(views["normal"], 0)[2])
        numpy.testing.assert_array_equal(data, self.exact["normals"])

    def test_vtk_and_gmsh_open_curved_triangles_and_find_the_same_area(self):
        report = self.mesh_json(MOLECULES / "benzene.pdb", "-C", "0.35", "--order", "2", "-o",
                                "c.vtu", "-o", "c.msh", "-o", "c.npz")
        grid = self.read_by(vtk.vtkXMLUnstructuredGridReader(), "c.vtu")
        self.assertEqual(grid.GetCell(0).GetCellType(), vtk.VTK_QUADRATIC_TRIANGLE)
        self.assertEqual(grid.GetNumberOfPoints(), report["second_order"]["nodes"])
        tessellation = vtk.vtkDataSetSurfaceFilter()
        tessellation.SetInputData(grid)
        tessellation.SetNonlinearSubdivisionLevel(3)
        area = vtk.vtkMassProperties()
        area.SetInputConnection(tessellation.GetOutputPort())
        self.assertLess(abs(area.GetSurfaceArea() / report["second_order"]["area"] - 1), 1e-3)
        gmsh.open(str(self.folder / "c.msh"))
        kinds, tags, nodes = gmsh.model.mesh.getElements(2)
        self.assertEqual(list(kinds), [9])  # triangles of six nodes
        with numpy.load(self.folder / "c.npz") as archive:
            numpy.testing.assert_array_equal(nodes[0].reshape(-1, 6)[:, :3], archive["faces"] + 1)
        _, weights = gmsh.model.mesh.getIntegrationPoints(9, "Gauss6")
        _, determinants, _ = gmsh.model.mesh.getJacobians(
            9, gmsh.model.mesh.getIntegrationPoints(9, "Gauss6")[0])
        whole = (determinants.reshape(len(tags[0]), -1) * weights).sum()
        self.assertLess(abs(whole / report["second_order"]["area"] - 1), 1e-4)
        self.assertGreater(determinants.min(), 0)

    def test_gmsh_opens_stl(self):
        gmsh.open(str(self.folder / "m.stl"))
        _, elements, _ = gmsh.model.mesh.getElements(2)
        self.assertEqual(len(elements[0]), len(self.exact["faces"]))


if __name__ == "__main__":
    main()
