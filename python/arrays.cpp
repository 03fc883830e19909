#include "python/arrays.h"

#include <string>
#include <string_view>
#include <utility>

namespace morskin::python {

namespace {

template <class T>
using Contiguous = py::array_t<T, py::array::c_style | py::array::forcecast>;

/// A masked array's values under its mask are whatever they were, no numbers of the caller's.
void require_unmasked(const py::object& from, const std::string& name) {
  const py::module_ masked = py::module_::import("numpy.ma");
  if (!py::isinstance(from, masked.attr("MaskedArray"))) return;
  const auto count = masked.attr("count_masked")(from).cast<py::ssize_t>();
  if (count == 0) return;
  throw py::value_error(name + " must have no masked values, and " + std::to_string(count) +
                        (count == 1 ? " is masked" : " are masked"));
}

/// @throws py::error_already_set  ValueError, caused by what NumPy or the object itself raises;
///                                but what is no fault of theirs, as KeyboardInterrupt, as it is
py::array array_from(const py::object& from, const std::string& name) {
  try {
    return py::array(from);
  } catch (py::error_already_set& raised) {
    if (!raised.matches(PyExc_Exception) || raised.matches(PyExc_MemoryError)) throw;
    py::raise_from(raised, PyExc_ValueError, (name + " cannot be made an array").c_str());
    throw py::error_already_set();
  }
}

/// The numbers of an array-like, whose NumPy kind must be one of `kinds`.
template <class T>
Contiguous<T> numbers(const py::object& from, std::string_view kinds, const std::string& name,
                      const char* what) {
  require_unmasked(from, name);
  const py::array array = array_from(from, name);
  // Nothing at all has the kind of floats.
  if (array.size() > 0 && kinds.find(array.dtype().kind()) == kinds.npos) {
    throw py::type_error(name + " must hold " + what);
  }
  return Contiguous<T>(array);
}

Contiguous<double> real_numbers(const py::object& from, const std::string& name) {
  return numbers<double>(from, "fiu", name, "real numbers");
}

void require_rows_of_three(const py::array& array, const std::string& name) {
  if (array.ndim() == 2 && array.shape(1) == 3) return;
  throw py::value_error(name + " must have the shape (n, 3)");
}

Point point(const Contiguous<double>& rows, py::ssize_t row) {
  return {rows.at(row, 0), rows.at(row, 1), rows.at(row, 2)};
}

template <class Index>
std::vector<std::array<std::uint32_t, 3>> triangles_from(const py::object& faces,
                                                         py::ssize_t vertices) {
  const auto corners = numbers<Index>(faces, "iu", "faces", "whole numbers");
  require_rows_of_three(corners, "faces");
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (py::ssize_t t = 0; t < corners.shape(0); ++t) {
    std::array<std::uint32_t, 3>& triangle = triangles.emplace_back();
    for (py::ssize_t k = 0; k < 3; ++k) {
      const Index corner = corners.at(t, k);
      if (std::cmp_less(corner, 0) || std::cmp_greater_equal(corner, vertices)) {
        throw py::value_error("face " + std::to_string(t) + " has a corner " +
                              std::to_string(corner) + ", but there are " +
                              std::to_string(vertices) + " vertices, counted from 0");
      }
      triangle[static_cast<std::size_t>(k)] = static_cast<std::uint32_t>(corner);
    }
  }
  return triangles;
}

}  // namespace

std::vector<Atom> atoms_from(const py::object& positions, const py::object& radii) {
  const auto centres = real_numbers(positions, "positions");
  const auto sizes = real_numbers(radii, "radii");
  require_rows_of_three(centres, "positions");
  if (sizes.ndim() != 1 || sizes.shape(0) != centres.shape(0)) {
    throw py::value_error("radii must have the shape (n,), with one radius for each position");
  }
  std::vector<Atom> atoms;
  atoms.reserve(static_cast<std::size_t>(sizes.shape(0)));
  for (py::ssize_t i = 0; i < sizes.shape(0); ++i)
    atoms.push_back({point(centres, i), sizes.at(i)});
  return atoms;
}

std::optional<Point> direction_from(const py::object& direction) {
  if (direction.is_none()) return std::nullopt;
  const auto numbers = real_numbers(direction, "direction");
  if (numbers.ndim() != 1 || numbers.shape(0) != 3) {
    throw py::value_error("direction must have the shape (3,)");
  }
  return Point{numbers.at(0), numbers.at(1), numbers.at(2)};
}

TriangleMesh mesh_from(const py::object& vertices, const py::object& faces) {
  const auto positions = real_numbers(vertices, "vertices");
  require_rows_of_three(positions, "vertices");
  TriangleMesh mesh;
  for (py::ssize_t v = 0; v < positions.shape(0); ++v) mesh.vertices.push_back(point(positions, v));
  // The largest unsigned numbers would be negative ones as signed, and named so.
  mesh.triangles = array_from(faces, "faces").dtype().kind() == 'u'
                       ? triangles_from<std::uint64_t>(faces, positions.shape(0))
                       : triangles_from<std::int64_t>(faces, positions.shape(0));
  return mesh;
}

}  // namespace morskin::python
