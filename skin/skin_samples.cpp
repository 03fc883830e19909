#include "skin/skin_samples.h"

#include <algorithm>
#include <cmath>

#include "geometry/orthogonal.h"
#include "skin/skin_surface.h"

namespace morskin::skin {

namespace {

/// The points of a two-dimensional sequence that fills the unit square evenly (Roberts 2018).
class EvenSequence {
 public:
  Eigen::Vector2d next() {
    at_ += Eigen::Vector2d(0.75487766624669276, 0.56984029099805327);
    at_ = at_.array() - at_.array().floor();
    return at_;
  }

 private:
  Eigen::Vector2d at_ = Eigen::Vector2d(0.5, 0.5);
};

Point on_sphere(const Patch& patch, const Eigen::Vector2d& u) {
  const double z = 2 * u.x() - 1, angle = 2 * M_PI * u.y();
  const double s = std::sqrt(1 - z * z), r = std::sqrt(std::abs(patch.half_weight));
  return patch.centre + r * Vector(s * std::cos(angle), s * std::sin(angle), z);
}

/// The integral of rho^-2 goes evenly with t where, at s along the axis from the middle,
/// s = sqrt(k / 2) sinh t on one sheet, s = +-sqrt(k / 2) cosh t on two, with k = |w| / 2.
Point on_hyperboloid(const Patch& patch, double largest, const Eigen::Vector2d& u) {
  const double waist = waist_radius(patch, largest), k = waist * waist, radius = std::sqrt(k / 2);
  const double most = std::asinh(largest / waist), t = (2 * u.x() - 1) * most;
  const bool is_one_sheet = patch.sign * patch.half_weight > 0;
  const double vertex = std::acosh(std::sqrt(2.0));
  const double s = is_one_sheet ? radius * std::sinh(t)
                                : std::copysign(radius * std::cosh(std::abs(t) + vertex), t);
  const double r = std::sqrt(std::max(s * s + (is_one_sheet ? k : -k), 0.0));
  const double angle = 2 * M_PI * u.y();
  return patch.centre + s * patch.axis + r * geometry::TangentFrame(patch.axis).direction(angle);
}

}  // namespace

surface::Samples skin_samples(const surface::Surface& skin, const MixedComplex& complex) {
  // So many of a sphere, or fewer where this would be too many of all.
  constexpr double of_sphere = 24;
  const double most = 4096 + static_cast<double>(skin.cell_count()) / 4;
  const double largest = skin.max_length_scale();
  double total = 0;
  for (std::size_t i = 0; i < skin.cell_count(); ++i) {
    total += skin.extent(CellId{i}, largest).area;
  }
  surface::Samples samples{{}, std::max(4 * M_PI / of_sphere, total / most)};
  EvenSequence sequence;
  double due = 0;
  for (std::size_t i = 0; i < skin.cell_count(); ++i) {
    const CellId cell{i};
    const Patch& patch = complex.kept_patch(cell);
    const bool is_sphere = patch.axis.isZero(0);
    if (is_sphere && patch.sign * patch.half_weight <= 0) continue;
    for (due += skin.extent(cell, largest).area / samples.each; due >= 1; due -= 1) {
      const Eigen::Vector2d u = sequence.next();
      const Point x = is_sphere ? on_sphere(patch, u) : on_hyperboloid(patch, largest, u);
      if (skin.is_in(x, cell)) samples.points.push_back(skin.at(x, cell));
    }
  }
  return samples;
}

}  // namespace morskin::skin
