#include "front/sweep_plan.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "geometry/orthogonal.h"

namespace morskin::front {

namespace {

/// Shares the minima out, from the leaves up to the root.
class Planner {
 public:
  Planner(const Dissection& dissection, const TangentDisk& disk)
      : parts(dissection.size()), dissection_(dissection), disk_(disk) {
    for (std::size_t k = 0; k < parts.size(); ++k) parts[k].region.box = dissection[k];
  }

  /// @param minima  from the lowest up
  void share_out(std::vector<SurfacePoint> minima) {
    for (std::size_t first = dissection_.first_leaf();; first /= 2) {
      minima = share_out(first, minima);
      if (first == 0) return;
    }
  }

  std::vector<SweepPart> parts;

 private:
  /// Gives the boxes of one level the minima that they have room for.
  /// @param first  box of the level
  /// @return the others, whose surroundings stay bare, and with them those that lie there
  std::vector<SurfacePoint> share_out(std::size_t first, const std::vector<SurfacePoint>& minima) {
    std::vector<std::vector<std::size_t>> in_box(first + 1);
    std::vector<char> is_left(minima.size(), 0);
    std::vector<std::size_t> to_keep_bare;
    const auto leave = [&](std::size_t i) {
      if (!std::exchange(is_left[i], 1)) to_keep_bare.push_back(i);
    };
    for (std::size_t i = 0; i < minima.size(); ++i) {
      const std::size_t k = dissection_.box_of(minima[i].position, first);
      in_box[k - first].push_back(i);
      if (!has_room(k, minima[i])) leave(i);
    }
    while (!to_keep_bare.empty()) {
      const SurfacePoint& p = minima[to_keep_bare.back()];
      to_keep_bare.pop_back();
      const double gap = disk_.spacing().bowl_gap * disk_.radius(p.length_scale);
      const SweepRegion::Ball ball{p.position, gap};
      dissection_.for_each_that_meets(ball.centre, ball.radius, first, [&](std::size_t k) {
        parts[k].region.kept_bare.push_back(ball);
        for (const std::size_t i : in_box[k - first]) {
          if (!has_room(k, minima[i])) leave(i);
        }
      });
    }
    std::vector<SurfacePoint> left;
    for (std::size_t i = 0; i < minima.size(); ++i) {
      const std::size_t k = dissection_.box_of(minima[i].position, first);
      (is_left[i] ? left : parts[k].minima).push_back(minima[i]);
    }
    return left;
  }
  bool has_room(std::size_t k, const SurfacePoint& p) const {
    return parts[k].region.contains(p.position, disk_.working_radius(p));
  }
  const Dissection& dissection_;
  const TangentDisk& disk_;
};

/// The last place with room on the way down from a point, in steps of a disk's radius. Nothing if
/// the way does not leave the region, and so ends at a minimum.
std::optional<SurfacePoint> lowest_place(SurfacePoint x, const SweepRegion& region,
                                         const morse::MorseFunction& function,
                                         const TangentDisk& disk) {
  const auto has_room = [&](const SurfacePoint& p) {
    return region.contains(p.position, disk.working_radius(p));
  };
  if (!has_room(x)) return std::nullopt;
  for (;;) {
    const Vector up = geometry::unit_orthogonal_part(function.gradient(x.position), x.normal);
    const auto next = disk.rim_point(x, -up);
    if (!next || function(next->position) >= function(x.position)) return std::nullopt;
    if (!has_room(*next)) return x;
    x = *next;
  }
}

}  // namespace

std::vector<SurfacePoint> minima_of(const morse::Guide& guide) {
  std::vector<const morse::CriticalPoint*> minima;
  for (const morse::CriticalPoint& p : guide.points) {
    if (p.index == 0) minima.push_back(&p);
  }
  std::ranges::stable_sort(minima, {}, &morse::CriticalPoint::value);
  std::vector<SurfacePoint> result;
  for (const morse::CriticalPoint* p : minima) result.push_back(p->point);
  return result;
}

std::vector<SweepPart> sweep_plan(const Dissection& dissection, const morse::Guide& guide,
                                  const surface::Samples& samples, const TangentDisk& disk) {
  Planner planner(dissection, disk);
  planner.share_out(minima_of(guide));
  for (const SurfacePoint& x : samples.points) {
    planner.parts[dissection.box_of(x.position, dissection.first_leaf())].samples.push_back(x);
  }
  return std::move(planner.parts);
}

std::vector<SurfacePoint> bowls_of(const SweepPart& part, const morse::MorseFunction& function,
                                   const TangentDisk& disk) {
  std::vector<SurfacePoint> bowls = part.minima;
  for (const SurfacePoint& x : part.samples) {
    if (const auto lowest = lowest_place(x, part.region, function, disk)) bowls.push_back(*lowest);
  }
  return bowls;
}

}  // namespace morskin::front
