#include "implicit/cover.h"

#include <Eigen/LU>
#include <string>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "geometry/parallel.h"
#include "implicit/linear_algebra.h"

namespace morskin::implicit {

namespace {

/// Boxes are halved so often; one this small that does not tell is next to a singular point.
constexpr int max_depth = 22;
/// Of one level. A smooth surface needs a few for each square of its radius of curvature.
constexpr std::size_t max_boxes = 1'000'000;
/// A settled box at the cube's boundary that has a smaller share of the cube's side is taken for a
/// zero there. Bounds over larger ones are wide, so these are halved.
constexpr double least_share_at_boundary = 1.0 / 64;

/// A box's place in the cover: none, settled, or to be halved.
enum class Place { Empty, Settled, Open };

/// Settles a box where the gradient's length and direction are known within a factor.
Place place(const Function& f, const Box& box, CoverBox& settled) {
  const Jet<Interval, 2> bounds = f.bounds(box);
  if (!bounds.value.contains(0)) return Place::Empty;
  const double least = min_norm(bounds.gradient), most = max_norm(bounds.gradient);
  constexpr double max_ratio = 2;
  if (!(least > 0 && most < max_ratio * least)) return Place::Open;
  int axis = 0;
  double part = 0;
  for (int k = 0; k < 3; ++k) {
    const double along = bounds.gradient[static_cast<std::size_t>(k)].min_abs();
    if (along > part) {
      part = along;
      axis = k;
    }
  }
  const double slant = Interval::up(most / part);
  constexpr double max_slant = 4;  // sqrt 3 on a small enough box
  if (!(slant < max_slant)) return Place::Open;
  // Halving excludes most of a large box that the zero set meets near a corner only, or not at all.
  constexpr double small_ratio = 1.2;
  const double distance = f.enclose(box.centre).value.min_abs() / most;
  if (distance > box.half && most > small_ratio * least) return Place::Open;
  settled = {box, least, most, axis, slant};
  return Place::Settled;
}

/// The critical point of f near a box that Newton's iteration finds from its centre, if it finds
/// one, for the words of a refusal.
std::optional<Point> nearby_critical_point(const Function& f, const Box& box) {
  Point x = box.centre;
  double last_step = 0;
  for (int step = 0; step < 30; ++step) {
    const Jet<Interval, 2> bounds = f.bounds({x, 0});
    Eigen::Matrix3d hessian;
    Vector gradient;
    for (std::size_t i = 0; i < 3; ++i) {
      gradient[static_cast<int>(i)] = bounds.gradient[i].middle();
      for (std::size_t j = 0; j < 3; ++j) {
        hessian(static_cast<int>(i), static_cast<int>(j)) =
            bounds.hessian[symmetric_index[i][j]].middle();
      }
    }
    const Vector move = hessian.fullPivLu().solve(gradient);
    if (!move.allFinite()) return std::nullopt;
    x -= move;
    last_step = move.norm();
  }
  constexpr double far = 64, converged = 0x1p-10;  // over the box's radius
  const bool is_found =
      last_step <= converged * box.radius() && (x - box.centre).norm() < far * box.radius();
  return is_found ? std::optional(x) : std::nullopt;
}

/// @param is_tiny  the box, which is next to a singular point then; else the boxes became too many
[[noreturn]] void refuse(const Function& f, const Box& box, bool is_tiny) {
  const Interval bounds = f.bounds(box).value;
  if (!bounds.is_finite()) {
    throw geometry::RefusedInput("near " + geometry::in_words(box.centre) +
                                 " the function or its derivatives have no bounds; write it "
                                 "without roots and quotients that vanish there");
  }
  const std::optional<Point> critical = nearby_critical_point(f, box);
  const Point at = critical.value_or(box.centre);
  if (!is_tiny && (!critical || std::abs(f.at(at).value) > bounds.width() / 4)) {
    throw geometry::RefusedInput("near " + geometry::in_words(box.centre) +
                                 " the bounds of the function are too wide to tell its zeros; "
                                 "write it less steep, or with each variable fewer times");
  }
  const std::string value = geometry::in_digits(f.at(at).value, 9);
  throw SingularLevel("the surface is singular, or nearly so, at " + geometry::in_words(at) +
                          ", where the function has the critical value " + value +
                          ", next to the level 0; choose another level, or scale a tiny surface up",
                      at, f.at(at).value);
}

/// What is left of some boxes.
struct Sorted {
  std::vector<CoverBox> settled;
  std::vector<Box> open;
};

Sorted sort(const Function& f, const std::vector<Box>& boxes, const geometry::Run& run) {
  std::vector<Sorted> parts(geometry::block_count(boxes.size()));
  geometry::for_each_block(run.threads(), boxes.size(), [&](auto begin, auto end, auto block) {
    for (std::size_t i = begin; i < end; ++i) {
      CoverBox settled;
      const Place where = place(f, boxes[i], settled);
      if (where == Place::Settled) parts[block].settled.push_back(settled);
      if (where == Place::Open) parts[block].open.push_back(boxes[i]);
    }
  });
  Sorted whole;
  for (Sorted& part : parts) {
    whole.settled.insert(whole.settled.end(), part.settled.begin(), part.settled.end());
    whole.open.insert(whole.open.end(), part.open.begin(), part.open.end());
  }
  return whole;
}

/// Whether a box touches the cube's boundary.
bool is_outermost(const Box& box, const Box& cube) {
  return (box.centre - cube.centre).cwiseAbs().maxCoeff() + box.half >= cube.half;
}

/// Whether f is below zero at one of some points of the cube's boundary, which saves a long search.
bool is_crossed(const Function& f, const Box& cube) {
  constexpr int points = 16;  // along each edge
  for (int axis = 0; axis < 3; ++axis) {
    for (int k = 0; k < 2 * points * points; ++k) {
      Vector off;
      off[axis] = k % 2 == 0 ? -1 : 1;
      off[(axis + 1) % 3] = (k / 2 % points + 0.5) * 2 / points - 1;
      off[(axis + 2) % 3] = (k / 2 / points + 0.5) * 2 / points - 1;
      if (!(f.at(cube.centre + cube.half * off).value > 0)) return true;
    }
  }
  return false;
}

}  // namespace

double Cover::max_gradient() const {
  double most = 0;
  for (const CoverBox& b : boxes) most = std::max(most, b.max_gradient);
  return most;
}

surface::BoundingBall Cover::bounding_ball() const {
  if (boxes.empty()) return {Point::Zero(), 0};
  Point low = boxes.front().box.centre, high = low;
  for (const CoverBox& b : boxes) {
    low = low.cwiseMin(b.box.centre);
    high = high.cwiseMax(b.box.centre);
  }
  surface::BoundingBall ball{(low + high) / 2, 0};
  for (const CoverBox& b : boxes) {
    const double far = (b.box.centre - ball.centre).norm() + b.box.radius();
    ball.radius = std::max(ball.radius, far * (1 + 0x1p-40));
  }
  return ball;
}

std::optional<Cover> cover(const Function& f, const Box& cube, const std::optional<Cover>& inner,
                           const geometry::Run& run) {
  if (is_crossed(f, cube)) return std::nullopt;
  Cover result = inner.value_or(Cover());
  const auto is_covered = [&](const Box& b) {
    return inner && (b.centre - cube.centre).cwiseAbs().maxCoeff() + b.half <= cube.half / 2;
  };
  std::vector<Box> boxes{cube};
  for (int depth = 0; !boxes.empty(); ++depth) {
    Sorted sorted = sort(f, boxes, run);
    for (const CoverBox& b : sorted.settled) {
      const bool is_at_boundary = is_outermost(b.box, cube);
      if (is_at_boundary && b.box.half < least_share_at_boundary * cube.half) return std::nullopt;
      if (is_at_boundary) {
        sorted.open.push_back(b.box);
      } else {
        result.boxes.push_back(b);
      }
    }
    if (sorted.open.empty()) break;
    if (depth == max_depth || 8 * sorted.open.size() > max_boxes) {
      for (const Box& b : sorted.open) {
        if (is_outermost(b, cube)) return std::nullopt;
      }
      refuse(f, sorted.open.front(), depth == max_depth);
    }
    boxes.clear();
    for (const Box& b : sorted.open) {
      for (int k = 0; k < 8; ++k) {
        if (!is_covered(b.octant(k))) boxes.push_back(b.octant(k));
      }
    }
  }
  // Without a zero on the boundary f has one sign there.
  const Point corner = cube.centre + Vector::Constant(cube.half);
  if (!f.enclose(corner).value.is_positive()) return std::nullopt;
  return result;
}

}  // namespace morskin::implicit
