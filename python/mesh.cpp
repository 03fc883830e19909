#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <filesystem>
#include <string>
#include <variant>
#include <vector>

#include "python/arguments.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/definitions.h"
#include "python/interruptible.h"

namespace morskin::python {

/// One name or several.
using Names = std::variant<std::string, std::vector<std::string>>;
template <>
inline constexpr const char* kind_of<Names> = "a string or a sequence of strings";

namespace {

std::string in_words(const Certificate& c) {
  const std::string verdict = c.certified ? "certified" : "not certified: " + c.reason;
  return "<morskin.Certificate: " + verdict + ">";
}

std::string in_words(const Mesh& mesh) {
  const TriangleMesh& triangles = mesh.mesh().triangles();
  return "<morskin.Mesh: " + std::to_string(triangles.vertices.size()) + " vertices, " +
         std::to_string(triangles.triangles.size()) + " faces, " +
         (mesh.mesh().certificate().certified ? "certified>" : "not certified>");
}

/// A property that is a view of a field of SkinPoint, which the mesh keeps.
template <class Field>
auto column(Field SkinPoint::*field) {
  return [field](const py::object& self) {
    return view(self.cast<const Mesh&>().points(), field, self);
  };
}

void bind_certificate(py::module_& module) {
  py::class_<Certificate>(module, "Certificate", "What is proved of a mesh, and how good it is.")
      .def_readonly(
          "certified", &Certificate::certified,
          "bool: homeomorphic to the skin, with all vertices on it, [U], and [L] or angles of at "
          "least 30 degrees")
      .def_readonly("is_homeomorphic", &Certificate::is_homeomorphic,
                    "bool: homeomorphic to the skin, even isotopic")
      .def_readonly("reason", &Certificate::reason,
                    "str: why the mesh is not certified; empty if it is")
      .def_readonly("components", &Certificate::components,
                    "int: connected components; 0 where the mesh is no closed manifold")
      .def_readonly("genus", &Certificate::genus,
                    "int: summed over components; 0 where the mesh is no closed manifold")
      .def_readonly("min_angle_deg", &Certificate::min_angle_deg, "float: degrees")
      .def_readonly("max_angle_deg", &Certificate::max_angle_deg, "float: degrees")
      .def_readonly("area", &Certificate::area, "float: Angstrom^2")
      .def_readonly("volume", &Certificate::volume,
                    "float: Angstrom^3, voids taken off; nan where the mesh is no closed manifold")
      .def_readonly("max_distance_to_skin", &Certificate::max_distance_to_skin,
                    "float: of a vertex, Angstrom; inf where none is known")
      .def_readonly("size_violations", &Certificate::size_violations,
                    "int: edges that break [L] and triangles that break [U]")
      .def("__repr__", [](const Certificate& c) { return in_words(c); });
}

void bind_arrays(py::class_<Mesh>& mesh) {
  mesh.def_property_readonly(
          "vertices",
          [](const py::object& self) {
            return view(self.cast<const Mesh&>().mesh().triangles().vertices, self);
          },
          "(n, 3) float64: positions on the skin, Angstrom")
      .def_property_readonly(
          "faces",
          [](const py::object& self) {
            return view(self.cast<const Mesh&>().mesh().triangles().triangles, self);
          },
          "(m, 3) uint32: vertices of each triangle, counter-clockwise seen from outside")
      .def_property_readonly("normals", column(&SkinPoint::normal),
                             "(n, 3) float64: the skin's unit normals, out of the body")
      .def_property_readonly("length_scales", column(&SkinPoint::length_scale),
                             "(n,) float64: smallest radius of curvature, Angstrom")
      .def_property_readonly("curvatures", column(&SkinPoint::curvatures),
                             "(n, 2) float64: principal curvatures, k1 >= k2, 1/Angstrom, positive "
                             "where the body is convex")
      .def_property_readonly("directions", column(&SkinPoint::directions),
                             "(n, 2, 3) float64: principal directions, unit, in the order of "
                             "`curvatures`;\nfirst x second = normal")
      .def_property_readonly("atoms", column(&SkinPoint::atom),
                             "(n,) uint32: atom of the least power distance, counted from 0")
      .def_property_readonly(
          "atom_ids", column(&SkinPoint::atoms),
          "(n, 4) int32: atoms that make the skin at the vertex, counted from 0; "
          "-1 where fewer than 4")
      .def_property_readonly("atom_weights", column(&SkinPoint::shares),
                             "(n, 4) float64: their shares, 1 in sum; 0 where fewer than 4")
      .def_property_readonly("components", column(&SkinPoint::component),
                             "(n,) uint32: component of the mesh, counted from 0 in the order of "
                             "the vertices");
}

/// What Skin.mesh and check() must be given for the same sizes of triangles.
py::dict sizing_of(const Mesh& mesh) {
  const MeshOptions sizing = mesh.mesh().sizing();
  return py::dict(py::arg("C") = sizing.C, py::arg("Q") = sizing.Q.value(),
                  py::arg("max_length_scale") = sizing.max_length_scale);
}

std::filesystem::path save(const Mesh& mesh, const py::object& file,
                           const py::object& vertex_data) {
  const std::filesystem::path path = path_from(file);
  const auto data = argument<Names>(vertex_data, "vertex_data");
  const auto* const one = std::get_if<std::string>(&data);
  const std::vector<std::string> names =
      one != nullptr ? std::vector{*one} : std::get<std::vector<std::string>>(data);
  return interruptible({py::int_(1), py::none()},
                       [&](const RunOptions& run) { return mesh.mesh().write(path, names, run); });
}

/// A function of morskin/exports.py, which imports another package, as a method.
auto exporter(const char* name) {
  return [name](const py::object& mesh) {
    return py::module_::import("morskin.exports").attr(name)(mesh);
  };
}

}  // namespace

void bind_mesh(py::module_& module) {
  bind_certificate(module);
  py::class_<Mesh> mesh(
      module, "Mesh",
      "A triangle mesh of a skin, with n vertices and m faces.\n\n"
      "Its arrays are read-only views of the mesh's own memory; copy what is to be "
      "changed.\nArrays by vertex beside `vertices` are found when one of them is first "
      "asked for.");
  bind_arrays(mesh);
  mesh.def_property_readonly(
          "certificate", [](const Mesh& self) { return self.mesh().certificate(); },
          "Certificate: what is proved of this mesh")
      .def_property_readonly(
          "fallbacks", [](const Mesh& self) { return self.mesh().fallbacks(); },
          "list of str: what took the place of parts that were not certified at first")
      .def_property_readonly(
          "skin", [](const Mesh& self) { return self.mesh().skin(); }, "Skin: that it is a mesh of")
      .def_property_readonly("sizing", sizing_of,
                             "dict: C, Q and max_length_scale that it was made with, as check() "
                             "takes them")
      .def("__repr__", [](const Mesh& self) { return in_words(self); });
  define(mesh, "save", save, py::arg("file"), py::kw_only(),
         py::arg("vertex_data") = std::vector<std::string>(),
         "save(file, *, vertex_data=()) -> pathlib.Path\n\n"
         "Writes PLY, OFF, OBJ, STL, VTU, GLB, NPZ, MSH or MSMS's .vert and .face, as the file's "
         "ending says, whole\nor not at all. Returns the file's name: a mesh that is not "
         "certified gets the ending .unverified.\n\n"
         "vertex_data  what PLY, VTU, GLB, NPZ and MSH hold beside the mesh: \"all\", or some of "
         "\"normal\",\n             \"curvature\", \"directions\", \"scale\", \"atom\", "
         "\"shares\", \"component\", \"patch\"\n\n"
         "Raises UnwritableOutput; RefusedInput for other names, a format that holds none, or\n"
         "triangles that single precision spoils, of STL and GLB.");
  define(mesh, "to_meshio", exporter("to_meshio"),
         "to_meshio() -> meshio.Mesh\n\nTriangles, with normals, length_scales, curvatures, atoms "
         "and components as point_data.\nFor Gmsh save() a file .msh. meshio writes Gmsh's files "
         "under the format \"gmsh\" only, and without\ncurvatures, since they are pairs; by the "
         "ending .msh it writes Fluent's.");
  define(mesh, "to_vtk", exporter("to_vtk"),
         "to_vtk() -> vtkPolyData\n\nThe same as a vtkPolyData; the normals are the active ones.");
}

}  // namespace morskin::python
