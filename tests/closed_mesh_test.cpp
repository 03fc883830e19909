// How a mesh is put together from a list of triangles, and what is said to be wrong with it.

#include <numeric>

#include "geometry/mesh_shape.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

bool names_edge(const std::string& text, std::uint32_t a, std::uint32_t b) {
  const auto edge = [](std::uint32_t p, std::uint32_t q) {
    return "edge " + std::to_string(p) + "-" + std::to_string(q);
  };
  return text.starts_with(edge(a, b)) || text.starts_with(edge(b, a));
}

/// The defect of a list names an edge of a triangle and says this of it.
void check_edge_named(const TriangleList& list, const std::array<std::uint32_t, 3>& triangle,
                      std::string_view ending) {
  const auto [a, b, c] = triangle;
  const std::string defect = closed_mesh(6, list).defect.value_or("");
  CAPTURE(defect);
  CHECK((names_edge(defect, a, b) || names_edge(defect, b, c) || names_edge(defect, c, a)));
  CHECK(defect.ends_with(ending));
}

}  // namespace

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
    Random(3).shuffle(list);
    const auto built = closed_mesh(rim + 2, list);
    REQUIRE(built.defect.value_or("") == "");
    CHECK(built.mesh.degree(VertexId{top}) == rim);
    CHECK(built.mesh.triangle_list() == list);
    list.back() = {top, bottom, list.back()[0]};
    CHECK(closed_mesh(rim + 2, list).defect.has_value());
  }
}

TEST_CASE("what is wrong at the first bad vertex is told the same by any number of threads") {
  // Spheres side by side, so many that threads share them, some with a vertex in common.
  for_seeds<Random>(20, [&](Random& random) {
    TriangleList list;
    std::uint32_t count = 0;
    for (int sphere = 0; sphere < 3000; ++sphere) {
      const bool is_shared = count > 0 && random.below(1000) == 0;
      const std::uint32_t first = is_shared ? count - 1 : count;
      append(list, octahedron(), first);
      count = first + 6;
    }
    const auto glued = glued_triangles(count, list);
    REQUIRE(glued.defect.value_or("") == "");
    const std::optional<std::string> alone = fan_defect(glued.mesh, 1);
    CHECK(fan_defect(glued.mesh, 3) == alone);
    CHECK(alone.has_value() == (count < 3000 * 6));
    if (alone) CHECK(alone->ends_with(" is where two sheets touch"));
  });
}

TEST_CASE("closed_mesh names an edge of a hole") {
  for (std::size_t missing = 0; missing < 8; ++missing) {
    CAPTURE(missing);
    TriangleList list = octahedron();
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(missing));
    check_edge_named(list, octahedron()[missing], "has only one triangle");
  }
}

TEST_CASE("closed_mesh names an edge of a triangle that faces the wrong way") {
  for (std::size_t turned = 0; turned < 8; ++turned) {
    CAPTURE(turned);
    TriangleList list = octahedron();
    std::swap(list[turned][0], list[turned][1]);
    check_edge_named(list, octahedron()[turned], "disagree on orientation");
  }
}

TEST_CASE("closed_mesh names an edge with three triangles") {
  TriangleList list = tetrahedron(0, 1, 2, 3);
  list.push_back({0, 1, 4});
  const std::string defect = closed_mesh(5, list).defect.value_or("");
  CAPTURE(defect);
  // The third triangle's other edges are defects too.
  CHECK((names_edge(defect, 0, 1) || names_edge(defect, 1, 4) || names_edge(defect, 4, 0)));
}

TEST_CASE("closed_mesh refuses an edge with four triangles, however they are paired") {
  // Two tetrahedra that share an edge: as two sheets they touch along it.
  TriangleList list = tetrahedron(0, 1, 2, 3);
  append(list, tetrahedron(0, 1, 4, 5), 0);
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
  TriangleList list = tetrahedron(3, 1, 2, 0);
  append(list, tetrahedron(3, 4, 5, 6), 0);
  CHECK(closed_mesh(7, list).defect.value_or("") == "vertex 3 is where two sheets touch");
}

TEST_CASE("closed_mesh names a triangle that repeats a corner and a vertex that is not used") {
  TriangleList list = octahedron();
  list.push_back({4, 4, 5});
  CHECK(closed_mesh(6, list).defect.value_or("") == "triangle 8 repeats a corner");
  CHECK(closed_mesh(7, octahedron()).defect.value_or("") == "vertex 6 belongs to no triangle");
}

// Found by mesh_fuzz: asking ahead for the first triangle looked for it among none.
TEST_CASE("closed_mesh names the first vertex of a mesh without triangles") {
  CHECK(closed_mesh(4, {}).defect.value_or("") == "vertex 0 belongs to no triangle");
  CHECK_FALSE(closed_mesh(0, {}).defect);
}

TEST_CASE("components are those that a search from triangle to triangle finds") {
  for_seeds<Random>(100, [&](Random& random) {
    const std::size_t parts = 1 + random.below(6);
    TriangleList list;
    for (std::uint32_t p = 0; p < parts; ++p) {
      append(list, octahedron(), 6 * p);
    }
    random.shuffle(list);
    const auto built = closed_mesh(6 * parts, list);
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
  });
}

TEST_CASE("vertices are of one component just where triangles join them, numbered from the first") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    Random random(seed);
    IndexedMesh mesh{std::vector<Point>(60), {}};
    const auto vertex = [&] { return static_cast<std::uint32_t>(59.9 * random.uniform()); };
    for (unsigned i = 0; i < seed / 4; ++i) {
      const std::uint32_t a = vertex();  // some near each other in the list, some far apart
      mesh.triangles.push_back({a, seed % 2 == 0 ? (a + 1) % 60 : vertex(), vertex()});
    }
    // The least vertex that can be reached, by repeating until nothing changes.
    std::vector<std::uint32_t> least(60);
    std::iota(least.begin(), least.end(), 0U);
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (const auto& corners : mesh.triangles) {
        for (const std::uint32_t v : corners) {
          for (const std::uint32_t w : corners) {
            if (least[w] >= least[v]) continue;
            least[v] = least[w];
            is_changed = true;
          }
        }
      }
    }
    std::vector<std::uint32_t> expected(60);
    std::uint32_t count = 0;
    for (std::uint32_t v = 0; v < 60; ++v) {
      expected[v] = least[v] == v ? count++ : expected[least[v]];
    }
    CHECK(vertex_components(mesh) == expected);
  }
}
