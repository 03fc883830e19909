#include "geometry/predicates.h"

#include <cmath>

#include "geometry/predicates_internal.h"

namespace morskin::geometry {
namespace internal {
namespace {

// __extension__ silences -Wpedantic.
__extension__ typedef __int128 Int128;

/// p - e in units of 2^-k, exactly, for the k that gives the largest of them `bits` bits.
template <std::size_t Count>
struct ScaledDifferences {
  std::array<std::array<std::int64_t, 3>, Count> rows;
  double scale;  ///< 2^k
};

/// Nothing if a difference is no whole number of units or has been rounded.
template <std::size_t Count>
std::optional<ScaledDifferences<Count>> scaled_differences(
    const std::array<const Point*, Count>& points, const Point& e, int bits) {
  double extent = 0;
  for (const Point* p : points) {
    for (int k = 0; k < 3; ++k) extent = std::max(extent, std::fabs((*p)[k] - e[k]));
  }
  int exponent = 0;
  std::frexp(extent, &exponent);
  ScaledDifferences<Count> result{{}, std::ldexp(1.0, bits - exponent)};
  for (std::size_t i = 0; i < Count; ++i) {
    for (int k = 0; k < 3; ++k) {
      // Whole numbers of units below 2^53 in both points prove that the difference is exact.
      const double p_units = (*points[i])[k] * result.scale;
      const double e_units = e[k] * result.scale;
      if (!(std::fabs(p_units) < 0x1p53) || !(std::fabs(e_units) < 0x1p53)) return std::nullopt;
      const auto p_whole = static_cast<std::int64_t>(p_units);
      const auto e_whole = static_cast<std::int64_t>(e_units);
      if (static_cast<double>(p_whole) != p_units || static_cast<double>(e_whole) != e_units) {
        return std::nullopt;
      }
      result.rows[i][static_cast<std::size_t>(k)] = p_whole - e_whole;
    }
  }
  return result;
}

/// w_p - w_e in units of the squared scale, if that is exact and below 2^49.
std::optional<std::int64_t> scaled_weight_difference(double p, double e, double scale) {
  const double difference = p - e;
  if (difference + e != p || p - difference != e) return std::nullopt;
  const double units = difference * scale * scale;
  if (!(std::fabs(units) < 0x1p49)) return std::nullopt;
  const auto whole = static_cast<std::int64_t>(units);
  if (static_cast<double>(whole) != units) return std::nullopt;
  return whole;
}

template <class Number>
std::array<Number, 3> difference(const Point& p, const Point& q) {
  return {Number::difference(p.x(), q.x()), Number::difference(p.y(), q.y()),
          Number::difference(p.z(), q.z())};
}

template <class Number>
std::array<std::array<Number, 3>, 3> orientation_matrix(const Point& a, const Point& b,
                                                        const Point& c, const Point& d) {
  return {difference<Number>(a, d), difference<Number>(b, d), difference<Number>(c, d)};
}

template <class Number>
std::array<std::array<Number, 4>, 4> orthosphere_matrix(const WeightedPoint& a,
                                                        const WeightedPoint& b,
                                                        const WeightedPoint& c,
                                                        const WeightedPoint& d,
                                                        const WeightedPoint& e) {
  const auto row = [&e](const WeightedPoint& p) -> std::array<Number, 4> {
    const auto [x, y, z] = difference<Number>(p.position, e.position);
    return {x, y, z, x * x + y * y + z * z - Number::difference(p.weight, e.weight)};
  };
  return {row(a), row(b), row(c), row(d)};
}

}  // namespace

std::optional<Sign> integer_orientation(const Point& a, const Point& b, const Point& c,
                                        const Point& d) {
  const auto scaled = scaled_differences<3>({&a, &b, &c}, d, 40);
  if (!scaled) return std::nullopt;
  std::array<std::array<Int128, 3>, 3> m;  // 6 * 2^120 < 2^127
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 3; ++k) m[i][k] = scaled->rows[i][k];
  }
  return sign_of(determinant(m));
}

Sign expanded_orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  return determinant(orientation_matrix<Expansion>(a, b, c, d)).sign();
}

std::optional<Sign> integer_orthosphere(const WeightedPoint& a, const WeightedPoint& b,
                                        const WeightedPoint& c, const WeightedPoint& d,
                                        const WeightedPoint& e) {
  const auto scaled =
      scaled_differences<4>({&a.position, &b.position, &c.position, &d.position}, e.position, 24);
  if (!scaled) return std::nullopt;
  const std::array<double, 4> weights{a.weight, b.weight, c.weight, d.weight};
  std::array<std::array<Int128, 4>, 4> m;  // 24 * 2^72 * (3 * 2^48 + 2^49) < 2^127
  for (std::size_t i = 0; i < 4; ++i) {
    const auto& [x, y, z] = scaled->rows[i];
    const auto weight = scaled_weight_difference(weights[i], e.weight, scaled->scale);
    if (!weight) return std::nullopt;
    m[i] = {x, y, z, x * x + y * y + z * z - *weight};
  }
  return sign_of(determinant(m));
}

/// As in `filtered_orthosphere`, but with exact differences, and each of the remaining 12 roundings
/// at most (4 in the height, 2 and 2 in the minors, 1 product, 3 sums) is about 2^-103: 24 * 12 *
/// 2^-103 < 2^-94, with one more bit as a margin.
std::optional<Sign> refined_orthosphere(const WeightedPoint& a, const WeightedPoint& b,
                                        const WeightedPoint& c, const WeightedPoint& d,
                                        const WeightedPoint& e) {
  Point extent(0, 0, 0);
  double weight = 0;
  for (const WeightedPoint* p : {&a, &b, &c, &d}) {
    extent = extent.cwiseMax((p->position - e.position).cwiseAbs());
    weight = std::max(weight, std::fabs(p->weight - e.weight));
  }
  const double bound = 0x1p-93 * extent.prod() * (extent.squaredNorm() + weight);
  return sign_beyond(determinant(orthosphere_matrix<DoubleDouble>(a, b, c, d, e)).rounded(), bound);
}

Sign expanded_orthosphere(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                          const WeightedPoint& d, const WeightedPoint& e) {
  return determinant(orthosphere_matrix<Expansion>(a, b, c, d, e)).sign();
}

/// Weight i grows by e_i > 0, with e_i far above e_j for ids i < j. The determinant is linear in
/// the heights, so the first point by id whose height has a nonzero cofactor decides. The cofactor
/// is the orientation of the other four points; that of e is never zero.
Sign symbolic_orthosphere(const std::array<const Point*, 5>& points,
                          const std::array<AtomId, 5>& ids) {
  std::array<std::size_t, 5> by_id{0, 1, 2, 3, 4};
  std::sort(by_id.begin(), by_id.end(),
            [&ids](std::size_t i, std::size_t j) { return ids[i] < ids[j]; });
  for (const std::size_t raised : by_id) {
    const auto other = [&](std::size_t i) -> const Point& {
      return *points[i < raised ? i : i + 1];
    };
    const Sign cofactor = orientation(other(0), other(1), other(2), other(3));
    if (cofactor != Sign::Zero) return raised % 2 == 0 ? cofactor : -cofactor;
  }
  return Sign::Positive;  // unreachable under the precondition
}

}  // namespace internal

Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d) {
  if (const auto sign = internal::filtered_orientation(a, b, c, d)) return *sign;
  if (const auto sign = internal::integer_orientation(a, b, c, d)) return *sign;
  return internal::expanded_orientation(a, b, c, d);
}

/// Collinear if the projections onto all three coordinate planes are.
bool are_collinear(const Point& a, const Point& b, const Point& c) {
  const auto is_shadow_flat = [&](int i, int j) {
    const double px = a[i] - c[i], py = a[j] - c[j], qx = b[i] - c[i], qy = b[j] - c[j];
    // 2 products with 5 roundings each: 2 differences, 1 product, 1 sum, and one as a margin.
    const double bound = 10 * 0x1p-53 * (std::fabs(px * qy) + std::fabs(py * qx));
    if (std::fabs(px * qy - py * qx) > bound) return false;
    const auto exact = [&](const Point& p, int k) { return Expansion::difference(p[k], c[k]); };
    return (exact(a, i) * exact(b, j) - exact(a, j) * exact(b, i)).sign() == Sign::Zero;
  };
  return is_shadow_flat(0, 1) && is_shadow_flat(1, 2) && is_shadow_flat(2, 0);
}

Side orthosphere_side(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                      const WeightedPoint& d, const WeightedPoint& e,
                      const std::array<AtomId, 5>& ids) {
  std::optional<Sign> sign = internal::filtered_orthosphere(a, b, c, d, e);
  if (!sign) sign = internal::integer_orthosphere(a, b, c, d, e);
  if (!sign) sign = internal::refined_orthosphere(a, b, c, d, e);
  if (!sign) sign = internal::expanded_orthosphere(a, b, c, d, e);
  if (*sign == Sign::Zero) {
    sign = internal::symbolic_orthosphere(
        {&a.position, &b.position, &c.position, &d.position, &e.position}, ids);
  }
  return *sign == Sign::Positive ? Side::Inside : Side::Outside;
}

}  // namespace morskin::geometry
