#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "geometry/exact_positions.h"
#include "geometry/predicates.h"
#include "geometry/triangle_contact.h"

namespace morskin::geometry {

/// Triangles about an edge vw, ordered by the angle from the first, exactly.
/// @pre none has its corners on one line
class EdgeFan {
 public:
  struct Blade {
    std::uint32_t triangle, apex;
    int sector;  ///< 0: as the first; 1: up to half a turn; 2: half a turn; 3: beyond
  };

  EdgeFan(const ExactPositions& at, std::uint32_t v, std::uint32_t w) : at_(at), v_(v), w_(w) {}

  void add(std::uint32_t triangle, std::uint32_t apex) {
    blades_.push_back({triangle, apex, blades_.empty() ? 0 : sector(blades_[0].apex, apex)});
  }

  /// By angle and then by triangle.
  const std::vector<Blade>& sorted() {
    std::ranges::stable_sort(blades_, [this](const Blade& a, const Blade& b) {
      if (a.sector != b.sector) return a.sector < b.sector;
      return a.sector % 2 == 1 && turn(a.apex, b.apex) == Sign::Positive;
    });
    return blades_;
  }

  /// Whether two triangles lie in one half-plane of the edge.
  bool are_alike(const Blade& a, const Blade& b) const {
    return a.sector == b.sector && (a.sector % 2 == 0 || turn(a.apex, b.apex) == Sign::Zero);
  }

 private:
  Sign turn(std::uint32_t a, std::uint32_t b) const {
    return orientation(at_[v_], at_[w_], at_[a], at_[b]);
  }
  int sector(std::uint32_t first, std::uint32_t apex) const {
    const Sign sign = turn(first, apex);
    if (sign != Sign::Zero) return sign == Sign::Positive ? 1 : 3;
    return is_improper_contact(at_, {v_, w_, first}, {v_, w_, apex}) ? 0 : 2;
  }

  const ExactPositions& at_;
  std::uint32_t v_, w_;
  std::vector<Blade> blades_;
};

}  // namespace morskin::geometry
