#pragma once

/// Meshes that are wrong in ways a certificate must see.

#include <array>
#include <cmath>
#include <cstdint>
#include <set>
#include <vector>

#include "geometry/surface_mesh.h"
#include "tests/support/meshes.h"

namespace morskin::support {

/// Both meshes as one.
inline geometry::IndexedMesh together(geometry::IndexedMesh a, const geometry::IndexedMesh& b) {
  const auto shift = static_cast<std::uint32_t>(a.positions.size());
  a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
  for (const auto& [p, q, r] : b.triangles) {
    a.triangles.push_back({p + shift, q + shift, r + shift});
  }
  return a;
}

inline geometry::IndexedMesh turned_inside_out(geometry::IndexedMesh mesh) {
  for (auto& triangle : mesh.triangles) std::swap(triangle[0], triangle[1]);
  return mesh;
}

/// Two copies of a mesh, cut open along the two edges p - m - q and sewn crosswise: one closed
/// surface that covers the skin twice, branching at p and q. As a sphere's it is a sphere again.
/// The second copy's own vertices come after those of the first.
inline geometry::IndexedMesh double_cover(const geometry::IndexedMesh& mesh) {
  const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
  const geometry::SurfaceMesh& surface = built.mesh;
  // m with two neighbours p, q; the triangles from p round to q are on one side of the cut.
  const geometry::VertexId m = surface.origin(geometry::HalfEdgeId{0U});
  std::vector<geometry::HalfEdgeId> round;
  surface.for_each_outgoing(m, [&](geometry::HalfEdgeId h) { round.push_back(h); });
  const std::size_t half = round.size() / 2;
  const std::uint32_t p = surface.target(round[0]).value, q = surface.target(round[half]).value;
  std::set<std::size_t> crossed;
  for (std::size_t i = 0; i < half; ++i) {
    crossed.insert(geometry::SurfaceMesh::triangle(round[i]).index());
  }
  geometry::IndexedMesh cover = mesh;
  std::vector<std::uint32_t> copy(mesh.positions.size());
  for (std::uint32_t v = 0; v < copy.size(); ++v) {
    copy[v] = v;
    if (v == p || v == q) continue;
    copy[v] = static_cast<std::uint32_t>(cover.positions.size());
    cover.positions.push_back(mesh.positions[v]);
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    auto second = mesh.triangles[t];
    for (std::uint32_t& v : second) v = copy[v];
    if (crossed.contains(t)) {
      for (std::size_t k = 0; k < 3; ++k) {
        if (mesh.triangles[t][k] == m.value) std::swap(cover.triangles[t][k], second[k]);
      }
    }
    cover.triangles.push_back(second);
  }
  return cover;
}

/// A mesh of the unit sphere with triangles as small as `smallest` at both poles: rings of sixteen
/// vertices, growing by a constant factor. The poles come first.
inline geometry::IndexedMesh sphere_with_fine_poles(double smallest) {
  constexpr std::uint32_t around = 16;
  constexpr double growth = 1.4;
  std::vector<double> angles;  // from the pole
  for (double angle = smallest; angle < M_PI / 2; angle *= growth) angles.push_back(angle);
  if (angles.back() > 1.2) angles.pop_back();
  const std::size_t half = angles.size();
  angles.push_back(M_PI / 2);
  for (std::size_t i = half; i-- > 0;) angles.push_back(M_PI - angles[i]);
  geometry::IndexedMesh mesh;
  mesh.positions = {geometry::Point(0, 0, 1), geometry::Point(0, 0, -1)};
  for (std::size_t ring = 0; ring < angles.size(); ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const double turn = 2 * M_PI * (i + 0.5 * static_cast<double>(ring % 2)) / around;
      const double s = std::sin(angles[ring]);
      mesh.positions.emplace_back(s * std::cos(turn), s * std::sin(turn), std::cos(angles[ring]));
    }
  }
  const auto at = [&](std::size_t ring, std::uint32_t i) {
    return static_cast<std::uint32_t>(2 + ring * around + i % around);
  };
  for (std::uint32_t i = 0; i < around; ++i) mesh.triangles.push_back({0, at(0, i), at(0, i + 1)});
  for (std::size_t ring = 0; ring + 1 < angles.size(); ++ring) {
    for (std::uint32_t i = 0; i < around; ++i) {
      const auto below = i + static_cast<std::uint32_t>(ring % 2);  // between i and i + 1
      mesh.triangles.push_back({at(ring, i), at(ring + 1, below), at(ring, i + 1)});
      mesh.triangles.push_back({at(ring, i + 1), at(ring + 1, below), at(ring + 1, below + 1)});
    }
  }
  const std::size_t last = angles.size() - 1;
  for (std::uint32_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({1, at(last, i + 1), at(last, i)});
  }
  return mesh;
}

}  // namespace morskin::support
