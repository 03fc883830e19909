// The mixed complex: mathematics.md section 11, T1.

#include "skin/mixed_complex.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/parallel.h"
#include "tests/support/seeds.h"
#include "tests/support/skin_case.h"

using namespace morskin;
using namespace morskin::skin;
using support::outside;
using support::SkinCase;

TEST_CASE("a wall seen from the other side is the same plane") {
  support::for_seeds<SkinCase>(100, [&](const SkinCase& test) {
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
  support::for_seeds<SkinCase>(100, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    kept += complex.kept_size();
    for (std::uint32_t i = 0; i < complex.kept_size(); ++i) {
      const std::vector<Wall> made = complex.make_walls(CellId{i});
      CHECK(
          std::ranges::equal(made, complex.kept_walls(CellId{i}), [](const Wall& a, const Wall& b) {
            return a.normal == b.normal && a.offset == b.offset && a.beyond == b.beyond;
          }));
    }
  });
  CHECK(kept > 1000);  // the law was put to the test
}

TEST_CASE("the complex is the same made by one thread and by several") {
  const support::WeightedPoints points =
      support::in_a_row(support::molecule("1crn.pdb", skin::Model::Vdw), 4, 20);
  const SkinSurface alone(points), together(points, MixedComplex::Keep::NearSkin, geometry::Run(4));
  const MixedComplex &one = alone.complex(), &other = together.complex();
  REQUIRE(one.kept_size() == other.kept_size());
  CHECK(one.kept_size() > 2 * geometry::usual_block);  // there was work for more than one
  const auto is_same_wall = [](const Wall& a, const Wall& b) {
    return a.normal == b.normal && a.offset == b.offset && a.beyond == b.beyond;
  };
  for (std::uint32_t i = 0; i < one.kept_size(); ++i) {
    const CellId cell{i};
    const Patch &p = one.kept_patch(cell), &q = other.kept_patch(cell);
    REQUIRE(one.number(cell) == other.number(cell));
    REQUIRE((p.centre == q.centre && p.axis == q.axis && p.half_weight == q.half_weight));
    REQUIRE(std::ranges::equal(one.kept_walls(cell), other.kept_walls(cell), is_same_wall));
  }
}

TEST_CASE("walls made on demand are the same once the lists of facets are forgotten") {
  support::for_seeds<SkinCase>(100, [&](SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    std::vector<std::vector<Wall>> before;
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      before.push_back(complex.make_walls(CellId{i}));
    }
    test.skin.forget_facets();
    CHECK(complex.triangulation().triangle_edges.capacity() == 0);
    CHECK(complex.triangulation().tetrahedron_triangles.capacity() == 0);
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      CHECK(std::ranges::equal(
          before[i], complex.make_walls(CellId{i}), [](const Wall& a, const Wall& b) {
            return a.normal == b.normal && a.offset == b.offset && a.beyond == b.beyond;
          }));
    }
  });
}

TEST_CASE("a cell is left out only if the ranges of power and weight on it do not overlap") {
  // By the definition, tetrahedron by tetrahedron, with no short cut for what lies deep inside.
  std::size_t left_out = 0;
  support::for_seeds<SkinCase>(300, [&](const SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    const auto& t = complex.triangulation();
    for (std::uint32_t i = 0; i < complex.size(); ++i) {
      const auto simplex = test.skin.atoms(CellId{i});
      double heaviest = -std::numeric_limits<double>::infinity();
      for (const AtomId a : simplex) {
        heaviest = std::max(heaviest, test.skin.points()[a.index()].weight);
      }
      const double w = 2 * complex.patch(CellId{i}).half_weight;
      const double slack = 4 * MixedComplex::nearness * std::abs(heaviest);
      // Of the tetrahedra about it; a cell with an unbounded dual has no largest power.
      double largest = -std::numeric_limits<double>::infinity();
      for (std::size_t s = 0; s < t.tetrahedra.size(); ++s) {
        if (std::ranges::includes(t.tetrahedra[s], simplex)) {
          largest = std::max(largest, -2 * complex.patch(complex.cell(3, s)).half_weight);
        }
      }
      constexpr double doubt = 1e-4;  // of the slack: how far rough weights are off, and more
      if (-w > heaviest + (1 + doubt) * slack) CHECK_FALSE(complex.is_kept(CellId{i}));
      if (complex.is_kept(CellId{i})) continue;
      ++left_out;
      CHECK((-w > heaviest + (1 - doubt) * slack || largest + (1 - doubt) * slack < w));
    }
  });
  CHECK(left_out > 1000);  // the law was put to the test
}

TEST_CASE("a cell's dimension and place lead back to the cell, and every simplex has one") {
  support::for_seeds<SkinCase>(100, [&](const SkinCase& test) {
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
  support::for_seeds<SkinCase>(300, [&](SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    for (int i = 0; i < 40; ++i) {
      const Point x = test.box.sample(test.random);
      const CellId cell = test.cell_of(x);
      if (const auto p = test.skin.project(x, cell)) CHECK(complex.is_kept(p->cell));
      double heaviest = -std::numeric_limits<double>::infinity();
      for (const AtomId a : test.skin.atoms(cell)) {
        heaviest = std::max(heaviest, test.skin.points()[a.index()].weight);
      }
      const double g = complex.patch(cell).value(x);
      if (std::abs(g) > 0.99 * MixedComplex::nearness * std::abs(heaviest)) continue;
      ++near;
      CHECK(complex.is_kept(cell));
    }
  });
  CHECK(near > 100);  // the law was put to the test
}

TEST_CASE(
    "every point lies in exactly one cell, up to walls, and the walk finds it from any start") {
  support::for_seeds<SkinCase>(300, [&](SkinCase& test) {
    const MixedComplex& complex = test.skin.complex();
    for (int i = 0; i < 10; ++i) {
      const Point x = test.box.sample(test.random);
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
    }
  });
}
