#pragma once

/// NumPy arrays in and out. What goes out is a view of the library's memory, read-only, that keeps
/// its owner alive; what comes in is copied once, into the types that the library takes.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "morskin/morskin.h"

namespace morskin::python {

namespace py = pybind11;

/// The axes of a field: none of a number, one of a row of numbers, two of a row of rows.
template <class T>
struct Axes {
  using Scalar = T;
  static void append(std::vector<py::ssize_t>&, std::vector<py::ssize_t>&) {}
};
template <class T, std::size_t size>
struct Axes<std::array<T, size>> {
  using Scalar = typename Axes<T>::Scalar;
  static void append(std::vector<py::ssize_t>& shape, std::vector<py::ssize_t>& strides) {
    shape.push_back(size);
    strides.push_back(sizeof(T));
    Axes<T>::append(shape, strides);
  }
};

/// `rows` fields, the first at `first`, each `step` bytes behind the one before it.
template <class Field>
py::array view(const Field* first, std::size_t rows, std::size_t step, py::handle owner) {
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(rows)};
  std::vector<py::ssize_t> strides{static_cast<py::ssize_t>(step)};
  Axes<Field>::append(shape, strides);
  py::array array(py::dtype::of<typename Axes<Field>::Scalar>(), shape, strides, first, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// All of a vector.
template <class Field>
py::array view(const std::vector<Field>& rows, py::handle owner) {
  return view(rows.data(), rows.size(), sizeof(Field), owner);
}

/// One field of each element of a vector.
template <class Row, class Field>
py::array view(const std::vector<Row>& rows, Field Row::*field, py::handle owner) {
  const Field* const first = rows.empty() ? nullptr : &(rows.front().*field);
  return view(first, rows.size(), sizeof(Row), owner);
}

/// @param positions  (n, 3), @param radii  (n,): anything that NumPy makes real numbers of
/// @throws py::value_error  for other shapes; py::type_error for what are no real numbers
std::vector<Atom> atoms_from(const py::object& positions, const py::object& radii);

/// @param direction  (3,) as above, or None
/// @throws py::value_error, py::type_error  as above
std::optional<Point> direction_from(const py::object& direction);

/// @param vertices  (n, 3), real; @param faces  (m, 3), whole
/// @throws py::value_error, py::type_error  as above, and for a corner that does not exist
TriangleMesh mesh_from(const py::object& vertices, const py::object& faces);

}  // namespace morskin::python
