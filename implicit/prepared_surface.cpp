#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/error.h"
#include "geometry/files/text_lines.h"
#include "implicit/implicit_surface.h"

namespace morskin::implicit {

namespace {

/// Of the cubes that are tried, unless a molecule's is larger.
constexpr double largest_half = 0x1p12;

/// A levelling, the room in which the Hessian is bounded, and the bound.
struct BoundedRoom {
  Levelling levelling;
  Room room;
  double M;
};

/// Whether the surface seems to meet a box, or one of a cover. Where bounds over a box are wide, it
/// may be in the cover although f is far from zero in it.
bool seems_met(const Function& f, const Box& box) {
  const Function::Value at = f.at(box.centre);
  return std::abs(at.value) <= box.half * at.gradient.norm();
}
bool seems_met(const Function& f, const Cover& cover) {
  return std::ranges::any_of(cover.boxes, [&](const CoverBox& b) { return seems_met(f, b.box); });
}

/// The largest norm of the Hessian at some points of the room, along normals of the surface. A
/// search that cannot succeed is mostly known by it.
double sampled_norm(const Function& f, const Levelling& levelling, const Cover& cover, double M) {
  constexpr std::size_t most_samples = 1000;
  const std::size_t stride = cover.boxes.size() / most_samples + 1;
  double most = 0;
  for (std::size_t i = 0; i < cover.boxes.size(); i += stride) {
    const Point& x = cover.boxes[i].box.centre;
    const Vector N = f.at(x).gradient / M;
    for (const double along : {-Room::reach, -1.5, 0.0, 0.75, 1.5, Room::reach}) {
      most = std::max(most, hessian_norm(f, levelling, x + along * N));
    }
  }
  return most;
}

/// A room for the length scale that M gives, where M bounds the Hessian in it, with or without
/// levelling. @param gradient  the largest on the surface, nearly
std::optional<BoundedRoom> room_for(const Function& f, const Cover& cover, double gradient,
                                    double M, const geometry::Run& run) {
  Room room(cover, M);
  // The levelling takes rate |grad f|^2 off the second derivative across the surface: more than M
  // makes no sense.
  for (const double share : {0.75, 0.0}) {
    const Levelling levelling{share * M / (gradient * gradient)};
    constexpr double margin = 1.2;  // with less there would be too many boxes
    if (!(margin * sampled_norm(f, levelling, cover, M) <= M)) continue;
    if (is_hessian_bounded(f, levelling, room, M, run)) {
      return BoundedRoom{levelling, std::move(room), M};
    }
  }
  return std::nullopt;
}

/// With the least M of a geometric sequence. The larger M, the smaller the length scale and with it
/// the room.
BoundedRoom best_room(const Function& f, const Cover& cover, const geometry::Run& run) {
  double least = 0, gradient = 0;  // by the middles of boxes that the surface seems to meet
  for (const CoverBox& b : cover.boxes) {
    if (!seems_met(f, b.box)) continue;
    const double norm = hessian_norm(f, {}, b.box.centre);
    if (std::isfinite(norm)) least = std::max(least, norm);
    gradient = std::max(gradient, f.at(b.box.centre).gradient.norm());
  }
  constexpr double step = 1.25, largest = 1e6;
  for (double M = step * least; M > 0 && M <= largest * least; M *= step) {
    if (auto found = room_for(f, cover, gradient, M, run)) return std::move(*found);
  }
  throw geometry::RefusedInput(
      "no bound on the function's second derivatives is found round the surface; write it without "
      "roots and quotients that vanish there");
}

/// Says why the last cube holds no surface.
/// @param found   in it
/// @param is_met  whether the surface seems to meet a box of it
[[noreturn]] void refuse(const std::optional<Cover>& found, bool is_met, double half) {
  const std::string where = "within " + geometry::in_digits(half, 6) + " of the centre ";
  const bool is_largest = half >= largest_half;
  if (found && found->boxes.empty()) {
    throw geometry::RefusedInput(where + "the function has no zero");
  }
  if (found && !is_met) {
    throw geometry::RefusedInput(where + "no zero of the function is found; choose another level");
  }
  if (found) {
    throw geometry::RefusedInput(where + "the surface has not room enough; " +
                                 (is_largest ? "scale it down" : "choose more with within="));
  }
  throw geometry::RefusedInput(
      where +
      "the surface is not closed, or the function is not above zero outside, or its bounds are too "
      "wide to tell; " +
      (is_largest ? "scale a larger surface down, or of a formula " : "") +
      "choose another space with within=, or its negative");
}

/// Off the axes, off the default and off each other.
std::vector<Vector> default_heights() {
  return {Vector(0.0231, 1, 0.0137), Vector(1, 0.0443, -0.0291), Vector(-0.0367, 0.0519, 1),
          Vector(0.5711, 0.6133, 0.5453)};
}

}  // namespace

PreparedSurface prepare_surface(std::shared_ptr<const Function> f, const SearchSpace& space,
                                const std::optional<Vector>& height, const geometry::Run& run) {
  Box cube = space.cube;
  std::optional<Cover> found;
  std::optional<BoundedRoom> bounded;
  std::size_t boxes = 0;  // of the body that it is about
  for (;; cube.half *= 2) {
    found = run.stage("cover", [&] { return cover(*f, cube, found, run); });
    if (!found) bounded.reset();  // the next cube keeps no boxes
    const bool is_met = found && seems_met(*f, *found);
    if (is_met) {
      // A larger cube keeps all boxes of the one before, and mostly adds none.
      const bool is_same_body = bounded && found->boxes.size() == boxes;
      if (!is_same_body) {
        bounded = run.stage("second derivatives", [&] { return best_room(*f, *found, run); });
        boxes = found->boxes.size();
      }
      if (cube.contains(bounded->room.cube())) break;
    }
    if (!space.is_fixed && cube.half < largest_half) continue;
    refuse(found, is_met, cube.half);
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
  return {ImplicitSurface(std::move(f), std::move(*found), bounded->levelling,
                          std::move(bounded->room), bounded->M),
          std::move(*critical), cube};
}

}  // namespace morskin::implicit
