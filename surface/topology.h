#pragma once

#include <cstddef>
#include <vector>

#include "geometry/point.h"

namespace morskin::surface {

/// The topology of a closed surface, or of some of its components, from a source independent of any
/// mesh.
struct Topology {
  std::size_t components = 0;
  std::size_t genus = 0;  ///< summed over components
  long euler_characteristic = 0;
  /// Of some components only: a point in each part that all of them cut space into, by the side of
  /// those some on which it lies. Together they tell which components these are.
  std::vector<geometry::Point> inside = {}, outside = {};
};

}  // namespace morskin::surface
