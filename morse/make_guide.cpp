#include "morse/make_guide.h"

#include <utility>

#include "morse/overlaps.h"
#include "morse/skin_spheres.h"

namespace morskin::morse {

namespace {

/// Whether two protecting spheres of full size overlap: only then is there anything to contract.
bool has_overlap(const std::vector<CriticalPoint>& points, double radius_share) {
  std::vector<double> radii;
  for (const CriticalPoint& p : points) radii.push_back(radius_share * p.point.length_scale);
  return !overlapping_spheres(points, radii).empty();
}

}  // namespace

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
  if (!has_overlap(guide.points, radius_share)) {
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
