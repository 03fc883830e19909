#include "bench/ablation/contraction_by_distance.h"

#include <limits>
#include <optional>
#include <vector>

#include "morse/overlaps.h"
#include "morse/quadrangles.h"

namespace morskin::ablation {

namespace {

using morse::CriticalId;

/// The shortest arc that may be contracted, or nothing.
std::optional<morse::Arc> shortest_arc(const morse::MorseSmaleComplex& complex,
                                       const morse::Quadrangles& quadrangles,
                                       const std::vector<double>& radii) {
  std::optional<morse::Arc> shortest;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < complex.arcs.size(); i += 4) {
    const CriticalId saddle = complex.arcs[i].saddle;
    if (!quadrangles.survives(saddle)) continue;
    for (const CriticalId extremum : quadrangles.ends(saddle)) {
      const double distance = (complex.points[saddle.index()].point.position -
                               complex.points[extremum.index()].point.position)
                                  .norm();
      const bool is_noise = distance < radii[saddle.index()] + radii[extremum.index()];
      if (is_noise && distance < least && quadrangles.other_end(saddle, extremum)) {
        least = distance;
        shortest = {saddle, extremum};
      }
    }
  }
  return shortest;
}

}  // namespace

morse::Simplification contract_by_distance(const morse::MorseSmaleComplex& complex,
                                           double radius_share) {
  morse::Quadrangles quadrangles(complex);
  std::vector<double> radii = morse::full_radii(complex.points, radius_share);
  while (const auto arc = shortest_arc(complex, quadrangles, radii)) {
    quadrangles.cancel(arc->saddle, arc->extremum);
  }
  morse::Simplification result;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    result.survives.push_back(quadrangles.survives(CriticalId{i}));
    if (!result.survives[i]) radii[i] = 0;
  }
  const auto left = morse::overlapping_spheres(complex.points, radii);
  result.overlaps_left = left.size();
  result.radius = morse::shrunk_apart(complex.points, radii, left);
  result.complex = quadrangles.remaining();
  return result;
}

}  // namespace morskin::ablation
