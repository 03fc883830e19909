#include "skin/void_volume.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "skin/void_volume_internal.h"

namespace morskin::skin {

namespace {

using geometry::Point;
using geometry::Vector;

/// Above the rounding of the few operations behind a share.
constexpr double share_rounding = 1e-8;

/// The share of a cube in which a linear function is positive: one less the volume of
/// {w . s <= b} in the unit cube, by inclusion and exclusion over its corners.
/// @param widths  w > 0: how much the function grows along each side
/// @param value   at the centre
double positive_share(const Vector& widths, double value) {
  const double b = widths.sum() / 2 - value;
  double sum = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    double rest = b;
    double sign = 1;
    for (int k = 0; k < 3; ++k) {
      if ((corner >> k & 1) == 0) continue;
      rest -= widths[k];
      sign = -sign;
    }
    if (rest > 0) sum += sign * rest * rest * rest;
  }
  return std::clamp(1 - sum / (6 * widths.prod()), 0.0, 1.0);
}

}  // namespace

VolumeBounds cut_shares(const surface::Enclosure& at, double half_side, double slack) {
  constexpr double smallest_width = 1e-3;  // beside the largest, for the sum not to cancel
  const Vector exact = 4 * half_side * at.half_gradient.cwiseAbs();
  const Vector widths = exact.cwiseMax(smallest_width * exact.maxCoeff());
  slack += (widths - exact).sum() / 2;
  return {std::max(positive_share(widths, at.low - slack) - share_rounding, 0.0),
          std::min(positive_share(widths, at.high + slack) + share_rounding, 1.0)};
}

namespace {

struct Cube {
  Point centre;
  double half_side;

  double volume() const { return 8 * half_side * half_side * half_side; }
};

class Measuring {
 public:
  Measuring(const SkinSurface& skin, const DualComplex& topology, std::uint32_t cavity,
            double fineness)
      : skin_(skin),
        components_(skin, topology),
        cavity_(cavity),
        fineness_(fineness),
        all_(skin.bounding_ball()),
        off_(rounding_of_centres(all_)),
        smallest_(std::max(topology.voids[cavity].clearance * 0x1p-20, 4 * off_)) {}

  /// Of cubes to begin with: the ball about the void's deepest point fits in one.
  double half_side(const Void& v) const { return std::max(v.clearance, smallest_); }

  bool is_outside_all(const Cube& cube) const {
    return (cube.centre - all_.centre).norm() > all_.radius + 2 * cube.half_side;
  }
  /// Whether the void comes into the cube.
  bool add(const Cube& cube, CellId hint) {
    const CellId cell = skin_.locate(cube.centre, hint);
    const surface::Enclosure at = skin_.enclose(cube.centre, cell);
    const double radius = std::sqrt(3) * cube.half_side + off_;
    const double n = at.half_gradient.norm();
    const double slack = radius * (radius + 2 * at.error);
    if (at.high + 2 * n * radius + slack < 0) return false;  // in the body
    if (at.low - 2 * n * radius - slack > 0) return add_empty(cube, cell);
    if (radius < fineness_ * n) return add_cut(cube, cell, at, slack + 2 * n * off_);
    if (cube.half_side < smallest_) {
      volume_.high += cube.volume();
      return true;
    }
    bool is_here = false;
    const double half = cube.half_side / 2;
    for (unsigned corner = 0; corner < 8; ++corner) {
      const Vector to((corner & 1) != 0 ? half : -half, (corner & 2) != 0 ? half : -half,
                      (corner & 4) != 0 ? half : -half);
      is_here |= add({cube.centre + to, half}, cell);
    }
    return is_here;
  }

  const VolumeBounds& volume() const { return volume_; }

 private:
  /// A centre is rounded once by place and once for each of some twenty halvings.
  static double rounding_of_centres(const surface::BoundingBall& all) {
    return 0x1p-47 * (all.centre.cwiseAbs().maxCoeff() + all.radius);
  }

  bool add_empty(const Cube& cube, CellId cell) {
    if (components_.void_at(cube.centre, cell) != cavity_) return false;
    volume_.low += cube.volume();
    volume_.high += cube.volume();
    return true;
  }
  /// A cube this small meets one sheet of the skin at most: on both sides of it balls of its length
  /// scale are free.
  bool add_cut(const Cube& cube, CellId cell, const surface::Enclosure& at, double slack) {
    const VolumeBounds shares = cut_shares(at, cube.half_side, slack);
    const auto on_skin = skin_.project(cube.centre, cell);
    const auto side = on_skin ? components_.outer_side(*on_skin) : std::nullopt;
    if (side && side->cavity != cavity_) return false;
    volume_.high += shares.high * cube.volume();
    if (!side) return true;
    volume_.low += shares.low * cube.volume();
    return shares.high > 0;
  }

  const SkinSurface& skin_;
  const SkinComponents components_;
  const std::uint32_t cavity_;
  const double fineness_;
  const surface::BoundingBall all_;
  const double off_;  ///< bound on a stored centre's distance from where it should be, Angstrom
  const double smallest_;  ///< half side, Angstrom: cubes that small stay undecided
  VolumeBounds volume_;
};

}  // namespace

/// From the void's deepest point to all cubes that it comes into, over their faces.
VolumeBounds void_volume(const SkinSurface& skin, const DualComplex& topology, std::uint32_t cavity,
                         double fineness) {
  const Void& v = topology.voids[cavity];
  Measuring measuring(skin, topology, cavity, fineness);
  const CellId start = skin.complex().cell(3, v.tetrahedron);
  using Place = std::array<int, 3>;
  std::vector<Place> waiting{{0, 0, 0}};
  std::set<Place> seen(waiting.begin(), waiting.end());
  const double half_side = measuring.half_side(v);
  while (!waiting.empty()) {
    const Place place = waiting.back();
    waiting.pop_back();
    const Vector steps(place[0], place[1], place[2]);
    const Cube cube{v.centre + 2 * half_side * steps, half_side};
    if (measuring.is_outside_all(cube) || !measuring.add(cube, start)) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      for (const int step : {-1, 1}) {
        Place next = place;
        next[k] += step;
        if (seen.insert(next).second) waiting.push_back(next);
      }
    }
  }
  return measuring.volume();
}

}  // namespace morskin::skin
