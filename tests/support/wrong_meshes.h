#pragma once

/// Meshes that are wrong in ways a certificate must see.

#include <algorithm>
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

/// The mesh with a triangle in front that begins at a vertex, so that (c3) is tried there.
inline geometry::IndexedMesh begun_at(geometry::IndexedMesh mesh, std::uint32_t v) {
  const auto has_v = [&](const auto& t) { return std::ranges::find(t, v) != t.end(); };
  std::iter_swap(mesh.triangles.begin(), std::ranges::find_if(mesh.triangles, has_v));
  auto& first = mesh.triangles.front();
  std::rotate(first.begin(), std::ranges::find(first, v), first.end());
  return mesh;
}

/// Triangle t is cut into three at a new vertex, the last. The first of them takes its number.
inline void cut(geometry::IndexedMesh& mesh, std::size_t t, const geometry::Point& at) {
  const auto [a, b, c] = mesh.triangles[t];
  const auto v = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.push_back(at);
  mesh.triangles[t] = {v, a, b};
  mesh.triangles.push_back({v, b, c});
  mesh.triangles.push_back({v, c, a});
}

/// A tube in place of two triangles, from one to the other.
inline geometry::IndexedMesh with_tube(geometry::IndexedMesh mesh, std::size_t from,
                                       std::size_t to) {
  const auto [a, b, c] = mesh.triangles[from];
  const auto [d, e, f] = mesh.triangles[to];
  mesh.triangles[from] = {a, b, d};
  mesh.triangles[to] = {b, f, d};
  for (const auto& side : TriangleList{{b, c, f}, {c, e, f}, {c, a, e}, {a, d, e}}) {
    mesh.triangles.push_back(side);
  }
  return mesh;
}

/// The mesh opened along two edges that meet at a vertex, the origin of half-edge h: on one side
/// the vertex is moved, and two triangles fill the hole. @param turns  from h on to the other edge
inline geometry::IndexedMesh slit(geometry::IndexedMesh mesh, geometry::HalfEdgeId h,
                                  std::size_t turns, const geometry::Vector& by) {
  const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
  const geometry::VertexId m = built.mesh.origin(h);
  std::vector<geometry::HalfEdgeId> round;
  built.mesh.for_each_outgoing(m, [&](geometry::HalfEdgeId out) { round.push_back(out); });
  turns = 1 + turns % (round.size() - 1);
  const auto other = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.emplace_back(mesh.positions[m.index()] + by);
  for (std::size_t i = 0; i < turns; ++i) {
    auto& t = mesh.triangles[geometry::SurfaceMesh::triangle(round[i]).index()];
    std::ranges::replace(t, m.value, other);
  }
  mesh.triangles.push_back({built.mesh.target(round[0]).value, other, m.value});
  mesh.triangles.push_back({other, built.mesh.target(round[turns]).value, m.value});
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

/// Several copies of a mesh that goes round an axis, cut open along a half plane from the axis on
/// and sewn on to the next: a cover without a branch. As a torus's it is a torus again. The mesh
/// itself where the axis meets one of its triangles, or where it does not go round.
inline geometry::IndexedMesh wound_cover(const geometry::IndexedMesh& mesh, std::uint32_t sheets,
                                         const geometry::Point& centre, int axis) {
  const auto count = static_cast<std::uint32_t>(mesh.positions.size());
  const auto turn = [&](std::uint32_t v) {
    const geometry::Vector e = mesh.positions[v] - centre;
    return std::atan2(e[(axis + 2) % 3], e[(axis + 1) % 3]);
  };
  // How many sheets up from u to v, the shorter way round.
  const auto step = [&](std::uint32_t u, std::uint32_t v) -> std::uint32_t {
    const double by = turn(v) - turn(u);
    return by > M_PI ? sheets - 1 : by < -M_PI ? 1 : 0;
  };
  geometry::IndexedMesh cover;
  for (std::uint32_t s = 0; s < sheets; ++s) {
    cover.positions.insert(cover.positions.end(), mesh.positions.begin(), mesh.positions.end());
    for (const auto& [a, b, c] : mesh.triangles) {
      if ((step(a, b) + step(b, c) + step(c, a)) % sheets != 0) return mesh;
      const std::uint32_t of_b = (s + step(a, b)) % sheets, of_c = (s + step(a, c)) % sheets;
      cover.triangles.push_back({s * count + a, of_b * count + b, of_c * count + c});
    }
  }
  const auto built = geometry::closed_mesh(cover.positions.size(), cover.triangles);
  return built.defect || geometry::components(built.mesh).count > 1 ? mesh : cover;
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
