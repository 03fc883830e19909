// The part of Triangulator that finds a first tetrahedron and puts the points in one after another.

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "geometry/exact_range.h"
#include "geometry/parallel.h"
#include "geometry/spatial_order.h"
#include "geometry/triangulator.h"

namespace morskin::geometry {
namespace {

/// The greatest power of two up to |x|, times 2^shift; for zero, 2^shift.
double scaled_power_of_two(double x, int shift) {
  return std::ldexp(1.0, (x == 0 ? 0 : std::ilogb(x)) + shift);
}

/// By facet of the first tetrahedron and its ghosts, the other one with the same corners. Which one
/// that is does not depend on the corners' numbers.
std::array<Triangulator::Facet, 20> facets_behind_first(
    std::span<const Triangulator::Tetrahedron> tetrahedra) {
  const auto corners_of = [&](Triangulator::Facet f) {
    std::array<Triangulator::Corner, 4> corners =
        tetrahedra[Triangulator::tetrahedron_of(f)].corners;
    std::swap(corners[Triangulator::index_of(f)], corners[3]);
    std::sort(corners.begin(), corners.begin() + 3);
    return std::array{corners[0], corners[1], corners[2]};
  };
  std::array<Triangulator::Facet, 20> behind{};
  for (Triangulator::Facet f = 0; f < 20; ++f) {
    for (Triangulator::Facet g = 0; g < 20; ++g) {
      if (f != g && corners_of(f) == corners_of(g)) behind[f] = g;
    }
  }
  return behind;
}

}  // namespace

Triangulator::Triangulator(std::span<const WeightedPoint> points, const Run& run,
                           std::size_t region)
    : atom_count_(points.size()) {
  if (points.size() > max_points) fail_for_lack_of_ids(max_points, "atoms");
  if (points.empty()) return;
  auto [order, rounds] = spatial_order(points, run.threads());
  find_first_tetrahedron(points, order);
  points_.resize(points.size());
  points_.reserve(points.size() + 3);
  ids_ = std::move(order);
  for_each_block(run.threads(), ids_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) points_[i] = {points[ids_[i].index()]};
  });
  if (dimension_ < 1) return;
  add_apexes(points);
  tetrahedra_.reserve(8 * points_.size());
  states_.reserve(8 * points_.size());
  all_.rim_numbers.resize(points_.size() + 1);
  make_first_tetrahedron();
  insert_rounds(rounds, run, region);
}

/// Moves affinely independent points to the front of the order, as many as there are.
void Triangulator::find_first_tetrahedron(std::span<const WeightedPoint> points,
                                          std::vector<AtomId>& order) {
  const auto at = [&](std::size_t i) -> const Point& { return points[order[i].index()].position; };
  dimension_ = 0;
  for (std::size_t i = 1; i < order.size() && dimension_ < 3; ++i) {
    const bool is_independent = dimension_ == 0 ? at(i) != at(0)
                                : dimension_ == 1
                                    ? !are_collinear(at(0), at(1), at(i))
                                    : orientation(at(0), at(1), at(2), at(i)) != Sign::Zero;
    if (!is_independent) continue;
    ++dimension_;
    std::swap(order[static_cast<std::size_t>(dimension_)], order[i]);
  }
}

/// An apex is the first point moved along an axis, which leaves the span of the points before it
/// for at least one of the three. The move is a power of two, to stay on the exact grid; at most
/// half the points' extent and towards the origin, to stay in range; and far above rounding.
void Triangulator::add_apexes(std::span<const WeightedPoint> points) {
  Point low = points[0].position;
  Point high = low;
  for (const WeightedPoint& p : points) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
  }
  const double step = scaled_power_of_two((high - low).maxCoeff(), -1);
  for (int known = dimension_; known < 3; ++known) {
    for (int axis = 0; axis < 3; ++axis) {
      Point apex = points_[0].position;
      const double shift = std::max({step, scaled_power_of_two(apex[axis], -40), coordinate_unit});
      apex[axis] += apex[axis] > 0 ? -shift : shift;
      const Point& second = points_[1].position;
      const bool is_independent =
          known == 1 ? !are_collinear(points_[0].position, second, apex)
                     : orientation(points_[0].position, second,
                                   dimension_ == 2 ? points_[2].position : points_.back().position,
                                   apex) != Sign::Zero;
      if (!is_independent) continue;
      points_.push_back({{apex, 0}});
      ids_.push_back(AtomId(ids_.size()));
      break;
    }
  }
}

/// The first four corners and, behind facet i, a ghost: the tetrahedron with corner i sent to
/// infinity, through the facet, and turned so that infinity is its last corner.
void Triangulator::make_first_tetrahedron() {
  std::array<Corner, 4> first{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto real = static_cast<std::size_t>(dimension_) + 1;
    first[k] = static_cast<Corner>(k < real ? k : atom_count_ + k - real);
  }
  const auto position = [&](std::size_t k) -> const Point& { return points_[first[k]].position; };
  if (orientation(position(0), position(1), position(2), position(3)) == Sign::Negative) {
    std::swap(first[0], first[1]);
  }
  tetrahedra_.push_back({first, {no_index, no_index, no_index, no_index}});
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Corner, 4> ghost = first;
    i == 3 ? std::swap(ghost[0], ghost[1]) : std::swap(ghost[i], ghost[3]);
    ghost[3] = infinity;
    tetrahedra_.push_back({ghost, {no_index, no_index, no_index, no_index}});
  }
  states_.assign(5, State::Live);
  static const std::array<Facet, 20> behind = facets_behind_first(tetrahedra_);
  for (Facet f = 0; f < 20; ++f) tetrahedra_[tetrahedron_of(f)].neighbours[index_of(f)] = behind[f];
}

}  // namespace morskin::geometry
