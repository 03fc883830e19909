// Data by vertex and triangle: that each stays with its element, whatever is done to the mesh.

#include "geometry/mesh_data.h"

#include <memory>

#include "front/subdomains.h"
#include "refine/refinement.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

// An array by one kind of id cannot be asked with another.
template <class Data, class Index>
constexpr bool can_index = requires(Data& data, Index i) {
  data[i];
};
static_assert(can_index<VertexData<int>, VertexId>);
static_assert(!can_index<VertexData<int>, TriangleId>);
static_assert(!can_index<VertexData<int>, std::size_t>);
static_assert(!can_index<IdVector<TriangleId, int>, VertexId>);

namespace {

constexpr int unlabelled = -1;

/// A mesh with data, and beside it what they ought to be, by nothing but ids kept by hand.
struct Labelled {
  SurfaceMesh mesh = closed_mesh(6, octahedron()).mesh;
  VertexData<int> vertex{mesh, unlabelled};
  TriangleData<int> triangle{mesh, unlabelled};
  std::vector<SurfaceMesh::FreeSlots> slots;
  int last = 0;

  Labelled() {
    for (std::size_t v = 0; v < mesh.vertex_count(); ++v) vertex[VertexId{v}] = ++last;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) triangle[TriangleId{t}] = ++last;
  }

  void edit(Random& random) {
    const HalfEdgeId h = random_half_edge(mesh, random);
    const double kind = random.uniform();
    if (kind < 0.4) {
      if (can_flip(mesh, h)) mesh.flip(h);
    } else if (kind < 0.7) {
      if (slots.empty() || random.uniform() < 0.3) slots.push_back(mesh.add_free_slots());
      const SurfaceMesh::FreeSlots free = slots.back();
      slots.pop_back();
      CHECK(vertex[free.vertex] == unlabelled);
      mesh.split(SurfaceMesh::triangle(h), free);
      CHECK(triangle[free.second] == unlabelled);
      CHECK(triangle[free.third] == unlabelled);
      vertex[free.vertex] = ++last;
      triangle[free.second] = ++last;
      triangle[free.third] = ++last;
    } else if (can_unsplit(mesh, mesh.origin(h))) {
      slots.push_back(mesh.unsplit(mesh.origin(h)));
    }
  }
  /// The labels of the triangles with those of their corners: true of a mesh whatever its ids.
  std::map<int, std::array<int, 3>> content() const {
    std::map<int, std::array<int, 3>> result;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
      if (mesh.is_removed(TriangleId{t})) continue;
      const auto [a, b, c] = mesh.corners(TriangleId{t});
      result[triangle[TriangleId{t}]] = {vertex[a], vertex[b], vertex[c]};
    }
    return result;
  }
};

}  // namespace

TEST_CASE("data stay with their vertices and triangles through edits, compaction and appending") {
  for_seeds<Random>(200, [](unsigned, Random& random) {
    Labelled one;
    for (int step = 0; step < 80; ++step) {
      // A flip moves corners between two triangles; all else keeps what it does not touch.
      const auto before = one.content();
      one.edit(random);
      std::size_t changed = 0;
      for (const auto& [label, corners] : one.content()) {
        const auto found = before.find(label);
        changed += found == before.end() || found->second != corners;
      }
      CHECK(changed <= 3);
      if (step % 20 == 19) {
        const auto whole = one.content();
        one.mesh.compact();
        one.slots.clear();
        CHECK(one.content() == whole);
        CHECK(one.vertex.size() == one.mesh.vertex_count());
        CHECK(one.triangle.size() == one.mesh.triangle_count());
      }
    }
    Labelled other;
    other.last = 1000;
    for (int& label : other.vertex) label = ++other.last;
    for (int& label : other.triangle) label = ++other.last;
    for (int step = 0; step < 30; ++step) other.edit(random);
    auto both = one.content();
    both.merge(other.content());
    one.mesh.append(std::move(other.mesh));
    CHECK(one.content() == both);
    CHECK(other.vertex.size() == 0);
    one.mesh.compact();
    CHECK(one.content() == both);
  });
}

TEST_CASE("data of an appended mesh without the same data begin anew") {
  SurfaceMesh mesh = closed_mesh(6, octahedron()).mesh;
  VertexData<int> labels(mesh, 7);
  labels[VertexId{2U}] = 8;
  mesh.append(closed_mesh(6, octahedron()).mesh);
  CHECK(labels.size() == 12);
  CHECK(labels[VertexId{2U}] == 8);
  CHECK(labels[VertexId{8U}] == 7);
}

TEST_CASE("a mesh and its data that have room for another's elements take them in where they are") {
  Labelled one, other;
  one.mesh.reserve(12);
  const auto *const vertices = one.vertex.data(), *const triangles = one.triangle.data();
  one.mesh.append(std::move(other.mesh));
  REQUIRE(one.vertex.size() == 12);
  REQUIRE(one.triangle.size() == 16);
  CHECK(one.vertex.data() == vertices);
  CHECK(one.triangle.data() == triangles);
}

TEST_CASE("a copy of a mesh has no followers, and data may outlive their mesh") {
  auto mesh = std::make_unique<SurfaceMesh>(closed_mesh(6, octahedron()).mesh);
  VertexData<int> labels(*mesh);
  SurfaceMesh copy = *mesh;
  copy.add_vertex();
  CHECK(labels.size() == 6);
  mesh->add_vertex();
  CHECK(labels.size() == 7);
  mesh.reset();
  CHECK(labels.size() == 7);
}

TEST_CASE("a mesh on a surface that is copied or moved takes its points and births along") {
  surface::Mesh mesh;
  mesh.births.emplace(mesh.surface);
  for (int k = 0; k < 3; ++k) mesh.add_vertex({Point(k, 0, 0), Vector::UnitZ(), 1, CellId{0U}});
  mesh.surface.add_triangle(VertexId{0U}, VertexId{1U}, VertexId{2U});
  surface::Mesh copy = mesh;
  surface::Mesh moved = std::move(mesh);
  for (surface::Mesh* m : {&copy, &moved}) {
    m->surface.add_triangle(VertexId{0U}, VertexId{2U}, VertexId{1U});
    m->surface.add_vertex();
    CHECK(m->points.size() == 4);
    CHECK(m->position(VertexId{2U}) == Point(2, 0, 0));
    CHECK(std::vector<std::uint32_t>(m->births->begin(), m->births->end()) ==
          std::vector<std::uint32_t>{0, 1});
  }
}

TEST_CASE("a triangle's birth is its turn in the sweep, and refinement keeps it where it may") {
  for_skins(10, [](const PreparedSkin& skin) {
    const auto laid = front::sweep_once(skin.surface, guide_for(skin), {.record_births = true});
    REQUIRE(laid.mesh.births.has_value());
    const std::size_t count = laid.mesh.surface.triangle_count();
    REQUIRE(laid.mesh.births->size() == count);
    for (std::size_t t = 0; t < count; ++t) CHECK((*laid.mesh.births)[TriangleId{t}] == t);

    surface::Mesh mesh = laid.mesh;
    refine::Refinement(skin.surface, {}, mesh).run();
    REQUIRE(mesh.births->size() == mesh.surface.triangle_count());
    // A triangle that has the corners of one that was laid was laid with it, most are such.
    std::size_t same = 0;
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const std::uint32_t birth = (*mesh.births)[TriangleId{t}];
      REQUIRE(birth < count);
      const auto now = mesh.surface.corners(TriangleId{t});
      const auto then = laid.mesh.surface.corners(TriangleId{birth});
      same += std::ranges::all_of(now, [&](VertexId v) {
        return std::ranges::any_of(
            then, [&](VertexId w) { return mesh.position(v) == laid.mesh.position(w); });
      });
    }
    CHECK(2 * same > mesh.surface.triangle_count());
  });
}
