#include "refine/journal.h"

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
    std::rotate(corners.begin(), std::ranges::min_element(corners), corners.end());
    all.insert(corners);
  }
  return all;
}

std::vector<Point> positions(const Mesh& mesh, std::size_t count) {
  std::vector<Point> all;
  for (std::size_t v = 0; v < count; ++v) all.push_back(mesh.position(VertexId{v}));
  return all;
}

/// All that a mesh is, ids included: what each triangle's corners are, and one edge of each vertex.
struct Slots {
  std::vector<std::optional<std::array<VertexId, 3>>> corners;
  std::vector<std::optional<HalfEdgeId>> outgoing;
  bool operator==(const Slots&) const = default;

  explicit Slots(const Mesh& mesh) {
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      corners.emplace_back();
      if (!mesh.surface.is_removed(TriangleId{t})) corners[t] = mesh.surface.corners(TriangleId{t});
    }
    for (std::size_t v = 0; v < mesh.surface.vertex_count(); ++v) {
      outgoing.push_back(mesh.surface.outgoing(VertexId{v}));
    }
  }
};

std::size_t size_of(const Work& work) {
  return work.to_flip.size() + work.too_short.size() + work.big.size();
}

/// Whether the slots are those of the vertices and triangles that are not there, each once.
bool are_all_free(const std::vector<SurfaceMesh::FreeSlots>& slots, const Mesh& mesh) {
  std::set<VertexId> vertices;
  std::set<TriangleId> of_triangles;
  for (const SurfaceMesh::FreeSlots& free : slots) {
    vertices.insert(free.vertex);
    of_triangles.insert({free.second, free.third});
  }
  std::size_t missing = 0;
  for (std::size_t v = 0; v < mesh.surface.vertex_count(); ++v) {
    if (mesh.surface.outgoing(VertexId{v}).has_value()) continue;
    if (!vertices.contains(VertexId{v})) return false;
    ++missing;
  }
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    if (mesh.surface.is_removed(TriangleId{t}) != of_triangles.contains(TriangleId{t}))
      return false;
  }
  return missing == slots.size() && vertices.size() == slots.size() &&
         of_triangles.size() == 2 * slots.size();
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
      CHECK(are_all_free(operations.free_slots(), mesh));
    });
  }
}

TEST_CASE("a contraction that is taken back leaves mesh and free slots as they were, in any skin") {
  std::size_t contracted = 0;
  for_skins(12, [&](unsigned seed, const PreparedSkin& skin) {
    Random random(seed);
    Mesh mesh = refined_mesh(skin, {.C = 0.15, .Q = Sizing::quality_for(0.15)});
    LocalOperations operations(skin.surface, {}, mesh);
    Journal journal(mesh);
    operations.record_in(journal);
    const Triangles before = triangles(mesh);
    const std::vector<Point> before_positions = positions(mesh, mesh.surface.vertex_count());
    const auto at = [&](VertexId v) -> const SurfacePoint& { return mesh.at(v); };
    for (int tries = 0; tries < 20; ++tries) {
      for (int k = 0; k < 3; ++k) {  // each in the mesh that the one before it left
        const HalfEdgeId h{random.below(3 * mesh.surface.triangle_count())};
        if (mesh.surface.is_removed(SurfaceMesh::triangle(h))) continue;
        contracted +=
            contract_edge(mesh.surface, at, h, [&](VertexId v) { return operations.remove(v); });
        operations.flip_where_needed();
        CHECK(are_all_free(operations.free_slots(), mesh));
      }
      journal.undo(0, operations.free_slots());
      CHECK(journal.size() == 0);
      CHECK(operations.free_slots().empty());
      CHECK(triangles(mesh) == before);
      CHECK(positions(mesh, before_positions.size()) == before_positions);
      CHECK(geometry::validate(mesh.surface).value_or("") == "");
    }
  });
  CHECK(contracted > 300);
}

TEST_CASE("a vertex that cannot be taken out leaves mesh, work, journal and free slots untouched") {
  std::size_t refused = 0;
  for_skins(12, [&](unsigned seed, const PreparedSkin& skin) {
    Random random(seed);
    Mesh mesh = refined_mesh(skin, {.C = 0.2, .Q = Sizing::quality_for(0.2)});
    LocalOperations operations(skin.surface, {}, mesh);
    Journal journal(mesh);
    operations.record_in(journal);
    // Fewer and fewer vertices, until most of those left have to stay.
    for (std::size_t tries = 0; tries < 2 * mesh.surface.vertex_count(); ++tries) {
      const VertexId v{random.below(mesh.surface.vertex_count())};
      if (!mesh.surface.outgoing(v)) continue;
      const bool is_looked_at = tries > mesh.surface.vertex_count();
      const auto before = is_looked_at ? std::optional(Slots(mesh)) : std::nullopt;
      const std::size_t changes = journal.size(), slots = operations.free_slots().size();
      const std::size_t flips = operations.counts().flip, work = size_of(operations.work());
      if (operations.remove(v)) continue;
      if (before) CHECK(Slots(mesh) == *before);
      CHECK(journal.size() == changes);
      CHECK(operations.free_slots().size() == slots);
      CHECK(operations.counts().flip == flips);
      CHECK(size_of(operations.work()) == work);
      ++refused;
    }
    CHECK(are_all_free(operations.free_slots(), mesh));
  });
  CHECK(refused > 300);
}

TEST_CASE("every triangle that changed has a touched corner") {
  const PreparedSkin skin = small_skins()[0];
  std::size_t changed = 0;
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
      ++changed;
      CHECK(std::ranges::any_of(
          corners, [&](VertexId v) { return std::ranges::binary_search(touched, v); }));
    }
  });
  CHECK(changed > 100);
}
