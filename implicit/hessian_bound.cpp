#include "implicit/hessian_bound.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/parallel.h"

namespace morskin::implicit {

namespace {

/// The eigenvalues are off by a few units in the last place of the matrix.
constexpr double up = 1 + 1e-12;

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

/// A box with the balls of the room that it meets.
struct Part {
  Box box;
  Room::Ids balls;
};

/// A cube about another that is halved without rounding, so that its parts leave no gaps.
Box dyadic_cube_about(const Box& cube) {
  const double half = std::exp2(std::ceil(std::log2(1.125 * cube.half)));
  const double grid = half / 16;
  return {cube.centre.unaryExpr([&](double x) { return std::round(x / grid) * grid; }), half};
}

/// The parts of a box that is to be halved which meet the room.
std::vector<Part> octants(const Part& whole, const Room& room) {
  std::vector<Part> result;
  for (int k = 0; k < 8; ++k) {
    Part part{whole.box.octant(k), {}};
    part.balls = room.meeting(part.box, whole.balls);
    if (!part.balls.empty()) result.push_back(std::move(part));
  }
  return result;
}

}  // namespace

double hessian_norm(const Function& f, const Levelling& levelling, const Point& x) {
  return norm_over(f, levelling, {x, 0});
}

bool is_hessian_bounded(const Function& f, const Levelling& levelling, const Room& room, double M,
                        const geometry::Run& run) {
  // The more balls, the larger the room.
  const std::size_t max_parts = 100'000 + 5 * room.all().size();
  std::size_t count = 0;
  constexpr std::size_t block_size = 16;
  std::vector<Part> parts{{dyadic_cube_about(room.cube()), room.all()}};
  while (!parts.empty()) {
    const std::size_t blocks = geometry::block_count(parts.size(), block_size);
    std::vector<std::vector<Part>> open(blocks);
    std::vector<char> is_exceeded(blocks, 0);
    const auto bound_block = [&](std::size_t begin, std::size_t end, std::size_t block) {
      for (std::size_t i = begin; i < end && !is_exceeded[block]; ++i) {
        if (norm_over(f, levelling, parts[i].box) <= M) continue;
        const Point& middle = parts[i].box.centre;
        is_exceeded[block] = !(hessian_norm(f, levelling, middle) <= M) && room.contains(middle, 0);
        std::vector<Part> halves = octants(parts[i], room);
        std::ranges::move(halves, std::back_inserter(open[block]));
      }
    };
    geometry::for_each_block(run.threads(), parts.size(), bound_block, block_size);
    if (std::ranges::find(is_exceeded, 1) != is_exceeded.end()) return false;
    parts.clear();
    for (std::vector<Part>& some : open) std::ranges::move(some, std::back_inserter(parts));
    count += parts.size();
    if (count > max_parts) return false;
  }
  return true;
}

}  // namespace morskin::implicit
