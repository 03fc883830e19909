#pragma once

/// What a sweep is to know beforehand: the Morse function, its surviving critical points and their
/// protecting spheres (sections 3.1, 3.2; "Initialization" of section 4.1).

#include <array>
#include <optional>
#include <vector>

#include "geometry/progress.h"
#include "morse/choose_function.h"
#include "morse/protecting_spheres.h"

namespace morskin::morse {

struct Guide {
  MorseFunction function;
  std::vector<CriticalPoint> points;  ///< those that survive the simplification
  ProtectingSpheres spheres;          ///< about them; no two overlap

  std::array<std::size_t, 3> found{};  ///< critical points by index, before the simplification
  bool is_simplified = true;  ///< false where rounding leaves the Morse-Smale complex undecided:
                              ///< then all points survive, and spheres shrink instead

  /// The same for the reversed function.
  Guide reversed() const;
  std::size_t count(int index) const;
};

/// @param euler_characteristic  of the skin
/// @param asked                 the function; without one, the first default that will do
/// @param radius_share          radius of a protecting sphere over the length scale at its centre
/// @param threads               at most; the guide is the same for any number
/// @throws DegenerateFunction
Guide make_guide(const skin::SkinSurface& skin, long euler_characteristic,
                 const std::optional<MorseFunction>& asked, double radius_share,
                 unsigned threads = 1, const geometry::Progress& progress = {});

}  // namespace morskin::morse
