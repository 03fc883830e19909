#include "morse/tracer.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace morskin::morse {

namespace {

using skin::CellId;
using skin::Patch;

/// The first node's distance from the saddle, over rho, on the osculating parabola: an error of
/// fourth order, 1e-10 rho. It scales with the square of the step, as both errors then shrink
/// alike.
constexpr double usual_take_off = 3e-3;
/// Largest angle between nodes on arcs in closed form, radians (or rho, on a hyperbola).
constexpr double node_spacing = 0.3;
/// Pieces in which a line that does not come a length scale farther counts as lost. The longest in
/// the corpus have some thousands in all, but one along a filament may have any number.
constexpr int max_pieces = 20000;

/// tan(t/2) of the point (cos t, sin t), 0 < t < pi, without cancellation at either pole.
double half_tangent(double cosine, double sine) {
  return cosine > 0 ? sine / (1 + cosine) : (1 - cosine) / sine;
}

/// Of the two lines through a saddle one runs along the meridian, with at least 1/sqrt 2 of its
/// direction along the axis, the other across it.
bool is_along_axis(const Patch& patch, const Vector& tangent) {
  return std::abs(patch.axis.dot(tangent)) > 0.5;
}

}  // namespace

Tracer::Tracer(const IntegralLines& lines, Direction direction, std::vector<Point>* points,
               std::vector<CellId>* cells)
    : lines_(lines),
      direction_(direction),
      points_(points),
      cells_(cells),
      tolerance_(lines.skin_.complex().wall_tolerance()),
      flow_(lines.skin_.complex().patch(CellId{0U}), lines.f_, direction) {}

void Tracer::enter(CellId cell, const Vector& u) {
  const skin::MixedComplex& complex = lines_.skin_.complex();
  const Patch& patch = complex.patch(cell);
  cell_ = cell;
  flow_ = GradientFlow(patch, lines_.f_, direction_);
  centre_ = patch.centre;
  centre_value_ = lines_.f_(centre_);
  u_ = flow_.settled(flow_.to_local(u));
  velocity_ = flow_(u_);
  decay_ = 0;
  walls_.clear();
  for (const skin::Wall& wall : complex.walls(cell)) {
    const Vector normal = flow_.to_local(wall.normal);
    const double offset = wall.offset - wall.normal.dot(centre_);
    walls_.push_back({normal, offset, wall.beyond, normal.dot(u_) - offset, normal.dot(velocity_)});
  }
}

// Ties of the triangulation give cells without width, whose patch need not contain the point: a
// flat tetrahedron's orthocentre may lie anywhere on a line. The gradient is continuous, so the
// line crosses them with the velocity of the cell that it leaves.
void Tracer::leave_through(LocalWall wall) {
  const skin::MixedComplex& complex = lines_.skin_.complex();
  const Point x = centre_ + flow_.to_space(u_);
  const Vector velocity = flow_.to_space(velocity_);
  CellId cell = wall.beyond, before = cell_;
  constexpr int max_crossed = 64;
  const double flat = no_width * tolerance_;
  for (int crossed = 0; crossed < max_crossed; ++crossed) {
    std::optional<CellId> passed;
    double farthest = -flat;
    for (const skin::Wall& other : complex.walls(cell)) {
      const double distance = other.normal.dot(x) - other.offset;
      const bool is_far_beyond = distance > flat;
      const bool may_pass = is_far_beyond || other.normal.dot(velocity) > 0;
      if (other.beyond == before || distance < farthest || !may_pass) continue;
      farthest = distance;
      passed = other.beyond;
    }
    if (!passed) break;
    before = std::exchange(cell, *passed);
  }
  enter(cell, x - complex.patch(cell).centre);
  if (cells_ != nullptr) cells_->back() = cell_;
}

void Tracer::note() {
  if (points_ == nullptr) return;
  points_->push_back(centre_ + flow_.to_space(u_));
  cells_->push_back(cell_);
}

IntegralLines::Passage Tracer::passage() const {
  const double rho = u_.norm();
  return {centre_ + flow_.to_space(u_), flow_.to_space(velocity_),
          flow_.to_space(flow_.normal(u_) / rho), rho};
}

void Tracer::start(const Point& x, CellId cell) {
  enter(cell, x - lines_.skin_.complex().patch(cell).centre);
  note();
}

// With r and s of the saddle, both relative to its radial direction and the axis: the line along
// the meridian is an arc of the hyperbola r^2 - s^2 = k. On the line across, r and s are even
// functions of b by symmetry; the first coefficient of s + s1 b^2 follows from ds/db = s'/b'.
void Tracer::start(CriticalId saddle, const Vector& tangent, double share) {
  origin_ = saddle;
  const surface::SurfacePoint& at = lines_.points_[saddle.index()].point;
  const Patch& patch = lines_.skin_.complex().patch(at.cell);
  const Vector u = at.position - patch.centre;
  const Vector& axis = patch.axis;
  const double s = axis.dot(u), rho = at.length_scale, rho2 = rho * rho;
  Vector radial = u - s * axis;
  const double r = radial.norm();
  radial /= r;
  const double of_usual = lines_.step_ / IntegralLines::usual_step;
  const double away = share * std::min(usual_take_off * of_usual * of_usual * rho,
                                       lines_.wall_distance(saddle) / 2);
  if (is_along_axis(patch, tangent)) {
    const double t = std::copysign(away / rho, axis.dot(tangent));
    enter(at.cell, (r * std::cosh(t) + s * std::sinh(t)) * radial +
                       (s * std::cosh(t) + r * std::sinh(t)) * axis);
  } else {
    const Vector w = lines_.f_.gradient(patch.centre);
    const double c = 2 * lines_.f_.curvature, v_r = radial.dot(w), v = axis.dot(w);
    const double k = patch.sign * patch.half_weight;
    const double l = (c * k + v_r * r - v * s) / rho2;
    const double l_of_b = -v_r / (2 * r * rho2), l_of_s = (v_r * s / r - v - 4 * l * s) / rho2;
    const double s_end = s + s * l_of_b / (c - 3 * l - s * l_of_s) * away * away;
    const double r_end = std::sqrt(k + s_end * s_end - away * away);
    enter(at.cell, r_end * radial + away * tangent + s_end * axis);
  }
  note();
}

void Tracer::follow_meridian(CriticalId saddle, const Vector& tangent) {
  const Patch& patch = lines_.skin_.complex().patch(cell_);
  if (!is_along_axis(patch, tangent)) return;
  for (const CriticalId id : lines_.within(lines_.points_[saddle.index()].point.cell)) {
    if (lines_.points_[id.index()].index != 1) return;
  }
  const double sign = patch.axis.dot(tangent) > 0 ? 1 : -1;
  const Vector u = u_;
  const double s = u.z(), r = std::hypot(u.x(), u.y());
  const Vector turned = sign * Vector(s / r * u.x(), s / r * u.y(), r);  // du / d(hyperbolic angle)
  // The line meets a wall where a cosh t + b sinh t = c: the zero with growing distance, in e^t.
  double first = INFINITY;
  std::size_t exit = 0;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const double a = walls_[i].normal.dot(u), b = walls_[i].normal.dot(turned),
                 c = walls_[i].offset + tolerance_;
    const double root2 = c * c - a * a + b * b;
    if (root2 < 0) continue;
    const double root = std::sqrt(root2);
    const double p = c >= 0 ? (c + root) / (a + b) : (a - b) / (c - root);
    if (p > 1 && p < first) {
      first = p;
      exit = i;
    }
  }
  if (first == INFINITY) return;
  const double end = std::log(first);
  const int pieces = std::max(1, static_cast<int>(std::ceil(end / node_spacing)));
  for (int i = 1; i <= pieces; ++i) {
    const double t = end * i / pieces;
    u_ = flow_.settled(std::cosh(t) * u + std::sinh(t) * turned);
    note();
  }
  leave_through(walls_[exit]);
}

std::optional<std::size_t> Tracer::wall_passed() const {
  // Lines leave a cell `tolerance` beyond its wall, so that rounding does not lead back into it.
  // Where cells have no width the next wall is passed with the first; a quarter allows for
  // rounding.
  std::optional<std::size_t> passed;
  double farthest = tolerance_ / 4;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    if (walls_[i].slope > 0 && walls_[i].distance >= farthest) {
      farthest = walls_[i].distance;
      passed = i;
    }
  }
  return passed;
}

void Tracer::run() {
  const auto here = [&]() -> Point { return centre_ + flow_.to_space(u_); };
  Point passed = here();
  for (int piece = 0;; ++piece) {
    if (piece == max_pieces) {
      if ((here() - passed).norm() < u_.norm()) return;
      passed = here();
      piece = 0;
    }
    if (const auto wall = wall_passed()) {
      leave_through(walls_[*wall]);
      continue;
    }
    if (!(flow_.is_sphere() ? follow_great_circle() : step())) return;
  }
}

Tracer::ArcExit Tracer::exit_of_arc(const Vector& pole, const Vector& side, double from) const {
  const double rho = u_.norm();
  ArcExit exit;
  for (const LocalWall& wall : walls_) {
    const double a = rho * wall.normal.dot(pole), b = rho * wall.normal.dot(side),
                 c = wall.offset + tolerance_;
    const double m2 = a * a + b * b;
    if (m2 <= c * c) continue;
    const double root = std::sqrt(m2 - c * c);
    const double x = (c * a - root * b) / m2, y = (c * b + root * a) / m2;
    if (y <= 0) continue;
    const double t = half_tangent(x, y);
    if (t < from && t > exit.half_tangent) exit = {t, &wall};
  }
  return exit;
}

// u = rho (cos t pole + sin t side), with the pole at the line's end: t falls to 0.
bool Tracer::follow_great_circle() {
  const double rho = u_.norm();
  const double gradient = flow_.gradient(Vector::Zero()).x();
  const double sign = direction_ == Direction::Up ? 1 : -1;
  const Vector pole = sign * Vector::UnitX();
  const double height = pole.dot(u_) / rho;
  Vector side = u_ / rho - height * pole;
  const double sine = side.norm();
  if (!(gradient > 0 && sine > 0)) return false;
  side /= sine;
  const double from = half_tangent(height, sine);
  const auto [to, exit] = exit_of_arc(pole, side, from);
  const double angle = 2 * std::atan(from);
  if (stop_) {
    const double x = sign * (*stop_ - level_here(u_) + gradient * u_.x()) / (gradient * rho);
    if (x > -1 && x < 1 && half_tangent(x, std::sqrt((1 - x) * (1 + x))) >= to) {
      const double t = std::acos(x);
      u_ = rho * (std::cos(t) * pole + std::sin(t) * side);
      velocity_ = flow_(u_);
      at_level_ = true;
      return false;
    }
  }
  if (exit != nullptr) {
    add_arc_nodes(pole, side, angle, 2 * std::atan(to));
    leave_through(*exit);
    return true;
  }
  for (const CriticalId id : lines_.within(cell_)) {
    if (lines_.points_[id.index()].index != (direction_ == Direction::Up ? 2 : 0)) continue;
    const Vector away = flow_.to_space(u_ - rho * pole);
    if (angle > node_spacing) {
      add_arc_nodes(pole, side, angle, angle / std::ceil(angle / node_spacing));
    }
    arrive(id, away);
    return false;
  }
  return false;
}

void Tracer::add_arc_nodes(const Vector& pole, const Vector& side, double from, double to) {
  const double rho = u_.norm();
  const int pieces =
      points_ == nullptr ? 1 : std::max(1, static_cast<int>(std::ceil((from - to) / node_spacing)));
  for (int i = 1; i <= pieces; ++i) {
    const double t = from + (to - from) * i / pieces;
    u_ = rho * (std::cos(t) * pole + std::sin(t) * side);
    note();
  }
}

void Tracer::arrive(CriticalId id, const Vector& from) {
  const CaptureDisc& disc = lines_.discs_[id.index()];
  course_.arrival = {id, std::atan2(from.dot(disc.second), from.dot(disc.first)), from.norm()};
  if (points_ == nullptr) return;
  points_->push_back(lines_.points_[id.index()].point.position);
  cells_->push_back(cell_);
}

}  // namespace morskin::morse
