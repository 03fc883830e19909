#include "skin/orthocentre.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "geometry/exact_range.h"
#include "geometry/predicates.h"
#include "skin/exact_vectors.h"

namespace morskin::skin {

namespace {

using geometry::Point;
using geometry::Vector;
using geometry::WeightedPoint;
using Simplex = std::span<const WeightedPoint>;

/// A product of vectors smaller than this share of the product of their lengths has cancelled too
/// much and is computed exactly. Above it doubles keep 53 - 10 bits, about as many as the walls'
/// tolerance assumes, long doubles 64 - 10.
constexpr double flat = 0x1p-10;
/// Above this share the sign of a product is right: rounding is below 2^-50.
constexpr double doubtful = 0x1p-40;
/// Such a share for a weight against its terms: of 64 - 10 bits 14 less remain.
constexpr long double thin = 0x1p-14L;

Wide wide(const Vector& v) { return v.cast<long double>(); }

/// With the edges e, f, g from the first point, and for each the difference p, q, r of its end's
/// power and its own at the first point, the orthocentre lies at numerator / (2 denominator) from
/// the first point. Vec and Number are double, long double or exact.
template <class Vec, class Number>
struct Fraction {
  Vec numerator;
  Number denominator;
  Vec normal;  ///< of the points' line or plane; anything for four
};

/// The first point's edges, and the powers that go with them.
template <class Vec, class Number>
struct Arms {
  std::array<Vec, 3> edges;
  std::array<Number, 3> powers{};
};

template <class Vec, class Number>
Fraction<Vec, Number> fraction(const Arms<Vec, Number>& arms, std::size_t points) {
  const auto& [e, f, g] = arms.edges;
  const auto& [p, q, r] = arms.powers;
  if (points == 2) return {p * e, e.dot(e), e};
  if (points == 3) {
    const Vec n = e.cross(f);
    return {p * f.cross(n) + q * n.cross(e), n.dot(n), n};
  }
  const Vec f_g = f.cross(g);
  return {p * f_g + q * g.cross(e) + r * e.cross(f), e.dot(f_g), e};
}

Fraction<Wide, long double> wide_fraction(Simplex simplex) {
  Arms<Wide, long double> arms;
  auto& [edges, powers] = arms;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    edges[i - 1] = wide(simplex[i].position) - wide(simplex[0].position);
    const long double more = static_cast<long double>(simplex[0].weight) - simplex[i].weight;
    powers[i - 1] = edges[i - 1].squaredNorm() + more;
  }
  return fraction(arms, simplex.size());
}

Arms<ExactVector, Expansion> exact_arms(Simplex simplex) {
  Arms<ExactVector, Expansion> arms;
  auto& [edges, powers] = arms;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    edges[i - 1] = ExactVector(simplex[0].position, simplex[i].position);
    powers[i - 1] = edges[i - 1].dot(edges[i - 1]) +
                    Expansion::difference(simplex[0].weight, simplex[i].weight);
  }
  return arms;
}

/// Whether the product of the edges, whose square is a triangle's denominator, has cancelled.
bool is_flat(Simplex simplex, long double denominator) {
  if (simplex.size() < 3) return false;
  long double squares = static_cast<long double>(flat) * flat;
  for (std::size_t i = 1; i < simplex.size(); ++i) {
    squares *= (wide(simplex[i].position) - wide(simplex[0].position)).squaredNorm();
  }
  return !((simplex.size() == 3 ? denominator : denominator * denominator) >= squares);
}

/// w - |numerator / (2 denominator)|^2 as one fraction. A triangle's numerator is the product of
/// p f - q e and the normal, which are orthogonal, so the normal's square cancels: degree 6 not 10.
long double exact_weight(Simplex simplex, const Arms<ExactVector, Expansion>& arms,
                         const Fraction<ExactVector, Expansion>& at) {
  const Expansion weight(simplex[0].weight), four(4.0);
  if (simplex.size() == 3) {
    const auto& [e, f, g] = arms.edges;
    const ExactVector m = arms.powers[0] * f + -arms.powers[1] * e;
    const Expansion denominator = four * at.denominator;
    return rounded(weight * denominator - m.dot(m)) / rounded(denominator);
  }
  const Expansion square = four * (at.denominator * at.denominator);
  return rounded(weight * square - at.numerator.dot(at.numerator)) / rounded(square);
}

}  // namespace

Orthocentre orthocentre(Simplex simplex) {
  assert(simplex.size() >= 1 && simplex.size() <= 4);
  const Wide first = wide(simplex[0].position);
  const double first_weight = simplex[0].weight;
  if (simplex.size() == 1) return {first, first_weight, Wide::Zero()};

  const auto quick = wide_fraction(simplex);
  Wide offset = quick.numerator / (2 * quick.denominator);
  Wide normal = quick.normal;
  if (is_flat(simplex, quick.denominator)) {
    const auto exact = fraction(exact_arms(simplex), simplex.size());
    offset = exact.numerator.rounded() / (2 * rounded(exact.denominator));
    normal = exact.normal.rounded();
  }
  const long double square = offset.squaredNorm();
  const long double edge = (wide(simplex[1].position) - first).squaredNorm();
  long double weight = first_weight - square;
  if (std::abs(weight) < thin * (std::abs(first_weight) + square + edge)) {
    const auto arms = exact_arms(simplex);
    weight = exact_weight(simplex, arms, fraction(arms, simplex.size()));
  }
  return {first + offset, weight,
          simplex.size() == 4 ? Wide(Wide::Zero()) : Wide(normal.normalized())};
}

/// If the volume of the edges e, f, g has not cancelled, each term of the numerator has an error of
/// a few u |f| |g| (|e|^2 + |w_0 - w_1|), so the offset o one of at most 2^-39 (extent + |o|), and
/// its square of 2^-37 (extent + |o|)^2.
double rough_weight(const std::array<WeightedPoint, 4>& tetrahedron) {
  Arms<Vector, double> arms;
  auto& [edge, power] = arms;
  double extent = 0, squares = flat * flat;
  const double first_weight = tetrahedron[0].weight;
  for (std::size_t i = 0; i < 3; ++i) {
    edge[i] = tetrahedron[i + 1].position - tetrahedron[0].position;
    const double square = edge[i].squaredNorm(), more = first_weight - tetrahedron[i + 1].weight;
    power[i] = square + more;
    extent += (square + std::abs(more)) / std::sqrt(square);
    squares *= square;
  }
  const auto at = fraction(arms, 4);
  const double square = (at.numerator / (2 * at.denominator)).squaredNorm();
  const double far = extent + std::sqrt(square);
  if (at.denominator * at.denominator >= squares && far * far <= 0x1p17 * std::abs(first_weight)) {
    return first_weight - square;
  }
  return static_cast<double>(orthocentre(tetrahedron).weight);
}

/// With z = p + n / (2 d) for the first point p, and a = x - p, the condition 2 |x - z|^2 < -w
/// reads 8 d^2 |a|^2 + |n|^2 + 4 d^2 w_p < 8 d a . n.
std::optional<Point> point_in_free_ball(const std::array<WeightedPoint, 4>& tetrahedron) {
  const WeightedPoint& p = tetrahedron[0];
  const auto [n, d, unused] = fraction(exact_arms(tetrahedron), 4);
  const Wide z = wide(p.position) + n.rounded() / (2 * rounded(d));
  const Point x = z.cast<double>().unaryExpr(&geometry::on_exact_grid);
  if (!std::ranges::all_of(x, geometry::is_exact_coordinate)) return std::nullopt;
  const ExactVector a(p.position, x);
  const Expansion four(4), eight(8);
  const Expansion square = eight * a.dot(a) + four * Expansion(p.weight);
  const Expansion excess = d * (d * square - eight * a.dot(n)) + n.dot(n);
  if (excess.sign() != geometry::Sign::Negative) return std::nullopt;
  return x;
}

Vector direction_off_facet(std::span<const Point> points) {
  const Point &origin = points.front(), &apex = points.back();
  const Vector to_apex = apex - origin;
  if (points.size() == 2) return to_apex.normalized();
  const Vector e = points[1] - origin;
  if (points.size() == 3) {
    const Vector unit_e = e.normalized();
    const Vector n = unit_e.cross(to_apex);
    if (n.norm() >= flat * to_apex.norm()) return n.cross(unit_e).normalized();
    const ExactVector exact_e(origin, points[1]);
    const Wide exact_n = exact_e.cross(ExactVector(origin, apex)).rounded();
    return exact_n.cross(exact_e.rounded()).normalized().cast<double>();
  }
  const Vector f = points[2] - origin;
  const Vector n = e.cross(f);
  const double height = n.dot(to_apex);
  const bool is_facet_flat = n.norm() < flat * e.norm() * f.norm();
  if (!is_facet_flat && std::abs(height) >= doubtful * n.norm() * to_apex.norm()) {
    const Vector unit = n.normalized();
    return height < 0 ? Vector(-unit) : unit;
  }
  const ExactVector exact_n = ExactVector(origin, points[1]).cross(ExactVector(origin, points[2]));
  const Vector unit = exact_n.rounded().normalized().cast<double>();
  const geometry::Sign side = exact_n.dot(ExactVector(origin, apex)).sign();
  return side == geometry::Sign::Negative ? Vector(-unit) : unit;
}

}  // namespace morskin::skin
