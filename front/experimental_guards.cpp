#include "front/experimental_guards.h"

#include <utility>

namespace morskin::front {

NarrowGuard::NarrowGuard(morse::ProtectingSpheres enlarged, bool follows_polygon)
    : enlarged_(std::move(enlarged)), follows_polygon_(follows_polygon) {}

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

}  // namespace morskin::front
