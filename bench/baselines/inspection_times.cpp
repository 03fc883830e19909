#include "bench/baselines/inspection_times.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morskin::baselines {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A rate found from the velocities now is raised by a quarter and by this share of its bound: over
/// the wait rho^2 changes, and the rates with it.
constexpr double raised = 1.25, share_of_bound = 0.15;

/// How long until something changes by `margin`, in the logarithm, at a rate.
/// @param bound  of the rate
double likely_wait(double margin, double rate, double bound) {
  return margin / std::min(raised * std::max(rate, 0.0) + share_of_bound * bound, bound);
}

}  // namespace

double next_inspection_time(const std::array<MovingCorner, 3>& corners, const Ratios& ratios,
                            const Slack& slack, double now) {
  std::array<double, 3> rho_rate;  // d ln rho / dt = g / (4 rho^4)
  std::array<Vector, 3> velocity;
  double rho = never, leaves = never, min_rho_rate = never;
  for (std::size_t k = 0; k < 3; ++k) {
    const double r = corners[k].point.length_scale;
    rho_rate[k] = corners[k].level / (4 * r * r * r * r);
    velocity[k] = corners[k].point.normal / (4 * r);
    rho = std::min(rho, r);
    leaves = std::min(leaves, corners[k].leaves);
    min_rho_rate = std::min(min_rho_rate, rho_rate[k]);
  }
  // A lower bound: a triangle that could not be mended would be inspected for ever.
  constexpr double min_margin = 0.05;
  // |d ln |ab| / dt| and |d ln rho / dt| are at most 1 / (4 rho^2) each.
  const double bound = 1 / (2 * rho * rho);

  std::array<Vector, 3> side;  // from corner k to k + 1
  std::array<double, 3> rate;  // of its length, d ln |ab| / dt
  double likely = never, margin_L = never;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    side[k] = corners[next].point.position - corners[k].point.position;
    rate[k] = side[k].dot(velocity[next] - velocity[k]) / side[k].squaredNorm();
    const double margin = std::max(std::log(ratios.L[k] / slack.min_L), min_margin);
    const double shrinks = std::max(rho_rate[k], rho_rate[next]) - rate[k];
    likely = std::min(likely, likely_wait(margin, shrinks, bound));
    margin_L = std::min(margin_L, margin);
  }
  // d ln R = sum over the sides of d ln l times the product of the cotangents at its ends.
  const double area2 = side[0].cross(side[1]).norm();
  double S = 0, R_rate = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector &a = side[k], &b = side[(k + 1) % 3], &c = side[(k + 2) % 3];
    const double cotangents = a.dot(b) * a.dot(c) / (area2 * area2);
    S += std::abs(cotangents);
    R_rate += rate[k] * cotangents;
  }
  const double margin_U = std::max(std::log(slack.max_U / ratios.U), min_margin);
  const double bound_U = (S + 1) / (4 * rho * rho);
  likely = std::min(likely, likely_wait(margin_U, R_rate - min_rho_rate, bound_U));

  // The squared length scale falls by at most dt / 2: integrated, the margin to [L] is used up
  // after 2 rho^2 (1 - exp(-margin)). For [U] half of the time is taken, as S changes as well.
  const double safe = std::min(2 * rho * rho * (1 - std::exp(-margin_L)), margin_U / (2 * bound_U));
  return now + std::max({safe, std::min(likely, leaves - now), min_wait * rho * rho});
}

}  // namespace morskin::baselines
