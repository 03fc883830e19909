#include "certify/tube.h"

#include <doctest/doctest.h>

#include <tuple>
#include <utility>

#include "tests/support/blurred_surface.h"
#include "tests/support/meshes.h"

using namespace morskin;
using certify::TubeProof;
using geometry::CellId;
using geometry::Point;
using surface::SurfacePoint;

namespace {

TubeProof proof(const surface::Surface& skin, const std::array<SurfacePoint, 3>& p) {
  const auto bounds = certify::triangle_bounds(p[0].position, p[1].position, p[2].position);
  return certify::prove_tube(skin, {&p[0], &p[1], &p[2]}, bounds, {{1e-11, 1e-11, 1e-11}, 1e-6});
}

/// An equilateral triangle in the unit sphere with a circumradius.
std::array<SurfacePoint, 3> on_ball(const skin::SkinSurface& skin, double R) {
  std::array<SurfacePoint, 3> p;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = 2 * M_PI * static_cast<double>(k) / 3;
    p[k] = skin.at(Point(R * std::cos(angle), R * std::sin(angle), std::sqrt(1 - R * R)),
                   geometry::CellId{0U});
  }
  return p;
}

/// A point of the skin and two others of it some length scales off, at two angles.
std::optional<std::array<SurfacePoint, 3>> triangle_about(const skin::SkinSurface& skin,
                                                          const SurfacePoint& a, double scales,
                                                          double angle, double turn) {
  const geometry::Vector e = a.normal.unitOrthogonal(), f = a.normal.cross(e);
  const auto around = [&](double at) {
    return skin.project(
        a.position + scales * a.length_scale * (std::cos(at) * e + std::sin(at) * f), a.cell);
  };
  const auto b = around(angle), c = around(angle + turn);
  if (!b || !c) return std::nullopt;
  return std::array{a, *b, *c};
}

std::optional<std::array<SurfacePoint, 3>> triangle_about(const skin::SkinSurface& skin,
                                                          const SurfacePoint& a,
                                                          support::Random& random) {
  const double size = random.between(0.1, 1), turn = random.between(0.5, 2);
  return triangle_about(skin, a, size, random.between(0, 6), turn);
}

/// A proof that is told N as wrong as its bounds allow, at all points to one side.
TubeProof deceived_proof(const skin::SkinSurface& skin, const std::array<SurfacePoint, 3>& p,
                         double share, const geometry::Vector& aside) {
  const auto bounds = certify::triangle_bounds(p[0].position, p[1].position, p[2].position);
  auto told = p;
  double max_error = 0;
  for (SurfacePoint& at : told) {
    const double off = share * at.length_scale;
    const geometry::Vector N = at.length_scale * at.normal + off * aside;
    at.length_scale = N.norm();
    at.normal = N / N.norm();
    max_error = std::max(max_error, 1.0001 * off);
  }
  return certify::prove_tube(support::Blurred(skin, share, [&] { return aside; }),
                             {&told[0], &told[1], &told[2]}, bounds,
                             {{1e-11, 1e-11, 1e-11}, max_error});
}

/// What a proof claims of a triangle, at some of its points.
void check_everywhere(const skin::SkinSurface& skin, const std::array<SurfacePoint, 3>& p,
                      const TubeProof& found, support::Random& random) {
  const auto circle = certify::circumcircle(p[0].position, p[1].position, p[2].position);
  const geometry::Vector n = circle.doubled_area.normalized();
  for (int k = 0; k < 40; ++k) {
    double s = random.uniform(), t = random.uniform();
    if (s + t > 1) s = 1 - s, t = 1 - t;
    const Point x =
        p[0].position + s * (p[1].position - p[0].position) + t * (p[2].position - p[0].position);
    const skin::Patch patch = skin.patch(skin.locate(x, p[0].cell));
    const geometry::Vector N = patch.half_gradient(x);
    CHECK(N.dot(n) > 0);
    CHECK(std::abs(patch.value(x)) < N.squaredNorm());
    const auto end = skin.project(x, p[0].cell);
    REQUIRE(end);
    CHECK((end->position - x).norm() <= found.max_path * (1 + 1e-9));
  }
}

/// Whether a mesher would leave the triangle as it is.
bool is_expected(const skin::SkinSurface& skin, const std::array<SurfacePoint, 3>& p) {
  return certify::expects_tube(skin, {&p[0], &p[1], &p[2]});
}

}  // namespace

TEST_CASE("on a ball all triangles are proved up to the last that lies in the tube") {
  const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
  // At the circumcentre |G| = R^2 and |N|^2 = 1 - R^2, equal where R^2 = 1/2.
  for (double R = 0.01; R < 0.70705; R += 0.0001) {
    CAPTURE(R);
    const TubeProof found = proof(skin, on_ball(skin, R));
    CHECK(found.holds());
    CHECK(found.max_path >= 1 - std::sqrt(1 - R * R));  // from the circumcentre straight up
  }
  for (double R = std::sqrt(0.5) + 1e-9; R < 1; R += 0.01) {
    CAPTURE(R);
    CHECK_FALSE(proof(skin, on_ball(skin, R)).is_in_tube);
  }
}

TEST_CASE("where the bounds from the corners are just met a proof has a bound on the path too") {
  // Found by eighteen corpus runs with C from 0.3 on: one triangle in a million was proved, its
  // path not bounded, and so no vertex was free of it.
  const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
  for (int k = -2000; k <= 2000; ++k) {
    const double R = 0.5 + 1e-9 * k;  // with rho = 1 that is where |G| = R^2 = (rho - R)^2
    CAPTURE(R);
    const TubeProof found = proof(skin, on_ball(skin, R));
    CHECK(found.holds());
    CHECK(std::isfinite(found.max_path));
  }
}

TEST_CASE("a triangle that is upside down is never proved upright") {
  const skin::SkinSurface skin({support::ball(0, 0, 0, 1)});
  for (double R = 0.01; R < 1; R += 0.05) {
    auto p = on_ball(skin, R);
    std::swap(p[0], p[1]);
    CHECK_FALSE(proof(skin, p).is_upright);
  }
}

TEST_CASE("a proof for a triangle holds at each of its points, and so does its longest path") {
  std::size_t held = 0, coarse = 0;
  support::for_skins(60, [&](unsigned seed, const PreparedSkin& skin) {
    morskin::MeshingOptions options = support::uncertified();
    options.sizing = {0.2, certify::Sizing::quality_for(0.2)};
    const auto mesh = support::skin_mesh(skin.surface, morskin::make_mesh(skin, options));
    support::Random random(seed);
    for (int i = 0; i < 200; ++i) {
      const SurfacePoint a = mesh.at(geometry::VertexId{random.below(mesh.points.size())});
      const auto triangle = triangle_about(skin.surface, a, random);
      if (!triangle) continue;
      const auto& p = *triangle;
      const auto circle = certify::circumcircle(p[0].position, p[1].position, p[2].position);
      const TubeProof found = proof(skin.surface, p);
      if (!found.holds()) continue;
      ++held;
      coarse +=
          circle.radius > 0.5 * std::min({a.length_scale, p[1].length_scale, p[2].length_scale});
      check_everywhere(skin.surface, p, found, random);
    }
  });
  CHECK(held > 2000);  // the law was put to the test
  CHECK(coarse > 20);  // beyond what the corners alone can show
}

TEST_CASE("the largest triangle that is proved obeys the proof, however wrong N is in its bounds") {
  std::size_t held = 0;
  support::for_skins(60, [&](unsigned seed, const PreparedSkin& prepared) {
    const skin::SkinSurface& skin = prepared.surface;
    const auto samples = skin.samples().points;
    support::Random random(seed);
    for (int i = 0; i < 100; ++i) {
      const SurfacePoint& a = samples[random.below(samples.size())];
      const double share = i % 4 == 0 ? 1e-4 : random.between(0.01, 0.4);
      const double angle = random.between(0, 6), turn = random.between(0.3, 2.9);
      const double up = random.between(-1, 1);  // the way that N is off
      const geometry::Vector across = random.direction();
      std::optional<std::array<SurfacePoint, 3>> largest;
      TubeProof proved;
      double good = 0, bad = 2;
      while (bad - good > 1e-4) {
        const double size = (good + bad) / 2;
        const auto p = triangle_about(skin, a, size, angle, turn);
        TubeProof found;
        if (p) {
          const geometry::Vector n =
              certify::circumcircle((*p)[0].position, (*p)[1].position, (*p)[2].position)
                  .doubled_area.normalized();
          found = deceived_proof(skin, *p, share, (up * n + 0.3 * across).normalized());
        }
        (found.holds() ? good : bad) = size;
        if (found.holds()) std::tie(largest, proved) = std::pair(p, found);
      }
      if (!largest) continue;
      ++held;
      check_everywhere(skin, *largest, proved, random);
    }
  });
  CHECK(held > 2000);  // the law was put to the test
}

TEST_CASE("on a triangle N is as near its affine interpolation as its sides keep their lengths") {
  std::size_t bent = 0, tight = 0;
  support::for_skins(60, [&](unsigned seed, const PreparedSkin& skin) {
    const skin::SkinSurface& surface = skin.surface;
    const auto N = [&](const Point& x) {
      return surface.patch(surface.locate(x, CellId{0U})).half_gradient(x);
    };
    const auto samples = surface.samples().points;
    support::Random random(seed);
    for (int i = 0; i < 300; ++i) {
      const SurfacePoint& at = samples[random.below(samples.size())];
      const double size = at.length_scale * random.between(0.1, 3);
      std::array<Point, 3> v;
      std::array<geometry::Vector, 3> image;
      for (std::size_t k = 0; k < 3; ++k) {
        v[k] = at.position + size * random.direction();
        image[k] = N(v[k]);
      }
      for (int tries = 0; tries < 20; ++tries) {
        std::array<double, 3> share{random.uniform(), random.uniform(), random.uniform()};
        const double sum = share[0] + share[1] + share[2];
        Point p = Point::Zero();
        geometry::Vector affine = geometry::Vector::Zero();
        double beta = 0, power = 0;
        for (std::size_t k = 0; k < 3; ++k) {
          share[k] /= sum;
          p += share[k] * v[k];
          affine += share[k] * image[k];
        }
        for (std::size_t k = 0; k < 3; ++k) {
          const std::size_t l = (k + 1) % 3;
          const double both = share[k] * share[l], side = (v[l] - v[k]).squaredNorm();
          beta += both * (side - (image[l] - image[k]).squaredNorm());
          power += both * side;
        }
        const double off = (N(p) - affine).squaredNorm();
        CHECK(off <= beta + 1e-9 * size * size);
        CHECK(beta <= power * (1 + 1e-9));
        bent += beta > 0.1 * power;
        tight += off > 0.5 * beta && beta > 0.01 * power;
      }
    }
  });
  CHECK(bent > 10'000);  // the law was put to the test
  CHECK(tight > 1000);   // and says hardly more than it must
}

TEST_CASE("what a mesher expects is proved, even where N is known to 2^-12 of itself only") {
  // 1BRS with 2 vertices per square Angstrom: in a neck one triangle was expected and not proved.
  const skin::SkinSurface unit({support::ball(0, 0, 0, 1)});
  double good = 0.5, bad = 1;  // circumradii
  while (bad - good > 1e-12) {
    const double middle = (good + bad) / 2;
    (is_expected(unit, on_ball(unit, middle)) ? good : bad) = middle;
  }
  support::Random random(1);
  CHECK(proof(support::Blurred(unit, random), on_ball(unit, good)).holds());
  CHECK(good > 0.69);
  std::size_t expected = 0;
  support::for_skins(60, [&](unsigned seed, const PreparedSkin& skin) {
    const auto mesh = support::skin_mesh(
        skin.surface, morskin::make_mesh(skin, {.sizing = support::sizing_for(0.2),
                                                .angle_goal_deg = 0,
                                                .has_safety_net = false}));
    support::Random triangles(seed);
    for (int i = 0; i < 1000; ++i) {
      const SurfacePoint& a = mesh.at(geometry::VertexId{triangles.below(mesh.points.size())});
      const auto p = triangle_about(skin.surface, a, triangles);
      if (!p || !is_expected(skin.surface, *p)) continue;
      ++expected;
      CHECK(proof(support::Blurred(skin.surface, triangles), *p).holds());
    }
  });
  CHECK(expected > 10'000);
}

TEST_CASE("a proof holds for triangles with corners off the skin too") {
  std::size_t held = 0;
  support::for_skins(40, [&](unsigned seed, const PreparedSkin& prepared) {
    const skin::SkinSurface& skin = prepared.surface;
    const auto samples = skin.samples().points;
    support::Random random(seed);
    for (int i = 0; i < 4000; ++i) {
      const SurfacePoint& a = samples[random.below(samples.size())];
      std::array<SurfacePoint, 3> p;
      double g = 0, error = 0, size = a.length_scale * random.between(0.1, 1);
      for (SurfacePoint& at : p) {
        const Point x = a.position + size * random.direction();
        at = skin.at(x, skin.locate(x, a.cell));
        const surface::Enclosure about = skin.enclose(x, at.cell);
        g = std::max(g, about.max_value());
        error = std::max(error, about.error + 1e-12 * at.length_scale);
      }
      const auto bounds = certify::triangle_bounds(p[0].position, p[1].position, p[2].position);
      const TubeProof found =
          certify::prove_tube(skin, {&p[0], &p[1], &p[2]}, bounds, {{g, g, g}, error});
      if (found.holds()) check_everywhere(skin, p, found, random), ++held;
    }
  });
  CHECK(held > 10'000);  // the law was put to the test
}
