#include "certify/mesh_quality.h"

#include <numbers>

#include "geometry/parallel.h"
#include "tests/support/meshes.h"
#include "tests/support/test.h"

using namespace morskin;
using certify::measure_quality;
using certify::MeshQuality;
using geometry::IndexedMesh;
using geometry::Point;

namespace {

double angle_deg(const Point& at, const Point& p, const Point& q) {
  const geometry::Vector e = p - at, f = q - at;
  return std::atan2(e.cross(f).norm(), e.dot(f)) * 180 / std::numbers::pi;
}

/// Twice the inradius over the circumradius, by Heron's formula.
double radius_ratio(const Point& p, const Point& q, const Point& r) {
  const double a = (q - r).norm(), b = (r - p).norm(), c = (p - q).norm(), s = (a + b + c) / 2;
  const double area = std::sqrt(s * (s - a) * (s - b) * (s - c));
  return 2 * (area / s) / (a * b * c / (4 * area));
}

std::size_t sum(const auto& counts) {
  return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// A sphere's mesh with its vertices moved, from a little to beyond all shape.
IndexedMesh shaken_sphere(unsigned seed, support::Random& random, int levels = 2) {
  IndexedMesh mesh = support::sphere_mesh({0, 0, 0}, 1, levels);
  const double off = std::exp2(-static_cast<double>(seed % 8));
  for (Point& p : mesh.positions) p += off * random.direction();
  return mesh;
}

MeshQuality of_triangle(const Point& p, const Point& q, const Point& r) {
  return measure_quality({{p, q, r}, {{0, 1, 2}}});
}

/// Two apexes with `rim` neighbours each.
IndexedMesh bipyramid(std::uint32_t rim) {
  IndexedMesh mesh{{{0, 0, 1}, {0, 0, -1}}, {}};
  for (std::uint32_t k = 0; k < rim; ++k) {
    const double turn = 2 * std::numbers::pi * k / rim;
    mesh.positions.emplace_back(std::cos(turn), std::sin(turn), 0);
    const std::uint32_t a = 2 + k, b = 2 + (k + 1) % rim;
    mesh.triangles.push_back({a, b, 0});
    mesh.triangles.push_back({b, a, 1});
  }
  return mesh;
}

/// Turned any way: nothing here depends on orientation.
IndexedMesh icosahedron() {
  IndexedMesh mesh;
  for (const double one : {1.0, -1.0}) {
    for (const double golden : {std::numbers::phi, -std::numbers::phi}) {
      mesh.positions.insert(mesh.positions.end(),
                            {{0, one, golden}, {one, golden, 0}, {golden, 0, one}});
    }
  }
  const auto are_neighbours = [&](std::uint32_t a, std::uint32_t b) {
    return (mesh.positions[a] - mesh.positions[b]).norm() < 2.1;  // edges are 2 long
  };
  for (std::uint32_t c = 0; c < mesh.positions.size(); ++c) {
    for (std::uint32_t b = 0; b < c; ++b) {
      for (std::uint32_t a = 0; a < b; ++a) {
        if (are_neighbours(a, b) && are_neighbours(b, c) && are_neighbours(c, a)) {
          mesh.triangles.push_back({a, b, c});
        }
      }
    }
  }
  return mesh;
}

}  // namespace

TEST_CASE("triangles below and above an angle are those that a count one by one finds") {
  support::for_seeds<support::Random>(300, [&](unsigned seed, support::Random& random) {
    const IndexedMesh mesh = shaken_sphere(seed, random);
    const MeshQuality quality = measure_quality(mesh);
    std::vector<double> smallest, largest;
    for (const auto& [a, b, c] : mesh.triangles) {
      const Point &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
      const auto [low, high] =
          std::minmax({angle_deg(p, q, r), angle_deg(q, r, p), angle_deg(r, p, q)});
      smallest.push_back(low);
      largest.push_back(high);
    }
    const auto count = [](const std::vector<double>& angles, auto is_counted) {
      return static_cast<std::size_t>(std::ranges::count_if(angles, is_counted));
    };
    for (int deg = 0; deg <= 60; deg += MeshQuality::bin_deg) {
      CAPTURE(deg);
      CHECK(quality.triangles_below(deg) == count(smallest, [&](double x) { return x < deg; }));
    }
    for (int deg = 60; deg <= 180; deg += MeshQuality::bin_deg) {
      CAPTURE(deg);
      CHECK(quality.triangles_above(deg) == count(largest, [&](double x) { return x > deg; }));
    }
    CHECK(sum(quality.smallest_angles) == mesh.triangles.size());
    CHECK(sum(quality.largest_angles) == mesh.triangles.size());
  });
}

TEST_CASE("the radius ratios are those that Heron's formula gives") {
  support::for_seeds<support::Random>(300, [&](unsigned seed, support::Random& random) {
    const IndexedMesh mesh = shaken_sphere(seed, random);
    const MeshQuality quality = measure_quality(mesh);
    double least = 1, total = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const double ratio = radius_ratio(mesh.positions[a], mesh.positions[b], mesh.positions[c]);
      least = std::min(least, ratio);
      total += ratio;
    }
    CHECK(std::abs(quality.min_radius_ratio - least) < 1e-12);
    CHECK(quality.mean_radius_ratio ==
          doctest::Approx(total / static_cast<double>(mesh.triangles.size())).epsilon(1e-12));
  });
}

TEST_CASE("the valences of a closed mesh count the neighbours of its vertices") {
  for (std::uint32_t rim = 3; rim < 14; ++rim) {
    CAPTURE(rim);
    IndexedMesh mesh = bipyramid(rim);
    mesh.append(support::sphere_mesh({5, 0, 0}, 1, 2));
    std::map<std::uint32_t, std::set<std::uint32_t>> neighbours;
    for (const auto& [a, b, c] : mesh.triangles) {
      neighbours[a].insert({b, c});
      neighbours[b].insert({c, a});
      neighbours[c].insert({a, b});
    }
    std::array<std::size_t, 10> counts{};
    for (const auto& [v, others] : neighbours) ++counts[std::min<std::size_t>(others.size(), 9)];
    const MeshQuality quality = measure_quality(mesh);
    CHECK(quality.valences == counts);
    CHECK(quality.min_valence == std::min(rim, 4U));
    CHECK(quality.max_valence == std::max(rim, 6U));
  }
}

TEST_CASE("the icosahedron has sixty degrees and five neighbours everywhere and the ratio 1") {
  const MeshQuality quality = measure_quality(icosahedron());
  CHECK(quality.triangles == 20);
  CHECK(quality.smallest_angles.back() == 20);
  CHECK(quality.largest_angles.front() == 20);
  CHECK(quality.valences[5] == 12);
  CHECK(quality.min_radius_ratio == doctest::Approx(1));
  CHECK(quality.mean_radius_ratio == doctest::Approx(1));
}

TEST_CASE("a right angle is not above 90 degrees, wherever the triangle lies") {
  support::for_seeds<support::Random>(1000, [](support::Random& random) {
    const Point at(random.between(-9, 9), random.between(-9, 9), random.between(-9, 9));
    const Point p(at.x() + random.between(0.1, 9), at.y(), at.z());
    const Point q(at.x(), at.y(), at.z() + random.between(0.1, 9));
    const MeshQuality quality = of_triangle(p, at, q);
    CHECK(quality.triangles_above(85) == 1);
    CHECK(quality.triangles_above(90) == 0);
  });
}

TEST_CASE("a triangle without an area has the angles 0 and 180 degrees and the ratio 0") {
  const Point a(1, 2, 3), b(1, 2, 4), middle(1, 2, 3.5);
  for (const MeshQuality& quality :
       {of_triangle(a, b, middle), of_triangle(a, a, b), of_triangle(a, b, a), of_triangle(b, a, a),
        of_triangle(a, a, a), measure_quality({{a, b}, {{0, 1, 1}}}),
        measure_quality({{a}, {{0, 0, 0}}})}) {
    CHECK(quality.triangles_below(MeshQuality::bin_deg) == 1);
    CHECK(quality.triangles_above(180 - MeshQuality::bin_deg) == 1);
    CHECK(quality.min_radius_ratio == 0);
    CHECK(quality.mean_radius_ratio == 0);
  }
}

TEST_CASE("every triangle is counted once, of coordinates at both ends of the doubles too") {
  support::for_seeds<support::Random>(3000, [](unsigned seed, support::Random& random) {
    IndexedMesh mesh{{}, {{0, 1, 2}, {2, 1, 3}, {3, 1, 0}, {0, 0, 3}}};
    for (int v = 0; v < 4; ++v) {
      const int exponent = static_cast<int>(random.below(50)) - 25 + (seed % 2 == 0 ? 500 : -535);
      mesh.positions.push_back(random.direction() * std::ldexp(1.0, exponent));
    }
    const MeshQuality quality = measure_quality(mesh);
    CHECK(sum(quality.smallest_angles) == 4);
    CHECK(sum(quality.largest_angles) == 4);
    CHECK(sum(quality.valences) == 4);
    CHECK(quality.min_radius_ratio >= 0);
    CHECK(quality.min_radius_ratio <= 1);
  });
}

TEST_CASE("a mesh without triangles has no shares, and ratios that are no numbers") {
  for (const IndexedMesh& mesh : {IndexedMesh{}, IndexedMesh{{{1, 2, 3}}, {}}}) {
    const MeshQuality quality = measure_quality(mesh);
    CHECK(quality.triangles_below(60) == 0);
    CHECK(quality.triangles_above(60) == 0);
    CHECK(quality.valences[0] == mesh.positions.size());
    CHECK(std::isnan(quality.min_radius_ratio));
    CHECK(std::isnan(quality.mean_radius_ratio));
  }
}

TEST_CASE("the quality of a mesh is the same to the last bit for any number of threads") {
  support::Random random(1);
  const IndexedMesh mesh = shaken_sphere(6, random, 6);
  REQUIRE(geometry::block_count(mesh.triangles.size()) > 3);
  const MeshQuality one = measure_quality(mesh);
  for (const unsigned threads : {0U, 2U, 3U, 7U}) {
    const MeshQuality more = measure_quality(mesh, geometry::Run(threads));
    CHECK(more.smallest_angles == one.smallest_angles);
    CHECK(more.largest_angles == one.largest_angles);
    CHECK(more.valences == one.valences);
    CHECK(more.min_valence == one.min_valence);
    CHECK(more.max_valence == one.max_valence);
    CHECK(more.min_radius_ratio == one.min_radius_ratio);
    CHECK(more.mean_radius_ratio == one.mean_radius_ratio);
  }
}
