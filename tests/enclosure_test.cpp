#include "skin/enclosure.h"

#include <doctest/doctest.h>

#include <Eigen/Dense>
#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include "skin/quad.h"
#include "tests/support/ball_sets.h"
#include "tests/support/good_mesh.h"
#include "tests/support/seeds.h"

using namespace morskin;
using geometry::AtomId;
using geometry::Point;
using geometry::WeightedPoint;
using surface::Enclosure;

namespace {

using Wide = Eigen::Matrix<long double, 3, 1>;

/// G and N by trying every simplex of the atoms in long doubles: the upper bound is second order
/// in the shares' errors, so G is right to some 2^-60 of the sizes.
struct Truth {
  long double value = std::numeric_limits<long double>::infinity();
  Wide half_gradient = Wide::Zero();
  long double size = 0;  ///< of the sums behind the value
};

Truth truth(const std::vector<WeightedPoint>& points, const Point& x) {
  Truth best;
  for (std::uint32_t subset = 1; subset < 1U << points.size(); ++subset) {
    const int count = std::popcount(subset);
    if (count > 4) continue;
    std::vector<Wide> u;
    std::vector<long double> power;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((subset >> i & 1) == 0) continue;
      u.push_back(points[i].position.cast<long double>() - x.cast<long double>());
      power.push_back(u.back().squaredNorm() - points[i].weight);
    }
    Eigen::Matrix<long double, Eigen::Dynamic, 1> shares(count);
    if (count > 1) {
      Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic> edges(3, count - 1);
      Eigen::Matrix<long double, Eigen::Dynamic, 1> along(count - 1);
      for (int k = 1; k < count; ++k) {
        edges.col(k - 1) = u[static_cast<std::size_t>(k)] - u[0];
        along[k - 1] =
            (power[0] - power[static_cast<std::size_t>(k)]) / 2 - edges.col(k - 1).dot(u[0]);
      }
      const auto gram = (edges.transpose() * edges).eval();
      shares.tail(count - 1) = gram.fullPivLu().solve(along);
    }
    shares[0] = 1 - (count > 1 ? shares.tail(count - 1).sum() : 0);
    // Inside, or moved there: any convex combination bounds G from above.
    if (!shares.allFinite() || shares.minCoeff() < -1e-3L) continue;
    shares = shares.cwiseMax(0.0L);
    shares /= shares.sum();
    Wide m = Wide::Zero();
    long double powers = 0, size = 0;
    for (int k = 0; k < count; ++k) {
      const auto i = static_cast<std::size_t>(k);
      m += shares[k] * u[i];
      powers += shares[k] * power[i];
      size += shares[k] * (2 * u[i].squaredNorm() + std::abs(power[i]));
    }
    const long double value = (m.squaredNorm() + powers) / 2;
    if (value < best.value) best = {value, -m, size};
  }
  return best;
}

struct Case {
  std::vector<WeightedPoint> points;
  double scale;
  Point centre;
};

/// At most seven atoms: random ones, the corners of a cube, doubled ones, nearly touching ones; of
/// some scale, about some centre.
Case some_case(unsigned seed) {
  support::Random random(seed);
  std::vector<WeightedPoint> points = support::ball_set(seed);
  if (seed % 4 == 1) {
    points.clear();
    for (int i = 0; i < 7; ++i) {
      points.push_back({Point(i & 1, i >> 1 & 1, i >> 2 & 1) * 2, 1.5});
    }
  }
  if (points.size() > 7) points.resize(7);
  const double scale = std::pow(10.0, -static_cast<double>(seed / 4 % 7));
  const double shift = seed / 28 % 3 == 0 ? 0 : std::pow(100.0, seed / 28 % 3);
  const Point centre = shift * random.direction();
  for (WeightedPoint& p : points) {
    p.position = centre + scale * p.position;
    p.weight *= scale * scale;
  }
  return {points, scale, centre};
}

}  // namespace

TEST_CASE("an enclosure holds G and N, whichever atoms are tried first, and is narrow") {
  support::for_seeds(300, [&](unsigned seed) {
    const Case test = some_case(seed);
    support::Random random(seed);
    const skin::LeastPower powers(test.points);
    for (int i = 0; i < 12; ++i) {
      const Point x = test.centre + test.scale * random.between(0, 8) * random.direction();
      const Truth g = truth(test.points, x);
      std::vector<AtomId> hint;
      for (std::size_t k = 0; k < std::min<std::size_t>(1 + random.below(4), test.points.size());
           ++k) {
        hint.push_back(AtomId{random.below(test.points.size())});
      }
      const Enclosure found = skin::enclose(test.points, powers, x, hint);
      const long double oracle = 0x1p-57L * g.size;
      CHECK(found.low <= g.value + oracle);
      CHECK(found.high >= g.value - oracle);
      const long double off = (found.half_gradient.cast<long double>() - g.half_gradient).norm();
      CHECK(off <= found.error + std::sqrt(2 * oracle));
      // The power falls to both sides of a wall, so a rounded q costs an edge's length each way.
      const double rounding = 0x1p-50 * (test.centre.norm() + 8 * test.scale);
      const auto width = static_cast<double>(0x1p-44L * g.size) +
                         rounding * 8 * std::sqrt(static_cast<double>(g.size));
      CHECK(found.high - found.low <= width);
      CHECK(found.error <= 2 * std::sqrt(width));
    }
  });
}

TEST_CASE("necks and gaps too thin for doubles are enclosed narrowly") {
  using skin::Quad;
  support::for_seeds(200, [&](unsigned seed) {
    // Two balls at distance a to both sides of the origin. With d their weight less a^2, about the
    // origin G = y^2 + z^2 - h^2 - d / 2 and N = (-h, y, z), h along the axis.
    support::Random random(seed);
    const double a = random.between(1, 2), weight = a * a;
    const Quad d = Quad(weight) - Quad(a) * Quad(a);
    const Point shift = seed % 2 == 0 ? Point(0, 0, 0) : Point(0, 512, -4096);
    const std::vector<WeightedPoint> points{{shift + Point(-a, 0, 0), weight},
                                            {shift + Point(a, 0, 0), weight}};
    const skin::LeastPower powers(points);
    const double rho = std::sqrt(static_cast<double>(skin::magnitude(d)) / 2);
    REQUIRE(rho < 2e-8);
    const std::vector<AtomId> atoms{AtomId{0U}, AtomId{1U}};
    for (int i = 0; i < 20; ++i) {
      const Point x = shift + rho * random.between(0.5, 2) * random.direction();
      const Point offset = x - shift;
      const Eigen::Matrix<Quad, 3, 1> N(-offset.x(), offset.y(), offset.z());
      const Quad value = N[1] * N[1] + N[2] * N[2] - N[0] * N[0] - d / 2;
      const Enclosure found = skin::enclose(points, powers, x, {atoms.data(), 1 + random.below(2)});
      CHECK(found.low <= value);
      CHECK(found.high >= value);
      CHECK((found.half_gradient.cast<Quad>() - N).cast<double>().norm() <= found.error);
      CHECK(found.high - found.low < 1e-6 * rho * rho);
      CHECK(found.error < 1e-3 * rho);
    }
  });
}

TEST_CASE("a point that is no number, or too far for its square, has no bounds") {
  const std::vector<WeightedPoint> points{{Point::Zero(), 2}};
  const skin::LeastPower powers(points);
  const AtomId atom{0U};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(),
                           std::numeric_limits<double>::infinity(), -1e300, 1e160}) {
    for (int axis = 0; axis < 3; ++axis) {
      Point x(1, 0, 0);
      x[axis] = bad;
      const Enclosure found = skin::enclose(points, powers, x, {&atom, 1});
      CHECK(found.low == -std::numeric_limits<double>::infinity());
      CHECK(found.high == std::numeric_limits<double>::infinity());
      CHECK(found.error == std::numeric_limits<double>::infinity());
    }
  }
}

TEST_CASE("a vertex's bounds are an enclosure's, rounded outwards to floats") {
  const skin::SkinSurface skin(support::molecule("ring12.xyzr", skin::Model::Vdw));
  support::Random random(1);
  geometry::IndexedMesh mesh;
  for (int i = 0; i < 4000; ++i) mesh.positions.push_back(random.in_cube(-6, 6));
  const auto located = certify::locate_with_bounds(mesh, skin);
  for (std::size_t v = 0; v < located.size(); ++v) {
    const surface::Enclosure about = skin.enclose(mesh.positions[v], located[v].cell);
    CHECK(located[v].low <= about.low);
    CHECK(located[v].high >= about.high);
    const surface::SurfacePoint point = located[v].at(mesh.positions[v]);
    const geometry::Vector N = point.length_scale * point.normal;
    CHECK(located[v].error >= about.error + (N - about.half_gradient).norm());
  }
}
