#include "morse/integral_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/orthogonal.h"
#include "morse/tracer.h"

namespace morskin::morse {

using skin::CellId;

IntegralLines::IntegralLines(const skin::SkinSurface& skin, const MorseFunction& f,
                             std::span<const CriticalPoint> points, double step)
    : skin_(skin), f_(f), points_(points), step_(step), discs_(points.size()) {
  by_cell_ = geometry::grouped<CriticalId>(skin.complex().kept_size(), [&](auto visit) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      visit(points[i].point.cell.index(), CriticalId{i});
    }
  });
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].index != 1) build_disc(CriticalId{i});
  }
}

double IntegralLines::wall_distance(CriticalId id) const {
  const surface::SurfacePoint& at = points_[id.index()].point;
  double nearest = INFINITY;
  for (const skin::Wall& wall : skin_.complex().walls(at.cell)) {
    nearest = std::min(nearest, wall.offset - wall.normal.dot(at.position));
  }
  return std::max(nearest, 0.0);
}

// At a critical point p the gradient of f is mu N(p), and G = 0 gives 2 N(p) . d = -d . M d for
// d = x - p, so on the patch f(x) - f(p) = d . (curvature I - mu M / 2) d = d . form d exactly. Let
// l be the form's lower value on the tangent plane, T its part between plane and normal, h the size
// of its value on the normal, x = |d| / rho. As |n . d| <= rho x^2 / 2,
//
//     d . form d  >=  |d|^2 g(x),   g(x) = l (1 - x^2 / 4) - T x - h x^2 / 4,
//
// and another point with gradient mu' N would need  g(x) (1 - x) <= (T + h x / 2) x / 2  (papers
// page). Below the smallest x with that p is the only critical point, and a line that comes within
// |d| = rho x to a level below rho^2 x^2 g(x) stays there.
void IntegralLines::build_disc(CriticalId id) {
  const CriticalPoint& p = points_[id.index()];
  const skin::Patch& patch = skin_.complex().patch(p.point.cell);
  const double rho = p.point.length_scale;
  const Vector& n = p.point.normal;
  CaptureDisc& disc = discs_[id.index()];
  disc.centre = p.point.position - patch.centre;
  disc.first = geometry::unit_orthogonal_part(patch.axis, n);
  disc.second = n.cross(disc.first);
  if (patch.axis.squaredNorm() == 0) return;  // lines are great circles, no disc is needed
  const double sign = p.index == 0 ? 1 : -1;
  const double mu = f_.gradient(p.point.position).dot(n) / rho;
  const auto reflect = [&](const Vector& v) { return patch.reflect(v); };
  for (int i = 0; i < 3; ++i) {
    disc.form.col(i) = sign * (f_.curvature * Vector::Unit(i) - mu / 2 * reflect(Vector::Unit(i)));
  }
  const double first = disc.first.dot(disc.form * disc.first),
               second = disc.second.dot(disc.form * disc.second);
  const double lowest = std::min(first, second);
  const Vector with_normal = disc.form * n;
  const double h = std::abs(n.dot(with_normal)), t = (with_normal - n.dot(with_normal) * n).norm();
  const auto g = [&](double x) { return lowest * (1 - x * x / 4) - t * x - h * x * x / 4; };
  const double farthest = wall_distance(id) / rho;
  double max_x = std::min(farthest, 1.0);
  // Both sides are monotone in x, so every x up to the first that passes is safe. The best level
  // among the shares is at most a few percent off the best of all.
  constexpr double share = 0.9;
  const double min_x = 1e-12 * max_x;  // where l is not positive no disc is proved to capture
  while (max_x > min_x && g(max_x) * (1 - max_x) <= (t + h * max_x / 2) * max_x / 2) max_x *= share;
  if (!(max_x > min_x)) return;
  for (double x = max_x; x > max_x / 4; x *= share) {
    const double level = rho * rho * x * x * g(x);
    if (level > disc.level) {
      disc.level = level;
      disc.radius = std::min(rho * x, wall_distance(id));
    }
  }
  disc.first *= std::sqrt(first);
  disc.second *= std::sqrt(second);
}

Course IntegralLines::trace(CriticalId saddle, const Vector& tangent, Direction direction,
                            std::vector<Point>& points, std::vector<CellId>& cells) const {
  const surface::SurfacePoint& at = points_[saddle.index()].point;
  points.push_back(at.position);
  cells.push_back(at.cell);
  Tracer tracer(*this, direction, &points, &cells);
  tracer.start(saddle, tangent, 1);
  tracer.follow_meridian(saddle, tangent);
  tracer.run();
  return tracer.course();
}

Course IntegralLines::trace(const surface::SurfacePoint& start, Direction direction,
                            std::vector<Point>& points, std::vector<CellId>& cells) const {
  Tracer tracer(*this, direction, &points, &cells);
  tracer.start(start.position, start.cell);
  tracer.run();
  return tracer.course();
}

IntegralLines::Passage IntegralLines::passage_at(const LineNodes& line, std::size_t node) const {
  const skin::Patch& patch = skin_.complex().patch(line.cells[node]);
  const GradientFlow flow(patch, f_, line.direction);
  const Point& x = line.points[node];
  const Vector normal = patch.half_gradient(x);
  const double rho = normal.norm();
  return {x, flow.to_space(flow(flow.to_local(x - patch.centre))), normal / rho, rho};
}

std::optional<IntegralLines::Passage> IntegralLines::passage(const LineNodes& line,
                                                             double level) const {
  const double sign = line.direction == Direction::Up ? 1 : -1;
  const auto is_beyond = [&](const Point& x) { return sign * (f_(x) - level) >= 0; };
  const auto after = std::partition_point(line.points.begin(), line.points.end(),
                                          [&](const Point& x) { return !is_beyond(x); });
  if (after == line.points.begin() || after == line.points.end()) return std::nullopt;
  const auto before = static_cast<std::size_t>(after - line.points.begin()) - 1;
  Tracer tracer(*this, line.direction, nullptr, nullptr);
  if (before == 0) {
    // f is even along the line at its saddle.
    const double start = f_(line.points[0]), next = f_(line.points[1]);
    tracer.start(line.saddle, line.tangent, std::sqrt((level - start) / (next - start)));
    return tracer.passage();
  }
  tracer.start(line.points[before], line.cells[before]);
  tracer.stop_at(level);
  tracer.run();
  if (!tracer.is_at_level()) return std::nullopt;
  return tracer.passage();
}

}  // namespace morskin::morse
