#include "geometry/surface_mesh.h"

#include <concepts>

#include "geometry/error.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

// An id is no integer and no other id; misuse does not compile.
static_assert(!std::is_convertible_v<std::uint32_t, VertexId>);
static_assert(!std::is_convertible_v<VertexId, std::uint32_t>);
static_assert(!std::is_constructible_v<TriangleId, VertexId>);
static_assert(!std::is_constructible_v<HalfEdgeId, TriangleId>);
static_assert(!std::equality_comparable_with<VertexId, TriangleId>);
static_assert(!std::is_invocable_v<decltype(&SurfaceMesh::target), const SurfaceMesh&, VertexId>);
static_assert(!std::is_invocable_v<decltype(&SurfaceMesh::degree), const SurfaceMesh&, HalfEdgeId>);
static_assert(std::is_invocable_v<decltype(&SurfaceMesh::degree), const SurfaceMesh&, VertexId>);

namespace {

SurfaceMesh octahedron_mesh() {
  auto built = closed_mesh(6, octahedron());
  REQUIRE_FALSE(built.defect);
  return std::move(built.mesh);
}

/// A random flip, split or unsplit of a closed mesh.
void random_operation(SurfaceMesh& mesh, Random& random) {
  const HalfEdgeId h = random_half_edge(mesh, random);
  const double kind = random.uniform();
  if (kind < 0.5) {
    if (can_flip(mesh, h)) mesh.flip(h);
  } else if (kind < 0.8) {
    mesh.split(SurfaceMesh::triangle(h), mesh.add_vertex());
  } else if (can_unsplit(mesh, mesh.origin(h))) {
    mesh.unsplit(mesh.origin(h));
  }
}

SurfaceMesh random_mesh(unsigned seed) {
  Random random(seed);
  SurfaceMesh mesh = octahedron_mesh();
  for (int i = 0; i < 60; ++i) random_operation(mesh, random);
  return mesh;
}

}  // namespace

TEST_CASE("flips, splits and unsplits keep a closed mesh a sphere, step by step") {
  for_seeds<Random>(200, [&](Random& random) {
    SurfaceMesh mesh = octahedron_mesh();
    for (int step = 0; step < 60; ++step) {
      CAPTURE(step);
      random_operation(mesh, random);
      REQUIRE(validate(mesh).value_or("") == "");
      REQUIRE(euler_characteristic(mesh) == 2);
    }
    CHECK(components(mesh).count == 1);
  });
}

TEST_CASE("a half-edge flipped twice runs the other way between the same triangles as at first") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    SurfaceMesh mesh = random_mesh(seed);
    const TriangleList before = canonical(mesh.triangle_list());
    const HalfEdgeId h = random_half_edge(mesh, random);
    if (!can_flip(mesh, h)) return;
    const VertexId a = mesh.origin(h), b = mesh.target(h);
    const VertexId c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
    mesh.flip(h);
    CHECK(mesh.origin(h) == d);
    CHECK(mesh.target(h) == c);
    CHECK(mesh.apex(h) == a);
    CHECK(mesh.apex(mesh.twin(h)) == b);
    mesh.flip(h);
    CHECK(mesh.origin(h) == b);
    CHECK(mesh.target(h) == a);
    CHECK(canonical(mesh.triangle_list()) == before);
  });
}

TEST_CASE("triangles taken out leave a boundary that new ones can be glued to") {
  SurfaceMesh mesh = octahedron_mesh();
  // The four triangles about vertex 4 and, so, the vertex.
  std::vector<TriangleId> gone;
  mesh.for_each_outgoing(VertexId{4U},
                         [&](HalfEdgeId h) { gone.push_back(SurfaceMesh::triangle(h)); });
  mesh.remove(gone);
  CHECK(validate(mesh, Expect::Any).value_or("") == "");
  CHECK(validate(mesh, Expect::Closed).has_value());
  CHECK_FALSE(mesh.outgoing(VertexId{4U}).has_value());
  std::vector<HalfEdgeId> open;
  for (std::uint32_t h = 0; h < 3 * mesh.triangle_count(); ++h) {
    if (!mesh.is_removed(SurfaceMesh::triangle(HalfEdgeId{h})) && mesh.is_boundary(HalfEdgeId{h})) {
      open.push_back(HalfEdgeId{h});
    }
  }
  REQUIRE(open.size() == 4);
  const VertexId v = mesh.add_vertex();
  std::vector<HalfEdgeId> spokes;
  for (const HalfEdgeId h : open) {
    const TriangleId t = mesh.add_triangle(mesh.target(h), mesh.origin(h), v);
    mesh.glue(SurfaceMesh::half_edge(t, 0), h);
    spokes.push_back(SurfaceMesh::half_edge(t, 1));
    spokes.push_back(SurfaceMesh::half_edge(t, 2));
  }
  for (const HalfEdgeId g : spokes) {
    for (const HalfEdgeId h : spokes) {
      if (mesh.is_boundary(g) && mesh.is_boundary(h) && mesh.origin(g) == mesh.target(h) &&
          mesh.target(g) == mesh.origin(h)) {
        mesh.glue(g, h);
      }
    }
  }
  CHECK(validate(mesh, Expect::Closed).value_or("") == "");
}

TEST_CASE("an unsplit undoes a split") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    SurfaceMesh mesh = random_mesh(seed);
    const TriangleList before = canonical(mesh.triangle_list());
    const TriangleId t = SurfaceMesh::triangle(random_half_edge(mesh, random));
    const VertexId v = mesh.add_vertex();
    mesh.split(t, v);
    CHECK(mesh.degree(v) == 3);
    CHECK(mesh.triangle_list().size() == before.size() + 2);
    mesh.unsplit(v);
    CHECK_FALSE(mesh.outgoing(v));
    CHECK(canonical(mesh.triangle_list()) == before);
  });
}

TEST_CASE("what an unsplit leaves has room for a split, which adds no element") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    SurfaceMesh mesh = random_mesh(seed);
    const SurfaceMesh::FreeSlots fresh = mesh.add_free_slots();
    CHECK(mesh.is_removed(fresh.second));
    CHECK(mesh.is_removed(fresh.third));
    CHECK(validate(mesh).value_or("") == "");
    mesh.split(SurfaceMesh::triangle(random_half_edge(mesh, random)), fresh);
    const SurfaceMesh::FreeSlots left = mesh.unsplit(fresh.vertex);
    CHECK(left.vertex == fresh.vertex);
    const std::size_t vertices = mesh.vertex_count(), places = mesh.triangle_count();
    const std::size_t triangles = mesh.triangle_list().size();
    mesh.split(SurfaceMesh::triangle(random_half_edge(mesh, random)), left);
    CHECK(validate(mesh).value_or("") == "");
    CHECK(mesh.degree(left.vertex) == 3);
    CHECK(mesh.vertex_count() == vertices);
    CHECK(mesh.triangle_count() == places);
    CHECK(mesh.triangle_list().size() == triangles + 2);
  });
}

TEST_CASE("degree and has_edge agree with a count over all triangles") {
  for_seeds(50, [&](unsigned seed) {
    const SurfaceMesh mesh = random_mesh(seed);
    const std::size_t n = mesh.vertex_count();
    std::vector<std::vector<char>> joined(n, std::vector<char>(n, 0));
    for (const auto& t : mesh.triangle_list()) {
      for (std::size_t k = 0; k < 3; ++k) joined[t[k]][t[(k + 1) % 3]] = 1;
    }
    for (std::size_t a = 0; a < n; ++a) {
      if (!mesh.outgoing(VertexId{a})) continue;
      const auto degree =
          static_cast<std::size_t>(std::count(joined[a].begin(), joined[a].end(), 1));
      CHECK(mesh.degree(VertexId{a}) == degree);
      for (std::size_t most = 1; most < 12; ++most) {
        CHECK(mesh.has_degree_above(VertexId{a}, most) == (degree > most));
      }
      for (std::size_t b = 0; b < n; ++b) {
        CHECK(mesh.has_edge(VertexId{a}, VertexId{b}) == (joined[a][b] == 1));
      }
    }
  });
}

TEST_CASE("compact drops what is removed and renames the rest in order") {
  for_seeds(200, [&](unsigned seed) {
    SurfaceMesh mesh = random_mesh(seed);
    TriangleList before = mesh.triangle_list();
    const auto renamed = mesh.compact().vertices;
    REQUIRE(validate(mesh).value_or("") == "");
    std::uint32_t next = 0;
    for (const auto& name : renamed) {
      if (name) CHECK(name->value == next++);
    }
    CHECK(mesh.vertex_count() == next);
    CHECK(mesh.triangle_count() == before.size());
    for (auto& t : before) {
      for (std::uint32_t& v : t) v = renamed[VertexId{v}]->value;
    }
    CHECK(mesh.triangle_list() == before);
  });
}

TEST_CASE("append keeps both meshes, one behind the other, with all their edges") {
  SurfaceMesh mesh = octahedron_mesh();
  mesh.append(octahedron_mesh());
  CHECK(validate(mesh) == std::nullopt);
  CHECK(components(mesh).count == 2);
  TriangleList expected = octahedron();
  append(expected, octahedron(), 6);
  CHECK(mesh.triangle_list() == expected);
  SurfaceMesh disk;
  for (int i = 0; i < 3; ++i) disk.add_vertex();
  disk.add_triangle(VertexId{0U}, VertexId{1U}, VertexId{2U});
  mesh.append(std::move(disk));
  CHECK(validate(mesh, Expect::Any) == std::nullopt);
  CHECK(components(mesh).count == 3);
}

TEST_CASE("closed_mesh accepts a closed mesh, keeps its triangles and glues all its edges") {
  for_seeds(50, [&](unsigned seed) {
    SurfaceMesh mesh = random_mesh(seed);
    mesh.compact();
    const auto built = closed_mesh(mesh.vertex_count(), mesh.triangle_list());
    REQUIRE(built.defect.value_or("") == "");
    CHECK(validate(built.mesh).value_or("") == "");
    CHECK(built.mesh.triangle_list() == mesh.triangle_list());
  });
}

TEST_CASE("as many triangles may be added as have half-edges with 32-bit ids, and no more") {
  constexpr std::size_t most = SurfaceMesh::max_triangles;
  CHECK(3 * most <= geometry::no_index);  // the last half-edge is below the mark for a boundary
  CHECK(3 * (most + 1) > geometry::no_index);
  CHECK_NOTHROW(geometry::require_capacity(most - 1, most, "triangles"));
  CHECK_THROWS_WITH_AS(geometry::require_capacity(most, most, "triangles"),
                       doctest::Contains("more than 1431655765 triangles"), geometry::LimitReached);
}
