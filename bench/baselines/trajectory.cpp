#include "bench/baselines/trajectory.h"

#include <cmath>
#include <limits>

namespace morskin::baselines {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// The stretch E at which E a + b / E - d, negative inside a wall, next turns positive: the root of
/// a E^2 - d E + b where the slope is positive, in the form that does not cancel.
/// @param tolerance  the rounding of d
double crossing(double a, double b, double d, double tolerance) {
  const double discriminant = d * d - 4 * a * b;
  if (!(discriminant >= 0)) return never;
  const double root = std::sqrt(discriminant);
  const double stretch = d >= 0 ? (d + root) / (2 * a) : 2 * b / (d - root);
  if (!(stretch > 0)) return never;
  if (stretch >= 1) return stretch;
  // Passed already: at the wall but for rounding and on the way out, or in again.
  return a + b > d - tolerance && a > b ? 1 : never;
}

}  // namespace

Trajectory::Trajectory(const SkinSurface& skin, const Point& x, CellId cell, double time)
    : cell_(cell), beyond_(cell), begins_(time) {
  const Patch& patch = skin.patch(cell);
  const Vector u = x - patch.centre;
  const Vector axial = u.dot(patch.axis) * patch.axis;
  across_ = patch.sign > 0 ? Vector(u - axial) : axial;
  along_ = patch.sign > 0 ? axial : Vector(u - axial);
  across_squared_ = across_.squaredNorm();
  along_squared_ = along_.squaredNorm();
  find_exit(skin);
}

double Trajectory::stretch(double g) const {
  const double root = std::sqrt(g * g + 4 * across_squared_ * along_squared_);
  return std::sqrt(g >= 0 ? (g + root) / (2 * across_squared_) : 2 * along_squared_ / (root - g));
}

void Trajectory::find_exit(const SkinSurface& skin) {
  const Patch& patch = skin.patch(cell_);
  exit_stretch_ = never;
  for (const skin::Wall& wall : skin.complex().walls(cell_)) {
    const double e =
        crossing(wall.normal.dot(across_), wall.normal.dot(along_),
                 wall.offset - wall.normal.dot(patch.centre), skin.complex().wall_tolerance());
    if (e < exit_stretch_) {
      exit_stretch_ = e;
      beyond_ = wall.beyond;
    }
  }
  const double e2 = exit_stretch_ * exit_stretch_;
  leaves_ =
      exit_stretch_ == never
          ? never
          : std::max(begins_, 2 * (e2 * across_squared_ - along_squared_ / e2 - patch.half_weight));
}

SurfacePoint Trajectory::at(const SkinSurface& skin, double t) const {
  const Patch& patch = skin.patch(cell_);
  const double e = stretch(patch.half_weight + t / 2);
  const Vector across = e * across_, along = along_ / e;
  const Vector n = across - along;
  const double rho = n.norm();
  return {patch.centre + across + along, n / rho, rho, cell_};
}

Trajectory Trajectory::followed_to(const SkinSurface& skin, double t) const {
  Trajectory part = *this;
  // At one moment a path passes a few cells that meet; so many mean that it cycles in cells flatter
  // than rounding.
  constexpr int max_at_once = 20;
  // Then the point is put where it ought to be and stays in that cell for this share of rho^2: it
  // comes at most 1/400 rho beyond a wall, which changes G by less than 10^-5 rho^2, and the next
  // part begins on the skin again.
  constexpr double rest = 0.01;
  int at_once = 0;
  while (part.leaves_ <= t) {
    const Point x = skin.patch(part.cell_).centre + part.exit_stretch_ * part.across_ +
                    part.along_ / part.exit_stretch_;
    const double now = part.leaves_;
    at_once = part.leaves_ > part.begins_ ? 0 : at_once + 1;
    part = Trajectory(skin, x, part.beyond_, now);
    if (at_once < max_at_once) continue;
    const auto end = LevelSet(skin, now).project(x, part.cell_);
    if (end) part = Trajectory(skin, end->position, end->cell, now);
    const double rho = skin.patch(part.cell_).length_scale(x);
    part.leaves_ = std::max(part.leaves_, now + rest * rho * rho);
    part.exit_stretch_ = part.stretch(skin.patch(part.cell_).half_weight + part.leaves_ / 2);
    part.beyond_ = skin.locate(part.at(skin, part.leaves_).position, part.cell_);
    at_once = 0;
  }
  return part;
}

}  // namespace morskin::baselines
