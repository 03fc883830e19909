#include "certify/sizing.h"

#include "certify/triangle_geometry.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;
using certify::Sizing;

namespace {

constexpr double rounding = 1e-12;

/// Random constants with 0 < 2C < Q.
Sizing random_sizing(Random& random) {
  return {random.between(0.01, 0.15), random.between(1.45, 1.75)};
}

surface::SurfacePoint corner(const geometry::Point& position, double length_scale) {
  return {position, geometry::Vector::UnitZ(), length_scale, geometry::CellId{}};
}

}  // namespace

TEST_CASE("erratum E3: the tangent disk's share is 0.208, twice what the printed formula gives") {
  const Sizing sizing;
  const double C = sizing.C, Q = sizing.Q;
  constexpr double three_digits = 0.0005;
  CHECK(std::abs(sizing.tangent_disk_share() - 0.208) < three_digits);
  const double R = C * Q / (1 + 2 * C * Q);
  const double printed = R * std::sqrt(1 - R * R);
  CHECK(std::abs(printed - 0.104) < three_digits);
  // As printed it would lie below the least radius that [L] allows.
  const double least = 2 * C / (Q - 2 * C);
  CHECK(std::abs(least - 0.107) < three_digits);
  CHECK(printed < least);
  CHECK(sizing.tangent_disk_share() > least);
}

TEST_CASE("a rim point dropped on the sandwich ball is as far as [U] lets an edge be") {
  for_seeds<Random>(1000, [&](Random& random) {
    const Sizing sizing = random_sizing(random);
    const double r = sizing.tangent_disk_share();
    // The ball of radius 1 under the disk: the rim lies 1 - sqrt(1 - r^2) above it.
    const double half_edge = std::hypot(r, 1 - std::sqrt(1 - r * r)) / 2;
    // [U] with the length scale fallen as fast as it can along the edge, with equality.
    CHECK(std::abs(half_edge - sizing.C * sizing.Q * (1 - 2 * half_edge)) < rounding);
  });
}

TEST_CASE("the least angle is 21.54 degrees with the default constants") {
  constexpr double two_digits = 0.01;
  CHECK(std::abs(Sizing{}.angle_bound_deg() - 21.54) < two_digits);
  CHECK(Sizing{}.angle_bound_deg() > 21.54);
}

TEST_CASE("insertion with the default constants cannot make a short edge") {
  const Sizing sizing;
  CHECK(sizing.Q * sizing.Q > 2 + 4 * sizing.C * sizing.Q);  // mathematics.md 2.3
}

TEST_CASE("a triangle that keeps [L] and [U] has no angle below the least one") {
  std::size_t kept = 0;
  for_seeds<Random>(20000, [&](Random& random) {
    const Sizing sizing = random_sizing(random);
    const auto near = [&]() -> geometry::Vector {
      return 0.35 * random.uniform() * random.direction();
    };
    std::array<surface::SurfacePoint, 3> p;
    for (surface::SurfacePoint& x : p) x = corner(near(), random.between(0.8, 1.2));
    const auto circle = certify::circumcircle(p[0].position, p[1].position, p[2].position);
    const double rho = surface::min_length_scale({&p[0], &p[1], &p[2]});
    if (sizing.triangle_ratio(circle.radius, rho) >= 1) return;
    bool keeps_L = true;
    for (std::size_t k = 0; k < 3; ++k) {
      keeps_L = keeps_L && sizing.edge_ratio(p[k], p[(k + 1) % 3]) > 1;
    }
    if (!keeps_L) return;
    ++kept;
    const auto angles = certify::angle_range(p[0].position, p[1].position, p[2].position);
    CHECK(angles.smallest_deg > sizing.angle_bound_deg());
  });
  CHECK(kept > 20);  // the law was put to the test
}

TEST_CASE("the ratios to [L] and [U] do not change with the unit of length") {
  for_seeds<Random>(1000, [&](Random& random) {
    const Sizing sizing = random_sizing(random);
    const geometry::Point a = random.direction(), b = random.direction();
    const double rho_a = random.between(0.1, 3), rho_b = random.between(0.1, 3);
    const double ratio = sizing.edge_ratio(corner(a, rho_a), corner(b, rho_b));
    CHECK(ratio == sizing.edge_ratio(corner(b, rho_b), corner(a, rho_a)));
    CHECK(ratio == sizing.edge_ratio(corner(2 * a, 2 * rho_a), corner(2 * b, 2 * rho_b)));
    CHECK(sizing.triangle_ratio(rho_a, rho_b) == sizing.triangle_ratio(2 * rho_a, 2 * rho_b));
  });
}

TEST_CASE("an edge is too short exactly where its ratio to [L] is 1 or less") {
  std::size_t too_short = 0, cases = 0;
  for_seeds<Random>(1000, [&](Random& random) {
    const Sizing sizing = random_sizing(random);
    const auto p = corner(random.direction(), random.between(0.1, 3));
    const auto q = corner(random.direction(), random.between(0.1, 3));
    const double ratio = sizing.edge_ratio(p, q);
    // Stretched to where the ratio is 1 but for rounding, and a little off.
    for (const double off : {0.0, 1e-16, 1e-15, 1e-10, 1e-8, 0.1}) {
      for (const double stretch : {(1 - off) / ratio, (1 + off) / ratio}) {
        auto moved = q;
        moved.position = p.position + stretch * (q.position - p.position);
        CHECK(sizing.is_too_short(p, moved) == (sizing.edge_ratio(p, moved) <= 1));
        too_short += sizing.is_too_short(p, moved);
        ++cases;
      }
    }
  });
  CHECK(4 * too_short > cases);
  CHECK(4 * too_short < 3 * cases);
}

TEST_CASE("for every C up to 0.2 the Q that goes with it lets refinement end and certifies") {
  CHECK(Sizing::quality_for(0.08) == 1.65);
  for (double C = 0.001; C <= Sizing::largest_proved_C; C += 0.001) {
    CAPTURE(C);
    const Sizing sizing{C, Sizing::quality_for(C)};
    CHECK(sizing.is_refinement_proved_to_end());
    CHECK(sizing.is_tube_proved());
  }
  const Sizing beyond{0.205, 2 * 0.205 + std::sqrt(4 * 0.205 * 0.205 + 2)};
  CHECK_FALSE(beyond.is_tube_proved());
}

TEST_CASE("for every C the Q that goes with it lets refinement end") {
  for (double C = 0.001; C < 2; C *= 1.1) {
    CAPTURE(C);
    CHECK(Sizing{C, Sizing::quality_for(C)}.is_refinement_proved_to_end());
  }
}

TEST_CASE("with a largest length scale the ratios are those of the smaller of it and rho") {
  for_seeds<Random>(1000, [&](Random& random) {
    const Sizing plain = random_sizing(random);
    Sizing capped = plain;
    capped.largest_length_scale = random.between(0.1, 2);
    const auto scale = [&](double rho) { return std::min(rho, capped.largest_length_scale); };
    const geometry::Point a = random.direction(), b = random.direction();
    const double rho_a = random.between(0.1, 3), rho_b = random.between(0.1, 3);
    CHECK(capped.edge_ratio(corner(a, rho_a), corner(b, rho_b)) ==
          plain.edge_ratio(corner(a, scale(rho_a)), corner(b, scale(rho_b))));
    CHECK(capped.triangle_ratio(rho_a, rho_b) == plain.triangle_ratio(rho_a, scale(rho_b)));
  });
}
