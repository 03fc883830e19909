#pragma once

/// When a triangle of the growing mesh must be inspected again (papers/5-dynamic.md).
///
/// Two times are found. The safe one follows from bounds that hold for all skins: the velocity is
/// an inversion of N, so |d ln |ab| / dt| <= 1 / (4 rho_a rho_b), and |d ln R / dt| <= S / (4
/// rho^2) with S the sum of |cot A cot B| over the pairs of angles. The likely one takes the
/// velocities that the corners have now, with a margin; it holds as long as they stay in their
/// cells, for across a wall the gradient of the velocity jumps. The later of the two is the answer.

#include <array>

#include "bench/baselines/moving_mesh.h"

namespace morskin::baselines {

/// What the safe and the likely time depend on.
struct MovingCorner {
  const SurfacePoint& point;
  double level;   ///< g = (w + t) / 2 of the quadric, Angstrom^2
  double leaves;  ///< when it leaves its cell
};

/// The ratios of a triangle to [L], for the edges from corner k to k + 1, and to [U].
struct Ratios {
  std::array<double, 3> L;
  double U;
};

/// How long the triangle keeps within `slack.min_L` and `slack.max_U`, at least min_wait
/// of the squared length scale.
double next_inspection_time(const std::array<MovingCorner, 3>& corners, const Ratios& ratios,
                            const Slack& slack, double now);

/// What could not be mended is inspected again after this share of the squared length scale. The
/// safe times of triangles that keep [L] and [U] are longer.
inline constexpr double min_wait = 0.02;

}  // namespace morskin::baselines
