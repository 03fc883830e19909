// The mixed complex: mathematics.md section 11, T1.

#include "skin/mixed_complex.h"

#include "geometry/parallel.h"
#include "tests/support/skin_case.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

bool is_same_wall(const Wall& a, const Wall& b) {
  return a.normal == b.normal && a.offset == b.offset && a.beyond == b.beyond;
}

/// Of a cell's atoms.
double heaviest(const SkinCase& test, CellId cell) {
  double weight = -INFINITY;
  for (const AtomId a : test.skin.atoms(cell)) {
    weight = std::max(weight, test.skin.points()[a.index()].weight);
  }
  return weight;
}

}  // namespace

TEST_CASE("a wall seen from the other side is the same plane") {
  for_seeds<SkinCase>(100, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    for (std::size_t i = 0; i < complex.size(); ++i) {
      for (const Wall& wall : complex.walls(CellId{i})) {
        const auto back = complex.walls(wall.beyond);
        CHECK(std::count_if(back.begin(), back.end(), [&](const Wall& other) {
                return other.beyond == CellId{i} && other.normal == -wall.normal &&
                       other.offset == -wall.offset;
              }) == 1);
        CHECK(std::abs(complex.dimension(wall.beyond) - complex.dimension(CellId{i})) == 1);
      }
    }
  });
}

TEST_CASE("walls made on demand are the kept ones, in the same order") {
  std::size_t kept = 0;
  for_seeds<SkinCase>(100, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    kept += complex.kept_size();
    for (std::uint32_t i = 0; i < complex.kept_size(); ++i) {
      const std::vector<Wall> made = complex.make_walls(CellId{i});
      CHECK(std::ranges::equal(made, complex.kept_walls(CellId{i}), is_same_wall));
    }
  });
  CHECK(kept > 1000);  // the law was put to the test
}

TEST_CASE("the complex is the same made by one thread and by several") {
  const WeightedPoints points = in_a_row(molecule("1crn.pdb", skin::Model::Vdw), 4, 20);
  const SkinSurface alone(points), together(points, MixedComplex::Keep::NearSkin, geometry::Run(4));
  const MixedComplex &one = alone.complex(), &other = together.complex();
  REQUIRE(one.kept_size() == other.kept_size());
  CHECK(one.kept_size() > 2 * geometry::usual_block);  // there was work for more than one
  for (std::uint32_t i = 0; i < one.kept_size(); ++i) {
    const CellId cell{i};
    const Patch &p = one.kept_patch(cell), &q = other.kept_patch(cell);
    REQUIRE(one.number(cell) == other.number(cell));
    REQUIRE((p.centre == q.centre && p.axis == q.axis && p.half_weight == q.half_weight));
    REQUIRE(std::ranges::equal(one.kept_walls(cell), other.kept_walls(cell), is_same_wall));
  }
}

TEST_CASE("walls made on demand are the same once the lists of facets are forgotten") {
  for_seeds<SkinCase>(100, [&](SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    std::vector<std::vector<Wall>> before;
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      before.push_back(complex.make_walls(CellId{i}));
    }
    test.skin.forget_facets();
    CHECK(complex.triangulation().triangle_edges.capacity() == 0);
    CHECK(complex.triangulation().tetrahedron_triangles.capacity() == 0);
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      CHECK(std::ranges::equal(before[i], complex.make_walls(CellId{i}), is_same_wall));
    }
  });
}

TEST_CASE("in a ball that holds thousands each simplex has a wall to each facet, and it one back") {
  // 8,000 edges of the large ball; were each asked for some 30,000 of its cells, 240 million.
  const SkinSurface skin(seeds_in_a_ball(8000));
  const MixedComplex& complex = skin.complex();
  const auto& t = complex.triangulation();
  CHECK(complex.kept_walls(complex.cell(AtomId{0U})).size() > 7000);
  std::size_t walls = 0;
  for (std::uint32_t i = 0; i < complex.size(); ++i) walls += complex.walls(CellId{i}).size();
  CHECK(walls == 2 * (2 * t.edges.size() + 3 * t.triangles.size() + 4 * t.tetrahedra.size()));
}

TEST_CASE("a cell is left out only if the ranges of power and weight on it do not overlap") {
  // By the definition, tetrahedron by tetrahedron, with no short cut for what lies deep inside.
  std::size_t left_out = 0;
  for_seeds<SkinCase>(300, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    const auto& t = complex.triangulation();
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      const auto simplex = test.skin.atoms(CellId{i});
      const double most = heaviest(test, CellId{i});
      const double w = 2 * complex.patch(CellId{i}).half_weight;
      const double slack = 4 * MixedComplex::nearness * std::abs(most);
      // Of the tetrahedra about it; a cell with an unbounded dual has no largest power.
      double largest = -std::numeric_limits<double>::infinity();
      for (std::size_t s = 0; s < t.tetrahedra.size(); ++s) {
        if (std::ranges::includes(t.tetrahedra[s], simplex)) {
          largest = std::max(largest, -2 * complex.patch(complex.cell(3, s)).half_weight);
        }
      }
      constexpr double doubt = 1e-4;  // of the slack: how far rough weights are off, and more
      if (-w > most + (1 + doubt) * slack) CHECK_FALSE(complex.is_kept(CellId{i}));
      if (complex.is_kept(CellId{i})) continue;
      ++left_out;
      CHECK((-w > most + (1 - doubt) * slack || largest + (1 - doubt) * slack < w));
    }
  });
  CHECK(left_out > 1000);  // the law was put to the test
}

TEST_CASE("a cell's dimension and place lead back to the cell, and every simplex has one") {
  for_seeds<SkinCase>(100, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    const auto& t = complex.triangulation();
    const std::array sizes{t.vertices.size(), t.edges.size(), t.triangles.size(),
                           t.tetrahedra.size()};
    std::vector<char> is_met(complex.size(), 0);
    for (std::size_t d = 0; d < 4; ++d) {
      for (std::size_t place = 0; place < sizes[d]; ++place) {
        const CellId cell = complex.cell(static_cast<int>(d), place);
        REQUIRE(cell.index() < complex.size());
        is_met[cell.index()] = 1;
        CHECK(complex.dimension(cell) == static_cast<int>(d));
        CHECK(complex.simplex_index(cell) == place);
      }
    }
    CHECK(std::ranges::count(is_met, 0) == 0);
  });
}

TEST_CASE("every point of the skin, and near it, lies in a cell that is kept") {
  std::size_t near = 0;
  for_points(40, [&](SkinCase& test, const Point& x) {
    const MixedComplex& complex = test.skin.complex();
    const CellId cell = test.cell_of(x);
    if (const auto p = test.skin.project(x, cell)) CHECK(complex.is_kept(p->cell));
    const double g = complex.patch(cell).value(x);
    if (std::abs(g) > 0.99 * MixedComplex::nearness * std::abs(heaviest(test, cell))) return;
    ++near;
    CHECK(complex.is_kept(cell));
  });
  CHECK(near > 100);  // the law was put to the test
}

TEST_CASE(
    "every point lies in exactly one cell, up to walls, and the walk finds it from any start") {
  for_points(10, [&](SkinCase& test, const Point& x) {
    const MixedComplex& complex = test.skin.complex();
    std::vector<CellId> within;
    std::size_t strictly = 0;
    for (std::size_t c = 0; c < complex.size(); ++c) {
      const double d = outside(complex, CellId{c}, x);
      if (d <= complex.wall_tolerance()) within.emplace_back(c);
      strictly += d < -complex.wall_tolerance();
    }
    CHECK(strictly <= 1);
    CHECK(within.size() >= 1);
    for (int start = 0; start < 5; ++start) {
      const CellId found = test.skin.locate(x, CellId{test.random.below(complex.size())});
      CHECK(std::find(within.begin(), within.end(), found) != within.end());
      if (strictly == 1 && within.size() == 1) CHECK(found == within[0]);
    }
  });
}
