#include "skin/least_power.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <type_traits>

namespace morskin::skin {

using geometry::AtomId;
using geometry::WeightedPoint;

LeastPower::LeastPower(std::span<const WeightedPoint> points,
                       std::span<const std::array<AtomId, 2>> edges)
    : points_(points.begin(), points.end()),
      first_(points.size() + 2, 0),
      neighbours_(2 * edges.size()),
      tree_(points) {
  for (const auto& edge : edges) {
    for (const AtomId a : edge) ++first_[a.index() + 2];
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  for (const auto& [a, b] : edges) {
    neighbours_[first_[a.index() + 1]++] = b;
    neighbours_[first_[b.index() + 1]++] = a;
  }
  first_.pop_back();
}

AtomId LeastPower::nearest(const geometry::Point& x, AtomId start) const {
  const auto rank = [&](AtomId a) {
    const WeightedPoint& p = points_[a.index()];
    return std::pair((x - p.position).squaredNorm() - p.weight, a);
  };
  auto best = rank(start);
  for (auto before = best;; before = best) {
    for (const AtomId a : neighbours(before.second)) best = std::min(best, rank(a));
    if (best == before) return best.second;
  }
}

/// Nothing unless S, the tried atoms that tie for the least power, is all there is at its level. An
/// atom in no edge is hidden, or nothing is known of its neighbours.
///
/// Powers are rounded by 20 units of S's largest size |z - q|^2 + |w|, far less than the ties'
/// width and the distance kept from it.
template <class Real>
std::optional<PowerTree::Least<Real>> LeastPower::among(const Vector3<Real>& q,
                                                        std::span<const AtomId> tried) const {
  constexpr double tie = 0x1p-32, smallest_size = 0x1p-900;
  const auto power = [&](AtomId a) {
    const WeightedPoint& p = points_[a.index()];
    return power_below<Real>(p.position.cast<Real>() - q, p.weight);
  };
  AtomId nearest = tried.front();
  Real least = power(nearest), size = 0;
  for (const AtomId a : tried) {
    const Real here = power(a);
    size = std::max(size, here + 2 * Real(std::abs(points_[a.index()].weight)));
    if (here >= least) continue;
    least = here;
    nearest = a;
  }
  if (!(size > smallest_size)) return std::nullopt;
  const Real level = least + tie * size, above = level + tie * size;
  const auto is_in = [&](AtomId a) {
    return std::ranges::find(tried, a) != tried.end() && power(a) <= level;
  };
  for (const AtomId a : tried) {
    if (!is_in(a)) continue;
    if (neighbours(a).empty()) return std::nullopt;
    for (const AtomId n : neighbours(a)) {
      if (!(power(n) > above) && !is_in(n)) return std::nullopt;
    }
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
