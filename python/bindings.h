#pragma once

/// The parts of the module `_morskin`, each of which adds its classes and functions.

#include <pybind11/pybind11.h>

#include <filesystem>
#include <mutex>
#include <utility>
#include <vector>

#include "morskin/morskin.h"
#include "python/interruptible.h"

namespace morskin::python {

namespace py = pybind11;

/// A mesh as Python holds it: what lies at its vertices is found when it is first asked for.
class Mesh {
 public:
  explicit Mesh(SkinMesh mesh) : mesh_(std::move(mesh)) {}

  const SkinMesh& mesh() const { return mesh_; }
  /// By vertex. Without the global lock, so other threads may ask meanwhile.
  const std::vector<SkinPoint>& points() const {
    const Unlocked unlocked;
    std::call_once(are_found_, [this] { points_ = mesh_.points(); });
    return points_;
  }

 private:
  SkinMesh mesh_;
  mutable std::once_flag are_found_;
  mutable std::vector<SkinPoint> points_;
};

}  // namespace morskin::python

namespace pybind11::detail {

/// Of a class that is bound. An object that its __new__ made and nothing filled raises TypeError,
/// where pybind11 would take memory as it happens to be for one.
template <class Bound>
class filled_caster : public type_caster_base<Bound> {
 public:
  bool load(handle source, bool convert) {
    const type_info* const type = get_type_info(typeid(Bound));
    if (type != nullptr && PyObject_TypeCheck(source.ptr(), type->type) != 0 &&
        reinterpret_cast<instance*>(source.ptr())->get_value_and_holder(type).value_ptr() ==
            nullptr) {
      throw type_error("the object was made without its __init__");
    }
    return type_caster_base<Bound>::load(source, convert);
  }
};

template <>
class type_caster<morskin::Skin> : public filled_caster<morskin::Skin> {};
template <>
class type_caster<morskin::python::Mesh> : public filled_caster<morskin::python::Mesh> {};
template <>
class type_caster<morskin::Certificate> : public filled_caster<morskin::Certificate> {};
template <>
class type_caster<morskin::MorseSmaleComplex> : public filled_caster<morskin::MorseSmaleComplex> {};
template <>
class type_caster<morskin::ReadOptions> : public filled_caster<morskin::ReadOptions> {};
// A class of its own, not a list.
template <>
class type_caster<std::vector<morskin::CriticalPoint>>
    : public filled_caster<std::vector<morskin::CriticalPoint>> {};

}  // namespace pybind11::detail

namespace morskin::python {

/// The library's errors become the exceptions of morskin/errors.py.
void bind_errors();
/// Certificate, and Mesh.
void bind_mesh(py::module_& module);
/// CriticalPoints and MorseSmaleComplex.
void bind_morse(py::module_& module);
/// Skin, and what makes one. @pre the others are bound
void bind_skin(py::module_& module);
/// What reads a molecule's file: its atoms, and its features.
void bind_molecule(py::module_& module);

/// @throws py::value_error  for a name that is no model's; py::type_error for what is no name
Model model_of(const py::object& model);

/// @param file  str, bytes or os.PathLike
/// @throws py::error_already_set  TypeError for anything else, ValueError for a name with a NUL
std::filesystem::path path_from(const py::object& file);

/// @throws py::error_already_set  NotCertified, with the mesh
[[noreturn]] void raise_not_certified(SkinMesh mesh);

}  // namespace morskin::python
