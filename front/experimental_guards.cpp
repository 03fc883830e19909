#include "front/experimental_guards.h"

#include <utility>
#include <vector>

namespace morskin::front {

namespace {

morse::ProtectingSpheres enlarged(const skin::SkinSurface& surface, const morse::Guide& guide) {
  constexpr double enlargement = 3;
  std::vector<double> radii;
  for (std::size_t c = 0; c < guide.points.size(); ++c) {
    radii.push_back(enlargement * guide.spheres.radius(morse::CriticalId{c}));
  }
  return {surface, guide.points, std::move(radii)};
}

}  // namespace

NarrowGuard::NarrowGuard(const skin::SkinSurface& surface, const morse::Guide& guide,
                         bool follows_polygon)
    : enlarged_(enlarged(surface, guide)), follows_polygon_(follows_polygon) {}

void NarrowGuard::gather(Neighbourhood& guard, const SurfacePoint& centre,
                         FrontEdgeId corner) const {
  if (enlarged_.containing(centre)) return guard.gather(centre);
  gather_along(guard, centre, corner);
}

/// Gathers a corner, the one before and the one after, and perhaps more both ways.
void NarrowGuard::gather_along(Neighbourhood& guard, const SurfacePoint& centre,
                               FrontEdgeId corner) const {
  guard.move_to(centre);
  guard.add(corner);
  const auto goes_on = [&](FrontEdgeId e) {
    return follows_polygon_ && e != corner && guard.is_within_radius(e);
  };
  const Front& front = guard.front();
  FrontEdgeId after = front[corner].next, before = front[corner].previous;
  for (guard.add(after); goes_on(after); guard.add(after)) after = front[after].next;
  for (guard.add(before); goes_on(before); guard.add(before)) before = front[before].previous;
}

std::unique_ptr<GuardPolicy> experimental_guard(Guard guard, const skin::SkinSurface& surface,
                                                const morse::Guide& guide) {
  if (guard == Guard::Everywhere) return nullptr;
  return std::make_unique<NarrowGuard>(surface, guide, guard == Guard::Adjacent);
}

}  // namespace morskin::front
