#include "front/tangent_disk.h"

#include <algorithm>
#include <cmath>

namespace morskin::front {

TangentDisk::TangentDisk(const surface::Surface& surface, const certify::Sizing& sizing,
                         const Spacing& spacing)
    : surface_(surface),
      sizing_(sizing),
      spacing_(spacing),
      share_(std::min(spacing.disk_share * sizing.tangent_disk_share(),
                      spacing.fan_share * std::sqrt(3) * sizing.C * sizing.Q)),
      wing_cosine_(std::cos(spacing_.wing_angle_deg * M_PI / 180)) {}

double TangentDisk::view_share() const {
  // Nearer than the length scale all skin is one sheet, a graph over the tangent plane: normals
  // differ by less than a right angle. This near they differ by less than asin(0.85) = 58 degrees.
  constexpr double largest_view = 0.85;
  return std::min(spacing_.view * share_, largest_view);
}

// [excerpt: disk]
double TangentDisk::radius(const SurfacePoint& centre, const Vector& direction) const {
  const double r = radius(centre.length_scale);
  if (!spacing_.is_by_both_ends) return r;
  const double far = surface_.length_scale(centre.position + r * direction, centre.cell);
  return radius(std::min(centre.length_scale, far));
}

std::optional<SurfacePoint> TangentDisk::rim_point(const SurfacePoint& centre,
                                                   const Vector& direction) const {
  return projected(centre.position + radius(centre, direction) * direction, centre.cell);
}
// [/excerpt]

bool TangentDisk::is_edge_long(const SurfacePoint& p, const SurfacePoint& w,
                               double squared_length) const {
  const double longest = spacing_.longest_edge * radius(std::min(p.length_scale, w.length_scale));
  return squared_length > longest * longest;
}

}  // namespace morskin::front
