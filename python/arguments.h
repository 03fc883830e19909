#pragma once

/// The values of arguments. For one of a wrong type pybind11 would list all that the function takes
/// and all that it was given.

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace morskin::python {

namespace py = pybind11;

/// What an argument must be, in words.
template <class T>
inline constexpr const char* kind_of = nullptr;
template <>
inline constexpr const char* kind_of<bool> = "True or False";
template <>
inline constexpr const char* kind_of<double> = "a number";
template <>
inline constexpr const char* kind_of<std::int64_t> = "a whole number of at most 64 bits";
template <>
inline constexpr const char* kind_of<std::string> = "a string";
template <class T>
inline constexpr const char* kind_of<std::optional<T>> = kind_of<T>;

/// @throws py::type_error  of one line, with the argument's name and the value, shortened
template <class T>
T argument(const py::object& value, const std::string& name) {
  constexpr bool may_be_none = std::is_convertible_v<std::nullopt_t, T>;
  py::detail::make_caster<T> caster;
  // pybind11 would take None for False.
  const bool is_right = (may_be_none || !value.is_none()) && caster.load(value, true);
  if (is_right) return py::detail::cast_op<T>(std::move(caster));
  const auto words = py::module_::import("reprlib").attr("repr")(value).attr("split")();
  const auto line = py::str(" ").attr("join")(words).template cast<std::string>();
  throw py::type_error(name + " must be " + kind_of<T> + (may_be_none ? " or None" : "") +
                       ", not " + line);
}

}  // namespace morskin::python
