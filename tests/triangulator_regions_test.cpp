// Points inserted in several regions of space at once.

#include "geometry/stopwatch.h"
#include "geometry/triangulator.h"
#include "tests/support/triangulations.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

namespace {

using Tetrahedra = std::vector<std::array<std::uint32_t, 4>>;

/// Ghosts and apexes too: they stand by numbers that no atom has.
Tetrahedra sorted_tetrahedra(const Triangulator& triangulator) {
  Tetrahedra result;
  for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
    if (!triangulator.is_live(i)) continue;
    std::array<std::uint32_t, 4> ids;
    for (std::size_t k = 0; k < 4; ++k) {
      const Triangulator::Corner corner = triangulator.tetrahedra()[i].corners[k];
      const auto atom = triangulator.atom(corner);
      ids[k] = atom ? atom->value : std::max(corner, 0x80000000U);
    }
    std::sort(ids.begin(), ids.end());
    result.push_back(ids);
  }
  std::sort(result.begin(), result.end());
  return result;
}

/// Neighbours know each other, share three corners and are positively oriented unless ghosts.
bool is_consistent(const Triangulator& triangulator) {
  for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
    if (!triangulator.is_live(i)) continue;
    const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = Triangulator::tetrahedron_of(t.neighbours[k]);
      const std::size_t place = Triangulator::index_of(t.neighbours[k]);
      if (!triangulator.is_live(there)) return false;
      const Triangulator::Tetrahedron& other = triangulator.tetrahedra()[there];
      if (other.neighbours[place] != 4 * i + k) return false;
    }
  }
  return true;
}

void check_regions(const Points& points, std::span<const std::size_t> regions) {
  const Tetrahedra one_by_one =
      sorted_tetrahedra(Triangulator(points, Run(), std::max<std::size_t>(points.size(), 1)));
  for (const std::size_t region : regions) {
    CAPTURE(points.size());
    CAPTURE(region);
    const Triangulator in_regions(points, Run(2), region);
    CHECK(sorted_tetrahedra(in_regions) == one_by_one);
    CHECK(is_consistent(in_regions));
  }
}

constexpr std::array<std::size_t, 6> sizes{1, 2, 7, 40, 150, 600};

}  // namespace

TEST_CASE("regions of any size give the tetrahedra that one by one gives") {
  for_seeds(12, [&](unsigned seed) {
    const std::size_t count = 200 + 300 * (seed % 7);
    check_regions(random_points(seed, count, 0.01 * (seed % 4)), sizes);
  });
}

TEST_CASE("regions change nothing where every test is a tie") {
  check_regions(lattice(12, 12, 12), sizes);
  check_regions(lattice(7, 11, 19, 0.1), sizes);
  for_seeds(8, [&](unsigned seed) {
    check_regions(whole_points(seed, 1500, 3 + 4 * (seed % 3)), sizes);
  });
}

TEST_CASE("regions change nothing on a sphere, in a plane or on a line") {
  Random random(3);
  Points sphere, around{{{0, 0, 0}, 0}}, plane, line;
  for (int i = 0; i < 1200; ++i) {
    sphere.push_back({random.direction(), 0});
    around.push_back({random.direction(), 0});
    const Point p = random.direction();
    plane.push_back({{p.x(), p.y(), 0}, 0.1 * p.z()});
    line.push_back({{p.x(), 0, 0}, 0.01 * p.z()});
  }
  for (const Points& points :
       {sphere, around, plane, line, lattice(40, 40, 1), lattice(900, 1, 1)}) {
    check_regions(points, sizes);
  }
}

TEST_CASE("regions change nothing with heavy points, hidden points and clusters far apart") {
  for_seeds<std::mt19937_64>(6, [&](unsigned seed, std::mt19937_64& random) {
    Points points = random_points(seed, 1500, 0);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (i % 100 == 0) points[i].weight = 0.05;
      if (seed % 2 == 0) points[i].position += Point::Constant(1000.0 * static_cast<double>(i % 3));
      if (i % 10 == 0) points[i] = points[random() % points.size()];
    }
    points.push_back({{0.5, 0.5, 0.5}, 0.3});  // hides many and has hundreds of neighbours
    check_regions(points, sizes);
  });
}

TEST_CASE("regions are inserted in the same way by any number of threads") {
  const Points points = random_points(3, 30000, 0.0001);
  const Triangulator one(points, Run(1), 1000), three(points, Run(3), 1000);
  REQUIRE(one.tetrahedra().size() == three.tetrahedra().size());
  bool is_same = true;
  for (std::size_t i = 0; i < one.tetrahedra().size(); ++i) {
    is_same &= one.is_live(i) == three.is_live(i);
    if (!one.is_live(i)) continue;
    is_same &= one.tetrahedra()[i].corners == three.tetrahedra()[i].corners;
    is_same &= one.tetrahedra()[i].neighbours == three.tetrahedra()[i].neighbours;
  }
  CHECK(is_same);
  check_regions(points, std::array<std::size_t, 2>{1000, 5000});
}

TEST_CASE("every 4,096 points inserted are reported, each point counted once") {
  const std::size_t count = 30000, in_first_tetrahedron = 4;
  const Points points = random_points(5, count, 0);
  for (const unsigned threads : {1U, 3U}) {
    for (const std::size_t region : {std::size_t{1000}, count}) {
      CAPTURE(threads);
      CAPTURE(region);
      std::vector<double> shares;
      const Run run(threads, [&](std::string_view, double share) { shares.push_back(share); });
      const Triangulator all(points, run, region);
      CHECK(shares.size() == (count - in_first_tetrahedron) / 4096);
      CHECK(std::ranges::all_of(shares, [](double share) { return share > 0 && share <= 1; }));
    }
  }
}

TEST_CASE("a filament with two atoms in all its tetrahedra takes little longer in regions") {
  Points points{{{2.6, -1.2, 0.1}, 1}, {{1.3, -0.4, 0}, 1}};
  for (int i = 0; i < 40000; ++i) points.push_back({{0, 0.5 * i, 0}, 1});
  const auto seconds = [&](std::size_t region) {
    const Stopwatch watch;
    const Triangulator all(points, Run(), region);
    CHECK(all.dimension() == 3);
    return watch.seconds();
  };
  const double in_one = seconds(points.size());
  CHECK(seconds(Triangulator::usual_region) < 5 * in_one + 0.1);
}
