#pragma once

/// The input of a sweep: the Morse function, its surviving critical points and their protecting
/// spheres (sections 3.1, 3.2; "Initialization" of section 4.1).

#include <array>
#include <vector>

#include "morse/protecting_spheres.h"

namespace morskin::morse {

struct Guide {
  MorseFunction function;
  std::vector<CriticalPoint> points;  ///< those that survive the simplification
  ProtectingSpheres spheres;          ///< about them; no two overlap

  std::array<std::size_t, 3> found{};  ///< critical points by index, before the simplification
  bool is_simplified = true;  ///< false if rounding leaves the Morse-Smale complex undecided:
                              ///< then all points survive and spheres shrink instead

  std::size_t count(int index) const;
};

}  // namespace morskin::morse
