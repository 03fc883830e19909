#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/surface_mesh.h"
#include "morskin/pipeline.h"
#include "skin/singular_skin.h"
#include "surface/mesh.h"
#include "tests/support/molecules.h"
#include "tests/support/seeds.h"

namespace morskin::support {

using TriangleList = std::vector<std::array<std::uint32_t, 3>>;

inline TriangleList octahedron() {
  return {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
}
inline TriangleList tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) {
  return {{a, b, c}, {a, c, d}, {a, d, b}, {d, c, b}};
}

/// The same triangles in one order: each from its smallest corner on, the list ascending.
inline TriangleList canonical(TriangleList list) {
  for (auto& t : list) std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
  std::sort(list.begin(), list.end());
  return list;
}

/// A sphere's mesh: the octahedron with every triangle cut into four, `levels` times, its vertices
/// moved out to the sphere.
inline geometry::IndexedMesh sphere_mesh(const geometry::Point& centre, double radius, int levels) {
  geometry::IndexedMesh mesh;
  for (const double s : {1.0, -1.0}) mesh.positions.emplace_back(s, 0, 0);
  for (const double s : {1.0, -1.0}) mesh.positions.emplace_back(0, s, 0);
  for (const double s : {1.0, -1.0}) mesh.positions.emplace_back(0, 0, s);
  mesh.triangles = octahedron();
  for (int level = 0; level < levels; ++level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, is_new] =
          middles.try_emplace(std::minmax(a, b), static_cast<std::uint32_t>(mesh.positions.size()));
      if (is_new) mesh.positions.push_back((mesh.positions[a] + mesh.positions[b]).normalized());
      return it->second;
    };
    TriangleList finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = finer;
  }
  for (geometry::Point& p : mesh.positions) p = centre + radius * p;
  return mesh;
}

/// A result's mesh as the refinement works on it.
inline surface::Mesh skin_mesh(const skin::SkinSurface& surface,
                               const morskin::MeshResult& result) {
  surface::Mesh mesh;
  mesh.surface = geometry::closed_mesh(result.mesh.positions.size(), result.mesh.triangles).mesh;
  for (std::size_t v = 0; v < result.cells.size(); ++v) {
    mesh.points[geometry::VertexId{v}] = surface.at(result.mesh.positions[v], result.cells[v]);
  }
  return mesh;
}

/// The prepared skin of some balls, or nothing when it is singular.
inline std::optional<morskin::PreparedSkin> prepared(const WeightedPoints& points) {
  try {
    return morskin::prepare_skin(points);
  } catch (const skin::SingularSkin&) {
    return std::nullopt;
  }
}

/// Tries a law for the skins of random ball sets that are not singular. The law takes the skin, or
/// its seed and the skin.
template <class Law>
void for_skins(unsigned count, Law law) {
  for_seeds(count, [&](unsigned seed) {
    const auto skin = prepared(ball_set(seed));
    if (!skin) return;
    if constexpr (std::is_invocable_v<Law, unsigned, const morskin::PreparedSkin&>) {
      law(seed, *skin);
    } else {
      law(*skin);
    }
  });
}

inline morskin::MeshingOptions along(const geometry::Vector& height) {
  morskin::MeshingOptions options;
  options.function = morse::MorseFunction::height(height);
  return options;
}
inline morskin::MeshingOptions with(const certify::Sizing& sizing) {
  morskin::MeshingOptions options;
  options.sizing = sizing;
  return options;
}
/// As the method made it, certified or not.
inline morskin::MeshingOptions uncertified() {
  morskin::MeshingOptions options;
  options.has_safety_net = false;
  return options;
}

/// Meshed and certified; the skin is gone, so nothing is to be asked of the cells.
inline morskin::MeshResult meshed(const std::vector<geometry::WeightedPoint>& points,
                                  const morskin::MeshingOptions& options = {},
                                  const morskin::Run& run = morskin::Run()) {
  return morskin::make_mesh(morskin::prepare_skin(points), options, run);
}

/// What critical points add up to.
inline long euler_characteristic(const morskin::CriticalCounts& counts) {
  return static_cast<long>(counts[0] + counts[2]) - static_cast<long>(counts[1]);
}

}  // namespace morskin::support
