#include "certify/curved_triangle.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace morskin::certify {

namespace {

using geometry::Vector;

/// x_u and x_v over two. Both are linear: their values at the corners a, b, c.
class Tangents {
 public:
  explicit Tangents(const CurvedTriangle& nodes) {
    const auto from_a = [&](std::size_t i) -> Vector { return nodes[i] - nodes[0]; };
    const Vector b = from_a(1), c = from_a(2), ab = from_a(3), bc = from_a(4), ca = from_a(5);
    for (const Vector& x : {b, c, ab, bc, ca}) scale_ = std::max(scale_, x.cwiseAbs().maxCoeff());
    along_u_ = {2 * ab - b / 2, 1.5 * b - 2 * ab, 2 * (bc - ca) - b / 2};
    along_v_ = {2 * ca - c / 2, 2 * (bc - ab) - c / 2, 1.5 * c - 2 * ca};
    flat_normal_ = b.cross(c);
  }

  /// The largest coordinate of a node seen from a, in magnitude.
  double scale() const { return scale_; }
  const Vector& flat_normal() const { return flat_normal_; }
  /// A Bernstein coefficient of (x_u x x_v) / 4.
  Vector coefficient(std::size_t i, std::size_t j) const {
    if (i == j) return along_u_[i].cross(along_v_[i]);
    return (along_u_[i].cross(along_v_[j]) + along_u_[j].cross(along_v_[i])) / 2;
  }
  /// x_u x x_v at barycentric coordinates.
  Vector normal(const std::array<double, 3>& at) const {
    Vector u = Vector::Zero(), v = Vector::Zero();
    for (std::size_t i = 0; i < 3; ++i) {
      u += 2 * at[i] * along_u_[i];
      v += 2 * at[i] * along_v_[i];
    }
    return u.cross(v);
  }

 private:
  std::array<Vector, 3> along_u_, along_v_;
  Vector flat_normal_;
  double scale_ = 0;
};

}  // namespace

std::optional<double> least_jacobian(const CurvedTriangle& nodes) {
  // A coefficient of (x_u x x_v) . d / 4 is off by less than 512 units of rounding, 2^-53, times
  // the square of the scale and the sum of |d|'s coordinates; the bound is twice that.
  constexpr double rounding = 0x1p-43;
  constexpr double min_scale = 0x1p-200, min_normal = 0x1p-500;  // far from underflow
  const Tangents tangents(nodes);
  const Vector& d = tangents.flat_normal();
  const double sum = d.cwiseAbs().sum(), scale = tangents.scale();
  if (!(scale > min_scale && sum > min_normal)) return std::nullopt;
  const double error = rounding * scale * scale * sum;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = i; j < 3; ++j) {
      const double coefficient = tangents.coefficient(i, j).dot(d);
      if (!(coefficient > error)) return std::nullopt;
      least = std::min(least, coefficient);
    }
  }
  return 4 * least / d.squaredNorm();
}

double curved_area(const CurvedTriangle& nodes) {
  // Seven points, degree five (Radon 1948): the centroid, and two orbits of three points.
  const double root = std::sqrt(15.0);
  const Tangents tangents(nodes);
  constexpr double third = 1.0 / 3;
  double sum = 9.0 / 40 * tangents.normal({third, third, third}).norm();
  for (const double sign : {-1.0, 1.0}) {
    const double weight = (155 + sign * root) / 1200, twice = (6 + sign * root) / 21;
    for (std::size_t i = 0; i < 3; ++i) {
      std::array<double, 3> at{twice, twice, twice};
      at[i] = 1 - 2 * twice;
      sum += weight * tangents.normal(at).norm();
    }
  }
  return sum / 2;
}

}  // namespace morskin::certify
