#include "refine/journal.h"

#include <map>
#include <set>

#include "refine/local_operations.h"
#include "tests/support/refined_meshes.h"
#include "tests/support/seeds.h"

using namespace morskin;
using namespace morskin::refine;
using namespace morskin::support;

namespace {

using Triangles = std::multiset<std::array<VertexId, 3>>;

/// The triangles there are, each from its smallest corner on.
Triangles triangles(const Mesh& mesh) {
  Triangles all;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    if (mesh.surface.is_removed(TriangleId{t})) continue;
    std::array<VertexId, 3> corners = mesh.surface.corners(TriangleId{t});
    std::ranges::rotate(corners, std::ranges::min_element(corners));
    all.insert(corners);
  }
  return all;
}

std::vector<Point> positions(const Mesh& mesh, std::size_t count) {
  std::vector<Point> all;
  for (std::size_t v = 0; v < count; ++v) all.push_back(mesh.position(VertexId{v}));
  return all;
}

/// Takes vertices out, puts some in, moves some and flips what ought to be flipped, at random.
void change(const PreparedSkin& skin, Mesh& mesh, LocalOperations& operations, Journal& journal,
            Random& random) {
  const VertexId v{random.below(mesh.surface.vertex_count())};
  if (!mesh.surface.outgoing(v)) return;
  const TriangleId t = SurfaceMesh::triangle(*mesh.surface.outgoing(v));
  switch (random.below(3)) {
    case 0:
      operations.remove(v);
      break;
    case 1:
      operations.insert_ball_centre(t, [](const Insertion&) { return true; });
      break;
    default: {
      const SurfacePoint from = mesh.at(v);
      const double step =
          0.1 *
          (mesh.position(mesh.surface.target(*mesh.surface.outgoing(v))) - from.position).norm();
      const auto moved = skin.surface.project(from.position + step * random.direction(), from.cell);
      if (!moved) return;
      mesh.points[v] = *moved;
      journal.note_move(v, from);
    }
  }
  operations.flip_where_needed();
}

}  // namespace

TEST_CASE("what is taken back leaves every triangle and every vertex as they were") {
  for (const PreparedSkin& skin : small_skins()) {
    for_seeds(20, [&](unsigned seed) {
      Random random(seed);
      Mesh mesh = refined_mesh(skin, {});
      const std::size_t count = mesh.surface.vertex_count();
      LocalOperations operations(skin.surface, {}, mesh);
      Journal journal(mesh);
      operations.record_in(journal);
      for (int i = 0; i < 20; ++i) change(skin, mesh, operations, journal, random);
      const Triangles kept = triangles(mesh);
      const std::vector<Point> kept_positions = positions(mesh, count);
      const std::size_t middle = journal.size();
      CHECK(middle > 0);
      for (int i = 0; i < 30; ++i) change(skin, mesh, operations, journal, random);
      journal.undo(middle, operations.free_slots());
      CHECK(geometry::validate(mesh.surface).value_or("") == "");
      CHECK(triangles(mesh) == kept);
      CHECK(positions(mesh, count) == kept_positions);
      const Mesh untouched = refined_mesh(skin, {});
      journal.undo(0, operations.free_slots());
      CHECK(triangles(mesh) == triangles(untouched));
      CHECK(positions(mesh, count) == positions(untouched, count));
    });
  }
}

TEST_CASE("every triangle that changed has a touched corner") {
  const PreparedSkin skin = small_skins()[0];
  for_seeds(20, [&](unsigned seed) {
    Random random(seed);
    Mesh mesh = refined_mesh(skin, {});
    const Triangles before = triangles(mesh);
    LocalOperations operations(skin.surface, {}, mesh);
    Journal journal(mesh);
    operations.record_in(journal);
    for (int i = 0; i < 5; ++i) change(skin, mesh, operations, journal, random);
    const std::vector<VertexId> touched = journal.touched();
    for (const auto& corners : triangles(mesh)) {
      if (before.contains(corners)) continue;
      CHECK(std::ranges::any_of(
          corners, [&](VertexId v) { return std::ranges::binary_search(touched, v); }));
    }
  });
}
