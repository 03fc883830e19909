#pragma once

#include <array>
#include <cmath>
#include <cstdint>

#include "geometry/expansion.h"

namespace morskin::support {

/// A whole number of 1,536 bits, in two's complement: an oracle for the exact predicates. The
/// widest of their polynomials needs 1,300 bits.
class BigInteger {
 public:
  BigInteger() = default;
  /// The number of units in x. @pre x is a multiple of 2^-places
  BigInteger(double x, int places) {
    int exponent = 0;
    const double fraction = std::frexp(std::fabs(x), &exponent);
    auto digits = static_cast<std::uint64_t>(std::ldexp(fraction, 53));
    int shift = exponent - 53 + places;
    for (; shift < 0 && digits != 0; ++shift) digits /= 2;
    if (digits == 0) return;
    const auto word = static_cast<std::size_t>(shift / 64);
    const int bit = shift % 64;
    words_[word] = digits << bit;
    if (bit > 0) words_[word + 1] = digits >> (64 - bit);
    if (x < 0) *this = -*this;
  }

  geometry::Sign sign() const {
    if ((words_.back() >> 63) != 0) return geometry::Sign::Negative;
    for (const std::uint64_t word : words_) {
      if (word != 0) return geometry::Sign::Positive;
    }
    return geometry::Sign::Zero;
  }

  BigInteger operator-() const {
    BigInteger result;
    std::uint64_t carry = 1;
    for (std::size_t i = 0; i < count; ++i) {
      result.words_[i] = ~words_[i] + carry;
      carry = carry != 0 && result.words_[i] == 0 ? 1 : 0;
    }
    return result;
  }
  friend BigInteger operator+(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    Wide sum = 0;
    for (std::size_t i = 0; i < count; ++i) {
      sum += static_cast<Wide>(a.words_[i]) + b.words_[i];
      result.words_[i] = static_cast<std::uint64_t>(sum);
      sum >>= 64;
    }
    return result;
  }
  friend BigInteger operator-(const BigInteger& a, const BigInteger& b) { return a + -b; }
  friend BigInteger operator*(const BigInteger& a, const BigInteger& b) {
    BigInteger result;
    for (std::size_t i = 0; i < count; ++i) {
      Wide sum = 0;
      for (std::size_t j = 0; i + j < count; ++j) {
        sum += static_cast<Wide>(a.words_[i]) * b.words_[j] + result.words_[i + j];
        result.words_[i + j] = static_cast<std::uint64_t>(sum);
        sum >>= 64;
      }
    }
    return result;
  }

 private:
  __extension__ typedef unsigned __int128 Wide;
  static constexpr std::size_t count = 24;

  std::array<std::uint64_t, count> words_{};  // lowest first
};

/// By expansion along the first row, all the way down.
template <std::size_t Size>
BigInteger permuted_determinant(const std::array<std::array<BigInteger, Size>, Size>& m,
                                std::size_t row = 0, unsigned taken = 0) {
  if (row == Size) return BigInteger(1, 0);
  BigInteger sum;
  bool is_odd = false;  // the free columns passed so far
  for (std::size_t k = 0; k < Size; ++k) {
    if ((taken >> k & 1) != 0) continue;
    const BigInteger term = m[row][k] * permuted_determinant(m, row + 1, taken | 1U << k);
    sum = is_odd ? sum - term : sum + term;
    is_odd = !is_odd;
  }
  return sum;
}

}  // namespace morskin::support
