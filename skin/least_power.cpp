#include "skin/least_power.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace morskin::skin {

using geometry::AtomId;
using geometry::WeightedPoint;

LeastPower::LeastPower(std::span<const WeightedPoint> points,
                       std::span<const std::array<AtomId, 2>> edges)
    : points_(points.begin(), points.end()),
      neighbours_(geometry::grouped<AtomId>(points.size(),
                                            [&](auto visit) {
                                              for (const auto& [a, b] : edges) {
                                                visit(a.index(), b);
                                                visit(b.index(), a);
                                              }
                                            })),
      tree_(points) {}

AtomId LeastPower::nearest(const geometry::Point& x, AtomId start) const {
  const auto rank = [&](AtomId a) {
    const WeightedPoint& p = points_[a.index()];
    return std::pair((x - p.position).squaredNorm() - p.weight, a);
  };
  auto best = rank(start);
  for (;;) {
    const AtomId here = best.second;
    for (const AtomId a : neighbours(here)) best = std::min(best, rank(a));
    if (best.second == here) return here;
  }
}

/// Nothing unless one of the tried atoms has less power than all its neighbours. An atom in no edge
/// is hidden, or nothing is known of its neighbours.
///
/// Powers are rounded down, by 20 units of size = |z - q|^2 + |w| at most, so only the least one's
/// rounding counts.
template <class Real>
std::optional<PowerTree::Least<Real>> LeastPower::among(const Vector3<Real>& q,
                                                        std::span<const AtomId> tried) const {
  constexpr double smallest_size = 0x1p-900;
  const auto power = [&](AtomId a) {
    const WeightedPoint& p = points_[a.index()];
    return power_below<Real>(p.position.cast<Real>() - q, p.weight);
  };
  AtomId nearest = tried.front();
  Real least = power(nearest);
  for (const AtomId a : tried.subspan(1)) {
    const Real here = power(a);
    if (here >= least) continue;
    least = here;
    nearest = a;
  }
  const Real size = least + 2 * Real(std::abs(points_[nearest.index()].weight));
  if (!(size > smallest_size) || neighbours(nearest).empty()) return std::nullopt;
  const Real above = least + 32 * unit_roundoff<Real> * size;
  for (const AtomId n : neighbours(nearest)) {
    if (!(power(n) > above)) return std::nullopt;
  }
  return PowerTree::Least<Real>{nearest, last_rounded_down(least)};
}

template <class Real>
PowerTree::Least<Real> LeastPower::at(const Vector3<Real>& q, std::span<const AtomId> tried) const {
  // Not worth it in quadruple precision: the search rules most atoms out in doubles.
  if constexpr (std::is_same_v<Real, double>) {
    if (const auto found = among(q, tried)) return *found;
  }
  return tree_.least(q, tried.front(), points_[tried.front().index()]);
}

template PowerTree::Least<double> LeastPower::at(const Vector3<double>&,
                                                 std::span<const AtomId>) const;
template PowerTree::Least<Quad> LeastPower::at(const Vector3<Quad>&, std::span<const AtomId>) const;

}  // namespace morskin::skin
