#pragma once

#include "geometry/glued_triangles.h"
#include "morse/make_guide.h"
#include "morskin/pipeline.h"
#include "skin/singular_skin.h"
#include "surface/mesh.h"
#include "tests/support/test.h"

namespace morskin::support {

using geometry::TriangleList;

inline TriangleList octahedron() {
  return {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
}
inline TriangleList tetrahedron(std::uint32_t a, std::uint32_t b, std::uint32_t c,
                                std::uint32_t d) {
  return {{a, b, c}, {a, c, d}, {a, d, b}, {d, c, b}};
}

/// Adds triangles on vertices that follow those of the list's before.
inline void append(TriangleList& list, TriangleList more, std::uint32_t first_vertex) {
  for (auto& t : more) {
    for (std::uint32_t& v : t) v += first_vertex;
  }
  list.insert(list.end(), more.begin(), more.end());
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

/// A mesh whose vertices are those of another moved onto a skin.
inline surface::Mesh projected_mesh(const skin::SkinSurface& surface,
                                    const geometry::IndexedMesh& other) {
  surface::Mesh mesh(geometry::closed_mesh(other.positions.size(), other.triangles).mesh);
  for (std::size_t v = 0; v < other.positions.size(); ++v) {
    mesh.points[geometry::VertexId{v}] = *surface.project(other.positions[v], geometry::CellId{});
  }
  return mesh;
}

inline geometry::HalfEdgeId random_half_edge(const geometry::SurfaceMesh& mesh, Random& random) {
  for (;;) {
    const geometry::HalfEdgeId h{random.below(3 * mesh.triangle_count())};
    if (!mesh.is_removed(geometry::SurfaceMesh::triangle(h))) return h;
  }
}
/// Whether an edge's flip leaves no edge twice.
inline bool can_flip(const geometry::SurfaceMesh& mesh, geometry::HalfEdgeId h) {
  const geometry::VertexId c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
  return c != d && !mesh.has_edge(c, d);
}
/// Whether a vertex has three triangles around it and more behind them.
inline bool can_unsplit(const geometry::SurfaceMesh& mesh, geometry::VertexId v) {
  if (!mesh.outgoing(v) || mesh.degree(v) != 3) return false;
  bool can = true;
  mesh.for_each_outgoing(v, [&](auto h) { can = can && mesh.degree(mesh.target(h)) > 3; });
  return can;
}

/// V - E + F of a closed mesh; what has been removed does not count.
inline long euler_characteristic(const geometry::SurfaceMesh& mesh) {
  long vertices = 0, triangles = 0;
  for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
    vertices += mesh.outgoing(geometry::VertexId{v}).has_value();
  }
  for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
    triangles += !mesh.is_removed(geometry::TriangleId{t});
  }
  return vertices - triangles / 2;
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
void for_skins(const Seeds& seeds, Law law) {
  for_seeds(seeds, [&](unsigned seed) {
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
  return {.sizing = {}, .function = morse::MorseFunction::height(height)};
}
inline morskin::MeshingOptions with(const certify::Sizing& sizing) { return {.sizing = sizing}; }
/// Of a mesh with this C, with the Q that goes with it.
inline certify::Sizing sizing_for(double C) { return {C, certify::Sizing::quality_for(C)}; }
/// As the method made it, certified or not.
inline morskin::MeshingOptions uncertified() { return {.sizing = {}, .has_safety_net = false}; }

/// What a sweep with this sizing goes by.
inline morse::Guide guide_for(const morskin::PreparedSkin& skin, const certify::Sizing& sizing = {},
                              const std::optional<morse::MorseFunction>& function = {},
                              unsigned threads = 1) {
  return morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), function,
                           morskin::sphere_share(skin.surface, sizing), geometry::Run(threads));
}

/// Meshed and certified; the skin is gone, so nothing is to be asked of the cells.
inline morskin::MeshResult meshed(const std::vector<geometry::WeightedPoint>& points,
                                  const morskin::MeshingOptions& options = {},
                                  const morskin::Run& run = morskin::Run()) {
  return morskin::make_mesh(morskin::prepare_skin(points), options, run);
}

}  // namespace morskin::support
