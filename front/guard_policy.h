#pragma once

#include "front/neighbourhood.h"

namespace morskin::front {

/// What the guard sees about a departure vertex: everything within its radius. Experiments see less
/// (front/experimental_guards.h).
class GuardPolicy {
 public:
  virtual ~GuardPolicy() = default;
  /// @param corner  of the departure vertex, a point of the surface
  virtual void gather(Neighbourhood& guard, const SurfacePoint& centre, FrontEdgeId corner) const {
    static_cast<void>(corner);
    guard.gather(centre);
  }
};

inline const GuardPolicy see_everything{};

}  // namespace morskin::front
