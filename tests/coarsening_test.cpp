// Coarsening: what it takes out, what it leaves, and that it may be done while the front goes on.

#include "refine/coarsening.h"

#include <algorithm>

#include "certify/certificate.h"
#include "certify/tube.h"
#include "front/snapshots.h"
#include "front/subdomains.h"
#include "refine/refinement.h"
#include "refine/thinning.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

Mesh fine_mesh(const PreparedSkin& skin, const Sizing& laid) {
  Mesh mesh = front::sweep_once(skin.surface, guide_for(skin, laid), {.sizing = laid}).mesh;
  Refinement(skin.surface, laid, mesh).run();
  return mesh;
}

/// Each ball set whose skin is not singular, with a mesh that has more triangles than it needs.
template <class Check>
void for_each_fine_mesh(unsigned count, Check check) {
  for_skins(count, [&](const PreparedSkin& skin) {
    check(skin, fine_mesh(skin, sizing_for(0.2).laid()));
  });
}

bool by_position(const Point& a, const Point& b) {
  return std::ranges::lexicographical_compare(a, b);
}

std::vector<Point> sorted_positions(const Mesh& mesh) {
  std::vector<Point> positions;
  for (const SurfacePoint& p : mesh.points) positions.push_back(p.position);
  std::ranges::sort(positions, by_position);
  return positions;
}

std::size_t short_edges(const Mesh& mesh, const Sizing& sizing) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < 3 * mesh.surface.triangle_count(); ++i) {
    const HalfEdgeId h{i};
    count += sizing.is_too_short(mesh.at(mesh.surface.origin(h)), mesh.at(mesh.surface.target(h)));
  }
  return count / 2;
}

/// Whether [U] holds for each triangle, and what the certificate has to prove of it.
bool is_fine_enough(const skin::SkinSurface& skin, const Mesh& mesh, const Sizing& sizing) {
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    const auto [a, b, c] = mesh.surface.corners(TriangleId{t});
    const std::array<const SurfacePoint*, 3> p{&mesh.at(a), &mesh.at(b), &mesh.at(c)};
    const auto circle = certify::circumcircle(p[0]->position, p[1]->position, p[2]->position);
    if (sizing.triangle_ratio(circle.radius, min_length_scale(p)) >= 1 ||
        !certify::expects_tube(skin, p)) {
      return false;
    }
  }
  return true;
}

void check_certified(const PreparedSkin& skin, const Mesh& mesh, const Sizing& sizing) {
  const auto certificate =
      certify::certify(indexed_mesh(mesh), skin.surface, skin.topology, sizing);
  CHECK_MESSAGE(certificate.certified, certificate.reason);
}

void check_certified_refined(const PreparedSkin& skin, Mesh& mesh, const Sizing& sizing) {
  Refinement(skin.surface, sizing, mesh).run();
  check_certified(skin, mesh, sizing);
}

}  // namespace

TEST_CASE("a coarser mesh is closed, has the same topology, and its triangles can all be proved") {
  for_each_fine_mesh(40, [](const PreparedSkin& skin, const Mesh& fine) {
    for (const double C : {0.25, 0.3, 0.4}) {
      CAPTURE(C);
      const Sizing sizing = sizing_for(C);
      Mesh mesh = fine;
      const std::size_t removed = Coarsening(skin.surface, sizing, mesh).run();
      mesh.surface.compact();
      CHECK(fine.points.size() - mesh.points.size() == removed);
      CHECK(validate(mesh.surface).value_or("") == "");
      CHECK(euler_characteristic(mesh.surface) == euler_characteristic(fine.surface));
      CHECK(components(mesh.surface).count == components(fine.surface).count);
      CHECK(is_fine_enough(skin.surface, mesh, sizing));
    }
  });
}

TEST_CASE("coarsening moves no vertex and keeps the order of those that stay") {
  for_each_fine_mesh(20, [](const PreparedSkin& skin, const Mesh& fine) {
    Mesh mesh = fine;
    Coarsening(skin.surface, sizing_for(0.35), mesh).run();
    mesh.surface.compact();
    std::size_t next = 0;
    for (const SurfacePoint& p : mesh.points) {
      while (next < fine.points.size() && fine.position(VertexId{next}) != p.position) ++next;
      REQUIRE(next < fine.points.size());
      ++next;
    }
  });
}

TEST_CASE("of the edges that [L] forbids next to none is left, of the triangles less than half") {
  std::size_t triangles_before = 0, triangles = 0, short_before = 0, short_after = 0;
  const Sizing sizing = sizing_for(0.3);
  for_each_fine_mesh(40, [&](const PreparedSkin& skin, const Mesh& fine) {
    Mesh mesh = fine;
    Coarsening(skin.surface, sizing, mesh).run();
    mesh.surface.compact();
    triangles_before += fine.surface.triangle_count();
    triangles += mesh.surface.triangle_count();
    short_before += short_edges(fine, sizing);
    short_after += short_edges(mesh, sizing);
  });
  CHECK(2 * triangles < triangles_before);
  CHECK(100 * short_after < short_before);
}

TEST_CASE("vertices outside the subdomain and next to those wait, and are taken out later") {
  for_each_fine_mesh(20, [](const PreparedSkin& skin, const Mesh& fine) {
    Mesh mesh = fine;
    const std::size_t count = mesh.points.size();
    Random random(static_cast<unsigned>(count));
    geometry::Parts parts(count, 0), stays(count, 0);
    for (std::size_t v = 0; v < count; ++v)
      parts[VertexId{v}] = random.uniform() < 0.05 ? geometry::no_part : 0;
    for (std::size_t h = 0; h < 3 * mesh.surface.triangle_count(); ++h) {
      const HalfEdgeId edge{h};
      if (parts[mesh.surface.origin(edge)] == 0) continue;
      stays[mesh.surface.origin(edge)] = 1;
      stays[mesh.surface.target(edge)] = 1;
    }
    Coarsening coarsening(skin.surface, sizing_for(0.3), mesh);
    CHECK(coarsening.run({parts, 0}) > 0);
    for (std::size_t v = 0; v < count; ++v) {
      if (stays[VertexId{v}]) CHECK(mesh.surface.outgoing(VertexId{v}).has_value());
    }
    mesh.surface.compact();
    CHECK(coarsening.run() > 0);
    mesh.surface.compact();
    CHECK(coarsening.run() == 0);  // nothing is new, nothing waits
    CHECK(validate(mesh.surface).value_or("") == "");
  });
}

TEST_CASE("a mesh coarsened behind the front is certified, and never there as a whole before") {
  const Sizing sizing = sizing_for(0.3), laid = sizing.laid();
  for_skins(30, [&](const PreparedSkin& skin) {
    const morse::Guide guide = guide_for(skin, laid);
    std::size_t most = 0;
    const auto inspect = [&](const front::Snapshot& now) {
      most = std::max(most, now.mesh.surface.triangle_count());
      for (std::size_t e = 0; e < now.front.capacity(); ++e) {
        const front::FrontEdge& edge = now.front[front::FrontEdgeId{e}];
        if (!edge.is_open) continue;
        CHECK(now.mesh.surface.is_boundary(edge.half_edge));
        CHECK(now.mesh.surface.origin(edge.half_edge) == edge.origin);
        CHECK(now.mesh.position(edge.origin) == edge.position);
      }
    };
    front::Snapshots snapshots(guide, {}, 50, inspect);
    const auto whole = front::sweep_once(skin.surface, guide, {.sizing = laid});
    auto coarse = front::sweep_once(
        skin.surface, guide, {.sizing = laid},
        front::CoarseningOptions{.sizing = sizing, .min_triangles = 300}, {&snapshots});
    REQUIRE(coarse.open_edges == 0);
    CHECK(whole.mesh.surface.triangle_count() ==
          coarse.mesh.surface.triangle_count() + 2 * coarse.operations.coarsen);
    if (whole.mesh.surface.triangle_count() > 4000) {
      CHECK(3 * most < 2 * whole.mesh.surface.triangle_count());
    }
    check_certified_refined(skin, coarse.mesh, sizing);
  });
}

TEST_CASE("each operation tells of more triangles laid, whatever is coarsened behind the front") {
  const Sizing sizing = sizing_for(0.3), laid = sizing.laid();
  const front::CoarseningOptions coarsening{.sizing = sizing, .min_triangles = 300};
  for_skins(20, [&](const PreparedSkin& skin) {
    std::size_t told = 0;
    front::OperationObserver observer([&](front::Operation, std::size_t triangles) {
      CHECK(triangles > std::exchange(told, triangles));
    });
    front::sweep_once(skin.surface, guide_for(skin, laid), {.sizing = laid, .record_births = true},
                      coarsening, {&observer});
  });
}

TEST_CASE("subdomains that are coarsened on their way give one mesh for any number of threads") {
  const Sizing sizing = sizing_for(0.35), laid = sizing.laid();
  for_skins(20, [&](const PreparedSkin& skin) {
    const morse::Guide guide = guide_for(skin, laid);
    const front::CoarseningOptions coarsening{.sizing = sizing, .min_triangles = 300};
    auto one = front::sweep_subdomains(skin.surface, guide, {.sizing = laid}, coarsening,
                                       geometry::Run(1));
    const auto two = front::sweep_subdomains(skin.surface, guide, {.sizing = laid}, coarsening,
                                             geometry::Run(2));
    REQUIRE(one.open_edges == 0);
    CHECK(indexed_mesh(one.mesh) == indexed_mesh(two.mesh));
    check_certified_refined(skin, one.mesh, sizing);
  });
}

TEST_CASE(
    "a front is laid with the largest C for which all is proved, never with larger triangles") {
  for (const double C : {0.05, 0.08, 0.2, 0.21, 0.3, 0.4}) {
    for (const double Q : {1.5, 1.65, Sizing::quality_for(C), 4.0}) {
      const Sizing sizing{C, Q}, laid = sizing.laid();
      CHECK(laid.C <= Sizing::largest_proved_C);
      CHECK(laid.C * laid.Q <= C * Q * (1 + 1e-15));
      CHECK(laid.largest_length_scale == sizing.largest_length_scale);
      if (C <= Sizing::largest_proved_C) CHECK(laid.Q == Q);
    }
  }
}

TEST_CASE("a thinned mesh has a tenth fewer vertices, keeps its topology and can be certified") {
  const Sizing sizing = sizing_for(0.4);
  std::size_t before = 0, after = 0;
  for_each_fine_mesh(30, [&](const PreparedSkin& skin, const Mesh& fine) {
    Mesh mesh = fine;
    Coarsening(skin.surface, sizing, mesh).run();
    mesh.surface.compact();
    Refinement(skin.surface, sizing, mesh).run();
    const std::size_t vertices = mesh.points.size();
    const std::size_t removed = thin(skin.surface, sizing, mesh);
    CHECK(mesh.points.size() + removed == vertices);
    CHECK(validate(mesh.surface).value_or("") == "");
    CHECK(euler_characteristic(mesh.surface) == euler_characteristic(fine.surface));
    CHECK(components(mesh.surface).count == components(fine.surface).count);
    CHECK(is_fine_enough(skin.surface, mesh, sizing));
    before += vertices;
    after += mesh.points.size();
    check_certified(skin, mesh, sizing);
  });
  CHECK(10 * after < 9 * before);
}

TEST_CASE("thinning leaves the vertices four edges from where the curvature decides the size") {
  Sizing sizing = sizing_for(0.4);
  sizing.set_edge_length(0.5);
  std::size_t left = 0, removed = 0;
  for_skins(20, [&](const PreparedSkin& skin) {
    Mesh mesh = fine_mesh(skin, sizing.laid());
    Refinement(skin.surface, sizing, mesh).run();
    const Mesh refined = mesh;
    removed += thin(skin.surface, sizing, mesh);
    const std::vector<Point> positions = sorted_positions(mesh);
    for (std::size_t i = 0; i < refined.points.size(); ++i) {
      const VertexId v{i};
      const bool is_near = std::ranges::any_of(refined.points, [&](const SurfacePoint& p) {
        return p.length_scale < sizing.largest_length_scale &&
               (p.position - refined.position(v)).norm() < 4 * sizing.edge_length();
      });
      if (is_near) continue;
      CHECK(std::ranges::binary_search(positions, refined.position(v), by_position));
      ++left;
    }
  });
  CHECK(left > 1000);
  CHECK(removed > 100);
}

TEST_CASE("a mesh is made finer about the places named and nowhere else, and keeps its topology") {
  const Sizing sizing = sizing_for(0.4);
  std::size_t stayed = 0, inserted = 0;
  for_each_fine_mesh(30, [&](const PreparedSkin& skin, const Mesh& fine) {
    Mesh mesh = fine;
    Coarsening(skin.surface, sizing, mesh).run();
    mesh.surface.compact();
    Refinement(skin.surface, sizing, mesh).run();
    thin(skin.surface, sizing, mesh);
    const Mesh thinned = mesh;
    const Point place = thinned.position(VertexId{0U});
    inserted += thicken(skin.surface, sizing, mesh, {place}, 3);
    CHECK(validate(mesh.surface).value_or("") == "");
    CHECK(euler_characteristic(mesh.surface) == euler_characteristic(fine.surface));
    CHECK(components(mesh.surface).count == components(fine.surface).count);
    CHECK(is_fine_enough(skin.surface, mesh, sizing));
    check_certified(skin, mesh, sizing);
    const std::vector<Point> positions = sorted_positions(mesh);
    for (const SurfacePoint& p : thinned.points) {
      if ((p.position - place).norm() < 6 * p.length_scale) continue;
      CHECK(std::ranges::binary_search(positions, p.position, by_position));
      ++stayed;
    }
  });
  CHECK(stayed > 1000);
  CHECK(inserted > 100);
}
