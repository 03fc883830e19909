#pragma once

/// Guards that see less than everything, to show what Morse theory alone would do
/// (papers/3.1-morse-functions.md). Most of their sweeps fail.

#include <memory>

#include "front/guard_policy.h"
#include "morse/guide.h"

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
  NarrowGuard(const skin::SkinSurface& surface, const morse::Guide& guide, bool follows_polygon);
  void gather(Neighbourhood& guard, const SurfacePoint& centre, FrontEdgeId corner) const override;

 private:
  void gather_along(Neighbourhood& guard, const SurfacePoint& centre, FrontEdgeId corner) const;

  morse::ProtectingSpheres enlarged_;
  bool follows_polygon_;
};

/// The policy of a guard; nothing for the default.
std::unique_ptr<GuardPolicy> experimental_guard(Guard guard, const skin::SkinSurface& surface,
                                                const morse::Guide& guide);

}  // namespace morskin::front
