#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "morse/cell_contact.h"
#include "morse/critical_points_internal.h"

namespace morskin::morse {

namespace {

using skin::CellId;
using skin::Patch;

CriticalPoint classify(const skin::SkinSurface& surface, CellId cell, const MorseFunction& height,
                       double lambda) {
  const Patch& patch = surface.complex().patch(cell);
  const Vector& v = height.direction;
  const Vector mv = patch.reflect(v);
  // [excerpt: height]
  CriticalPoint critical;
  const Point x = patch.centre + lambda * mv;
  critical.point = {x, lambda > 0 ? v : Vector(-v), std::abs(lambda), cell};
  critical.value = height(x);
  // M restricted to the tangent plane: `sign` across the axis, `sign * (1 - 2 |a|^2)` along the
  // axis's part a in that plane.
  const Vector along = patch.axis - patch.axis.dot(v) * v;
  const double across_value = -patch.sign / lambda;
  const double along_value = -patch.sign * (1 - 2 * along.squaredNorm()) / lambda;
  critical.index = (across_value < 0) + (along_value < 0);
  // [/excerpt]
  if (critical.index == 1) {
    critical.descending = along.normalized();
    critical.ascending = v.cross(along).normalized();
    if (along_value > 0) std::swap(critical.descending, critical.ascending);
  }
  return critical;
}

}  // namespace

void add_height_critical_points(const skin::SkinSurface& surface, CellId cell,
                                const MorseFunction& height, CriticalPoints& result) {
  // The error of d below: two unit vectors and their product, each with 2^-53, add up to less than
  // 2^-50, and the square multiplies them by 4 axial < 4; its own rounding is smaller.
  constexpr double rounding_of_d = 0x1p-48;
  const skin::MixedComplex& complex = surface.complex();
  const Patch& patch = complex.patch(cell);
  const double axial = patch.axis.dot(height.direction);
  const double d = patch.sign * (1 - 2 * axial * axial);
  // |d| is also the smaller eigenvalue of the Hessian in units of 1 / rho. Beyond twice its error,
  // that error over |d|, relative to the length scale, bounds the error of the point.
  const double error = rounding_of_d / std::abs(d);
  const bool is_singular = error > 0.5;
  if (!is_singular && !(patch.half_weight * d > 0)) return;
  const double size =
      std::sqrt(std::abs(patch.half_weight) / (std::abs(d) + (is_singular ? rounding_of_d : 0)));
  const double wall = wall_doubt * size + complex.wall_tolerance();
  for (const double lambda : {-size, size}) {
    if (error > wall_doubt) {  // the point is uncertain along its line only
      const Vector mv = patch.reflect(height.direction);
      const auto point = point_in_cell(
          complex, cell,
          Stretch{patch.centre, lambda < 0 ? Vector(-mv) : mv,
                  is_singular ? size : size * (1 - error),
                  is_singular ? std::numeric_limits<double>::infinity() : size * (1 + error)},
          wall);
      if (!point) continue;
      if (is_singular) {
        result.degeneracies.push_back(
            "the Hessian is singular within rounding at a critical point " + position_text(*point));
        continue;
      }
    }
    take(surface, classify(surface, cell, height, lambda), wall + error * size, result);
  }
}

}  // namespace morskin::morse
