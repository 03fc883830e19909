#pragma once

/// Persistence pairs of the critical points: the saddles and extrema that can be cancelled, and
/// their order (section 3.2, after Edelsbrunner, Harer and Zomorodian 2003).
///
/// Rising through the values, a component of the sublevel set is born at each minimum. A saddle may
/// join two components; then the younger one, with the higher minimum, ends, and that minimum is
/// paired with the saddle. Maxima pair with saddles in the same manner from above. No saddle has
/// both kinds of pair: on a surface a saddle that joins two components below it does not join two
/// above it. The lowest minimum and the highest maximum of each component of the skin, and two
/// saddles for each handle, remain unpaired.
///
/// Ties of values fall by id throughout.

#include <vector>

#include "morse/morse_smale_complex.h"

namespace morskin::morse {

struct PersistencePair {
  CriticalId saddle, extremum;
  /// The older extremum of the two components that the saddle joins; `extremum` ends in it.
  CriticalId elder;
  double persistence = 0;  ///< |f(saddle) - f(extremum)|, unit of the function
};

/// All pairs, the least persistent first. Near-linear: two sorts and two passes of union-find.
///
/// Law:  a pair inside another's component comes first, also when both are equally persistent.
/// @pre  the values rise from minimum to saddle to maximum along every arc
std::vector<PersistencePair> persistence_pairs(const MorseSmaleComplex& complex);

/// Order by value, ties by id.
inline bool is_lower(const MorseSmaleComplex& complex, CriticalId a, CriticalId b) {
  const double fa = complex.points[a.index()].value, fb = complex.points[b.index()].value;
  return fa != fb ? fa < fb : a < b;
}

}  // namespace morskin::morse
