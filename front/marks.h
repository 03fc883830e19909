#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <utility>
#include <vector>

#include "front/departures.h"
#include "morse/critical_point.h"

namespace morskin::front {

using morse::CriticalId;

/// The marks of Algorithm 1: departures stopped in the protecting sphere of a saddle (red, on one
/// of its two sides) or a maximum (green). A sphere that is released counts for nothing any more.
/// Takes the space of those that the front has come to.
class Marks {
 public:
  using Sides = std::array<std::vector<Departure>, 2>;   ///< green marks are on the first
  static constexpr std::size_t saddle = 1, maximum = 2;  ///< indices of critical points

  explicit Marks(const std::vector<morse::CriticalPoint>& points) : points_(points) {}

  void mark(CriticalId c, std::size_t side, const Departure& departure) {
    spheres_[c].sides[side].push_back(departure);
  }
  bool is_marked_on_both_sides(CriticalId c) const {
    const auto found = spheres_.find(c);
    return found != spheres_.end() && !found->second.sides[0].empty() &&
           !found->second.sides[1].empty();
  }
  bool is_released(CriticalId c) const {
    if (are_all_released_[index_of(c)]) return true;
    const auto found = spheres_.find(c);
    return found != spheres_.end() && found->second.is_released;
  }
  /// @return its marks
  Sides release(CriticalId c) {
    Sphere& sphere = spheres_[c];
    sphere.is_released = true;
    return std::exchange(sphere.sides, {});
  }
  /// No sphere about a point of this index counts from now on. @return those that may hold marks
  std::vector<CriticalId> release_all(std::size_t index) {
    are_all_released_[index] = true;
    std::vector<CriticalId> met;
    for (const auto& [c, sphere] : spheres_) {
      if (index_of(c) == index) met.push_back(c);
    }
    return met;
  }

  /// Follows a sweep of the same critical points: a saddle released there is released here, and
  /// maxima count again, for their holes have changed.
  /// @pre neither holds marks.
  void absorb(const Marks& other) {
    are_all_released_[saddle] |= other.are_all_released_[saddle];
    are_all_released_[maximum] = false;
    for (const auto& [c, sphere] : other.spheres_) spheres_[c].is_released |= sphere.is_released;
    std::erase_if(spheres_, [&](const auto& entry) { return index_of(entry.first) == maximum; });
  }

 private:
  struct Sphere {
    Sides sides;
    bool is_released = false;
  };
  std::size_t index_of(CriticalId c) const {
    return static_cast<std::size_t>(points_[c.index()].index);
  }

  const std::vector<morse::CriticalPoint>& points_;
  std::map<CriticalId, Sphere> spheres_;
  std::array<bool, 3> are_all_released_{};  ///< by index
};

}  // namespace morskin::front
