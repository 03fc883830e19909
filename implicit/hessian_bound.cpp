#include "implicit/hessian_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "geometry/parallel.h"

namespace morskin::implicit {

namespace {

/// The eigenvalues are off by a few units in the last place of the matrix.
constexpr double up = 1 + 1e-12;

struct Candidate {
  Box box;
  double bound;
};

/// Bounds the norm over a box. With H = A + R, A its middle and |R| <= r, and grad f = g + e,
/// |e| <= delta, the levelled f has the Hessian s (H - rate grad f grad f^T) outside, s <= 1 the
/// slope, so that its eigenvalues are no more than s (A's + r), and no less than s times those of
/// A - rate (1 + t) g g^T less r + rate (1 + 1/t) delta^2, for any t > 0.
double norm_over(const Function& f, const Levelling& levelling, const Box& box) {
  // Without levelling the second derivatives are all that counts.
  const Jet<Interval, 2> bounds = levelling.rate > 0 ? f.bounds(box) : f.over(box);
  Eigen::Matrix3d A;
  Vector g;
  double squared_r = 0, squared_delta = 0;
  for (int i = 0; i < 3; ++i) {
    const Interval& slope = bounds.gradient[static_cast<std::size_t>(i)];
    g[i] = slope.middle();
    squared_delta += slope.radius() * slope.radius();
    for (int j = 0; j < 3; ++j) {
      const Interval& h =
          bounds.hessian[symmetric_index[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]];
      if (!h.is_finite()) return std::numeric_limits<double>::infinity();
      A(i, j) = h.middle();
      squared_r += h.radius() * h.radius();
    }
  }
  const double r = up * std::sqrt(squared_r) + 1e-12 * A.norm();
  const double top = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A, Eigen::EigenvaluesOnly)
                         .eigenvalues()
                         .maxCoeff() +
                     r;
  double lost = 0;
  const double rate = bounds.value.high > 0 ? levelling.rate : 0;
  if (rate > 0) {
    const double delta = up * std::sqrt(squared_delta);
    if (!std::isfinite(delta)) return std::numeric_limits<double>::infinity();
    const double t = std::max(1e-3, delta / (g.norm() + delta));
    A -= rate * (1 + t) * up * g * g.transpose();
    lost = up * rate * (1 + 1 / t) * delta * delta + 1e-12 * A.norm();
  }
  const double bottom = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(A, Eigen::EigenvaluesOnly)
                            .eigenvalues()
                            .minCoeff() -
                        r - lost;
  const double least_value = std::max(0.0, bounds.value.low);
  const double scale = std::min(1.0, up * std::exp(-levelling.rate * least_value));
  return up * scale * std::max(top, -bottom);
}

bool meets(const Box& box, const surface::BoundingBall& ball) {
  const Vector off = (box.centre - ball.centre).cwiseAbs() - Vector::Constant(box.half);
  return off.cwiseMax(0).norm() <= ball.radius * up;
}

}  // namespace

double hessian_bound(const Function& f, const Levelling& levelling,
                     const surface::BoundingBall& ball, double useless, const geometry::Run& run) {
  constexpr double good_enough = 1.2;
  constexpr std::size_t max_rounds = 40, per_round = 64;
  std::vector<Candidate> heap{{{ball.centre, ball.radius * up}, Interval::infinity}};
  double reached = 0;  // by some point
  for (std::size_t round = 0; round < max_rounds && reached < useless; ++round) {
    // Always so many at once, so that the answer does not depend on the number of threads.
    std::vector<Box> boxes;
    while (!heap.empty() && boxes.size() < per_round &&
           heap.front().bound > good_enough * reached) {
      std::ranges::pop_heap(heap, {}, &Candidate::bound);
      for (int k = 0; k < 8; ++k) {
        const Box part = heap.back().box.octant(k);
        if (meets(part, ball)) boxes.push_back(part);
      }
      heap.pop_back();
    }
    if (boxes.empty()) break;
    constexpr std::size_t samples = 4;  // one centre in so many tells what is reached
    std::vector<double> bound(boxes.size()), at_centre(boxes.size(), 0);
    const auto bound_block = [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        bound[i] = norm_over(f, levelling, boxes[i]);
        if (i % samples == 0) at_centre[i] = norm_over(f, levelling, {boxes[i].centre, 0});
      }
    };
    geometry::for_each_block(run.threads(), boxes.size(), bound_block, 16);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (std::isfinite(at_centre[i]) && meets({boxes[i].centre, 0}, ball)) {
        reached = std::max(reached, at_centre[i]);
      }
      heap.push_back({boxes[i], bound[i]});
      std::ranges::push_heap(heap, {}, &Candidate::bound);
    }
  }
  double most = reached;
  for (const Candidate& c : heap) most = std::max(most, c.bound);
  return most;
}

}  // namespace morskin::implicit
