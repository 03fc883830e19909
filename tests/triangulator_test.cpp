#include "geometry/triangulator.h"

#include "tests/support/triangulations.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::support;

TEST_CASE("points added one by one give the triangulation of all at once") {
  std::vector<Points> sets{lattice(5, 5, 5), lattice(3, 4, 7, 0.1)};
  for (unsigned seed = 0; seed < 40; ++seed) sets.push_back(random_points(seed, 5 + 5 * seed, 0));
  // On a sphere, to rounding: every tetrahedron has nearly the same circumsphere.
  Random random(5);
  sets.emplace_back();
  for (int i = 0; i < 300; ++i) sets.back().push_back({random.direction(), 0});
  for (Points& points : sets) {
    CAPTURE(points.size());
    random.shuffle(points);
    std::size_t first = 4;
    while (regular_triangulation({points.begin(), points.begin() + static_cast<long>(first)})
               .dimension < 3) {
      ++first;
    }
    Triangulator triangulator(std::span<const WeightedPoint>(points).first(first));
    bool is_bookkeeping_right = true;
    for (std::size_t i = first; i < points.size(); ++i) {
      // Hints may be anywhere: any live tetrahedron will do.
      std::array<std::uint32_t, 2> hints{};
      for (std::uint32_t& hint : hints) {
        do {
          hint = static_cast<std::uint32_t>(random.below(triangulator.tetrahedra().size()));
        } while (!triangulator.is_live(hint));
      }
      const auto corner = triangulator.add(points[i], hints);
      REQUIRE(corner);
      is_bookkeeping_right &= *corner == i && triangulator.atom(*corner) == AtomId(i);
      for (const std::uint32_t t : triangulator.added()) {
        const auto& corners = triangulator.tetrahedra()[t].corners;
        is_bookkeeping_right &=
            triangulator.is_live(t) && std::ranges::count(corners, *corner) == 1;
      }
    }
    CHECK(is_bookkeeping_right);
    CHECK_FALSE(triangulator.add(points[0], {triangulator.added()[0], triangulator.added()[0]}));
    std::vector<std::array<AtomId, 4>> tetrahedra;
    for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
      if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
      std::array<AtomId, 4> ids;
      for (std::size_t k = 0; k < 4; ++k) ids[k] = *triangulator.atom(t.corners[k]);
      std::sort(ids.begin(), ids.end());
      tetrahedra.push_back(ids);
    }
    std::sort(tetrahedra.begin(), tetrahedra.end());
    CHECK(tetrahedra == regular_triangulation(points).tetrahedra);
  }
}

TEST_CASE("neighbouring tetrahedra of the triangulator know each other and share three corners") {
  for (const Points& points : {random_points(1, 500, 0.01), lattice(6, 6, 6), lattice(5, 5, 1)}) {
    const Triangulator triangulator(points);
    bool is_consistent = true;
    for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
      if (!triangulator.is_live(i)) continue;
      const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
      for (std::size_t k = 0; k < 4; ++k) {
        const Triangulator::Facet behind = t.neighbours[k];
        const std::uint32_t there = Triangulator::tetrahedron_of(behind);
        const std::size_t place = Triangulator::index_of(behind);
        const Triangulator::Tetrahedron& other = triangulator.tetrahedra()[there];
        auto mine = t.corners, theirs = other.corners;
        std::swap(mine[k], mine[3]);
        std::swap(theirs[place], theirs[3]);
        std::sort(mine.begin(), mine.end() - 1);
        std::sort(theirs.begin(), theirs.end() - 1);
        is_consistent &= triangulator.is_live(there) && other.neighbours[place] == 4 * i + k &&
                         std::equal(mine.begin(), mine.end() - 1, theirs.begin());
      }
    }
    CHECK(is_consistent);
  }
}
