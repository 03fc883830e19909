#include "geometry/last_visit.h"

#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <vector>

#include "geometry/mesh_data.h"
#include "tests/support/test.h"

using namespace morskin::geometry;

namespace {

constexpr std::size_t mebibyte = std::size_t{1} << 20;

std::size_t resident_bytes() {
  std::size_t whole = 0, resident = 0;
  std::ifstream("/proc/self/statm") >> whole >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

/// Triangles that share nothing, with a number of their own by vertex.
struct Scattered {
  Scattered(std::size_t triangles, std::uint32_t first_number) {
    mesh.reserve(3 * triangles);
    for (std::size_t v = 0; v < 3 * triangles; ++v) {
      const VertexId added = mesh.add_vertex();
      number[added] = first_number + added.value;
    }
    for (std::uint32_t v = 0; v < 3 * triangles; v += 3) {
      mesh.add_triangle(VertexId{v}, VertexId{v + 2}, VertexId{v + 1});
    }
  }
  SurfaceMesh mesh;
  VertexData<std::uint64_t> number{mesh};
};

}  // namespace

TEST_CASE("a last visit meets each element once, in order, and gives large arrays' pages back") {
  for (const std::size_t bytes :
       {std::size_t{0}, 12 * sizeof(std::uint32_t), 3 * mebibyte, 64 * mebibyte + 20}) {
    CAPTURE(bytes);
    std::vector<std::uint32_t> array(bytes / sizeof(std::uint32_t));
    for (std::uint32_t i = 0; i < array.size(); ++i) array[i] = i;
    const std::size_t before = resident_bytes();
    std::uint32_t next = 0;
    bool is_in_order = true;
    visit_last(array, [&](auto block) {
      for (const std::uint32_t x : block) is_in_order = is_in_order && x == next++;
    });
    CHECK(is_in_order);
    CHECK(next == array.size());
    const bool is_large = bytes > 8 * mebibyte;
    if (is_large) CHECK(resident_bytes() + 56 * mebibyte < before);
    if (!is_large) CHECK((array.empty() || array.back() == array.size() - 1));
    for (std::uint32_t& x : array) x = 7;  // it may be written again
    CHECK(std::ranges::count(array, 7U) == static_cast<std::ptrdiff_t>(array.size()));
  }
}

TEST_CASE("meshes so large that their pages are given back are appended and listed as small ones") {
  constexpr std::uint32_t triangles = 1'500'000;  // 34 MiB of half-edges and of data
  Scattered one(triangles, 5), other(triangles, 5 + 3 * triangles);
  one.mesh.append(std::move(other.mesh));
  REQUIRE(one.mesh.triangle_count() == 2 * triangles);
  REQUIRE(one.number.size() == 6 * std::size_t{triangles});
  bool is_kept = true;
  for (std::uint32_t v = 0; v < 6 * triangles; ++v) {
    is_kept = is_kept && one.number[VertexId{v}] == 5 + v;
  }
  CHECK(is_kept);
  const SurfaceMesh::Lists lists = one.mesh.turned_into_lists();
  CHECK(one.mesh.triangle_count() == 0);
  REQUIRE(lists.triangles.size() == 2 * triangles);
  bool is_listed = true;
  for (std::uint32_t t = 0; t < 2 * triangles; ++t) {
    is_listed = is_listed && lists.triangles[t] == TriangleCorners{3 * t, 3 * t + 2, 3 * t + 1};
  }
  CHECK(is_listed);
  CHECK(std::ranges::all_of(lists.twins, [](HalfEdgeId h) { return h == HalfEdgeId::none(); }));
}
