#pragma once

#include <algorithm>

#include "surface/surface_point.h"

namespace morskin::surface {

/// Bounds on G and N at one point, with all rounding counted: `low <= G <= high`, and N differs
/// from `half_gradient` by at most `error`. Bounds that could not be found are infinite.
struct Enclosure {
  double low, high;      ///< of G, Angstrom^2
  Vector half_gradient;  ///< nearly N, Angstrom
  double error;          ///< Angstrom

  /// Upper bound on |G|.
  double max_value() const { return std::max(-low, high); }
  double middle() const { return low + (high - low) / 2; }
};

}  // namespace morskin::surface
