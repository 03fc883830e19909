#include "morskin/voids.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "certify/certificate.h"
#include "certify/located_vertices.h"
#include "geometry/mesh_check.h"
#include "skin/skin_components.h"
#include "tests/support/meshes.h"
#include "tests/support/nasty_sets.h"

using namespace morskin;
using geometry::IndexedMesh;
using geometry::Point;
using geometry::WeightedPoint;

namespace {

constexpr double all = std::numeric_limits<double>::infinity();

/// Four equal balls at the corners of a regular tetrahedron, whose centre is in none.
std::vector<WeightedPoint> four_about_a_void(double half_edge, double clearance) {
  // The centre has the power 3 a^2 - w; the void's ball has the radius sqrt((3 a^2 - w) / 2).
  const double a = half_edge, weight = 3 * a * a - 2 * clearance * clearance;
  return {{{a, a, a}, weight}, {{a, -a, -a}, weight}, {{-a, a, -a}, weight}, {{-a, -a, a}, weight}};
}

certify::Certificate certified(const PreparedSkin& skin, const IndexedMesh& mesh,
                               const surface::Topology& expected) {
  return certify::certify(mesh, skin.surface, expected);
}

/// A hollow shell of balls with one more in its middle.
std::vector<WeightedPoint> shell_about_a_ball() {
  auto points = support::molecule("shell_hollow.xyzr", skin::Model::Vdw);
  points.push_back({Point::Zero(), 2});
  return points;
}

/// The voids' volumes by a mesh of their walls: by void what its components enclose, together.
std::map<std::uint32_t, double> volumes_by_mesh(const PreparedSkin& skin, double C) {
  const certify::Sizing sizing{.C = C};
  const IndexedMesh mesh = make_mesh(skin, support::with(sizing)).mesh;
  const skin::SkinComponents parts(skin.surface, skin.topology);
  const auto points = certify::locate_vertices(mesh, skin.surface);
  std::map<std::uint32_t, double> volumes;
  for (const geometry::MeshComponent& c : geometry::check_mesh(mesh).components) {
    const auto sides = parts.sides(points[mesh.triangles[c.first_triangle][0]]);
    if (sides && sides->cavity) volumes[*sides->cavity] -= c.volume;
  }
  return volumes;
}

}  // namespace

TEST_CASE("a void that is a ball has a ball's volume, within bounds that cubes make narrow") {
  for (const double clearance : {0.01, 0.1, 0.15}) {
    for (const double scale : {1.0, 1e-3, 1e4}) {
      CAPTURE(clearance);
      CAPTURE(scale);
      const auto skin = support::prepared(four_about_a_void(scale, scale * clearance));
      REQUIRE(skin);
      REQUIRE(skin->topology.voids.size() == 1);
      CHECK(skin->topology.voids[0].centre.norm() < 1e-9 * scale);
      CHECK(skin->topology.voids[0].clearance == doctest::Approx(scale * clearance));
      const double volume = 4 * M_PI / 3 * std::pow(scale * clearance, 3);
      double last_low = 0, last_high = all;
      for (const double fineness : {0.5, 0.25, 0.125, 0.0625}) {
        const auto found = skin::void_volume(skin->surface, skin->topology, 0, fineness);
        CHECK(found.low <= volume * (1 + 1e-9));
        CHECK(found.high >= volume * (1 - 1e-9));
        CHECK(found.high - found.low < 5 * fineness * fineness * volume);
        CHECK(found.high - found.low < last_high - last_low);
        last_low = found.low;
        last_high = found.high;
      }
      const auto found = skin::void_volume(skin->surface, skin->topology, 0, 1.0 / 64);
      CHECK(found.low <= volume * (1 + 1e-9));
      CHECK(found.high >= volume * (1 - 1e-9));
    }
  }
}

TEST_CASE(
    "a void's volume lies within its bounds at every fineness, whichever way its walls bend") {
  // Those of a ball are hollow seen from inside, those of a shell of balls bulge.
  std::vector<std::vector<WeightedPoint>> sets{
      four_about_a_void(1, 0.1), support::molecule("shell_hollow.xyzr", skin::Model::Vdw),
      support::molecule("c60.xyz", skin::Model::Vdw)};
  support::for_seeds(200, [&](unsigned seed) { sets.push_back(support::ball_set(seed)); });
  std::size_t compared = 0;
  for (const auto& points : sets) {
    const auto skin = support::prepared(points);
    if (!skin) continue;
    for (std::uint32_t v = 0; v < skin->topology.voids.size(); ++v) {
      const auto at = [&](double fineness) {
        return skin::void_volume(skin->surface, skin->topology, v, fineness);
      };
      const skin::VolumeBounds fine = at(1.0 / 32);
      for (const double fineness : {1.0, 0.5, 0.25, 0.125}) {
        CAPTURE(fineness);
        const skin::VolumeBounds coarse = at(fineness);
        CHECK(coarse.low <= fine.high);
        CHECK(coarse.high >= fine.low);
      }
      ++compared;
    }
  }
  CHECK(compared >= 8);
}

TEST_CASE("the volumes of voids are those that a fine mesh encloses") {
  std::vector<std::vector<WeightedPoint>> sets{support::molecule("1crn.pdb", skin::Model::Vdw),
                                               shell_about_a_ball(),
                                               support::molecule("c60.xyz", skin::Model::Vdw)};
  support::for_seeds(200, [&](unsigned seed) { sets.push_back(support::ball_set(seed)); });
  std::size_t compared = 0;
  for (const auto& points : sets) {
    const auto skin = support::prepared(points);
    if (!skin || skin->topology.voids.empty()) continue;
    const auto by_mesh = volumes_by_mesh(*skin, 0.05);
    const auto volumes = void_volumes(*skin);
    CHECK(by_mesh.size() == volumes.size());
    for (const auto& [cavity, volume] : by_mesh) {
      // A flat triangle leaves out less than its circumradius squared over the length scale.
      const double flat = 0.01 * volume;
      CHECK(volumes[cavity].low <= volume + flat);
      CHECK(volumes[cavity].high >= volume - flat);
      ++compared;
    }
  }
  CHECK(compared >= 15);
}

TEST_CASE("with its voids dropped a skin is meshed without them, and certified as that alone") {
  for (const bool is_static : {false, true}) {
    CAPTURE(is_static);
    for (const auto& points : {support::molecule("1crn.pdb", skin::Model::Vdw),
                               support::molecule("shell_hollow.xyzr", skin::Model::Vdw)}) {
      PreparedSkin skin = prepare_skin(points);
      MeshingOptions options = support::with(support::sizing_for(0.2));
      options.method = is_static ? Method::Static : Method::Sweep;
      const MeshResult whole = make_mesh(skin, options);
      drop_voids(skin, all);
      const surface::Topology expected = skin.expected();
      CHECK(expected.components == skin.topology.skin_components() - skin.topology.voids.size());
      const MeshResult made = make_mesh(skin, options);
      REQUIRE(made.certificate.certified);
      CHECK(made.certificate.components == expected.components);
      CHECK(made.mesh.triangles.size() < whole.mesh.triangles.size());
      const certify::Sizing& sizing = made.sizing;
      CHECK_FALSE(certify::certify(made.mesh, skin.surface, skin.topology, sizing).is_homeomorphic);
      CHECK_FALSE(certify::certify(whole.mesh, skin.surface, expected, sizing).is_homeomorphic);
    }
  }
}

TEST_CASE("a mesh without another void than the one that is dropped is refused") {
  // Spheres of one size on both sides: only where they are tells them apart.
  std::vector<WeightedPoint> points = four_about_a_void(1, 0.1);
  for (WeightedPoint p : four_about_a_void(1, 0.1)) {
    p.position.x() += 8;
    points.push_back(p);
  }
  PreparedSkin skin = prepare_skin(points);
  REQUIRE(skin.topology.voids.size() == 2);
  std::array<IndexedMesh, 2> meshes;
  std::array<surface::Topology, 2> expected;
  for (std::size_t kept : {0, 1}) {
    skin.is_dropped = {kept == 1, kept == 0};
    expected[kept] = skin.expected();
    const MeshResult made = make_mesh(skin);
    REQUIRE(made.certificate.certified);
    meshes[kept] = made.mesh;
  }
  for (std::size_t k : {0, 1}) {
    CHECK(certified(skin, meshes[k], expected[k]).is_homeomorphic);
    const auto other = certified(skin, meshes[k], expected[1 - k]);
    CHECK_FALSE(other.is_homeomorphic);
    CHECK(other.reason.find("others than the components to be meshed") != std::string::npos);
  }
}

TEST_CASE("with a void go the bodies inside it") {
  PreparedSkin skin = prepare_skin(shell_about_a_ball());
  REQUIRE(skin.topology.voids.size() == 1);
  CHECK(skin.topology.bodies.size() == 2);
  CHECK(skin.topology.outer_bodies.size() == 1);
  CHECK(skin.topology.voids[0].bodies.size() == 2);
  CHECK(skin.topology.voids[0].euler_characteristic == 2);  // a hollow ball
  CHECK(skin.topology.skin_components() == 3);
  drop_voids(skin, all);
  CHECK(skin.expected().components == 1);
  const MeshResult made = make_mesh(skin);
  CHECK(made.certificate.certified);
  CHECK(made.certificate.components == 1);
}

TEST_CASE("voids are not dropped where no stored point is surely in one") {
  PreparedSkin skin = prepare_skin(four_about_a_void(1, 0.1));
  REQUIRE(skin.topology.voids.size() == 1);
  // The same tetrahedron with heavier balls, which leave no free ball about its orthocentre.
  std::vector<WeightedPoint> heavier = skin.surface.points();
  for (WeightedPoint& p : heavier) p.weight = 3.2;
  skin.surface = prepare_skin(heavier).surface;
  CHECK_THROWS_AS(drop_voids(skin, all), geometry::RefusedInput);
  CHECK_THROWS_AS(skin.expected(), geometry::RefusedInput);
}

TEST_CASE("voids are dropped by their volume, and none that might be larger") {
  const PreparedSkin whole = prepare_skin(support::molecule("1crn.pdb", skin::Model::Vdw));
  const auto volumes = void_volumes(whole);
  REQUIRE(volumes.size() > 1);
  std::size_t some = 0;  // bounds between the volumes
  for (const double bound : {0.0, 0.01, 0.1, 1.0, 1e3}) {
    PreparedSkin skin = whole;
    drop_voids(skin, bound);
    const auto dropped = std::ranges::count(skin.is_dropped, 1);
    some += dropped > 0 && static_cast<std::size_t>(dropped) < volumes.size();
    for (std::uint32_t v = 0; v < volumes.size(); ++v) {
      if (skin.has_dropped(v)) CHECK(volumes[v].low < bound);
      if (!skin.has_dropped(v)) CHECK(volumes[v].high >= bound);
    }
  }
  CHECK(some > 0);
  PreparedSkin skin = whole;
  CHECK_THROWS_AS(drop_voids(skin, -1), geometry::RefusedInput);
  CHECK_THROWS_AS(drop_voids(skin, std::nan("")), geometry::RefusedInput);
}

TEST_CASE("a void stays where the finest cubes leave doubt whether it is smaller than asked for") {
  const PreparedSkin whole = prepare_skin(four_about_a_void(1, 0.15));
  REQUIRE(whole.topology.voids.size() == 1);
  const auto volume = skin::void_volume(whole.surface, whole.topology, 0, 1.0 / 64);
  REQUIRE(volume.low < volume.high);
  const auto is_dropped_below = [&](double bound) {
    PreparedSkin skin = whole;
    drop_voids(skin, bound);
    return skin.has_dropped(0);
  };
  CHECK_FALSE(is_dropped_below(volume.low));
  CHECK_FALSE(is_dropped_below(volume.middle()));
  CHECK_FALSE(is_dropped_below(volume.high));
  CHECK(is_dropped_below(volume.high * (1 + 1e-9)));
}

TEST_CASE("each component of the skin lies between a body and a void or the outside, once") {
  support::for_seeds(600, [&](unsigned seed) {
    // Flat ones, lattices and single balls among them.
    auto skin =
        support::prepared(seed % 2 == 0 ? support::ball_set(seed) : support::nasty_set(seed));
    if (!skin) return;
    const skin::DualComplex& topology = skin->topology;
    std::size_t pairs = topology.outer_bodies.size();
    for (const skin::Void& v : topology.voids) {
      CHECK(v.bodies.size() >= 1);
      CHECK(v.clearance > 0);
      pairs += v.bodies.size();
      CHECK(skin->surface.enclose(v.centre, skin->surface.complex().cell(3, v.tetrahedron)).low >
            0);
    }
    CHECK(pairs == topology.skin_components());
    skin->is_dropped.assign(topology.voids.size(), 1);
    CHECK_NOTHROW(skin->expected());  // each void has a point that is surely in it
    std::size_t labelled = 0;
    for (const std::uint32_t body : topology.body_of_vertex) {
      labelled += body != skin::DualComplex::no_part;
    }
    CHECK(labelled == topology.simplices[0]);
  });
}

TEST_CASE("whatever voids are dropped from random sets, the rest is certified") {
  std::size_t with_voids = 0;
  support::for_seeds(400, [&](unsigned seed) {
    auto skin = support::prepared(support::ball_set(seed));
    if (!skin || skin->topology.voids.empty()) return;
    support::Random random(seed);
    std::vector<char> is_dropped(skin->topology.voids.size());
    for (char& d : is_dropped) d = random.below(2) == 0 ? 1 : 0;
    skin->is_dropped = is_dropped;
    for (const double C : {0.08, 0.2, 0.4}) {
      CAPTURE(C);
      const MeshResult made = make_mesh(*skin, support::with(support::sizing_for(C)));
      CHECK(made.certificate.certified);
      CHECK(made.certificate.components == skin->expected().components);
    }
    ++with_voids;
  });
  CHECK(with_voids > 10);
}
