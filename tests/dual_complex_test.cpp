#include "skin/dual_complex.h"

#include "geometry/parallel.h"
#include "morse/critical_points.h"
#include "skin/singular_skin.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

using Betti = std::array<std::size_t, 3>;

Betti betti(const WeightedPoints& points) { return dual_complex(SkinSurface(points)).betti; }

std::vector<AtomId> singular_atoms(const WeightedPoints& points) {
  try {
    dual_complex(SkinSurface(points));
  } catch (const SingularSkin& singular) {
    return singular.atoms;
  }
  return {};
}

std::vector<AtomId> atoms(std::initializer_list<std::uint32_t> ids) {
  return {ids.begin(), ids.end()};
}

double one_more(double x) { return std::nextafter(x, std::numeric_limits<double>::infinity()); }
double one_less(double x) { return std::nextafter(x, 0); }

}  // namespace

TEST_CASE("the Betti numbers of bodies drawn by hand are those one sees") {
  CHECK(betti({ball(0, 0, 0, 1)}) == Betti{1, 0, 0});
  CHECK(betti({ball(0, 0, 0, 1), ball(5, 0, 0, 1)}) == Betti{2, 0, 0});
  CHECK(betti({ball(0, 0, 0, 1), ball(2, 0, 0, 1)}) == Betti{1, 0, 0});
  CHECK(betti({ball(0, 0, 0, 1), ball(0, 0, 0, 1)}) == Betti{1, 0, 0});
  CHECK(betti({ball(0, 0, 0, 2), ball(0.1, 0, 0, 0.5)}) == Betti{1, 0, 0});
  CHECK(betti(octahedron_balls()) == Betti{1, 0, 0});
  CHECK(betti(molecule("two_balls.xyzr", Model::Vdw)) == Betti{1, 0, 0});
  CHECK(betti(molecule("ring12.xyzr", Model::Vdw)) == Betti{1, 1, 0});
  CHECK(betti(molecule("shell_hollow.xyzr", Model::Vdw)) == Betti{1, 0, 1});
}

TEST_CASE("a tetrahedron of growing balls is four, then a frame, then a cage, then whole") {
  CHECK(betti(tetrahedron_balls(1.9)) == Betti{4, 0, 0});
  CHECK(betti(tetrahedron_balls(2.3)) == Betti{1, 3, 0});
  CHECK(betti(tetrahedron_balls(2.8)) == Betti{1, 0, 1});
  CHECK(betti(tetrahedron_balls(3.1)) == Betti{1, 0, 0});
}

TEST_CASE("the cube of eight is a frame, a cage or whole, as its half diagonals are to its balls") {
  constexpr double half_edge = 1.25;
  const auto expected = [](double weight) {
    if (weight < half_edge * half_edge) return Betti{8, 0, 0};
    if (weight < 2 * half_edge * half_edge) return Betti{1, 5, 0};
    if (weight < 3 * half_edge * half_edge) return Betti{1, 0, 1};
    return Betti{1, 0, 0};
  };
  for (const Model model : {Model::Paper, Model::Sas, Model::Vdw}) {
    for (const double probe : {0.0, 0.7, 1.4}) {
      CAPTURE(std::string(name_of(model)));
      CAPTURE(probe);
      const WeightedPoints points = molecule("cube8.xyzr", model, probe);
      CHECK(betti(points) == expected(points[0].weight));
    }
  }
}

TEST_CASE("components, tunnels and voids make up the Euler characteristic of the complex") {
  for_seeds(500, [&](unsigned seed) {
    const DualComplex complex = dual_complex(SkinSurface(ball_set(seed)));
    const auto [b0, b1, b2] = complex.betti;
    CHECK(static_cast<long>(b0 + b2) - static_cast<long>(b1) == complex.euler_characteristic());
    CHECK(2 * static_cast<long>(complex.skin_components()) -
              2 * static_cast<long>(complex.skin_genus()) ==
          complex.skin_euler_characteristic());
    CHECK(b0 >= 1);
    CHECK(b1 < 1000);  // no difference below zero
  });
}

TEST_CASE("minima - saddles + maxima is the Euler characteristic of the skin in every direction") {
  std::size_t asked = 0, degenerate = 0;
  for_seeds<Random>(300, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const long expected = dual_complex(skin).skin_euler_characteristic();
    for (int i = 0; i < 20; ++i) {
      const auto critical = morse::critical_points(skin, {random.direction()});
      ++asked;
      if (!critical.degeneracies.empty()) {
        ++degenerate;
        continue;
      }
      CHECK(critical.euler_characteristic() == expected);
    }
  });
  CHECK(100 * degenerate < asked);
}

TEST_CASE("two balls that just touch are refused by name, one ulp more or less is not") {
  // Radii 3 and 4, seven apart.
  const auto two = [](double w) { return WeightedPoints{{{0, 0, 0}, w}, {{0, 7, 0}, 16}}; };
  CHECK(singular_atoms(two(9)) == atoms({0, 1}));
  CHECK(betti(two(one_more(9))) == Betti{1, 0, 0});
  CHECK(betti(two(one_less(9))) == Betti{2, 0, 0});
  // A third ball, far off, changes the names only.
  CHECK(singular_atoms({{{50, 0, 0}, 1}, {{0, 0, 0}, 9}, {{7, 0, 0}, 16}}) == atoms({1, 2}));
  CHECK_THROWS_WITH_AS(dual_complex(SkinSurface(two(9))), doctest::Contains("0, 1"), SingularSkin);
}

TEST_CASE("several threads find the complex that one finds, and name the same singular balls") {
  const SkinSurface skin(in_a_row(molecule("1crn.pdb", skin::Model::Vdw), 4, 20));
  const DualComplex one = dual_complex(skin), other = dual_complex(skin, geometry::Run(4));
  CHECK(skin.triangulation().triangles.size() > geometry::usual_block);
  CHECK(one.simplices == other.simplices);
  CHECK(one.betti == other.betti);
  // A lattice of balls of diameter 1: thousands of pairs just touch, and the first is named.
  WeightedPoints lattice;
  for (int i = 0; i < 15 * 15 * 15; ++i) {
    const int x = i % 15, y = i / 15 % 15, z = i / 225;
    lattice.push_back({geometry::Point(x, y, z), 0.25});
  }
  const SkinSurface touching(lattice);
  for (const unsigned threads : {1U, 4U}) {
    CAPTURE(threads);
    try {
      dual_complex(touching, geometry::Run(threads));
      FAIL("not refused");
    } catch (const SingularSkin& singular) {
      CHECK(singular.atoms == atoms({0, 1}));
    }
  }
}

TEST_CASE("a ball that touches another from inside is not singular") {
  // Radii 3 and 1, two apart: the weight of the pair is zero, but the pair does not meet its dual.
  CHECK(betti({{{0, 0, 0}, 9}, {{2, 0, 0}, 1}}) == Betti{1, 0, 0});
}

TEST_CASE("three balls with one common point are refused by name, one ulp more or less is not") {
  // Squared circumradius 6, squared half edges 4.5.
  const auto three = [](double w) {
    return WeightedPoints{{{3, 0, 0}, w}, {{0, 3, 0}, w}, {{0, 0, 3}, w}};
  };
  CHECK(singular_atoms(three(6)) == atoms({0, 1, 2}));
  CHECK(betti(three(one_more(6))) == Betti{1, 0, 0});
  CHECK(betti(three(one_less(6))) == Betti{1, 1, 0});
  CHECK(singular_atoms(three(4.5)).size() == 2);
}

TEST_CASE("four balls with one common point are refused by name, one ulp more or less is not") {
  CHECK(singular_atoms(tetrahedron_balls(3)) == atoms({0, 1, 2, 3}));
  CHECK(betti(tetrahedron_balls(one_more(3))) == Betti{1, 0, 0});
  CHECK(betti(tetrahedron_balls(one_less(3))) == Betti{1, 0, 1});
  CHECK(singular_atoms(tetrahedron_balls(2)).size() == 2);
}

TEST_CASE("a singular place that other balls cover is not singular") {
  CHECK(betti({{{0, 0, 0}, 9}, {{7, 0, 0}, 16}, {{3, 0, 0}, 4}}) == Betti{1, 0, 0});
}

TEST_CASE("doubled balls and shuffled balls have the same Betti numbers") {
  for_seeds(200, [&](unsigned seed) {
    const WeightedPoints points = ball_set(seed);
    const Betti plain = betti(points);
    CHECK(betti(doubled(points)) == plain);
    CHECK(betti(shuffled(points, seed)) == plain);
  });
}
