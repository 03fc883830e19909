#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "implicit/implicit_surface.h"

namespace morskin::implicit {

namespace {

/// A levelling, the ball in which the Hessian is bounded, and the bound.
struct Room {
  Levelling levelling;
  surface::BoundingBall ball;
  double M;
};

/// The ball goes beyond the body by three times the largest length scale. A bound in the body's
/// ball comes first: M is no smaller than that, and the length scale no larger.
Room room_about(const Function& f, const Cover& cover, const Levelling& levelling, double useless,
                const geometry::Run& run) {
  constexpr double length_scales = 3.01;
  Room result{levelling, cover.bounding_ball(), 0};
  const double first = hessian_bound(f, levelling, result.ball, useless, run);
  result.ball.radius += length_scales * cover.max_gradient() / first;
  // Rounding may leave the larger ball with the smaller bound.
  result.M = std::max(first, hessian_bound(f, levelling, result.ball, useless, run));
  return result;
}

/// With or without levelling, by M.
Room best_room(const Function& f, const Cover& cover, const geometry::Run& run) {
  Room best = room_about(f, cover, {}, Interval::infinity, run);
  if (!std::isfinite(best.M)) {
    throw geometry::RefusedInput(
        "no bound on the function's second derivatives is found round the surface; write it "
        "without roots and quotients that vanish there");
  }
  // The levelling takes rate |grad f|^2 off the second derivative across the surface: no more than
  // what is there makes sense.
  const double most = best.M / (cover.max_gradient() * cover.max_gradient());
  constexpr double share = 0.5;
  const Room other = room_about(f, cover, {share * most}, best.M, run);
  return other.M < best.M ? other : best;
}

/// Off the axes, off the default and off each other.
std::vector<Vector> default_heights() {
  return {Vector(0.0231, 1, 0.0137), Vector(1, 0.0443, -0.0291), Vector(-0.0367, 0.0519, 1),
          Vector(0.5711, 0.6133, 0.5453)};
}

bool contains(const Box& cube, const surface::BoundingBall& ball) {
  return (ball.centre - cube.centre).cwiseAbs().maxCoeff() + ball.radius < cube.half;
}

}  // namespace

PreparedSurface prepare_surface(std::shared_ptr<const Function> f, const SearchSpace& space,
                                const std::optional<Vector>& height, const geometry::Run& run) {
  constexpr double largest = 0x1p12;
  Box cube = space.cube;
  std::optional<Cover> found;
  std::optional<Room> room;
  double radius = 0;  // of the body that the room is about
  for (;; cube.half *= 2) {
    found = run.stage("cover", [&] { return cover(*f, cube, found, run); });
    if (found && !found->boxes.empty()) {
      // Cubes about one point have the same boxes, so that a larger one mostly finds the same body.
      const bool is_same_body = room && found->bounding_ball().radius == radius;
      if (!is_same_body) {
        room = run.stage("second derivatives", [&] { return best_room(*f, *found, run); });
        radius = found->bounding_ball().radius;
      }
      if (contains(cube, room->ball)) break;
    }
    if (!space.is_fixed && cube.half < largest) continue;
    const std::string where = "within " + std::to_string(static_cast<long>(cube.half));
    throw geometry::RefusedInput(
        !found ? where +
                     " of the centre the surface is not closed, or the function is not above "
                     "zero outside; choose another space with within=, or its negative"
        : found->boxes.empty() ? where + " of the centre the function has no zero"
                               : where + " of the centre the surface has not room enough; choose " +
                                     "more with within=");
  }
  const std::vector<Vector> heights = height ? std::vector{*height} : default_heights();
  std::optional<CriticalHeights> critical;
  for (const Vector& along : heights) {
    CriticalHeights next = run.stage("critical points", [&] {
      return critical_heights(*f, *found, LevelDirections::of(along), run);
    });
    const bool is_complete = next.is_complete();
    if (is_complete || !critical) critical = std::move(next);
    if (is_complete) break;
  }
  return {ImplicitSurface(std::move(f), std::move(*found), room->levelling, room->ball, room->M),
          std::move(*critical)};
}

}  // namespace morskin::implicit
