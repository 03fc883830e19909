// The tracer where no closed form is known: Runge-Kutta steps that end where something happens, at
// a cell wall, on a level, in a capture disc.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "morse/tracer.h"

namespace morskin::morse {

namespace {

/// A zero of the cubic with these values (opposite signs) and slopes at 0 and 1, roughly.
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

}  // namespace

Vector Tracer::step_end(double time) const {
  return flow_.settled(runge_kutta_step(flow_, u_, velocity_, time));
}

/// Shortens a step to where a function, negative at its begin and not at its end, is zero.
/// `function` gives value and slope in time at a point. The step's new end is left in end_.
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

/// Whether the line bulges through a wall within a step that ends before it. If so, `time` becomes
/// the time of the farthest point.
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
    // As the distance is nearly a parabola, its top is no higher than this.
    const double top = wall.normal.dot(x) - wall.offset + std::abs(s) * (high - low);
    if (top < tolerance_ || s == 0) return false;
    (s > 0 ? low : high) = t;
    (s > 0 ? s_low : s_high) = s;
  }
  return false;
}

/// Shortens the step to the first wall it passes. @return whether there is one.
bool Tracer::end_at_wall(double& time, std::optional<std::size_t>& exit) {
  // |u''| stays below a small multiple of |u'| times the rate, so a line can bulge no farther
  // beyond the walls' distances at the step's ends than this.
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
  const double gradient = flow_.gradient(u_).norm(), speed = velocity_.norm();
  const double rate = flow_.rate(u_, gradient);
  // Where the flow is slow, near critical points, it is nearly linear, and the error of a step is
  // its length times the ninth power of its time: a little more time gives about the same error.
  double time = lines_.step_ * std::sqrt(std::sqrt(std::sqrt(gradient / speed))) / rate;
  if (!(speed > 0 && std::isfinite(time))) return false;
  end_ = step_end(time);
  std::optional<std::size_t> exit;
  for (std::size_t i = 0; i <= walls_.size() && end_at_wall(time, exit); ++i) {
  }
  if (stop_ && look_for_stop(time)) return false;
  if (!exit && (capture(time) || is_at_saddle())) return false;
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

bool Tracer::look_for_stop(double time) {
  const double way = way_ == Way::Up ? 1 : -1;
  if (way * (level_here(end_) - *stop_) < 0) return false;
  const double rounding = 4e-16 * (std::abs(*stop_) + std::abs(centre_value_));
  first_zero(time, rounding, [&](const Vector& x, const Vector& velocity) {
    return std::pair(way * (level_here(x) - *stop_), way * flow_.gradient(x).dot(velocity));
  });
  u_ = end_;
  velocity_ = flow_(u_);
  at_level_ = true;
  return true;
}

bool Tracer::is_at_saddle() {
  for (const CriticalId id : lines_.within(cell_)) {
    const CriticalPoint& p = lines_.points_[id.index()];
    if (p.index != 1 || id == origin_) continue;
    const Vector d = centre_ + flow_.to_space(end_) - p.point.position;
    if (d.norm() < lines_.merge_distance(p.point.length_scale)) course_.saddle = id;
  }
  return course_.saddle.has_value();
}

bool Tracer::capture(double time) {
  for (const CriticalId id : lines_.within(cell_)) {
    const CaptureDisc& disc = lines_.discs_[id.index()];
    if (lines_.points_[id.index()].index != (way_ == Way::Up ? 2 : 0) ||
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
