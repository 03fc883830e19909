#pragma once

/// The gradient flow of a Morse function within one patch of the skin (sections 3.1, 3.2), in
/// coordinates u = x - centre, so that small patches far from the origin lose no digits.
///
/// With W(u) the gradient of f in space, linear in u, and N = M u normal to the patch,
///
///     u' = W - (W . N / |u|^2) N,
///
/// which is analytic on the patch and vanishes at the critical points only.
/// Erratum: papers/README.md, E2.

#include "morse/morse_function.h"
#include "skin/patch.h"

namespace morskin::morse {

/// Which way a line runs.
enum class Way { Down, Up };

class GradientFlow {
 public:
  GradientFlow(const skin::Patch& patch, const MorseFunction& f, Way way)
      : axis_(patch.axis),
        sign_(patch.sign),
        gradient_(f.gradient(patch.centre)),
        linear_(2 * f.curvature),
        way_(way == Way::Up ? 1 : -1) {}

  /// N, half the gradient of the patch's G.
  Vector normal(const Vector& u) const { return sign_ * (u - (2 * axis_.dot(u)) * axis_); }
  /// W, the gradient of f in space.
  Vector gradient(const Vector& u) const { return gradient_ + linear_ * u; }
  /// u', the velocity of the line. @pre u lies on the patch.
  Vector operator()(const Vector& u) const {
    const Vector n = normal(u), w = gradient(u);
    return way_ * (w - (w.dot(n) / u.squaredNorm()) * n);
  }
  /// How fast the velocity can change, 1 over the time unit of u': the derivative of u' is a small
  /// multiple of it at most.
  double rate(const Vector& u) const { return std::abs(linear_) + gradient(u).norm() / u.norm(); }
  /// f(u) - f(centre).
  double value(const Vector& u) const { return gradient_.dot(u) + linear_ / 2 * u.squaredNorm(); }

 private:
  Vector axis_;
  double sign_;
  Vector gradient_;
  double linear_, way_;
};

/// One step of length `time` from u along the flow, by the explicit Runge-Kutta method of order 8
/// with 11 stages. The error of a step is of order 9 in time * rate.
///
/// @param velocity  flow(u)
/// Source: Cooper and Verner, SIAM Journal on Numerical Analysis 9 (1972).
Vector runge_kutta_step(const GradientFlow& flow, const Vector& u, const Vector& velocity,
                        double time);

}  // namespace morskin::morse
