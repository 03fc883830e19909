#pragma once

#include <cstddef>

namespace morskin::surface {

/// What is known of a closed surface's topology from elsewhere than a mesh.
struct Topology {
  std::size_t components = 0;
  std::size_t genus = 0;  ///< summed over components
  long euler_characteristic = 0;
};

}  // namespace morskin::surface
