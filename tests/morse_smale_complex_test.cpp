#include "morse/morse_smale_complex.h"

#include "skin/dual_complex.h"
#include "tests/support/morse_lines.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;

namespace {

using Region = std::array<CriticalId, 4>;

/// The faces of the arcs embedded as `order` says: by point, its arcs counter-clockwise. Written
/// anew, by walking: at each point turn into the next arc clockwise.
std::vector<std::vector<CriticalId>> faces(const MorseSmaleComplex& complex,
                                           const std::vector<std::vector<ArcId>>& order) {
  std::set<std::pair<std::uint32_t, bool>> walked;  // an arc, and whether from its saddle
  std::vector<std::vector<CriticalId>> all;
  for (std::uint32_t a = 0; a < complex.arcs.size(); ++a) {
    for (const bool from_saddle : {false, true}) {
      if (walked.contains({a, from_saddle})) continue;
      std::vector<CriticalId> face;
      std::pair<std::uint32_t, bool> dart(a, from_saddle);
      while (walked.insert(dart).second) {
        const Arc& arc = complex.arcs[dart.first];
        const CriticalId here = dart.second ? arc.saddle : arc.extremum;
        const CriticalId there = dart.second ? arc.extremum : arc.saddle;
        face.push_back(here);
        const std::vector<ArcId>& around = order[there.index()];
        const auto at = std::find(around.begin(), around.end(), ArcId{dart.first});
        const ArcId next = at == around.begin() ? around.back() : *(at - 1);
        dart = {next.value, !dart.second};
      }
      all.push_back(face);
    }
  }
  return all;
}

std::vector<std::vector<ArcId>> order_of(const MorseSmaleComplex& complex) {
  std::vector<std::vector<ArcId>> order(complex.points.size());
  for (std::uint32_t a = 0; a < complex.arcs.size(); ++a) {
    order[complex.arcs[a].saddle.index()].push_back(ArcId{a});
  }
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (complex.points[i].index == 1) continue;
    const auto arcs = complex.arcs_at(CriticalId{i});
    order[i].assign(arcs.begin(), arcs.end());
  }
  return order;
}

bool are_quadrangles(const MorseSmaleComplex& complex,
                     const std::vector<std::vector<CriticalId>>& all) {
  return std::all_of(all.begin(), all.end(), [&](const std::vector<CriticalId>& face) {
    std::array<int, 4> index{};
    if (face.size() != 4) return false;
    for (std::size_t i = 0; i < 4; ++i) index[i] = complex.points[face[i].index()].index;
    return index[0] + index[2] == 2 && index[1] + index[3] == 2 &&
           (index[0] == 1 ? index[1] != 1 && index[1] != index[3]
                          : index[1] == 1 && index[0] != index[2]);
  });
}

/// From its minimum on.
Region turned(const MorseSmaleComplex& complex, std::vector<CriticalId> face) {
  std::rotate(face.begin(),
              std::find_if(face.begin(), face.end(),
                           [&](CriticalId id) { return complex.points[id.index()].index == 0; }),
              face.end());
  return {face[0], face[1], face[2], face[3]};
}

/// The first law that a case's complex breaks, or nothing.
std::string broken_law(const MorseCase& test) {
  const MorseSmaleComplex complex = complex_of(test);
  if (!complex.degeneracies.empty()) return complex.degeneracies.front();
  const std::size_t saddles = test.critical.count(1);
  if (complex.arcs.size() != 4 * saddles) return "four arcs to a saddle";
  if (complex.regions.size() != 2 * saddles) return "two regions to a saddle";
  for (std::uint32_t a = 0; a < complex.arcs.size(); ++a) {
    const Arc& arc = complex.arcs[a];
    const CriticalPoint &saddle = complex.points[arc.saddle.index()],
                        &end = complex.points[arc.extremum.index()];
    if (end.index != (a % 2 == 0 ? 0 : 2)) return "arcs down and up take turns";
    const auto line = complex.line(ArcId{a});
    if (line.front() != saddle.point.position || line.back() != end.point.position) {
      return "polylines run from saddle to extremum";
    }
    const Vector leaves = line[1] - line[0];
    const Vector next = complex.line(ArcId{a % 4 == 3 ? a - 3 : a + 1})[1] - line[0];
    if (leaves.cross(next).dot(saddle.point.normal) <= 0) return "the four arcs turn to the left";
    if ((a % 4 == 0) != (leaves.dot(saddle.descending) > 0.9 * leaves.norm())) {
      return "the first arc descends along the given direction";
    }
  }
  const auto all = faces(complex, order_of(complex));
  if (!are_quadrangles(complex, all)) return "faces are quadrangles";
  std::vector<Region> found, given = complex.regions;
  for (const auto& face : all) found.push_back(turned(complex, face));
  std::sort(found.begin(), found.end());
  std::sort(given.begin(), given.end());
  if (found != given) return "the regions are the faces";
  for (const Region& r : complex.regions) {
    const auto value = [&](std::size_t i) { return complex.points[r[i].index()].value; };
    if (!(value(0) < std::min(value(1), value(3)) && std::max(value(1), value(3)) < value(2))) {
      return "a region's minimum is its lowest point, its maximum the highest";
    }
  }
  const skin::DualComplex dual = skin::dual_complex(test.skin);
  if (complex.components != dual.skin_components()) return "components as in the dual complex";
  if (test.critical.euler_characteristic() != dual.skin_euler_characteristic()) return "chi";
  return "";
}

}  // namespace

TEST_CASE("random sets of balls have a complex of quadrangles, for heights and distances") {
  std::size_t sound = 0;
  for_morse_cases(200, [&](const MorseCase& test) {
    CHECK(broken_law(test) == "");
    ++sound;
  });
  CHECK(sound > 195);
}

TEST_CASE("the bundled molecules have a complex of quadrangles in all three models") {
  for_molecules(bundled_molecules, [](const WeightedPoints& balls) {
    const MorseCase test(balls, MorseFunction{});
    REQUIRE_FALSE(test.is_degenerate());
    CHECK(broken_law(test) == "");
  });
}

TEST_CASE("components without saddles are counted: a lone ball, two apart, one in another") {
  for_seeds<Random>(50, [&](unsigned seed, Random& random) {
    const MorseFunction f = seed % 2 == 0
                                ? MorseFunction::height(random.direction())
                                : MorseFunction::squared_distance(30 * random.direction());
    const auto components = [&](const WeightedPoints& points) {
      const MorseCase test(points, f);
      CHECK(broken_law(test) == "");
      return complex_of(test).components;
    };
    CHECK(components({ball(1, 2, 3, 1.2)}) == 1);
    CHECK(components({ball(0, 0, 0, 1), ball(9, 1, 2, 1.5)}) == 2);
    CHECK(components({ball(0, 0, 0, 3), ball(0.5, 0, 0, 1)}) == 1);
    CHECK(components({ball(0, 0, 0, 1), ball(1.5, 0, 0, 1), ball(20, 0, 0, 1)}) == 2);
  });
}

TEST_CASE("a shell has an inner and an outer component, a ring one of genus one") {
  const MorseCase shell(molecule("shell_hollow.xyzr", skin::Model::Paper), {});
  CHECK(complex_of(shell).components == skin::dual_complex(shell.skin).skin_components());
  CHECK(skin::dual_complex(shell.skin).betti[2] == 1);
  const MorseCase ring(molecule("ring12.xyzr", skin::Model::Paper), {});
  CHECK(complex_of(ring).components == 1);
  CHECK(ring.critical.euler_characteristic() == 0);
}

TEST_CASE("with any two neighbouring arcs swapped at an extremum a face is no quadrangle") {
  std::size_t swaps = 0;
  for_morse_cases(40, [&](const MorseCase& test) {
    const MorseSmaleComplex complex = complex_of(test);
    const auto order = order_of(complex);
    REQUIRE(are_quadrangles(complex, faces(complex, order)));
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (complex.points[i].index == 1 || order[i].size() < 3) continue;
      for (std::size_t k = 0; k + 1 < order[i].size(); ++k) {
        auto swapped = order;
        std::swap(swapped[i][k], swapped[i][k + 1]);
        ++swaps;
        CHECK_FALSE(are_quadrangles(complex, faces(complex, swapped)));
      }
    }
  });
  CHECK(swaps > 1000);
}

TEST_CASE(
    "a line that merges shares its end with an earlier one of its kind, and f stays monotone") {
  std::size_t shared = 0, merged = 0;
  for (const char* file : {"1grm_model1.pdb", "1crn.pdb", "9dna.pdb"}) {
    CAPTURE(file);
    const MorseCase test(molecule(file, skin::Model::Paper), MorseFunction{});
    const MorseSmaleComplex complex = complex_of(test);
    merged += complex.merged_lines;
    for (std::uint32_t a = 0; a < complex.arcs.size(); ++a) {
      const auto line = complex.line(ArcId{a});
      bool is_monotone = true;
      for (std::size_t i = 1; i < line.size(); ++i) {
        is_monotone &= a % 2 == 0 ? test.f(line[i]) < test.f(line[i - 1])
                                  : test.f(line[i]) > test.f(line[i - 1]);
      }
      CHECK(is_monotone);
      bool has_parent = false;
      for (const ArcId b : complex.arcs_at(complex.arcs[a].extremum)) {
        if (b.value >= a) continue;
        const auto earlier = complex.line(b);
        has_parent |= line[line.size() - 2] == earlier[earlier.size() - 2];
      }
      shared += has_parent;
    }
  }
  CHECK(merged > 10);
  CHECK(shared == merged);
}

TEST_CASE("a connection of two saddles by symmetry is reported, not guessed about") {
  // Seen along its own plane, the lines of a ring's inside run from its upper saddle to its lower.
  for (const Vector& direction : {Vector(0.3, 1, 0), Vector(1, 0.21, 0), Vector(1, 1, 0.3)}) {
    const MorseCase ring(molecule("ring12.xyzr", skin::Model::Paper),
                         MorseFunction::height(direction));
    REQUIRE_FALSE(ring.is_degenerate());
    const MorseSmaleComplex complex = complex_of(ring);
    CHECK(complex.regions.empty());
    REQUIRE_FALSE(complex.degeneracies.empty());
    CHECK(contains(complex.degeneracies.front(), "runs into the saddle"));
  }
  // The waist of a neck seen across it.
  const MorseCase neck({ball(-1.5, 0, 0, 1.5), ball(1.5, 0, 0, 1)},
                       MorseFunction::height(Vector(0, 1, 0.25)));
  CHECK_FALSE(complex_of(neck).degeneracies.empty());
}

TEST_CASE("doubling all lengths doubles every point of every line exactly") {
  for (unsigned seed = 0; seed < 60; seed += 2) {
    CAPTURE(seed);
    const MorseCase test(seed);
    if (test.is_degenerate()) continue;
    const MorseCase twice(doubled(test.skin.points()), test.f);
    const MorseSmaleComplex small = complex_of(test), large = complex_of(twice);
    REQUIRE(small.line_points.size() == large.line_points.size());
    bool is_doubled = true;
    for (std::size_t i = 0; i < small.line_points.size(); ++i) {
      is_doubled &= large.line_points[i] == 2 * small.line_points[i];
    }
    CHECK(is_doubled);
    CHECK(small.regions == large.regions);
  }
}

TEST_SUITE("slow") {
  TEST_CASE("2,000 random sets have a complex of quadrangles, for heights and distances") {
    for_morse_cases({1000, 3000}, [](const MorseCase& test) { CHECK(broken_law(test) == ""); });
  }

  TEST_CASE("the bundled molecules have a complex of quadrangles in five random directions each") {
    Random random(5);
    for_molecules(bundled_molecules, [&](const WeightedPoints& balls) {
      for (int i = 0; i < 5; ++i) {
        CAPTURE(i);
        const MorseCase test(balls, MorseFunction::height(random.direction()));
        if (!test.is_degenerate()) CHECK(broken_law(test) == "");
      }
    });
  }
}
