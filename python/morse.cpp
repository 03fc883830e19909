#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "python/arrays.h"
#include "python/bindings.h"

namespace morskin::python {

namespace {

using Points = std::vector<CriticalPoint>;

/// How many there are of each index.
std::string in_words(const Points& points) {
  std::array<std::size_t, 3> counts{};
  for (const CriticalPoint& p : points) ++counts.at(static_cast<std::size_t>(p.index));
  const auto& [minima, saddles, maxima] = counts;
  return "minima " + std::to_string(minima) + ", saddles " + std::to_string(saddles) + ", maxima " +
         std::to_string(maxima);
}

/// A property that is a view of a field of all points.
template <class Field>
auto column(Field CriticalPoint::*field) {
  return [field](const py::object& self) { return view(self.cast<const Points&>(), field, self); };
}

/// A property that is a view of a vector of the complex.
template <class Rows>
auto rows(Rows MorseSmaleComplex::*rows) {
  return [rows](const py::object& self) {
    return view(self.cast<const MorseSmaleComplex&>().*rows, self);
  };
}

}  // namespace

void bind_morse(py::module_& module) {
  py::class_<Points>(module, "CriticalPoints", "The k critical points of a height on a skin.")
      .def_property_readonly("positions", column(&CriticalPoint::position),
                             "(k, 3) float64: Angstrom")
      .def_property_readonly("indices", column(&CriticalPoint::index),
                             "(k,) int32: 0 minimum, 1 saddle, 2 maximum")
      .def_property_readonly("values", column(&CriticalPoint::value),
                             "(k,) float64: of the height, Angstrom")
      .def("__len__", [](const Points& self) { return self.size(); })
      .def("__repr__",
           [](const Points& self) { return "<morskin.CriticalPoints: " + in_words(self) + ">"; });
  py::class_<MorseSmaleComplex>(module, "MorseSmaleComplex",
                                "The Morse-Smale complex of a height on a skin.")
      .def_readonly("points", &MorseSmaleComplex::points, "CriticalPoints: its k nodes")
      .def_property_readonly("arcs", rows(&MorseSmaleComplex::arcs),
                             "(a, 2) uint32: the saddle and the extremum that each arc joins; four "
                             "arcs for each saddle")
      .def_property_readonly(
          "arc_points", rows(&MorseSmaleComplex::arc_points),
          "(p, 3) float64: the arcs' polylines, one after the other, from saddle "
          "to extremum, Angstrom")
      .def_property_readonly("arc_offsets", rows(&MorseSmaleComplex::arc_offsets),
                             "(a + 1,) uint32: arc i is arc_points[arc_offsets[i]:arc_offsets[i + "
                             "1]]")
      .def_property_readonly("regions", rows(&MorseSmaleComplex::regions),
                             "(r, 4) uint32: minimum, saddle, maximum, saddle of each, "
                             "counter-clockwise seen from outside")
      .def("__repr__", [](const MorseSmaleComplex& self) {
        return "<morskin.MorseSmaleComplex: " + in_words(self.points) + ", arcs " +
               std::to_string(self.arcs.size()) + ", regions " +
               std::to_string(self.regions.size()) + ">";
      });
}

}  // namespace morskin::python
