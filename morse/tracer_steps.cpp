// The tracer where there is no closed form: Runge-Kutta steps, shortened to end at a cell wall, on
// a level or in a capture disc.

#include <algorithm>
#include <cmath>

#include "geometry/orthogonal.h"
#include "morse/tracer.h"

namespace morskin::morse {

namespace {

/// An approximate zero of the cubic with these values, of opposite signs, and slopes at 0 and 1.
double cubic_zero(double v0, double s0, double v1, double s1) {
  double t = v0 / (v0 - v1);
  const double c = 3 * (v1 - v0) - 2 * s0 - s1, d = s0 + s1 - 2 * (v1 - v0);
  for (int i = 0; i < 3; ++i) {
    const double value = v0 + t * (s0 + t * (c + t * d)), slope = s0 + t * (2 * c + 3 * t * d);
    const double next = t - value / slope;
    if (!(next > 0 && next < 1)) break;
    t = next;
  }
  return t;
}

/// A line creeps where its slope, |grad f| on the skin over that in space, is below this: a usual
/// step then gains 0.003 rho, an implicit one, which costs ten times as much, up to 0.054 rho;
constexpr double creeping_slope = 1e-2;
/// and where its speed changes at less than this share of the rate at which its neighbours
/// converge: while its speed changes by an implicit step's `creeping_change`, they come 9 e-folds
/// nearer, for which the usual method needs a handful of steps.
constexpr double rate_share = 0.02;
/// E-folds after which the distance from the slow curve is rounding: e^-37 < 2^-53.
constexpr double settled_decay = 37;
/// Bounds on a creeping step, over the usual step: on its length over rho and, near the extremum,
/// on the e-folds of its change of speed. Its error is of order 5, and 3 across the curve, where
/// the flow damps it. Chosen to make creeping lines as accurate as others
/// (tests/creeping_lines_test.cpp).
constexpr double creeping_share = 0.3, creeping_change = 1;

/// Below this slope the velocity is rounding: a difference of terms of the gradient's size, whose
/// last 6 of 53 bits are unknown.
constexpr double slope_at_rest = 0x1p-47;

/// The radius over rho within which the flow about a saddle is taken as linear.
constexpr double linear_radius = 0.1;

}  // namespace

// If Radau's method converges for a step it does for shorter ones; otherwise the end stays at u_.
Vector Tracer::step_end(double time) const {
  return flow_.settled(is_implicit_ ? radau_step(flow_, u_, velocity_, time).value_or(u_)
                                    : runge_kutta_step(flow_, u_, velocity_, time));
}

/// The rates at which the flow separates lines along its two principal directions on the skin, the
/// lower one first. From the derivative alone: the direction of a slow flow is rounding.
std::pair<double, double> Tracer::rates() const {
  const auto [first, second] = geometry::TangentFrame(flow_.normal(u_).normalized());
  const Eigen::Matrix3d derivative = flow_.derivative(u_);
  const Vector of_first = derivative * first, of_second = derivative * second;
  const double half = (first.dot(of_first) + second.dot(of_second)) / 2;
  const double product =
      first.dot(of_first) * second.dot(of_second) - first.dot(of_second) * second.dot(of_first);
  const double lower = half - std::sqrt(std::max(half * half - product, 0.0));
  return {lower, product / lower};
}

/// The usual time of a step or, on a line that creeps, the time that its speed allows. Zero where f
/// is flat within rounding.
double Tracer::step_time() {
  const double gradient = flow_.gradient(u_).norm(), speed = velocity_.norm();
  is_implicit_ = false;
  if (!(speed > slope_at_rest * gradient)) return 0;
  // Where the flow is slow, near critical points, it is nearly linear, and a step's error is its
  // length times the eighth power of its time: a little more time gives about the same error.
  const double time =
      lines_.step_ * std::sqrt(std::sqrt(std::sqrt(gradient / speed))) / flow_.rate(u_, gradient);
  const auto [fast, slow] = speed < creeping_slope * gradient ? rates() : std::pair(0.0, 0.0);
  if (!(std::abs(slow) < -rate_share * fast)) {
    decay_ = 0;
    return time;
  }
  if (decay_ < settled_decay) {
    decay_ -= fast * time;
    creep_time_ = time;
    return time;
  }
  const double longest =
      lines_.step_ * std::min(creeping_share * u_.norm() / speed, creeping_change / std::abs(slow));
  creep_time_ = std::min(2 * creep_time_, longest);
  while (creep_time_ > time && !radau_step(flow_, u_, velocity_, creep_time_)) creep_time_ /= 2;
  is_implicit_ = creep_time_ > time;
  return std::max(creep_time_, time);
}

/// Shortens a step to the zero of a function that is negative at its begin and not at its end, and
/// sets end_. @param function  (point, velocity) -> value and its derivative in time
/// @return the new time
template <class Function>
double Tracer::first_zero(double time, double tolerance, Function function) {
  const auto [v0, s0] = function(u_, velocity_);
  auto [v1, s1] = function(end_, flow_(end_));
  double low = 0, high = time;
  double t = v0 < 0 && v1 > 0 ? time * cubic_zero(v0, s0 * time, v1, s1 * time) : time;
  for (int i = 0; i < 60; ++i) {
    end_ = step_end(t);
    const auto [value, slope] = function(end_, flow_(end_));
    if (std::abs(value) <= tolerance) break;
    (value < 0 ? low : high) = t;
    t -= value / slope;
    if (!(t > low && t < high)) t = (low + high) / 2;
    if (!(t > low && t < high)) break;
  }
  return t;
}

/// Whether the line passes a wall within a step that ends before it. If so, `time` becomes a time
/// beyond the wall.
bool Tracer::rises_above(const LocalWall& wall, double& time, double slope_at_end) const {
  double low = 0, high = time, s_low = wall.slope, s_high = slope_at_end;
  for (int i = 0; i < 6; ++i) {
    const double t = low + (high - low) * s_low / (s_low - s_high);
    const Vector x = step_end(t);
    if (wall.normal.dot(x) - wall.offset >= tolerance_) {
      time = t;
      return true;
    }
    const double s = wall.normal.dot(flow_(x));
    // A bound on the top of the distance, which is nearly a parabola.
    const double top = wall.normal.dot(x) - wall.offset + std::abs(s) * (high - low);
    if (top < tolerance_ || s == 0) return false;
    (s > 0 ? low : high) = t;
    (s > 0 ? s_low : s_high) = s;
  }
  return false;
}

/// Shortens the step to the first wall it passes. @return whether there is one.
bool Tracer::end_at_wall(double& time, std::optional<std::size_t>& exit) {
  // |u''| is below a small multiple of |u'| times the rate, which bounds how far the line goes
  // beyond its distances from the walls at the step's ends.
  const double bulge =
      time * time * flow_.rate(u_, flow_.gradient(u_).norm()) * velocity_.norm() / 2;
  for (std::size_t i = 0; i < walls_.size(); ++i) {
    const LocalWall& wall = walls_[i];
    const double distance = wall.normal.dot(end_) - wall.offset;
    if (std::max(distance, wall.distance) + bulge < tolerance_ || exit == i) continue;
    double shortened = time;
    if (distance < tolerance_) {
      const double slope = wall.normal.dot(flow_(end_));
      if (!(wall.slope > 0 && slope < 0 && rises_above(wall, shortened, slope))) continue;
      end_ = step_end(shortened);
    }
    time = first_zero(shortened, tolerance_ / 2, [&](const Vector& x, const Vector& velocity) {
      return std::pair(wall.normal.dot(x) - wall.offset - tolerance_, wall.normal.dot(velocity));
    });
    exit = i;
    return true;
  }
  return false;
}

bool Tracer::step() {
  double time = step_time();
  if (!(time > 0 && std::isfinite(time))) {
    course_.is_at_rest = true;
    return false;
  }
  end_ = step_end(time);
  std::optional<std::size_t> exit;
  for (std::size_t i = 0; i <= walls_.size() && end_at_wall(time, exit); ++i) {
  }
  if (stop_ && stops_within(time)) return false;
  if ((!exit && capture(time)) || is_at_saddle()) return false;
  u_ = end_;
  velocity_ = flow_(u_);
  note();
  if (exit) {
    leave_through(walls_[*exit]);
    return true;
  }
  for (LocalWall& wall : walls_) {
    wall.distance = wall.normal.dot(u_) - wall.offset;
    wall.slope = wall.normal.dot(velocity_);
  }
  return true;
}

bool Tracer::stops_within(double time) {
  const double sign = direction_ == Direction::Up ? 1 : -1;
  if (sign * (level_here(end_) - *stop_) < 0) return false;
  const double rounding = 4e-16 * (std::abs(*stop_) + std::abs(centre_value_));
  first_zero(time, rounding, [&](const Vector& x, const Vector& velocity) {
    return std::pair(sign * (level_here(x) - *stop_), sign * flow_.gradient(x).dot(velocity));
  });
  u_ = end_;
  velocity_ = flow_(u_);
  at_level_ = true;
  return true;
}

bool Tracer::is_at_saddle() {
  for (const CriticalId id : lines_.within(cell_)) {
    const CriticalPoint& p = lines_.points_[id.index()];
    if (p.index == 1 && id != origin_ && comes_too_near(p)) course_.saddle = id;
  }
  return course_.saddle.has_value();
}

// Near a saddle a line comes in along one of its two directions and leaves along the other: x falls
// like e^(-i t), y grows like e^(o t), and x^(o/i) y is constant. So at x = `radius`, y was the
// value compared below, the offset from the line that ends at the saddle; its sign is unknown
// within the accuracy of lines. It is computed in the one step in which y outgrows x, where neither
// is small against the other and the curvature of the two directions does not matter.
bool Tracer::comes_too_near(const CriticalPoint& saddle) const {
  const double rho = saddle.point.length_scale, radius = linear_radius * rho;
  const Vector to = centre_ + flow_.to_space(end_) - saddle.point.position;
  if (!(to.squaredNorm() < radius * radius)) return false;
  const double merge = lines_.merge_distance(rho);
  if (to.norm() < merge) return true;
  const Vector &in = direction_ == Direction::Down ? saddle.ascending : saddle.descending,
               &out = direction_ == Direction::Down ? saddle.descending : saddle.ascending;
  const double x = std::abs(in.dot(to)), y = std::abs(out.dot(to));
  if (y < x) return false;
  const Vector from = centre_ + flow_.to_space(u_) - saddle.point.position;
  if (std::abs(out.dot(from)) >= std::abs(in.dot(from))) return false;
  const Eigen::Matrix3d derivative =
      flow_.derivative(flow_.to_local(saddle.point.position - centre_));
  const auto rate = [&](const Vector& direction) {
    const Vector local = flow_.to_local(direction);
    return std::abs(local.dot(derivative * local));
  };
  return y * std::pow(x / radius, rate(out) / rate(in)) < merge;
}

bool Tracer::capture(double time) {
  for (const CriticalId id : lines_.within(cell_)) {
    const CaptureDisc& disc = lines_.discs_[id.index()];
    if (lines_.points_[id.index()].index != (direction_ == Direction::Up ? 2 : 0) ||
        !disc.contains(flow_.to_space(end_))) {
      continue;
    }
    if (!disc.contains(flow_.to_space(u_))) {
      const double rounding = 1e-13 + 1e-15 * u_.norm() / disc.radius;
      first_zero(time, rounding * disc.level, [&](const Vector& x, const Vector& velocity) {
        const Vector d = flow_.to_space(x) - disc.centre;
        return std::pair(disc.level - d.dot(disc.form * d),
                         -2 * d.dot(disc.form * flow_.to_space(velocity)));
      });
      u_ = end_;
      note();
    }
    arrive(id, flow_.to_space(end_) - disc.centre);
    return true;
  }
  return false;
}

}  // namespace morskin::morse
