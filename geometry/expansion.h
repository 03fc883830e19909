#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace morskin::geometry {

/// The sign of a number, known for certain.
enum class Sign : std::int8_t { Negative = -1, Zero = 0, Positive = 1 };

constexpr Sign operator-(Sign sign) { return static_cast<Sign>(-static_cast<int>(sign)); }

/// The sign of any ordered number; NaN is not allowed.
template <class Number>
constexpr Sign sign_of(const Number& x) {
  return x > Number(0) ? Sign::Positive : x < Number(0) ? Sign::Negative : Sign::Zero;
}

namespace internal {

/// A double and its rounding error; the true number is head + tail. Sums and products of two
/// doubles are such numbers exactly (Dekker 1971, Knuth 1969; no contraction to fma allowed).
struct Rounded {
  double head;
  double tail;
};

inline Rounded two_sum(double a, double b) {
  const double sum = a + b;
  const double b_seen = sum - a;
  const double a_seen = sum - b_seen;
  return {sum, (a - a_seen) + (b - b_seen)};
}

/// The same for |a| >= |b|.
inline Rounded fast_two_sum(double a, double b) {
  const double sum = a + b;
  return {sum, b - (sum - a)};
}

/// The upper 26 bits of a double and the rest, which again has at most 26.
inline Rounded split(double a) {
  constexpr double splitter = 134217729;  // 2^27 + 1
  const double scaled = splitter * a;
  const double head = scaled - (scaled - a);
  return {head, a - head};
}

/// a * b, given the splits of both.
inline Rounded two_product(double a, Rounded a_split, double b, Rounded b_split) {
  const double product = a * b;
  const double error = ((a_split.head * b_split.head - product) + a_split.head * b_split.tail) +
                       a_split.tail * b_split.head;
  return {product, a_split.tail * b_split.tail + error};
}

}  // namespace internal

/// A number of about 106 bits, for a filter between double and `Expansion`.
///
/// Law: a difference of doubles is exact; the error of a sum is at most 2^-103 (|a| + |b|), that of
///      a product little more than 2^-103 |a b|.
class DoubleDouble {
 public:
  static DoubleDouble difference(double a, double b) { return internal::two_sum(a, -b); }
  double rounded() const { return parts_.head; }

  friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const internal::Rounded heads = internal::two_sum(a.parts_.head, b.parts_.head);
    return internal::two_sum(heads.head, heads.tail + (a.parts_.tail + b.parts_.tail));
  }
  friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) {
    return a + DoubleDouble({-b.parts_.head, -b.parts_.tail});
  }
  friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto [x, x_tail] = a.parts_;
    const auto [y, y_tail] = b.parts_;
    const internal::Rounded heads =
        internal::two_product(x, internal::split(x), y, internal::split(y));
    return internal::fast_two_sum(heads.head, heads.tail + (x * y_tail + x_tail * y));
  }

 private:
  DoubleDouble(internal::Rounded parts) : parts_(parts) {}

  internal::Rounded parts_;  // |tail| <= 2^-53 |head|
};

/// An exact real number, a sum of doubles that do not overlap: each is smaller than the lowest set
/// bit of the next. Sums, differences and products are exact.
///
/// Law:    the sign is that of the largest component; zero has no components.
/// @pre    no operation overflows, and no product of two components has a bit below 2^-1074.
/// Source: Shewchuk 1997, Adaptive precision floating-point arithmetic: fast-expansion-sum,
///         scale-expansion (both with zero elimination) and compress.
class Expansion {
 public:
  Expansion() {}
  explicit Expansion(double value) {
    if (value != 0) push(value);
  }
  Expansion(const Expansion& other) { *this = other; }
  Expansion& operator=(const Expansion& other);

  /// a - b, exactly.
  static Expansion difference(double a, double b);

  Sign sign() const { return size_ == 0 ? Sign::Zero : sign_of(data()[size_ - 1]); }
  /// Smallest first, none zero.
  std::span<const double> components() const { return {data(), size_}; }

  Expansion operator-() const;
  friend Expansion operator+(const Expansion& a, const Expansion& b);
  friend Expansion operator-(const Expansion& a, const Expansion& b);
  friend Expansion operator*(const Expansion& a, const Expansion& b);

 private:
  static constexpr std::size_t inline_capacity = 24;

  const double* data() const { return size_ <= inline_capacity ? few_.data() : many_.data(); }
  double* data() { return size_ <= inline_capacity ? few_.data() : many_.data(); }
  void push(double component);
  void add_scaled(const Expansion& b, double factor);
  /// Reduces the number of components.
  void compress();

  std::size_t size_ = 0;
  std::array<double, inline_capacity> few_;  // in use while size_ <= inline_capacity
  std::vector<double> many_;                 // in use beyond
};

}  // namespace morskin::geometry
