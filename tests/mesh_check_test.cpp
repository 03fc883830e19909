#include "geometry/mesh_check.h"

#include <numbers>

#include "geometry/mesh_shape.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::geometry;
using support::Random;

namespace {

IndexedMesh sphere(int levels = 2) { return support::sphere_mesh({0, 0, 0}, 1, levels); }

/// The only kind of defect that a mesh has, how often, and the first in words.
void check_only(const IndexedMesh& mesh, MeshDefect kind, std::size_t count,
                const std::string& first) {
  const MeshCheck check = check_mesh(mesh);
  REQUIRE(check.defects.size() == 1);
  CHECK(check.defects[0].kind == kind);
  CHECK(check.defects[0].count == count);
  CHECK(check.defects[0].first == first);
  CHECK(check.find(kind) == &check.defects[0]);
}

IndexedMesh without_triangle(IndexedMesh mesh, std::size_t t) {
  mesh.triangles.erase(mesh.triangles.begin() + static_cast<std::ptrdiff_t>(t));
  return mesh;
}

IndexedMesh inside_out(IndexedMesh mesh) {
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  return mesh;
}

/// A torus of n by m vertices with radii 3 and 1.
IndexedMesh torus(std::uint32_t n, std::uint32_t m) {
  IndexedMesh mesh;
  for (std::uint32_t i = 0; i < n; ++i) {
    for (std::uint32_t j = 0; j < m; ++j) {
      const double a = 2 * M_PI * i / n, b = 2 * M_PI * j / m, r = 3 + std::cos(b);
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), std::sin(b));
      const auto at = [&](std::uint32_t k, std::uint32_t l) { return k % n * m + l % m; };
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("a sphere, a torus, and a sphere in a sphere are closed, with their genus and volume") {
  const MeshCheck ball = check_mesh(sphere(4));
  CHECK(ball.is_closed_oriented_manifold());
  REQUIRE(ball.components.size() == 1);
  CHECK(ball.components[0].genus() == 0);
  CHECK(ball.components[0].volume == doctest::Approx(4 * M_PI / 3).epsilon(0.01));
  CHECK(ball.components[0].area == doctest::Approx(4 * M_PI).epsilon(0.01));

  const MeshCheck ring = check_mesh(torus(40, 20));
  CHECK(ring.is_closed_oriented_manifold());
  REQUIRE(ring.components.size() == 1);
  CHECK(ring.components[0].genus() == 1);
  CHECK(ring.components[0].euler_characteristic() == 0);
  CHECK(ring.components[0].volume == doctest::Approx(6 * M_PI * M_PI).epsilon(0.03));

  IndexedMesh shell = support::sphere_mesh({90, 0, 0}, 2, 3);
  shell.append(inside_out(support::sphere_mesh({90, 0, 0}, 1, 3)));
  shell.append(torus(9, 7));
  const MeshCheck check = check_mesh(shell);
  CHECK(check.is_closed_oriented_manifold());
  REQUIRE(check.components.size() == 3);
  CHECK(check.components[0].volume > 0);
  CHECK(check.components[1].volume == doctest::Approx(-check.components[0].volume / 8));
  CHECK(check.components[2].genus() == 1);
  CHECK(check.components[1].first_triangle == check.components[0].triangles);
  CHECK(check.component_of_triangle.back() == 2);
}

TEST_CASE("each kind of defect is counted and its first element named") {
  check_only({}, MeshDefect::NoTriangles, 1, "no triangles");

  IndexedMesh bad = sphere();
  const auto [a, b, c] = bad.triangles[5];
  bad = without_triangle(bad, 5);
  const auto least = std::min({std::pair(std::min(a, b), std::max(a, b)),
                               std::pair(std::min(b, c), std::max(b, c)),
                               std::pair(std::min(c, a), std::max(c, a))});
  check_only(bad, MeshDefect::BoundaryEdge, 3,
             "edge " + std::to_string(least.first) + "-" + std::to_string(least.second) +
                 " has only one triangle");
  CHECK_FALSE(check_mesh(bad).components[0].is_closed_and_oriented);

  bad = sphere();
  std::swap(bad.triangles[5][0], bad.triangles[5][1]);
  check_only(bad, MeshDefect::DisagreeingTriangles, 3,
             "edge " + std::to_string(least.first) + "-" + std::to_string(least.second) +
                 ": its triangles disagree on orientation");

  bad = sphere();
  bad.positions.emplace_back(7, 7, 7);
  check_only(bad, MeshDefect::UnusedVertex, 1,
             "vertex " + std::to_string(bad.positions.size() - 1) + " belongs to no triangle");

  // Two spheres made to share vertex 1: two sheets touch there.
  bad = sphere();
  const auto shift = static_cast<std::uint32_t>(bad.positions.size());
  bad.append(support::sphere_mesh({-2, 0, 0}, 1, 2));
  for (auto& t : bad.triangles) std::ranges::replace(t, shift, 1U);
  bad.positions[shift] = bad.positions.back();
  for (auto& t : bad.triangles) {
    std::ranges::replace(t, static_cast<std::uint32_t>(bad.positions.size() - 1), shift);
  }
  bad.positions.pop_back();
  check_only(bad, MeshDefect::SplitVertex, 1, "vertex 1 is where two sheets touch");
  CHECK(check_mesh(bad).components.size() == 2);
  CHECK(check_mesh(bad).components[1].genus() == 0);
  // The sheets are told apart wherever the first and the last triangle at the vertex lie.
  for (std::size_t i = 0; i < bad.triangles.size(); ++i) {
    std::rotate(bad.triangles.begin(), bad.triangles.begin() + 1, bad.triangles.end());
    check_only(bad, MeshDefect::SplitVertex, 1, "vertex 1 is where two sheets touch");
  }
}

TEST_CASE("a triangle that stands twice is a duplicate, whichever way round the second is") {
  for (const bool is_turned : {false, true}) {
    IndexedMesh bad = sphere();
    bad.triangles.push_back(bad.triangles[9]);
    if (is_turned) std::swap(bad.triangles.back()[1], bad.triangles.back()[2]);
    const MeshCheck check = check_mesh(bad);
    REQUIRE(check.find(MeshDefect::DuplicateTriangle) != nullptr);
    CHECK(check.find(MeshDefect::DuplicateTriangle)->count == 1);
    CHECK(check.find(MeshDefect::DuplicateTriangle)->first ==
          "triangles 9 and " + std::to_string(bad.triangles.size() - 1) + " have the same corners");
    CHECK(check.find(MeshDefect::CrowdedEdge)->count == 3);
  }
  const IndexedMesh pillow{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}}};
  check_only(pillow, MeshDefect::DuplicateTriangle, 1, "triangles 0 and 1 have the same corners");
}

TEST_CASE("degenerate triangles are found exactly, at any scale") {
  for (const double scale : {1.0, 0x1p-800, 0x1p800}) {
    CAPTURE(scale);
    IndexedMesh mesh = sphere(0);
    mesh.positions[4] = Point(0.5, 0.5, 0);  // on the edge from (1, 0, 0) to (0, 1, 0)
    for (Point& p : mesh.positions) p *= scale;
    check_only(mesh, MeshDefect::Collinear, 1, "triangle 0 has its corners on one line");
    mesh.positions[4].x() = std::nextafter(mesh.positions[4].x(), 0);
    CHECK(check_mesh(mesh).is_closed_oriented_manifold());
  }
  for (const bool is_first : {true, false}) {
    IndexedMesh mesh = sphere();
    mesh.triangles.insert(is_first ? mesh.triangles.begin() : mesh.triangles.end(), {3, 3, 4});
    const std::size_t place = is_first ? 0 : mesh.triangles.size() - 1;
    check_only(mesh, MeshDefect::RepeatedCorner, 1,
               "triangle " + std::to_string(place) + " repeats a corner");
  }
}

TEST_CASE(
    "all triangles at one edge or one vertex are checked in time that grows with their number") {
  // A million operations; were each triangle held against all others, 40,000 million.
  constexpr std::uint32_t count = 200'000;
  IndexedMesh fan, cone;
  for (std::uint32_t i = 0; i < count + 2; ++i) {
    const double angle = 2 * M_PI * i / count;
    fan.positions.emplace_back(std::cos(angle), std::sin(angle), i);
  }
  cone.positions = fan.positions;
  cone.positions[0] = {0, 0, 1};
  cone.positions[1] = {0, 0, -1};
  for (std::uint32_t i = 2; i < count + 2; ++i) {
    fan.triangles.push_back({0, 1, i});
    const std::uint32_t next = i + 1 < count + 2 ? i + 1 : 2;
    cone.triangles.push_back({0, i, next});
    cone.triangles.push_back({1, next, i});
    cone.positions[i].z() = 0;
  }
  Random(1).shuffle(cone.triangles);
  const MeshCheck crowded = check_mesh(fan);
  REQUIRE(crowded.find(MeshDefect::CrowdedEdge) != nullptr);
  CHECK(crowded.find(MeshDefect::CrowdedEdge)->first == "edge 0-1 has 200000 triangles");
  CHECK(crowded.find(MeshDefect::DuplicateTriangle) == nullptr);
  CHECK(check_mesh(cone).is_closed_oriented_manifold());
  CHECK_FALSE(geometry::closed_mesh(cone.positions.size(), cone.triangles).defect);
}

TEST_CASE("a spoiled mesh has a defect exactly when closed_mesh finds one") {
  std::size_t good = 0;
  support::for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    IndexedMesh mesh = sphere(static_cast<int>(seed % 3));
    for (std::size_t step = random.below(3); step > 0; --step) {
      auto& t = mesh.triangles[random.below(mesh.triangles.size())];
      const std::size_t k = random.below(3);
      switch (random.below(4)) {
        case 0:
          std::rotate(t.begin(), t.begin() + 1, t.end());  // harmless
          break;
        case 1:
          std::swap(t[k], t[(k + 1) % 3]);
          break;
        case 2:
          t[k] = static_cast<std::uint32_t>(random.below(mesh.positions.size()));
          break;
        default:
          std::swap(t, mesh.triangles.back());
          mesh.triangles.pop_back();
      }
    }
    const auto built = geometry::closed_mesh(mesh.positions.size(), mesh.triangles);
    const MeshCheck check = check_mesh(mesh);
    CHECK(check.is_closed_oriented_manifold() == !built.defect);
    if (built.defect) return;
    ++good;
    CHECK(check.components.size() == geometry::components(built.mesh).count);
    CHECK(check.component_of_triangle == geometry::components(built.mesh).of_triangle);
  });
  CHECK(good > 300);
  CHECK(good < 900);
}

TEST_CASE("the shape of a mesh is the sum of its triangles and does not change when it is moved") {
  const IndexedMesh mesh = sphere(3);
  const geometry::MeshShape shape = geometry::measure_shape(mesh);
  double area = 0, volume = 0;
  for (const auto& c : check_mesh(mesh).components) {
    area += c.area;
    volume += c.volume;
  }
  CHECK(shape.area == doctest::Approx(area));
  CHECK(shape.volume == doctest::Approx(volume));
  const geometry::MeshShape moved =
      geometry::measure_shape(support::sphere_mesh({1000, -2000, 500}, 1, 3));
  CHECK(moved.volume == doctest::Approx(shape.volume).epsilon(1e-9));
  CHECK(moved.min_angle_deg == doctest::Approx(shape.min_angle_deg).epsilon(1e-6));
}

TEST_CASE("the extreme angles of a mesh are exactly those of its triangles one by one") {
  support::for_seeds<support::Random>(300, [&](unsigned seed, support::Random& random) {
    IndexedMesh mesh = sphere(2);
    // From all but regular triangles to flat ones, and some with a side of length zero.
    const double off = std::exp2(-static_cast<double>(seed % 30));
    for (geometry::Point& p : mesh.positions) p += off * random.direction();
    if (seed % 5 == 0) mesh.triangles[random.below(mesh.triangles.size())][0] = 0;
    if (seed % 7 == 0) mesh.positions[3] = mesh.positions[random.below(mesh.positions.size())];
    double largest = -1, smallest = 1, area = 0, volume = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const auto t = geometry::triangle_shape(mesh.positions[a], mesh.positions[b],
                                              mesh.positions[c], mesh.positions[0]);
      largest = std::max(largest, t.largest_cosine);
      smallest = std::min(smallest, t.smallest_cosine);
      area += t.area;
      volume += t.volume;
    }
    const geometry::MeshShape shape = geometry::measure_shape(mesh);
    CHECK(shape.min_angle_deg == std::acos(std::min(largest, 1.0)) * (180 / std::numbers::pi));
    CHECK(shape.max_angle_deg == std::acos(std::max(smallest, -1.0)) * (180 / std::numbers::pi));
    CHECK(shape.area == area);
    CHECK(shape.volume == volume);
  });
}

TEST_CASE("a mesh measured in parts, in any order, has the shape of the whole") {
  const IndexedMesh mesh = sphere(3);
  const geometry::MeshShape whole = geometry::measure_shape(mesh);
  geometry::ShapeMeasure measured(mesh);
  std::array parts{measured, measured, measured};
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) parts[t * t % 3].add(mesh.triangles[t]);
  for (const auto& part : parts) measured.add(part);
  CHECK(measured.shape().min_angle_deg == whole.min_angle_deg);
  CHECK(measured.shape().max_angle_deg == whole.max_angle_deg);
  CHECK(measured.shape().area == doctest::Approx(whole.area).epsilon(1e-14));
  CHECK(measured.shape().volume == doctest::Approx(whole.volume).epsilon(1e-13));
}

TEST_CASE("the angles of needles are told, of which cosines tell nothing") {
  for (const double height : {1e-3, 1e-6, 1e-9, 1e-12, 1e-100}) {
    const IndexedMesh needle{{{0, 0, 0}, {1, 0, 0}, {0.5, height, 0}, {0.5, 0.3, 1}},
                             {{0, 1, 2}, {0, 1, 3}}};
    const geometry::MeshShape shape = geometry::measure_shape(needle);
    const double angle = std::atan(2 * height) * (180 / std::numbers::pi);
    CHECK(shape.min_angle_deg == doctest::Approx(angle).epsilon(1e-9).scale(0));
    CHECK(shape.max_angle_deg == doctest::Approx(180 - 2 * angle).epsilon(1e-12));
  }
}

TEST_CASE("the histogram counts three angles a triangle, each in its ten degrees") {
  const IndexedMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5, 0, 0}},
                         {{0, 1, 2}, {0, 1, 3}, {0, 0, 1}}};
  const geometry::AngleHistogram counts = geometry::angle_histogram(mesh);
  CHECK(std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == 9);
  CHECK(counts[9] == 1);   // the right angle
  CHECK(counts[4] == 2);   // 45 degrees twice
  CHECK(counts[17] == 2);  // the flat one, and one at the side of length zero
}
