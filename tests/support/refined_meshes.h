#pragma once

/// Meshes as the sweep leaves them and as the refinement does, and what the latter must be.

#include "front/sweep.h"
#include "front/sweep_plan.h"
#include "refine/refinement.h"
#include "tests/support/meshes.h"

namespace morskin::support {

using namespace refine;

/// What the sweep leaves for the refinement.
inline Mesh swept_mesh(const PreparedSkin& skin, const Sizing& sizing = {}) {
  const morse::Guide guide = guide_for(skin, sizing);
  Mesh mesh;
  front::Sweep sweep(skin.surface, guide, {.sizing = sizing}, mesh);
  sweep.run({}, front::minima_of(guide));
  REQUIRE(sweep.open_edges() == 0);
  return mesh;
}

inline Mesh refined_mesh(const PreparedSkin& skin, const Sizing& sizing = {}) {
  return skin_mesh(skin.surface,
                   morskin::make_mesh(skin, {.sizing = sizing, .has_safety_net = false}));
}

inline RefinementCounts refine_mesh(const PreparedSkin& skin, Mesh& mesh,
                                    const Sizing& sizing = {}) {
  Refinement refinement(skin.surface, sizing, mesh);
  refinement.run();
  return refinement.counts();
}

struct Breaches {
  std::size_t L = 0, U = 0;
  bool operator==(const Breaches&) const = default;
};
inline Breaches breaches(const Mesh& mesh, const Sizing& sizing = {}) {
  Breaches found;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    const std::array p{&mesh.at(a), &mesh.at(b), &mesh.at(c)};
    const double radius = circumcircle(p[0]->position, p[1]->position, p[2]->position).radius;
    const double rho = min_length_scale(p);
    found.U += !(sizing.triangle_ratio(radius, rho) < 1);
    for (std::size_t k = 0; k < 3; ++k) {
      found.L += !(sizing.edge_ratio(*p[k], *p[(k + 1) % 3]) > 1);
    }
  }
  return found;
}

/// Sound, of the skin's topology, every vertex with its point, no breach left.
inline void check_refined(const PreparedSkin& skin, const Mesh& mesh, const Sizing& sizing = {}) {
  CHECK(geometry::validate(mesh.surface).value_or("") == "");
  REQUIRE(mesh.points.size() == mesh.surface.vertex_count());
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    REQUIRE(mesh.surface.outgoing(VertexId{v}).has_value());
  }
  CHECK(breaches(mesh, sizing) == Breaches{});
  CHECK(euler_characteristic(mesh.surface) == skin.topology.skin_euler_characteristic());
  CHECK(geometry::components(mesh.surface).count == skin.topology.skin_components());
}

/// A ball this shallowly entered counts as empty: the refinement's own share of its squared radius.
constexpr double min_intrusion = 1e-9;

inline std::size_t entered_balls(const PreparedSkin& skin, const Mesh& mesh) {
  std::size_t entered = 0;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    const SurfaceBall around =
        exact_surface_ball(skin.surface, mesh.at(a), mesh.position(b), mesh.position(c));
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
      if (VertexId{v} == a || VertexId{v} == b || VertexId{v} == c) continue;
      // Twice, since the flips compare with the smaller of two balls, which may round apart.
      if (around.intrusion(mesh.position(VertexId{v})) >
          2 * min_intrusion * around.squared_radius) {
        ++entered;
        break;
      }
    }
  }
  return entered;
}

inline std::vector<PreparedSkin> small_skins() {
  return {morskin::prepare_skin({ball(0, 0, 0, 1)}),
          morskin::prepare_skin({ball(0, 0, 0, 1), ball(1.9, 0.2, 0.1, 1.2)}),
          morskin::prepare_skin({ball(0, 0, 0, 1), ball(2, 0.1, 0.3, 0.9), ball(0.8, 1.6, 0, 0.8)}),
          morskin::prepare_skin(tetrahedron_balls(2.3))};
}

}  // namespace morskin::support
