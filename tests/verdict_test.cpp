// What a certificate asks of angles and sizes beside the proof.

#include <algorithm>
#include <cmath>
#include <tuple>

#include "certify/certificate.h"
#include "certify/triangle_geometry.h"
#include "tests/support/good_mesh.h"

using namespace morskin;
using geometry::Point;

namespace {

/// What breaks the two, counted one by one; the bounds are absolute.
void check_counts(const certify::Certificate& found, const geometry::IndexedMesh& mesh,
                  double largest, double shortest) {
  const auto length = [&](const auto& t, std::size_t k) {
    return (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm();
  };
  std::size_t too_big = 0, too_short = 0;
  std::string first_big, first_short;
  double worst_U = 0, worst_L = 1e9, smallest_deg = 180;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    const Point &p = mesh.positions[t[0]], &q = mesh.positions[t[1]], &r = mesh.positions[t[2]];
    const double u = certify::circumcircle(p, q, r).radius / largest;
    if (u >= 1 && too_big++ == 0) first_big = "triangle " + std::to_string(i) + " has";
    worst_U = std::max(worst_U, u);
    smallest_deg = std::min(smallest_deg, certify::angle_range(p, q, r).smallest_deg);
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if (a > b) continue;
      const double l = length(t, k) / shortest;
      worst_L = std::min(worst_L, l);
      if (l > 1 || too_short++ != 0) continue;
      first_short = "edge " + std::to_string(a) + "-" + std::to_string(b) + " has";
    }
  }
  CHECK(found.violations_U == too_big);
  CHECK(found.violations_L == too_short);
  CHECK(support::contains(found.broken_by(certify::Claim::U), first_big));
  CHECK(support::contains(found.broken_by(certify::Claim::L), first_short));
  CHECK(found.worst_U == doctest::Approx(worst_U));
  CHECK(found.worst_L == doctest::Approx(worst_L));
  CHECK(found.proved_angle_deg() == doctest::Approx(smallest_deg));
  const auto& [a, b, c] = mesh.triangles[found.sharpest_triangle];
  const double sharpest =
      certify::angle_range(mesh.positions[a], mesh.positions[b], mesh.positions[c]).smallest_deg;
  CHECK(sharpest == doctest::Approx(smallest_deg));
}

}  // namespace

TEST_CASE("a mesh is certified for its angles, by [L] or each by itself") {
  const support::Good good({support::ball(0, 0, 0, 1)});
  const double smallest = good.certify(good.mesh).min_angle_deg;
  REQUIRE(smallest > 30);
  const auto certified_with = [&](certify::Sizing sizing, double claimed_deg) {
    sizing.claimed_angle_deg = claimed_deg;
    return certify::certify(good.mesh, good.skin.surface, good.skin.topology, sizing);
  };
  // With a small Q all edges are too short for [L], with a large C no triangle too big for [U].
  constexpr certify::Sizing all_short{.C = 0.3, .Q = 1.2};
  for (const double claimed : {0.0, smallest - 1e-9}) {
    CHECK(certified_with({}, claimed).certified);
    const certify::Certificate c = certified_with(all_short, claimed);
    CHECK(c.violations_L > 0);
    CHECK_MESSAGE(c.certified, c.reason);
  }
  for (const certify::Sizing& sizing : {certify::Sizing{}, all_short}) {
    const certify::Certificate c = certified_with(sizing, smallest + 1e-9);
    CHECK(c.is_homeomorphic);
    CHECK_FALSE(c.certified);
    CHECK_MESSAGE(support::contains(c.reason, "has an angle of"), c.reason);
    CHECK(c.proved_angle_deg() <= smallest + 1e-12);
    CHECK(c.proved_angle_deg() > smallest - 1e-9);
  }
}

TEST_CASE(
    "one broken claim of the proof is enough, and with [L] broken an angle below 30 degrees") {
  using certify::Claim;
  certify::Certificate good;
  good.min_sine = std::sin(29.9 * M_PI / 180);
  const auto concluded = [](certify::Certificate c) {
    c.conclude({});
    return c;
  };
  CHECK(concluded(good).certified);  // [L] and [U] hold, whatever the angles
  for (const Claim claim : {Claim::Manifold, Claim::OnSkin, Claim::Upright, Claim::Tube,
                            Claim::Degree, Claim::Counts}) {
    certify::Certificate bad = good;
    bad.fail(claim, "so it is");
    bad = concluded(bad);
    CHECK(bad.is_homeomorphic == (claim == Claim::OnSkin));
    CHECK_FALSE(bad.certified);
    CHECK(bad.reason == "so it is");
  }
  certify::Certificate too_big = good, too_short = good;
  too_big.violations_U = 1;
  CHECK_FALSE(concluded(too_big).certified);
  too_short.violations_L = 1;
  CHECK_FALSE(concluded(too_short).certified);
  too_short.min_sine = std::sin(30.1 * M_PI / 180);
  CHECK(concluded(too_short).certified);
}

TEST_CASE(
    "what breaks [L] and [U] is counted as one by one, and the first and the worst are told") {
  const support::Good good({support::ball(0, 0, 0, 1)});
  const geometry::IndexedMesh sphere = support::sphere_mesh(Point::Zero(), 1, 5);
  REQUIRE(sphere.triangles.size() > 4096);  // more than a thread takes at once
  for (const auto& extreme : {sphere.triangles.front(), sphere.triangles.back()}) {
    geometry::IndexedMesh mesh = sphere;
    Point& x = mesh.positions[extreme[2]];
    x = (x + 0.3 * (mesh.positions[extreme[0]] - x)).normalized();
    constexpr double largest = 0.0347, shortest = 0.0655;  // met by about half
    const double Q = std::sqrt(2 * largest / shortest);
    check_counts(certify::certify(mesh, good.skin.surface, good.skin.topology, {largest / Q, Q}),
                 mesh, largest, shortest);
  }
}

TEST_CASE("one element that breaks a size condition is told in the singular") {
  certify::Certificate found;
  found.min_sine = 0.1;
  for (const auto& [edges, triangles, told] :
       {std::tuple(1U, 2U, "1 edge breaks [L], 2 triangles break [U]"),
        std::tuple(2U, 1U, "2 edges break [L], 1 triangle breaks [U]"),
        std::tuple(1U, 0U, "1 edge breaks [L], 0 triangles break [U]")}) {
    found.violations_L = edges;
    found.violations_U = triangles;
    found.reason.clear();
    found.conclude({});
    CHECK(found.reason == told);
  }
}

TEST_CASE("a mesh that only has a triangle too large is not said to have an angle too small") {
  certify::Sizing sizing;
  sizing.claimed_angle_deg = 30;
  certify::Certificate found;
  found.min_sine = std::sin(40 * M_PI / 180);
  found.violations_U = 1;
  found.conclude(sizing);
  CHECK_FALSE(found.certified);
  CHECK(found.reason == "0 edges break [L], 1 triangle breaks [U]");
  found.violations_U = 0;
  found.reason.clear();
  found.conclude(sizing);
  CHECK(found.certified);
  found.min_sine = std::sin(29 * M_PI / 180);
  found.conclude(sizing);
  CHECK_FALSE(found.certified);
  CHECK(support::contains(found.reason, "has an angle of 29"));
}
