#include "morse/make_guide.h"

#include <utility>

#include "morse/overlaps.h"
#include "morse/skin_spheres.h"

namespace morskin::morse {

Guide make_guide(const skin::SkinSurface& skin, long euler_characteristic,
                 const std::optional<MorseFunction>& asked, double radius_share,
                 const geometry::Run& run, const Contraction& contract) {
  ChosenFunction chosen = run.stage(
      "critical points", [&] { return choose_function(skin, euler_characteristic, asked); });
  Guide guide;
  guide.function = chosen.function;
  for (const CriticalPoint& p : chosen.critical.points) {
    ++guide.found[static_cast<std::size_t>(p.index)];
  }
  guide.points = chosen.critical.points;
  // Only spheres of full size that overlap leave anything to contract.
  if (overlapping_spheres(guide.points, full_radii(guide.points, radius_share)).empty()) {
    guide.spheres = protecting_spheres(skin, guide.points, radius_share);
    return guide;
  }
  const MorseSmaleComplex complex = run.stage("integral lines", [&] {
    return morse_smale_complex(skin, chosen.function, chosen.critical, Polylines::Drop, run);
  });
  guide.is_simplified = complex.degeneracies.empty();
  if (!guide.is_simplified) {
    guide.spheres = protecting_spheres(skin, guide.points, radius_share);
    return guide;
  }
  const Simplification simple = contract(complex, radius_share);
  guide.points.clear();
  std::vector<double> radii;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (!simple.survives[i]) continue;
    guide.points.push_back(complex.points[i]);
    radii.push_back(simple.radius[i]);
  }
  guide.spheres = protecting_spheres(skin, guide.points, std::move(radii));
  return guide;
}

}  // namespace morskin::morse
