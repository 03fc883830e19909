#include "refine/local_operations.h"

#include "tests/support/refined_meshes.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

constexpr Sizing coarse{.C = 0.12, .Q = 1.65};

/// Every triangle too big for the default sizing.
Work all_big(const Mesh& mesh) {
  Work work;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) work.big.emplace_back(t);
  return work;
}

}  // namespace

TEST_CASE("operations in a subdomain change no triangle with a vertex outside") {
  for (const PreparedSkin& skin : small_skins()) {
    Mesh mesh = refined_mesh(skin, coarse);
    const std::size_t triangles = mesh.surface.triangle_count();
    geometry::Parts parts;
    for (const SurfacePoint& p : mesh.points) parts.push_back(p.position.x() > 0.3 ? 1 : 0);
    std::vector<SurfaceMesh::FreeSlots> slots;
    for (int k = 0; k < 2000; ++k) slots.push_back(mesh.surface.add_free_slots());
    parts.resize(mesh.surface.vertex_count(), 0);
    geometry::Parts changing = parts;
    const SurfaceMesh before = mesh.surface;

    LocalOperations part(skin.surface, {}, mesh, all_big(mesh), {changing, 0}, slots);
    part.insert_into_big_triangles(100000);
    CHECK(part.counts().insert > 10);
    CHECK(geometry::validate(mesh.surface).value_or("") == "");
    std::size_t changed = 0;
    for (std::size_t t = 0; t < triangles; ++t) {
      const auto corners = before.corners(TriangleId{t});
      if (corners == mesh.surface.corners(TriangleId{t})) continue;
      ++changed;
      for (const VertexId v : corners) CHECK(parts[v] == 0);
    }
    CHECK(changed > 10);

    LocalOperations whole(skin.surface, {}, mesh);
    whole.absorb(part);
    CHECK(whole.counts().insert == part.counts().insert);
    whole.flip_where_needed();
    whole.contract_short_edges();
    whole.insert_into_big_triangles(100000);
    whole.contract_short_edges();
    CHECK(whole.work().big.size() + whole.work().too_short.size() == 0);
    mesh.surface.compact();
    check_refined(skin, mesh);
    CHECK(entered_balls(skin, mesh) == 0);
  }
}

TEST_CASE("a subdomain without room leaves its work as it is") {
  const PreparedSkin skin = small_skins()[2];
  Mesh mesh = refined_mesh(skin, coarse);
  geometry::Parts parts(mesh.points.size(), 0);
  const auto before = mesh.surface.triangle_list();
  LocalOperations part(skin.surface, {}, mesh, all_big(mesh), {parts, 0});
  part.insert_into_big_triangles(100000);
  CHECK(part.counts().insert == 0);
  CHECK(part.work().big.size() > 10);
  CHECK(mesh.surface.triangle_list() == before);
}

TEST_CASE("refinement by boxes has one outcome for any number of threads") {
  for (const PreparedSkin& skin : small_skins()) {
    const Mesh rough = refined_mesh(skin, coarse);
    Mesh alone = rough;
    const RefinementCounts counts = refine_mesh(skin, alone);
    CHECK(counts.insert > 128);  // else one box
    check_refined(skin, alone);
    for (const unsigned threads : {2U, 3U}) {
      Mesh together = rough;
      Refinement refinement(skin.surface, {}, together, geometry::Run(threads));
      refinement.run();
      CHECK(refinement.counts().flip == counts.flip);
      CHECK(refinement.counts().insert == counts.insert);
      CHECK(indexed_mesh(together) == indexed_mesh(alone));
    }
  }
}
