#pragma once

#include <cstddef>

namespace morskin::surface {

/// The topology of a closed surface, from a source independent of any mesh.
struct Topology {
  std::size_t components = 0;
  std::size_t genus = 0;  ///< summed over components
  long euler_characteristic = 0;
};

}  // namespace morskin::surface
