#pragma once

/// Surfaces given by formulas, with nothing of a molecule behind them: a sphere and a torus.

#include "surface/surface.h"
#include "tests/support/test.h"

namespace morskin::support {

using geometry::Point;
using geometry::Vector;
using surface::CellId;

/// What both share. All crossings of a segment are found by halving: a piece is settled once its
/// ends tell that it stays on one side (surface::is_certainly_clear), or once G is monotone on it.
class FormulaSurface : public surface::Surface {
 public:
  double residual_bound(double rho) const final { return 1e-11 * rho * rho; }
  double length_scale(const Point& x, CellId cell) const final {
    return jet(x, cell).half_gradient.norm();
  }
  /// The formulas lose a few units in the last place of squares no larger than `size`.
  surface::Enclosure enclose(const Point& x, CellId hint) const final {
    const surface::Jet at_x = jet(x, locate(x, hint));
    const double size = x.squaredNorm() + max_length_scale() * max_length_scale() +
                        bounding_ball().radius * bounding_ball().radius;
    const double error = 0x1p-46 * size;
    return {at_x.value - error, at_x.value + error, at_x.half_gradient, 0x1p-46 * std::sqrt(size)};
  }
  bool is_in(const Point& x, CellId cell) const final { return locate(x, cell) == cell; }

  surface::LineCrossings crossings(const Point& p, const Point& q, CellId) const final {
    surface::LineCrossings result;
    halve(p, q, 0, 1, result.all);
    return result;
  }

 protected:
  surface::Jet jet_at(const Point& x) const { return jet(x, locate(x, CellId{0U})); }

 private:
  void halve(const Point& p, const Point& q, double low, double high,
             std::vector<surface::LineCrossing>& found) const {
    const Point a = p + low * (q - p), b = p + high * (q - p);
    const double length = (b - a).norm();
    const surface::Jet at_a = jet_at(a), at_b = jet_at(b);
    const bool is_one_side = (at_a.value > 0) == (at_b.value > 0);
    if (is_one_side && surface::is_certainly_clear(length, std::sqrt(std::abs(at_a.value)),
                                                   std::sqrt(std::abs(at_b.value)))) {
      return;
    }
    // N is 1-Lipschitz, so along the piece its part keeps its sign where it is longer than that.
    const bool is_monotone = std::abs(at_a.half_gradient.dot((b - a) / length)) > length;
    constexpr double min_share = 1e-12;
    if ((is_monotone && is_one_side) || high - low < min_share) return;
    const double middle = (low + high) / 2;
    if (is_monotone) {
      found.push_back(zero(p, q, low, high, at_a.value > 0));
    } else {
      halve(p, q, low, middle, found);
      halve(p, q, middle, high, found);
    }
  }
  surface::LineCrossing zero(const Point& p, const Point& q, double low, double high,
                             bool is_outside_at_low) const {
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      const bool is_outside = jet_at(p + middle * (q - p)).value > 0;
      (is_outside == is_outside_at_low ? low : high) = middle;
    }
    const Point x = p + high * (q - p);
    return {high, x, locate(x, CellId{0U})};
  }
};

/// G = |x|^2 - r^2.
class Sphere final : public FormulaSurface {
 public:
  explicit Sphere(double radius) : r_(radius) {}

  CellId locate(const Point&, CellId) const override { return CellId{0U}; }
  surface::Jet jet(const Point& x, CellId) const override { return {x.squaredNorm() - r_ * r_, x}; }
  std::optional<surface::SurfacePoint> project(const Point& x, CellId) const override {
    const double distance = x.norm();
    if (!(distance > 0)) return std::nullopt;
    return at(x * (r_ / distance), CellId{0U});
  }
  surface::BoundingBall bounding_ball() const override { return {Point::Zero(), 1.01 * r_}; }
  double max_length_scale() const override { return r_; }
  surface::Samples samples() const override {
    constexpr int count = 32;
    surface::Samples result{{}, 4 * M_PI / count};
    for (int i = 0; i < count; ++i) {  // a spiral from pole to pole
      const double z = (2 * i + 1.0) / count - 1, s = std::sqrt(1 - z * z);
      const double angle = i * M_PI * (3 - std::sqrt(5.0));
      const Point x = r_ * Point(s * std::cos(angle), s * std::sin(angle), z);
      result.points.push_back(at(x, CellId{0U}));
    }
    return result;
  }
  std::size_t cell_count() const override { return 1; }
  surface::PatchExtent extent(CellId, double) const override { return {4 * M_PI, r_}; }

 private:
  double r_;
};

/// A tube of radius r about a circle of radius R >= 2 r round the z axis. With s the distance from
/// the axis,
///     G = (s - R)^2 + z^2 - r^2      for s >= R / 2   (cell 0),
///     G = R^2 / 2 - s^2 + z^2 - r^2  inside           (cell 1),
/// so that N stays 1-Lipschitz down to the axis.
class Torus final : public FormulaSurface {
 public:
  /// @pre R >= 2 r
  Torus(double R, double r) : R_(R), r_(r) {}

  CellId locate(const Point& x, CellId) const override {
    return CellId{std::hypot(x.x(), x.y()) >= R_ / 2 ? 0U : 1U};
  }
  surface::Jet jet(const Point& x, CellId cell) const override {
    const double s = std::hypot(x.x(), x.y()), z = x.z();
    if (cell.value == 1) {
      return {R_ * R_ / 2 - s * s + z * z - r_ * r_, Vector(-x.x(), -x.y(), z)};
    }
    const double off = s - R_;
    return {off * off + z * z - r_ * r_, Vector(off * x.x() / s, off * x.y() / s, z)};
  }
  std::optional<surface::SurfacePoint> project(const Point& x, CellId) const override {
    const double s = std::hypot(x.x(), x.y());
    if (!(s > 0)) return std::nullopt;
    const Point centre(R_ * x.x() / s, R_ * x.y() / s, 0);
    const Vector d = x - centre;
    if (!(d.norm() > 0)) return std::nullopt;
    return at(centre + r_ * d.normalized(), CellId{0U});
  }
  surface::BoundingBall bounding_ball() const override { return {Point::Zero(), 1.01 * (R_ + r_)}; }
  double max_length_scale() const override { return r_; }
  /// Round the circle, outside and inside by turns.
  surface::Samples samples() const override {
    constexpr int count = 64;
    surface::Samples result{{}, 4 * M_PI * M_PI * R_ / r_ / count};
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * M_PI * (i + 0.37) / count, s = i % 2 == 0 ? R_ + r_ : R_ - r_;
      const Point x(s * std::cos(angle), s * std::sin(angle), 0);
      result.points.push_back(at(x, locate(x, CellId{0U})));
    }
    return result;
  }
  std::size_t cell_count() const override { return 2; }
  surface::PatchExtent extent(CellId, double) const override {
    return {4 * M_PI * M_PI * R_ / r_, r_};
  }

 private:
  double R_, r_;
};

}  // namespace morskin::support
