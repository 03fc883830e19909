#pragma once

/// Guards that see less than everything, to show what Morse theory alone would do
/// (papers/3.1-morse-functions.md). Most of their sweeps fail.

#include "front/guard_policy.h"
#include "morse/protecting_spheres.h"

namespace morskin::front {

/// Where the front looks for collisions. Only `Everywhere` is safe.
enum class Guard {
  Everywhere,
  Adjacent,  ///< along the front's own polygon, and everywhere within enlarged protecting spheres
  Spheres,   ///< within enlarged protecting spheres only
};

/// Sees everything within enlarged protecting spheres, and elsewhere only the front's own polygon.
class NarrowGuard : public GuardPolicy {
 public:
  /// @param follows_polygon  as far as the guard's radius; else to the neighbouring corners only
  /// @param enlarged  the guide's protecting spheres, enlarged
  NarrowGuard(morse::ProtectingSpheres enlarged, bool follows_polygon);
  void gather(Neighbourhood& guard, const SurfacePoint& centre, FrontEdgeId corner) const override;

 private:
  void gather_along(Neighbourhood& guard, const SurfacePoint& centre, FrontEdgeId corner) const;

  morse::ProtectingSpheres enlarged_;
  bool follows_polygon_;
};

}  // namespace morskin::front
