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

/// Whether pybind11 may convert what is near to the type. It would cut off the decimals of a number
/// that is no `float`, as NumPy's float32.
template <class T>
inline constexpr bool may_be_converted = !std::is_same_v<T, std::int64_t>;
template <class T>
inline constexpr bool may_be_converted<std::optional<T>> = may_be_converted<T>;

/// @throws py::type_error  of one line, with the argument's name and the value, shortened
template <class T>
T argument(const py::object& value, const std::string& name) {
  constexpr bool may_be_none = std::is_convertible_v<std::nullopt_t, T>;
  py::detail::make_caster<T> caster;
  // pybind11 would take None for False, and bytes for a string.
  const bool is_allowed = (may_be_none || !value.is_none()) && !py::isinstance<py::bytes>(value) &&
                          !py::isinstance<py::bytearray>(value);
  if (is_allowed && caster.load(value, may_be_converted<T>))
    return py::detail::cast_op<T>(std::move(caster));
  const auto words = py::module_::import("reprlib").attr("repr")(value).attr("split")();
  const auto line = py::str(" ").attr("join")(words).template cast<std::string>();
  throw py::type_error(name + " must be " + kind_of<T> + (may_be_none ? " or None" : "") +
                       ", not " + line);
}

}  // namespace morskin::python
