#include "skin/waists.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "tests/support/meshes.h"

using namespace morskin;
using geometry::WeightedPoint;

namespace {

/// Two balls at a distance of 2, of a weight that leaves a neck, or a gap, of this radius.
std::vector<WeightedPoint> pair(double radius, int sign) {
  // The edge's orthocentre has the weight w - 1; half of it is the radius squared.
  const double weight = 1 + sign * 2 * radius * radius;
  return {{{-1, 0, 0}, weight}, {{1, 0, 0}, weight}};
}

}  // namespace

TEST_CASE("a waist demands the integral over its hyperboloid") {
  for (const double radius : {1e-4, 0.01, 0.1, 0.3}) {
    CAPTURE(radius);
    const auto skin = support::prepared(pair(radius, 1));
    REQUIRE(skin);
    const auto found = skin::waists(skin->surface);
    REQUIRE(found.size() == 1);
    CHECK_FALSE(found[0].is_tunnel);
    CHECK(found[0].radius == doctest::Approx(radius));
    CHECK(found[0].centre.norm() < 1e-12);
    // The cell is a slab of thickness 1. By the midpoint rule over ds, in the variable of asinh.
    double sum = 0;
    const int steps = 20'000;
    const double end = std::asinh(0.5 / radius);
    for (int i = 0; i < steps; ++i) {
      const double t = (i + 0.5) / steps * end;
      const double s = radius * std::sinh(t), ds = radius * std::cosh(t) * end / steps;
      sum += 2 * 2 * M_PI * ds / std::sqrt(radius * radius + 2 * s * s);
    }
    CHECK(found[0].demand == doctest::Approx(sum).epsilon(1e-4));
  }
}

TEST_CASE("of a hyperboloid that other cells cut a waist demands the part in its cell") {
  std::vector<WeightedPoint> cube{{{0, 0, 0}, 2.5}};
  for (int i = 0; i < 8; ++i) {
    cube.push_back({{2.0 * (i & 1) - 1, 1.0 * (i & 2) - 1, 0.5 * (i & 4) - 1}, 1.9});
  }
  const double w = 1.15;  // a tunnel of radius 0.3
  const std::vector<WeightedPoint> ring{
      {{0, 0, 0}, w}, {{2, 0, 0}, w}, {{1, std::sqrt(3.0), 0}, w}};
  for (const auto& [balls, count] : {std::pair(cube, 12u), std::pair(ring, 4u)}) {
    CAPTURE(count);
    const auto skin = support::prepared(balls);
    REQUIRE(skin);
    const MeshResult result = make_mesh(*skin, {.sizing = {.C = 0.04}});
    std::vector<double> of_mesh(skin->surface.cell_count());
    for (const auto& [a, b, c] : result.mesh.triangles) {
      const auto& at = result.mesh.positions;
      const double area = (at[b] - at[a]).cross(at[c] - at[a]).norm() / 2;
      for (const std::uint32_t v : {a, b, c}) {
        const geometry::CellId cell = result.cells[v];
        const double scale = skin->surface.length_scale(at[v], cell);
        of_mesh[cell.index()] += area / 3 / (scale * scale);
      }
    }
    const auto found = skin::waists(skin->surface);
    REQUIRE(found.size() == count);
    for (const skin::Waist& waist : found) {
      CHECK(waist.demand == doctest::Approx(of_mesh[waist.cell.index()]).epsilon(0.06));
    }
  }
}

TEST_CASE("balls that do not meet have no neck, and three about a hole have one tunnel") {
  const auto apart = support::prepared(pair(0.1, -1));
  REQUIRE(apart);
  CHECK(skin::waists(apart->surface).empty());
  // The centre has the power 4/3 - w.
  const double radius = 0.05, weight = 4.0 / 3 - 2 * radius * radius;
  const double h = std::sqrt(3.0);
  const auto ring =
      support::prepared({{{0, 0, 0}, weight}, {{2, 0, 0}, weight}, {{1, h, 0}, weight}});
  REQUIRE(ring);
  REQUIRE(ring->topology.skin_genus() == 1);
  const auto found = skin::waists(ring->surface);
  REQUIRE(found.size() == 4);
  CHECK(std::ranges::is_sorted(found, {}, &skin::Waist::radius));
  CHECK(found[0].is_tunnel);
  CHECK(found[0].radius == doctest::Approx(radius));
  CHECK(std::ranges::count_if(found, &skin::Waist::is_tunnel) == 1);
}

TEST_CASE(
    "eight balls at the corners of a cube have a neck for each edge and none for a diagonal") {
  std::vector<WeightedPoint> cube;
  for (int i = 0; i < 8; ++i) {
    cube.push_back({{2.0 * (i & 1), 1.0 * (i & 2), 0.5 * (i & 4)}, 1.9 * 1.9});
  }
  const auto skin = support::prepared(cube);
  REQUIRE(skin);
  const auto found = skin::waists(skin->surface);
  CHECK(found.size() == 12);
  CHECK(std::ranges::none_of(found, &skin::Waist::is_tunnel));
  for (const skin::Waist& waist : found) CHECK(waist.radius == doctest::Approx(found[0].radius));
}

TEST_CASE("a hyperboloid that lies outside its cell, where the body is solid, is no neck") {
  // The tetrahedra about the edge of the first two have orthospheres of weight w - 0.82805.
  const auto octahedron = [](double w) {
    return std::vector<WeightedPoint>{{{0, 0, 0.9}, w}, {{0, 0, -0.9}, w}, {{1, 0, 0}, w},
                                      {{-1, 0, 0}, w},  {{0, 1, 0}, w},    {{0, -1, 0}, w}};
  };
  const auto solid = support::prepared(octahedron(0.84));
  REQUIRE(solid);
  REQUIRE(solid->topology.skin_components() == 1);
  const auto found = skin::waists(solid->surface);
  CHECK(found.size() == 12);  // a neck for each edge of the octahedron, none for its axis
  for (const skin::Waist& waist : found) CHECK(waist.centre.norm() > 0.5);
  // With voids beside it the axis is one.
  const auto hollow = support::prepared(octahedron(0.815));
  REQUIRE(hollow);
  CHECK(hollow->topology.betti[2] > 0);
  CHECK(std::ranges::any_of(skin::waists(hollow->surface),
                            [](const skin::Waist& waist) { return waist.centre.norm() < 0.1; }));
}
