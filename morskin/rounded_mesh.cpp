#include "morskin/rounded_mesh.h"

#include <Eigen/Geometry>
#include <vector>

#include "certify/triangle_geometry.h"

namespace morskin {

std::size_t count_spoilt(const geometry::IndexedMesh& mesh, const geometry::IndexedMesh& rounded,
                         double most_lost_deg) {
  std::size_t count = 0;
  for (const auto& t : mesh.triangles) {
    const auto normal = [&](const std::vector<geometry::Point>& at) -> geometry::Vector {
      return (at[t[1]] - at[t[0]]).cross(at[t[2]] - at[t[0]]);
    };
    const auto smallest_deg = [&](const std::vector<geometry::Point>& at) {
      return certify::angle_range(at[t[0]], at[t[1]], at[t[2]]).smallest_deg;
    };
    const double lost_deg = smallest_deg(mesh.positions) - smallest_deg(rounded.positions);
    const double along = normal(mesh.positions).dot(normal(rounded.positions));
    if (!(along > 0 && lost_deg < most_lost_deg)) ++count;
  }
  return count;
}

}  // namespace morskin
