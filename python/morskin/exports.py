"""Meshes for other packages, which are imported when they are asked for."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:
    from ._morskin import Mesh


def _vertex_data(mesh: Mesh) -> dict[str, NDArray[Any]]:
    """What the mesh knows of its vertices, by name."""
    names = ["normals", "length_scales", "curvatures", "atoms", "components"]
    return {name: np.ascontiguousarray(getattr(mesh, name)) for name in names}


def to_meshio(mesh: Mesh) -> Any:
    """Mesh.to_meshio."""
    import meshio
    triangles = mesh.faces.astype(np.int64)  # meshio's writer of Fluent's files knows no uint32
    points = mesh.vertices.copy()  # as all else, to be written to
    return meshio.Mesh(points, [("triangle", triangles)], point_data=_vertex_data(mesh))


def to_vtk(mesh: Mesh) -> Any:
    """Mesh.to_vtk."""
    from vtkmodules.util.numpy_support import numpy_to_vtk, numpy_to_vtkIdTypeArray
    from vtkmodules.vtkCommonCore import vtkPoints
    from vtkmodules.vtkCommonDataModel import vtkCellArray, vtkPolyData
    points = vtkPoints()
    points.SetData(numpy_to_vtk(mesh.vertices, deep=True))
    rows = np.column_stack([np.full(len(mesh.faces), 3), mesh.faces]).astype(np.int64)
    cells = vtkCellArray()
    cells.SetCells(len(rows), numpy_to_vtkIdTypeArray(rows.ravel(), deep=True))
    result = vtkPolyData()
    result.SetPoints(points)
    result.SetPolys(cells)
    for name, values in _vertex_data(mesh).items():
        array = numpy_to_vtk(values, deep=True)
        array.SetName(name)
        result.GetPointData().AddArray(array)
    result.GetPointData().SetActiveNormals("normals")
    return result
