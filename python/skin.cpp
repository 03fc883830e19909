#include <pybind11/stl.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "python/arguments.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/definitions.h"
#include "python/interruptible.h"

namespace morskin::python {

template <>
inline constexpr const char* kind_of<const Skin*> = "a Skin";

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

template <class Value>
using Names = std::vector<std::pair<std::string, Value>>;

/// @throws py::value_error  for a word that is none of the names
template <class Value>
Value named(const std::string& word, const Names<Value>& names, const std::string& what) {
  std::string all;
  for (const auto& [name, value] : names) {
    if (word == name) return value;
    all += (all.empty() ? "" : ", ") + name;
  }
  throw py::value_error(what + " must be one of " + all + ", not " + word);
}

constexpr auto number_or_none = argument<std::optional<double>>;

std::optional<Method> method_of(const py::object& method) {
  const auto word = argument<std::optional<std::string>>(method, "method");
  if (!word) return std::nullopt;
  return named<Method>(*word, {{"sweep", Method::Sweep}, {"static", Method::Static}}, "method");
}

Skin make_skin(const py::object& positions, const py::object& radii, const py::object& model,
               const py::object& probe, const py::object& drop_voids_below,
               const py::object& threads, const py::object& progress) {
  const std::vector<Atom> atoms = atoms_from(positions, radii);
  const SkinOptions options{model_of(model), argument<double>(probe, "probe"),
                            argument<double>(drop_voids_below, "drop_voids_below")};
  return interruptible({threads, progress},
                       [&](const RunOptions& run) { return Skin(atoms, options, run); });
}

std::optional<std::size_t> subdomains_of(const py::object& fronts) {
  const auto number = argument<std::optional<std::int64_t>>(fronts, "fronts");
  // What is below 1 is refused with 0, which is out of range too.
  if (!number) return std::nullopt;
  return static_cast<std::size_t>(std::max<std::int64_t>(*number, 0));
}

std::unique_ptr<Mesh> mesh(const Skin& skin, const py::object& C, const py::object& Q,
                           const py::object& max_length_scale, const py::object& edge_length,
                           const py::object& density, const py::object& triangles,
                           const py::object& grading, const py::object& angle_goal_deg,
                           const py::object& method, const py::object& fronts,
                           const py::object& direction, const py::object& allow_uncertified,
                           const py::object& threads, const py::object& progress) {
  MeshOptions options{.Q = number_or_none(Q, "Q"),
                      .max_length_scale = argument<double>(max_length_scale, "max_length_scale"),
                      .edge_length = number_or_none(edge_length, "edge_length"),
                      .density = number_or_none(density, "density"),
                      .triangles = number_or_none(triangles, "triangles"),
                      .grading = number_or_none(grading, "grading"),
                      .angle_goal_deg = number_or_none(angle_goal_deg, "angle_goal_deg"),
                      .method = method_of(method),
                      .fronts = subdomains_of(fronts),
                      .direction = direction_from(direction)};
  const bool is_size_given = options.edge_length || options.density || options.triangles;
  options.C = number_or_none(C, "C").value_or(is_size_given ? MeshOptions::coarsest_C : options.C);
  const bool is_any_wanted = argument<bool>(allow_uncertified, "allow_uncertified");
  SkinMesh made = interruptible({threads, progress},
                                [&](const RunOptions& run) { return skin.mesh(options, run); });
  if (!made.certificate().certified && !is_any_wanted) raise_not_certified(std::move(made));
  return std::make_unique<Mesh>(std::move(made));
}

Certificate check(const py::object& vertices, const py::object& faces, const py::object& skin,
                  const py::object& C, const py::object& Q, const py::object& max_length_scale,
                  const py::object& threads, const py::object& progress) {
  const Skin& of = *argument<const Skin*>(skin, "skin");
  const TriangleMesh triangles = mesh_from(vertices, faces);
  const MeshOptions options{
      .C = argument<double>(C, "C"),
      .Q = number_or_none(Q, "Q"),
      .max_length_scale = argument<double>(max_length_scale, "max_length_scale")};
  return interruptible({threads, progress},
                       [&](const RunOptions& run) { return of.certify(triangles, options, run); });
}

std::vector<CriticalPoint> critical_points(const Skin& skin, const py::object& direction) {
  const std::optional<Point> along = direction_from(direction);
  const Unlocked unlocked;
  return skin.critical_points(along);
}

MorseSmaleComplex morse_smale(const Skin& skin, const py::object& direction,
                              const py::object& simplify, const py::object& progress) {
  const std::optional<Point> along = direction_from(direction);
  const Simplify how = argument<bool>(simplify, "simplify") ? Simplify::ShortArcs : Simplify::Not;
  return interruptible({py::int_(1), progress},
                       [&](const RunOptions& run) { return skin.morse_smale(along, run, how); });
}

py::tuple read_mesh(const py::object& file) {
  const std::filesystem::path path = path_from(file);
  auto* const mesh = new TriangleMesh();
  const py::capsule owner(mesh, [](void* p) { delete static_cast<TriangleMesh*>(p); });
  {
    const Unlocked unlocked;
    *mesh = morskin::read_mesh(path);
  }
  return py::make_tuple(view(mesh->vertices, owner), view(mesh->triangles, owner));
}

constexpr const char* mesh_text = R"(mesh(*, C=None, density=None, ...) -> Mesh

Meshes the skin and certifies the mesh.

C                  how closely the mesh follows the skin: edges grow with it. None: 0.08; with
                   edge_length, density or triangles 0.4, as coarse as it gets
Q                  quality, above 1; None: the one that goes with C
max_length_scale   a larger length scale counts as this one, Angstrom
edge_length        the median edge where the skin is flat enough, Angstrom
density            vertices per Angstrom^2
triangles          in all. Of these three sizes at most one, in place of max_length_scale; it is
                   reached as far as C allows
grading            by how much edges may grow for each Angstrom, at least 0.01
angle_goal_deg     the smallest angle aimed at, degrees; None: 35, or 30 with C above 0.2
method             "sweep" or "static"; None: chosen
fronts             how many subdomains are swept separately, a power of two; 1: from below with
                   one front, the paper's Algorithm 1; None: as many as the size is worth
direction          (3,): to sweep along
allow_uncertified  return a mesh that is not certified, rather than raise NotCertified
threads            at most; None: as many as the machine has. The mesh does not depend on it
progress           called now and then with the stage's name and the share of it that is done, 0 to
                   1 or None; what it raises ends the run, as Ctrl-C does

Raises NotCertified, with the mesh; RefusedInput, a ValueError, for values that make no sense.)";

void bind_functions(py::module_& module) {
  using py::arg;
  const py::none none;
  define(module, "check", &check, arg("vertices"), arg("faces"), arg("skin"), py::kw_only(),
         arg("C") = MeshOptions().C, arg("Q") = none, arg("max_length_scale") = infinity,
         arg("threads") = none, arg("progress") = none,
         "check(vertices, faces, skin, *, C=0.08, Q=None, max_length_scale=inf) -> "
         "Certificate\n\nChecks any mesh against a skin. A bad mesh is no error: the "
         "certificate says what is wrong.\n\n"
         "vertices  (n, 3): Angstrom\n"
         "faces     (m, 3): whole numbers, counter-clockwise seen from outside\n"
         "C, Q and max_length_scale are what the mesh was made with: **mesh.sizing for one of "
         "this library.\nthreads and progress are as of Skin.mesh.\n\n"
         "Raises RefusedInput for sizes that make no sense.");
  define(module, "read_mesh", &read_mesh, arg("file"),
         "read_mesh(file) -> vertices (n, 3) float64, Angstrom; faces (m, 3) uint32\n\n"
         "A mesh in a file: PLY, OFF, OBJ, STL, MSMS, VTU or MSH, gzipped or not.\n\n"
         "Raises UnreadableInput.");
  define(
      module, "van_der_waals_radius",
      [](const py::object& element) {
        return van_der_waals_radius(argument<std::string>(element, "element"));
      },
      arg("element"),
      "van_der_waals_radius(element) -> Angstrom, or None for what is no element with one\n\n"
      "element  a symbol in upper or lower case");
}

}  // namespace

Model model_of(const py::object& model) {
  return named<Model>(argument<std::string>(model, "model"),
                      {{"paper", Model::Paper},
                       {"sas", Model::Sas},
                       {"vdw", Model::Vdw},
                       {"ses-like", Model::SesLike}},
                      "model");
}

void bind_skin(py::module_& module) {
  using py::arg;
  const py::none none;
  py::class_<Skin> skin(
      module, "Skin",
      "Skin(positions, radii, model=\"vdw\", *, probe=1.4, drop_voids_below=0)\n\n"
      "A skin surface, prepared once; it may be used from several threads.\n\n"
      "positions         (n, 3): of the atoms, Angstrom\n"
      "radii             (n,): van der Waals, Angstrom\n"
      "model             radius of an atom's sphere: \"vdw\" r, \"sas\" r + probe, "
      "\"ses-like\" r + 0.25, or \"paper\"\n"
      "probe             Angstrom\n"
      "drop_voids_below  voids of a volume proved to be below this, Angstrom^3, are "
      "left out; inf: all\n"
      "threads, progress as of mesh()\n\n"
      "Raises RefusedInput, with `atoms` where it is about some.");
  define_init(skin, &make_skin, arg("positions"), arg("radii"), arg("model") = "vdw", py::kw_only(),
              arg("probe") = 1.4, arg("drop_voids_below") = 0.0, arg("threads") = none,
              arg("progress") = none);
  skin.def_property_readonly("components", &Skin::components,
                             "int: connected components of what is meshed, exact")
      .def_property_readonly("genus", &Skin::genus, "int: summed over components, exact")
      .def("__repr__", [](const Skin& self) {
        return "<morskin.Skin: components " + std::to_string(self.components()) + ", genus " +
               std::to_string(self.genus()) + ">";
      });
  define(skin, "mesh", &mesh, mesh_text, py::kw_only(), arg("C") = none, arg("Q") = none,
         arg("max_length_scale") = infinity, arg("edge_length") = none, arg("density") = none,
         arg("triangles") = none, arg("grading") = none, arg("angle_goal_deg") = none,
         arg("method") = none, arg("fronts") = none, arg("direction") = none,
         arg("allow_uncertified") = false, arg("threads") = none, arg("progress") = none);
  define(skin, "critical_points", &critical_points, arg("direction") = none,
         "critical_points(direction=None) -> CriticalPoints\n\n"
         "Those of the height along `direction`, (3,), or along the library's choice. Voids that "
         "are not\nmeshed are in them.\n\nRaises RefusedInput if the direction is degenerate for "
         "this skin.");
  define(skin, "morse_smale", &morse_smale, arg("direction") = none, py::kw_only(),
         arg("simplify") = false, arg("progress") = none,
         "morse_smale(direction=None, *, simplify=False) -> MorseSmaleComplex\n\n"
         "The complex of the same height as traced, nothing cancelled; or simplified as in "
         "section 3.2 of the\npaper: short arcs, between overlapping protecting spheres, are "
         "contracted. `progress` as of mesh().");
  bind_functions(module);
}

}  // namespace morskin::python
