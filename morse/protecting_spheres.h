#pragma once

/// Protecting spheres about the critical points (sections 3.1, 4.1), where the front is expected to
/// change its topology.

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geometry/grouped.h"
#include "morse/critical_point.h"

namespace morskin::morse {

class ProtectingSpheres {
 public:
  /// A cell of the surface and a sphere that meets it.
  using Incidence = std::pair<surface::CellId, CriticalId>;

  ProtectingSpheres() = default;  ///< none
  /// @param radii       by point, Angstrom; where spheres overlap, the lowest id counts
  /// @param incidences  all of them, for cells below `cells`
  ProtectingSpheres(std::span<const CriticalPoint> points, std::vector<double> radii,
                    std::vector<Incidence> incidences, std::size_t cells);

  /// The sphere that contains a point of the surface, or nothing. O(1), by the list of spheres that
  /// meet the point's cell.
  std::optional<CriticalId> containing(const surface::SurfacePoint& p) const;

  double radius(CriticalId id) const { return radius_[id.index()]; }

 private:
  std::vector<Point> centres_;
  std::vector<double> radius_;
  geometry::Grouped<CriticalId> spheres_;  ///< by cell
};

/// By point, the radius of a sphere, Angstrom, such that no two overlap.
/// @param radius_share  over the length scale at the centre; a sphere shrinks to half the distance
///                      to the nearest other critical point. Erratum: papers/errata.md, E15.
std::vector<double> disjoint_radii(std::span<const CriticalPoint> points, double radius_share);

}  // namespace morskin::morse
