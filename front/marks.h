#pragma once

#include <array>
#include <cstddef>
#include <utility>
#include <vector>

#include "front/departures.h"
#include "geometry/id_vector.h"
#include "morse/critical_point.h"

namespace morskin::front {

using morse::CriticalId;

/// The marks of Algorithm 1: departures stopped in the protecting sphere of a saddle (red, on one
/// of its two sides) or a maximum (green). A sphere that is released counts for nothing any more.
class Marks {
 public:
  using Sides = std::array<std::vector<Departure>, 2>;  ///< green marks are on the first

  explicit Marks(const std::vector<morse::CriticalPoint>& points)
      : points_(points), spheres_(points.size()) {}

  void mark(CriticalId c, std::size_t side, const Departure& departure) {
    spheres_[c].sides[side].push_back(departure);
  }
  bool is_marked_on_both_sides(CriticalId c) const {
    const Sides& sides = spheres_[c].sides;
    return !sides[0].empty() && !sides[1].empty();
  }
  bool is_released(CriticalId c) const { return spheres_[c].is_released; }
  /// @return its marks
  Sides release(CriticalId c) {
    spheres_[c].is_released = true;
    return std::exchange(spheres_[c].sides, {});
  }

  /// Follows a sweep of the same critical points, by the same function or reversed: a saddle
  /// released there is released here, and maxima count again, for their holes have changed.
  /// @pre neither holds marks.
  void absorb(const Marks& other) {
    for (std::size_t c = 0; c < spheres_.size(); ++c) {
      const bool is_saddle = points_[c].index == 1;
      const CriticalId id{c};
      spheres_[id].is_released =
          is_saddle && (spheres_[id].is_released || other.spheres_[id].is_released);
    }
  }

 private:
  struct Sphere {
    Sides sides;
    bool is_released = false;
  };
  const std::vector<morse::CriticalPoint>& points_;
  geometry::IdVector<CriticalId, Sphere> spheres_;
};

}  // namespace morskin::front
