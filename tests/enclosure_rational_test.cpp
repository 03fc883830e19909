/// Enclosures against G and N in rational numbers, on nasty sets of balls: no rounding on this
/// side.

#include <doctest/doctest.h>

#include <cmath>
#include <optional>
#include <vector>

#include "skin/enclosure.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/rationals.h"
#include "tests/support/seeds.h"

using namespace morskin;
using geometry::AtomId;
using geometry::Point;
using geometry::WeightedPoint;
using namespace morskin::support::rational;

namespace {

struct Exact {
  mpq_class value;
  Vector half_gradient;
};

/// G(x) is the least of (|m|^2 + sum s_i power_i) / 2 over convex shares s, where m = sum s_i u_i,
/// u_i = z_i - x and power_i = |u_i|^2 - w_i, and N = -m there. It is least on the hull of at most
/// four atoms, in the interior of their hull: where no move along an edge from the first changes
/// it.
Exact by_definition(const std::vector<WeightedPoint>& points, const Point& x) {
  std::vector<Vector> u;
  std::vector<mpq_class> power;
  for (const WeightedPoint& p : points) {
    u.push_back(minus(exact(p.position), exact(x)));
    power.push_back(dot(u.back(), u.back()) - mpq_class(p.weight));
  }
  std::optional<Exact> best;
  for (std::uint32_t subset = 1; subset < 1U << points.size(); ++subset) {
    std::vector<std::size_t> atoms;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if ((subset >> i & 1) != 0) atoms.push_back(i);
    }
    if (atoms.size() > 4) continue;
    std::vector<Vector> edges;
    for (std::size_t k = 1; k < atoms.size(); ++k) edges.push_back(minus(u[atoms[k]], u[atoms[0]]));
    std::vector<std::vector<mpq_class>> rows;
    for (std::size_t k = 0; k < edges.size(); ++k) {
      rows.emplace_back();
      for (const Vector& edge : edges) rows[k].push_back(dot(edges[k], edge));
      rows[k].push_back((power[atoms[0]] - power[atoms[k + 1]]) / 2 - dot(edges[k], u[atoms[0]]));
    }
    const auto shares = solve(rows);
    if (!shares) continue;
    mpq_class first = 1;
    bool is_inside = true;
    for (const mpq_class& s : *shares) {
      first -= s;
      is_inside &= s >= 0;
    }
    if (!is_inside || first < 0) continue;
    Vector m = u[atoms[0]];
    mpq_class value = first * power[atoms[0]];
    for (std::size_t k = 0; k < edges.size(); ++k) {
      for (std::size_t axis = 0; axis < 3; ++axis) m[axis] += (*shares)[k] * edges[k][axis];
      value += (*shares)[k] * power[atoms[k + 1]];
    }
    value = (value + dot(m, m)) / 2;
    if (!best || value < best->value) best = Exact{value, {-m[0], -m[1], -m[2]}};
  }
  REQUIRE(best);
  return *best;
}

}  // namespace

TEST_CASE("an enclosure holds G and N of nasty sets of balls in rational arithmetic") {
  std::size_t looks = 0;
  support::for_seeds(600, [&](unsigned seed) {
    std::vector<WeightedPoint> points = support::nasty_set(seed);
    if (points.size() > 6) points.resize(6);
    const skin::LeastPower powers(points);
    support::Random random(seed);
    for (int i = 0; i < 6; ++i) {
      // Around an atom, at a distance between that of its patch and a billionth of it.
      const WeightedPoint& about = points[random.below(points.size())];
      const double patch = std::sqrt(std::abs(about.weight) / 2);
      const double distance = patch * std::pow(10.0, random.between(-9, 0.5));
      const Point x = about.position + distance * random.direction();
      const AtomId hint{random.below(points.size())};
      const surface::Enclosure found = skin::enclose(points, powers, x, {&hint, 1});
      const Exact truth = by_definition(points, x);
      CHECK(mpq_class(found.low) <= truth.value);
      CHECK(mpq_class(found.high) >= truth.value);
      const Vector off = minus(exact(found.half_gradient), truth.half_gradient);
      CHECK(dot(off, off) <= mpq_class(found.error) * mpq_class(found.error));
      ++looks;
    }
  });
  CHECK(looks == 3600);
}
