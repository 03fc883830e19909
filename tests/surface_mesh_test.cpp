#include "geometry/surface_mesh.h"

#include <doctest/doctest.h>

#include <concepts>
#include <type_traits>

#include "geometry/error.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::geometry;
using support::TriangleList;

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
  MeshOrDefect built = closed_mesh(6, support::octahedron());
  REQUIRE_FALSE(built.defect);
  return std::move(built.mesh);
}

/// Whether an edge's flip leaves no edge twice.
bool can_flip(const SurfaceMesh& mesh, HalfEdgeId h) {
  const VertexId c = mesh.apex(h), d = mesh.apex(mesh.twin(h));
  return c != d && !mesh.has_edge(c, d);
}

/// Whether a vertex has three triangles around it and more behind them.
bool can_unsplit(const SurfaceMesh& mesh, VertexId v) {
  if (!mesh.outgoing(v) || mesh.degree(v) != 3) return false;
  bool can = true;
  mesh.for_each_outgoing(v, [&](HalfEdgeId h) { can = can && mesh.degree(mesh.target(h)) > 3; });
  return can;
}

HalfEdgeId random_half_edge(const SurfaceMesh& mesh, support::Random& random) {
  for (;;) {
    const HalfEdgeId h{random.below(3 * mesh.triangle_count())};
    if (!mesh.is_removed(SurfaceMesh::triangle(h))) return h;
  }
}

/// A random flip, split or unsplit of a closed mesh.
void random_operation(SurfaceMesh& mesh, support::Random& random) {
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
  support::Random random(seed);
  SurfaceMesh mesh = octahedron_mesh();
  for (int i = 0; i < 60; ++i) random_operation(mesh, random);
  return mesh;
}

bool names_edge(const std::string& text, std::uint32_t a, std::uint32_t b) {
  const auto edge = [](std::uint32_t p, std::uint32_t q) {
    return "edge " + std::to_string(p) + "-" + std::to_string(q);
  };
  return text.starts_with(edge(a, b)) || text.starts_with(edge(b, a));
}

}  // namespace

TEST_CASE("flips, splits and unsplits keep a closed mesh a sphere, step by step") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    SurfaceMesh mesh = octahedron_mesh();
    for (int step = 0; step < 60; ++step) {
      CAPTURE(step);
      random_operation(mesh, random);
      REQUIRE(validate(mesh).value_or("") == "");
      std::size_t vertices = 0;
      for (std::size_t v = 0; v < mesh.vertex_count(); ++v) {
        vertices += mesh.outgoing(VertexId{v}).has_value();
      }
      REQUIRE(mesh.triangle_list().size() + 4 == 2 * vertices);
    }
    CHECK(components(mesh).count == 1);
  }
}

TEST_CASE("a half-edge flipped twice runs the other way between the same triangles as at first") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    SurfaceMesh mesh = random_mesh(seed);
    const TriangleList before = support::canonical(mesh.triangle_list());
    const HalfEdgeId h = random_half_edge(mesh, random);
    if (!can_flip(mesh, h)) continue;
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
    CHECK(support::canonical(mesh.triangle_list()) == before);
  }
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
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    SurfaceMesh mesh = random_mesh(seed);
    const TriangleList before = support::canonical(mesh.triangle_list());
    const TriangleId t = SurfaceMesh::triangle(random_half_edge(mesh, random));
    const VertexId v = mesh.add_vertex();
    mesh.split(t, v);
    CHECK(mesh.degree(v) == 3);
    CHECK(mesh.triangle_list().size() == before.size() + 2);
    mesh.unsplit(v);
    CHECK_FALSE(mesh.outgoing(v));
    CHECK(support::canonical(mesh.triangle_list()) == before);
  }
}

TEST_CASE("what an unsplit leaves has room for a split, which adds no element") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    SurfaceMesh mesh = random_mesh(seed);
    const SurfaceMesh::Room fresh = mesh.add_room();
    CHECK(mesh.is_removed(fresh.second));
    CHECK(mesh.is_removed(fresh.third));
    CHECK(validate(mesh).value_or("") == "");
    mesh.split(SurfaceMesh::triangle(random_half_edge(mesh, random)), fresh);
    const SurfaceMesh::Room left = mesh.unsplit(fresh.vertex);
    CHECK(left.vertex == fresh.vertex);
    const std::size_t vertices = mesh.vertex_count(), places = mesh.triangle_count();
    const std::size_t triangles = mesh.triangle_list().size();
    mesh.split(SurfaceMesh::triangle(random_half_edge(mesh, random)), left);
    CHECK(validate(mesh).value_or("") == "");
    CHECK(mesh.degree(left.vertex) == 3);
    CHECK(mesh.vertex_count() == vertices);
    CHECK(mesh.triangle_count() == places);
    CHECK(mesh.triangle_list().size() == triangles + 2);
  }
}

TEST_CASE("degree and has_edge agree with a count over all triangles") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
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
  }
}

TEST_CASE("compact drops what is removed and renames the rest in order") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    SurfaceMesh mesh = random_mesh(seed);
    TriangleList before = mesh.triangle_list();
    const auto renamed = mesh.compact();
    REQUIRE(validate(mesh).value_or("") == "");
    std::uint32_t next = 0;
    for (const auto& name : renamed) {
      if (name) CHECK(name->value == next++);
    }
    CHECK(mesh.vertex_count() == next);
    CHECK(mesh.triangle_count() == before.size());
    for (auto& t : before) {
      for (std::uint32_t& v : t) v = renamed[v]->value;
    }
    CHECK(mesh.triangle_list() == before);
  }
}

TEST_CASE("append keeps both meshes, one behind the other, with all their edges") {
  SurfaceMesh mesh = octahedron_mesh();
  const SurfaceMesh second = octahedron_mesh();
  mesh.append(second);
  CHECK(validate(mesh) == std::nullopt);
  CHECK(components(mesh).count == 2);
  TriangleList expected = support::octahedron();
  for (const auto& [a, b, c] : support::octahedron()) expected.push_back({a + 6, b + 6, c + 6});
  CHECK(mesh.triangle_list() == expected);
  SurfaceMesh disk;
  for (int i = 0; i < 3; ++i) disk.add_vertex();
  disk.add_triangle(VertexId{0U}, VertexId{1U}, VertexId{2U});
  mesh.append(disk);
  CHECK(validate(mesh, Expect::Any) == std::nullopt);
  CHECK(components(mesh).count == 3);
}

TEST_CASE("a disk is a valid mesh but not a closed one") {
  SurfaceMesh mesh;
  const VertexId a = mesh.add_vertex(), b = mesh.add_vertex(), c = mesh.add_vertex();
  const VertexId d = mesh.add_vertex();
  const TriangleId s = mesh.add_triangle(a, b, c), t = mesh.add_triangle(c, b, d);
  mesh.glue(SurfaceMesh::half_edge(s, 1), SurfaceMesh::half_edge(t, 0));
  CHECK(validate(mesh, Expect::Any).value_or("") == "");
  CHECK(names_edge(validate(mesh).value_or(""), 0, 1));
}

TEST_CASE("validate sees two triangles that share an edge without being glued twice over") {
  // Two triangles back to back over one edge, and a third from it to elsewhere, unglued.
  SurfaceMesh mesh;
  for (int i = 0; i < 5; ++i) mesh.add_vertex();
  mesh.add_triangle(VertexId{0U}, VertexId{1U}, VertexId{2U});
  mesh.add_triangle(VertexId{0U}, VertexId{1U}, VertexId{3U});
  CHECK(validate(mesh, Expect::Any).has_value());
}

TEST_CASE("closed_mesh accepts a closed mesh, keeps its triangles and glues all its edges") {
  for (unsigned seed = 0; seed < 50; ++seed) {
    CAPTURE(seed);
    SurfaceMesh mesh = random_mesh(seed);
    mesh.compact();
    const MeshOrDefect built = closed_mesh(mesh.vertex_count(), mesh.triangle_list());
    REQUIRE(built.defect.value_or("") == "");
    CHECK(validate(built.mesh).value_or("") == "");
    CHECK(built.mesh.triangle_list() == mesh.triangle_list());
  }
}

TEST_CASE("closed_mesh takes no longer where two vertices are in all triangles, whichever ids") {
  constexpr std::uint32_t rim = 200'000;  // a search through all edges for each would take minutes
  for (const std::uint32_t first : {0U, rim}) {
    CAPTURE(first);
    const std::uint32_t top = first, bottom = first + 1, offset = first == 0 ? 2 : 0;
    TriangleList list;
    for (std::uint32_t i = 0; i < rim; ++i) {
      const std::uint32_t p = offset + i, q = offset + (i + 1) % rim;
      list.push_back({p, q, top});
      list.push_back({q, p, bottom});
    }
    support::Random random(3);
    for (std::size_t t = list.size(); t > 1; --t) std::swap(list[t - 1], list[random.below(t)]);
    const MeshOrDefect built = closed_mesh(rim + 2, list);
    REQUIRE(built.defect.value_or("") == "");
    CHECK(built.mesh.degree(VertexId{top}) == rim);
    CHECK(built.mesh.triangle_list() == list);
    list.back() = {top, bottom, list.back()[0]};
    CHECK(closed_mesh(rim + 2, list).defect.has_value());
  }
}

TEST_CASE("what is wrong at the first bad vertex is told the same by any number of threads") {
  // Spheres side by side, so many that threads share them, some with a vertex in common.
  for (unsigned seed = 0; seed < 20; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    TriangleList list;
    std::uint32_t count = 0;
    for (int sphere = 0; sphere < 3000; ++sphere) {
      const bool is_shared = count > 0 && random.below(1000) == 0;
      const std::uint32_t first = is_shared ? count - 1 : count;
      for (auto t : support::octahedron()) {
        for (std::uint32_t& v : t) v += first;
        list.push_back(t);
      }
      count = first + 6;
    }
    const MeshOrDefect glued = glued_mesh(count, list);
    REQUIRE(glued.defect.value_or("") == "");
    const std::optional<std::string> alone = fan_defect(glued.mesh, 1);
    CHECK(fan_defect(glued.mesh, 3) == alone);
    CHECK(alone.has_value() == (count < 3000 * 6));
    if (alone) CHECK(alone->ends_with(" is where two sheets touch"));
  }
}

TEST_CASE("closed_mesh names an edge of a hole") {
  for (std::size_t missing = 0; missing < 8; ++missing) {
    CAPTURE(missing);
    TriangleList list = support::octahedron();
    const auto [a, b, c] = list[missing];
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(missing));
    const std::string defect = closed_mesh(6, list).defect.value_or("");
    CAPTURE(defect);
    CHECK((names_edge(defect, a, b) || names_edge(defect, b, c) || names_edge(defect, c, a)));
    CHECK(defect.ends_with("has only one triangle"));
  }
}

TEST_CASE("closed_mesh names an edge of a triangle that faces the wrong way") {
  for (std::size_t turned = 0; turned < 8; ++turned) {
    CAPTURE(turned);
    TriangleList list = support::octahedron();
    const auto [a, b, c] = list[turned];
    list[turned] = {b, a, c};
    const std::string defect = closed_mesh(6, list).defect.value_or("");
    CAPTURE(defect);
    CHECK((names_edge(defect, a, b) || names_edge(defect, b, c) || names_edge(defect, c, a)));
    CHECK(defect.ends_with("disagree on orientation"));
  }
}

TEST_CASE("closed_mesh names an edge with three triangles") {
  TriangleList list = support::tetrahedron(0, 1, 2, 3);
  list.push_back({0, 1, 4});
  const std::string defect = closed_mesh(5, list).defect.value_or("");
  CAPTURE(defect);
  // The third triangle's other edges are defects too.
  CHECK((names_edge(defect, 0, 1) || names_edge(defect, 1, 4) || names_edge(defect, 4, 0)));
}

TEST_CASE("closed_mesh refuses an edge with four triangles, however they are paired") {
  // Two tetrahedra that share an edge: as two sheets they touch along it.
  TriangleList list = support::tetrahedron(0, 1, 2, 3);
  for (const auto& t : support::tetrahedron(0, 1, 4, 5)) list.push_back(t);
  const std::string defect = closed_mesh(6, list).defect.value_or("");
  CAPTURE(defect);
  CHECK((names_edge(defect, 0, 1) || defect.starts_with("vertex 0 ") ||
         defect.starts_with("vertex 1 ")));
  // A sphere with two edges between the same two vertices: one sheet, but the edge stands twice.
  list = {{0, 1, 2}, {1, 0, 3}, {1, 0, 2}, {0, 1, 3}};
  CHECK(closed_mesh(4, list).defect.has_value());
  for (const std::uint32_t inner :
       {4U, 6U}) {  // the same with more triangles between the two edges
    const std::uint32_t c = inner, d = inner + 1;
    const TriangleList half{{0, 1, c}, {1, 0, d}, {0, c, d}, {1, d, c}};
    list = half;
    for (auto t : half) {
      for (std::uint32_t& v : t) v = v < 2 ? 1 - v : v - (inner - 2);
      list.push_back(t);
    }
    CHECK(closed_mesh(inner + 2, list).defect.has_value());
  }
}

TEST_CASE("closed_mesh names the vertex where two sheets touch") {
  TriangleList list = support::tetrahedron(3, 1, 2, 0);
  for (const auto& t : support::tetrahedron(3, 4, 5, 6)) list.push_back(t);
  CHECK(closed_mesh(7, list).defect.value_or("") == "vertex 3 is where two sheets touch");
}

TEST_CASE("closed_mesh names a triangle that repeats a corner and a vertex that is not used") {
  TriangleList list = support::octahedron();
  list.push_back({4, 4, 5});
  CHECK(closed_mesh(6, list).defect.value_or("") == "triangle 8 repeats a corner");
  CHECK(closed_mesh(7, support::octahedron()).defect.value_or("") ==
        "vertex 6 belongs to no triangle");
}

// Found by mesh_fuzz: asking ahead for the first triangle looked for it among none.
TEST_CASE("closed_mesh names the first vertex of a mesh without triangles") {
  CHECK(closed_mesh(4, {}).defect.value_or("") == "vertex 0 belongs to no triangle");
  CHECK_FALSE(closed_mesh(0, {}).defect);
}

TEST_CASE("components are those that a search from triangle to triangle finds") {
  for (unsigned seed = 0; seed < 100; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    const std::size_t parts = 1 + random.below(6);
    TriangleList list;
    for (std::uint32_t p = 0; p < parts; ++p) {
      for (auto t : support::octahedron()) {
        for (std::uint32_t& v : t) v += 6 * p;
        list.push_back(t);
      }
    }
    for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
    const MeshOrDefect built = closed_mesh(6 * parts, list);
    REQUIRE(built.defect.value_or("") == "");
    const Components found = components(built.mesh);
    CHECK(found.count == parts);
    std::uint32_t seen = 0;
    for (std::size_t t = 0; t < list.size(); ++t) {
      CHECK(found.of_triangle[t] <= seen);  // numbered by their first triangle
      seen = std::max(seen, found.of_triangle[t] + 1);
      for (std::size_t s = 0; s < t; ++s) {
        CHECK((found.of_triangle[s] == found.of_triangle[t]) == (list[s][0] / 6 == list[t][0] / 6));
      }
    }
  }
}

TEST_CASE("as many triangles may be added as have half-edges with 32-bit ids, and no more") {
  constexpr std::size_t most = SurfaceMesh::max_triangles;
  CHECK(3 * most <= 0xFFFFFFFFU);  // the last half-edge is below the mark for a boundary
  CHECK(3 * (most + 1) > 0xFFFFFFFFU);
  CHECK_NOTHROW(geometry::require_capacity(most - 1, most, "triangles"));
  CHECK_THROWS_WITH_AS(geometry::require_capacity(most, most, "triangles"),
                       doctest::Contains("more than 1431655765 triangles"), geometry::LimitReached);
}
