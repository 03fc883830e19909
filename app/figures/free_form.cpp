#include "app/figures/free_form.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/kd_tree.h"
#include "geometry/predicates.h"
#include "geometry/regular_triangulation.h"

namespace morskin::figures {
namespace {

// Union and difference that round the seam over a width.
double joined(double a, double b, double width) {
  const double h = std::max(width - std::abs(a - b), 0.0) / width;
  return std::min(a, b) - h * h * width / 4;
}
double carved(double a, double b, double width) { return -joined(-a, b, width); }

double ellipsoid(const Point& x, const Point& centre, const Vector& radii) {
  const Vector d = (x - centre).cwiseQuotient(radii);
  const double inner = d.norm(), outer = d.cwiseQuotient(radii).norm();
  return outer > 0 ? inner * (inner - 1) / outer : -radii.minCoeff();
}

// A rod with round ends of two radii.
double rod(const Point& x, const Point& from, const Point& to, double r_from, double r_to) {
  const Vector d = to - from;
  const double t = std::clamp((x - from).dot(d) / d.squaredNorm(), 0.0, 1.0);
  return (x - from - t * d).norm() - (r_from + t * (r_to - r_from));
}

Vector gradient(double (*function)(const Point&), const Point& x) {
  constexpr double h = 1e-5;
  Vector g;
  for (int k = 0; k < 3; ++k) {
    g[k] = (function(x + h * Vector::Unit(k)) - function(x - h * Vector::Unit(k))) / (2 * h);
  }
  return g;
}

std::optional<Point> settled(double (*function)(const Point&), Point x) {
  for (int i = 0; i < 12; ++i) {
    const Vector g = gradient(function, x);
    const double value = function(x);
    if (std::abs(value) < 1e-9) return x;
    if (!(g.squaredNorm() > 1e-12)) return std::nullopt;
    x -= value / g.squaredNorm() * g;
  }
  return std::abs(function(x)) < 1e-6 ? std::optional(x) : std::nullopt;
}

}  // namespace

double head_function(const Point& p) {
  const Point x(std::abs(p.x()), p.y(), p.z());                                // both halves alike
  double f = ellipsoid(x, {0, 0.4, -0.16}, {0.7, 0.74, 0.9});                  // skull
  f = joined(f, ellipsoid(x, {0, -0.16, 0.2}, {0.54, 0.78, 0.54}), 0.2);       // face
  f = joined(f, rod(x, {0, -0.6, -0.3}, {0, -1.25, -0.42}, 0.33, 0.36), 0.2);  // neck
  f = joined(f, ellipsoid(x, {0, -1.5, -0.42}, {0.85, 0.3, 0.42}), 0.3);       // shoulders
  f = joined(f, ellipsoid(x, {0, -0.83, 0.54}, {0.2, 0.14, 0.16}), 0.16);      // chin
  f = joined(f, rod(x, {0.46, -0.28, -0.02}, {0.16, -0.84, 0.46}, 0.13, 0.12), 0.15);  // jaw
  f = joined(f, rod(x, {0.07, 0.27, 0.8}, {0.44, 0.26, 0.6}, 0.1, 0.1), 0.1);          // brow
  f = joined(f, ellipsoid(x, {0.37, -0.16, 0.5}, {0.17, 0.13, 0.17}), 0.14);           // cheekbone
  // The skin fills hollows; so the eyes stand out of theirs, each with its iris.
  f = carved(f, ellipsoid(x, {0.25, 0.04, 0.95}, {0.25, 0.2, 0.38}), 0.05);         // socket
  f = joined(f, ellipsoid(x, {0.255, 0.045, 0.735}, {0.13, 0.11, 0.13}), 0.01);     // eye
  f = joined(f, ellipsoid(x, {0.24, 0.045, 0.835}, {0.065, 0.065, 0.055}), 0.005);  // iris
  f = joined(f, rod(x, {0, 0.2, 0.74}, {0, -0.2, 1.02}, 0.06, 0.1), 0.06);          // nose
  f = joined(f, ellipsoid(x, {0.11, -0.23, 0.86}, {0.08, 0.075, 0.11}), 0.04);
  f = joined(f, rod(x, {0.0, -0.465, 0.8}, {0.2, -0.51, 0.66}, 0.062, 0.03), 0.03);  // lips
  f = joined(f, rod(x, {0.0, -0.6, 0.79}, {0.17, -0.56, 0.67}, 0.07, 0.03), 0.02);
  f = joined(f, ellipsoid(x, {0.76, 0.04, -0.14}, {0.1, 0.26, 0.17}), 0.05);  // ear
  f = carved(f, ellipsoid(x, {0.9, 0.05, -0.09}, {0.1, 0.17, 0.1}), 0.05);
  return f;
}

std::vector<Point> samples_of(double (*function)(const Point&), const Point& low, const Point& high,
                              double spacing) {
  std::vector<Point> candidates;
  // A grid of half the spacing; where the function can vanish in a cell, its middle is settled.
  const double step = spacing / 2;
  const Vector extent = (high - low) / step;
  for (int i = 0; i < extent.x(); ++i) {
    for (int j = 0; j < extent.y(); ++j) {
      for (int k = 0; k < extent.z(); ++k) {
        const Point x = low + step * Vector(i + 0.5, j + 0.5, k + 0.5);
        if (std::abs(function(x)) > step) continue;
        if (const auto p = settled(function, x)) candidates.push_back(*p);
      }
    }
  }
  // One after the other, those that no earlier one is too near to.
  const geometry::KdTree<geometry::VertexId> tree(candidates);
  std::vector<bool> is_taken(candidates.size());
  std::vector<Point> samples;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const auto near = tree.nearest(candidates[i], 0.8 * spacing,
                                   [&](geometry::VertexId v) { return is_taken[v.index()]; });
    if (near) continue;
    is_taken[i] = true;
    samples.push_back(candidates[i].unaryExpr(&geometry::on_exact_grid));
  }
  return samples;
}

std::vector<geometry::WeightedPoint> inner_polar_balls(const std::vector<Point>& samples,
                                                       double (*function)(const Point&)) {
  std::vector<geometry::WeightedPoint> points;
  for (const Point& p : samples) points.push_back({p, 0});
  const geometry::RegularTriangulation delaunay = geometry::regular_triangulation(points);
  struct DelaunayBall {
    Point centre;
    double squared_radius;
  };
  std::vector<std::optional<DelaunayBall>> poles(samples.size());
  for (const auto& corners : delaunay.tetrahedra) {
    Eigen::Matrix3d sides;
    const Point& a = samples[corners[0].index()];
    for (int k = 0; k < 3; ++k) {
      sides.row(k) = samples[corners[static_cast<std::size_t>(k) + 1].index()] - a;
    }
    const Vector to_centre = sides.fullPivLu().solve(sides.rowwise().squaredNorm() / 2);
    const DelaunayBall ball{a + to_centre, to_centre.squaredNorm()};
    if (!ball.centre.allFinite() || !(function(ball.centre) < 0)) continue;
    for (const geometry::AtomId corner : corners) {
      auto& pole = poles[corner.index()];
      if (!pole || ball.squared_radius > pole->squared_radius) pole = ball;
    }
  }
  std::vector<geometry::WeightedPoint> balls;
  for (const auto& pole : poles) {
    if (pole) balls.push_back({pole->centre, 2 * pole->squared_radius});
  }
  const auto as_numbers = [](const geometry::WeightedPoint& p) {
    return std::array{p.position.x(), p.position.y(), p.position.z(), p.weight};
  };
  std::ranges::sort(balls, {}, as_numbers);
  const auto same = [&](const auto& p, const auto& q) { return as_numbers(p) == as_numbers(q); };
  balls.erase(std::unique(balls.begin(), balls.end(), same), balls.end());
  return balls;
}

}  // namespace morskin::figures
