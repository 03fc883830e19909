#include "geometry/expansion.h"

#include <algorithm>

namespace morskin::geometry {

using internal::fast_two_sum;
using internal::Rounded;
using internal::split;
using internal::two_product;
using internal::two_sum;

Expansion& Expansion::operator=(const Expansion& other) {
  size_ = other.size_;
  if (size_ > inline_capacity) {
    many_ = other.many_;
  } else {
    std::copy_n(other.few_.data(), size_, few_.data());
  }
  return *this;
}

void Expansion::push(double component) {
  if (size_ < inline_capacity) {
    few_[size_++] = component;
    return;
  }
  if (size_ == inline_capacity) many_.assign(few_.begin(), few_.end());
  many_.resize(size_);
  many_.push_back(component);
  ++size_;
}

Expansion Expansion::difference(double a, double b) {
  const Rounded exact = two_sum(a, -b);
  Expansion result;
  if (exact.tail != 0) result.push(exact.tail);
  if (exact.head != 0) result.push(exact.head);
  return result;
}

Expansion Expansion::operator-() const {
  Expansion result = *this;
  for (double* c = result.data(); c != result.data() + size_; ++c) *c = -*c;
  return result;
}

/// Merges the components by magnitude and sweeps up once, passing the running sum on.
Expansion operator+(const Expansion& a, const Expansion& b) {
  if (a.size_ == 0) return b;
  if (b.size_ == 0) return a;
  const double* from_a = a.data();
  const double* from_b = b.data();
  const double* const end_a = from_a + a.size_;
  const double* const end_b = from_b + b.size_;
  const auto next = [&] {
    const bool take_a =
        from_b == end_b || (from_a != end_a && std::fabs(*from_a) < std::fabs(*from_b));
    return take_a ? *from_a++ : *from_b++;
  };
  Expansion result;
  double running = next();
  for (std::size_t left = a.size_ + b.size_ - 1; left > 0; --left) {
    const Rounded sum = two_sum(running, next());
    if (sum.tail != 0) result.push(sum.tail);
    running = sum.head;
  }
  if (running != 0) result.push(running);
  return result;
}

Expansion operator-(const Expansion& a, const Expansion& b) { return a + -b; }

void Expansion::add_scaled(const Expansion& b, double factor) {
  const Rounded factor_split = split(factor);
  Expansion scaled;
  double running = 0;
  for (const double component : b.components()) {
    const Rounded product = two_product(component, split(component), factor, factor_split);
    const Rounded low = two_sum(running, product.tail);
    if (low.tail != 0) scaled.push(low.tail);
    const Rounded high = fast_two_sum(product.head, low.head);
    if (high.tail != 0) scaled.push(high.tail);
    running = high.head;
  }
  if (running != 0) scaled.push(running);
  *this = *this + scaled;
}

Expansion operator*(const Expansion& a, const Expansion& b) {
  const Expansion& longer = a.size_ < b.size_ ? b : a;
  const Expansion& shorter = a.size_ < b.size_ ? a : b;
  Expansion result;
  for (const double component : shorter.components()) result.add_scaled(longer, component);
  result.compress();
  return result;
}

void Expansion::compress() {
  if (size_ < 2) return;
  double* const c = data();
  // Downwards: gather into few large components at the upper end of the array.
  double running = c[size_ - 1];
  std::size_t bottom = size_ - 1;
  for (std::size_t i = size_ - 1; i-- > 0;) {
    const Rounded sum = fast_two_sum(running, c[i]);
    running = sum.head;
    if (sum.tail != 0) {
      c[bottom--] = sum.head;
      running = sum.tail;
    }
  }
  c[bottom] = running;
  // Upwards: rounding errors stay as components at the lower end.
  std::size_t kept = 0;
  for (std::size_t i = bottom + 1; i < size_; ++i) {
    const Rounded sum = fast_two_sum(c[i], running);
    running = sum.head;
    if (sum.tail != 0) c[kept++] = sum.tail;
  }
  c[kept++] = running;
  if (size_ > inline_capacity && kept <= inline_capacity) std::copy_n(c, kept, few_.data());
  size_ = kept;
}

}  // namespace morskin::geometry
