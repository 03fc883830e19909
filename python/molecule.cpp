#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "morskin/features.h"
#include "python/arguments.h"
#include "python/arrays.h"
#include "python/bindings.h"
#include "python/interruptible.h"

namespace morskin::python {

namespace {

ReadOptions read_options(std::vector<std::string> chains, const py::object& waters,
                         std::optional<std::vector<std::string>> hetatms, std::string altloc,
                         const py::object& hydrogens, const py::object& model_number,
                         std::optional<std::string> assembly, std::optional<std::string> radii) {
  return {.chains = std::move(chains),
          .waters = argument<bool>(waters, "waters"),
          .hetatms = std::move(hetatms),
          .locations = std::move(altloc),
          .hydrogens = argument<bool>(hydrogens, "hydrogens"),
          .model = argument<std::optional<std::int64_t>>(model_number, "model_number"),
          .assembly = std::move(assembly),
          .radii = std::move(radii)};
}

py::tuple read_molecule(const py::object& file, const ReadOptions& options) {
  const std::filesystem::path path = path_from(file);
  auto* const molecule = new Molecule();
  const py::capsule owner(molecule, [](void* p) { delete static_cast<Molecule*>(p); });
  {
    const Unlocked unlocked;
    *molecule = read_molecule_file(path, options);
  }
  const std::vector<double>& charges = molecule->charges;
  return py::make_tuple(view(molecule->atoms, &Atom::position, owner),
                        view(molecule->atoms, &Atom::radius, owner),
                        charges.empty() ? py::object(py::none()) : view(charges, owner),
                        py::dict(py::cast(molecule->left_out)));
}

/// A letter for each byte, as in the command's NPZ: old files hold names in any code.
py::object letters_of(const std::string& text) {
  return py::reinterpret_steal<py::object>(
      PyUnicode_DecodeLatin1(text.data(), static_cast<py::ssize_t>(text.size()), nullptr));
}

/// An array of NumPy's that has these values and keeps them.
py::object array_of(FeatureArray array) {
  return std::visit(
      [&]<class Value>(std::vector<Value>& values) -> py::object {
        if constexpr (std::is_same_v<Value, std::string>) {
          py::list texts;
          for (const std::string& text : values) texts.append(letters_of(text));
          return py::module_::import("numpy").attr("array")(texts, py::arg("dtype") = "U");
        } else {
          auto* const kept = new std::vector<Value>(std::move(values));
          const py::capsule owner(kept,
                                  [](void* p) { delete static_cast<std::vector<Value>*>(p); });
          std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(kept->size() / array.columns)};
          if (array.columns > 1) shape.push_back(static_cast<py::ssize_t>(array.columns));
          return py::array_t<Value>(shape, kept->data(), owner);
        }
      },
      array.values);
}

py::dict features(const py::object& file, const ReadOptions& reading, const py::object& density,
                  const py::object& model, const py::object& probe,
                  const py::object& drop_voids_below, const py::object& C, const py::object& Q,
                  const py::object& angle_goal_deg, const py::object& threads,
                  const py::object& progress) {
  constexpr auto number_or_none = argument<std::optional<double>>;
  const FeatureOptions options{
      .reading = reading,
      .skin = {model_of(model), argument<double>(probe, "probe"),
               argument<double>(drop_voids_below, "drop_voids_below")},
      .mesh = {.C = argument<double>(C, "C"),
               .Q = number_or_none(Q, "Q"),
               .density = argument<double>(density, "density"),
               .angle_goal_deg = number_or_none(angle_goal_deg, "angle_goal_deg")}};
  const std::filesystem::path path = path_from(file);
  Features found = interruptible({threads, progress}, [&](const RunOptions& run) {
    return morskin::features(path, options, run);
  });
  if (!found.mesh.certificate().certified) raise_not_certified(std::move(found.mesh));
  py::dict arrays;
  for (FeatureArray& array : found.arrays) {
    const py::str name(array.name);
    arrays[name] = array_of(std::move(array));
  }
  return arrays;
}

}  // namespace

std::filesystem::path path_from(const py::object& file) {
  PyObject* bytes = nullptr;
  if (PyUnicode_FSConverter(file.ptr(), &bytes) == 0) throw py::error_already_set();
  return std::string(py::reinterpret_steal<py::bytes>(bytes));
}

void bind_molecule(py::module_& module) {
  using py::arg;
  const py::none none;
  py::class_<ReadOptions>(module, "ReadOptions", "What read() is asked for.")
      .def(py::init(&read_options), py::kw_only(), arg("chains"), arg("waters"), arg("hetatms"),
           arg("altloc"), arg("hydrogens"), arg("model_number"), arg("biological_assembly"),
           arg("radii"));
  module.def("read_molecule", &read_molecule, arg("file"), arg("options"),
             "read_molecule(file, options) -> positions (n, 3), radii (n,), Angstrom; charges (n,) "
             "or None; what was left out");
  module.def("features", &features, arg("file"), arg("options"), py::kw_only(), arg("density"),
             arg("model"), arg("probe"), arg("drop_voids_below"), arg("C"), arg("Q"),
             arg("angle_goal_deg"), arg("threads") = none, arg("progress") = none,
             "features(file, options, *, ...) -> dict of arrays\n\nmorskin.features has them.");
}

}  // namespace morskin::python
