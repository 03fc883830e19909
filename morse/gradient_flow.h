#pragma once

/// The gradient flow of a Morse function f within one patch of the skin (sections 3.1, 3.2).
///
/// Points are u = (r, b, s) from the patch's centre, so that small patches far from the origin lose
/// no digits: s along the axis, r along the part of f's gradient at the centre that is orthogonal
/// to it, b along the third direction. With (V, 0, v) that gradient, c = 2 curvature and
/// k = sign w/2, the patch is r^2 + b^2 - e s^2 = k (e = 1 on a hyperboloid, -1 on a sphere, whose
/// axis is any one with v = 0), and the part of the gradient along the skin is
///
///     r' = (c - l) r + V,   b' = (c - l) b,   s' = (c + e l) s + v,
///     l  = (c k + V r - v s) / ((1 + e) s^2 + k),
///
/// the denominator being |u|^2. It is analytic and vanishes at the critical points only.
/// Erratum: papers/errata.md, E2.

#include <Eigen/Geometry>
#include <cmath>
#include <optional>

#include "geometry/orthogonal.h"
#include "morse/morse_function.h"
#include "skin/patch.h"

namespace morskin::morse {

/// Of an integral line: descending or ascending.
enum class Direction { Down, Up };

class GradientFlow {
 public:
  GradientFlow(const skin::Patch& patch, const MorseFunction& f, Direction direction)
      : linear_(2 * f.curvature),
        time_sign_(direction == Direction::Up ? 1 : -1),
        sign_(patch.sign),
        level_(patch.sign * patch.half_weight) {
    const Vector gradient = f.gradient(patch.centre);
    const bool is_sphere = patch.axis.squaredNorm() == 0;
    twist_ = is_sphere ? -1 : 1;
    axis_ = is_sphere ? gradient.unitOrthogonal() : patch.axis;
    along_ = is_sphere ? 0 : axis_.dot(gradient);
    across_ = (gradient - along_ * axis_).norm();
    radial_ = geometry::unit_orthogonal_part(gradient, axis_);
    third_ = axis_.cross(radial_);
  }

  Vector to_local(const Vector& v) const { return {radial_.dot(v), third_.dot(v), axis_.dot(v)}; }
  Vector to_space(const Vector& u) const {
    return u.x() * radial_ + u.y() * third_ + u.z() * axis_;
  }
  bool is_sphere() const { return twist_ < 0; }

  /// The velocity of the line. @pre u lies on the patch.
  Vector operator()(const Vector& u) const {
    // The sign goes into the constants, off the critical path of the steps.
    const double r = u.x(), b = u.y(), s = u.z();
    const double linear = time_sign_ * linear_, across = time_sign_ * across_,
                 along = time_sign_ * along_;
    const double l = (linear * level_ - along * s + across * r) / ((1 + twist_) * s * s + level_);
    const double shrink = linear - l;
    return {shrink * r + across, shrink * b, (linear + twist_ * l) * s + along};
  }
  /// The Jacobian of the velocity. @pre u lies on the patch.
  Eigen::Matrix3d derivative(const Vector& u) const {
    const double r = u.x(), s = u.z(), below = (1 + twist_) * s * s + level_;
    const double l = (linear_ * level_ + across_ * r - along_ * s) / below;
    const Vector of_l(across_ / below, 0, -(along_ + 2 * (1 + twist_) * l * s) / below);
    Eigen::Matrix3d result = Vector(-r, -u.y(), twist_ * s) * of_l.transpose();
    result.diagonal() += Vector(linear_ - l, linear_ - l, linear_ + twist_ * l);
    return time_sign_ * result;
  }
  /// The gradient of f in space.
  Vector gradient(const Vector& u) const { return linear_ * u + Vector(across_, 0, along_); }
  /// The velocity's derivative is at most a small multiple of this rate.
  double rate(const Vector& u, double gradient_norm) const {
    return std::abs(linear_) + gradient_norm / u.norm();
  }
  /// f(u) - f(centre).
  double value(const Vector& u) const {
    return across_ * u.x() + along_ * u.z() + linear_ / 2 * u.squaredNorm();
  }
  /// The patch's G.
  double off(const Vector& u) const {
    return sign_ * (u.x() * u.x() + u.y() * u.y() - twist_ * u.z() * u.z() - level_);
  }
  /// N, half the gradient of G.
  Vector normal(const Vector& u) const {
    return {sign_ * u.x(), sign_ * u.y(), -sign_ * twist_ * u.z()};
  }
  /// The point of the patch that u slides to along the normal, as Patch::slide.
  Vector settled(const Vector& u) const {
    const double round = u.x() * u.x() + u.y() * u.y(), axial = u.z() * u.z();
    const double quadratic = round - twist_ * axial, off = quadratic - level_;
    const double rho2 = round + axial;
    const double t = -off / (rho2 + std::sqrt(std::max(rho2 * rho2 - quadratic * off, 0.0)));
    return {u.x() * (1 + t), u.y() * (1 + t), u.z() * (1 - twist_ * t)};
  }

 private:
  double linear_, time_sign_, sign_, level_, twist_, across_, along_;
  Vector axis_, radial_, third_;
};

/// One step of length `time` from u along the flow, by the explicit Runge-Kutta method of order 8
/// with 11 stages. The error of a step is of order 9 in time * rate.
///
/// @param velocity  flow(u)
/// Source: Cooper and Verner, SIAM Journal on Numerical Analysis 9 (1972).
Vector runge_kutta_step(const GradientFlow& flow, const Vector& u, const Vector& velocity,
                        double time);

/// One step of length `time` by Radau's implicit method of order 5 with 3 stages, for lines that
/// creep along a slow curve: the flow's fast attraction to that curve does not bound its length.
///
/// @return nothing where Newton's method does not converge: a shorter step will.
/// Source: Hairer and Wanner, Solving Ordinary Differential Equations II, section IV.8.
std::optional<Vector> radau_step(const GradientFlow& flow, const Vector& u, const Vector& velocity,
                                 double time);

}  // namespace morskin::morse
