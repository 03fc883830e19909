#include "bench/ablation/breaches.h"

#include <cmath>

#include "certify/triangle_geometry.h"

namespace morskin::ablation {

using geometry::HalfEdgeId;
using geometry::SurfaceMesh;
using geometry::TriangleId;

Breaches count_breaches(const certify::Sizing& sizing, const surface::Mesh& mesh) {
  Breaches breaches;
  for (std::size_t i = 0; i < mesh.surface.triangle_count(); ++i) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{i});
    const double radius =
        certify::circumcircle(mesh.position(a), mesh.position(b), mesh.position(c)).radius;
    const double rho = surface::min_length_scale({&mesh.at(a), &mesh.at(b), &mesh.at(c)});
    breaches.big_triangles += sizing.triangle_ratio(radius, rho) >= 1;
    for (const std::uint32_t k : {0U, 1U, 2U}) {
      const HalfEdgeId h = SurfaceMesh::half_edge(TriangleId{i}, k);
      const bool is_seen_elsewhere = !mesh.surface.is_boundary(h) && mesh.surface.twin(h) < h;
      breaches.short_edges +=
          !is_seen_elsewhere &&
          sizing.is_too_short(mesh.at(mesh.surface.origin(h)), mesh.at(mesh.surface.target(h)));
    }
  }
  return breaches;
}

std::size_t angles_below(double degrees, const geometry::IndexedMesh& mesh) {
  const double cosine = std::cos(degrees * M_PI / 180);
  std::size_t count = 0;
  for (const auto& corners : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const geometry::Point& p = mesh.positions[corners[k]];
      const geometry::Vector to = mesh.positions[corners[(k + 1) % 3]] - p;
      const geometry::Vector from = mesh.positions[corners[(k + 2) % 3]] - p;
      count += to.dot(from) > cosine * to.norm() * from.norm();
    }
  }
  return count;
}

}  // namespace morskin::ablation
