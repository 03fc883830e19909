#pragma once

/// Functions written as text: x, y, z, numbers, + - * /, ^ with a whole exponent, sqrt exp log sin
/// cos, parentheses. A minus binds less than ^, so -x^2 is -(x^2); x^2^3 is
/// x^(2^3).

#include <cstdint>
#include <string_view>
#include <vector>

#include "implicit/function.h"

namespace morskin::implicit {

class Expression final : public Function {
 public:
  /// A number in the text means the double next to it.
  /// @throws geometry::UnreadableInput  naming the column, from 1
  explicit Expression(std::string_view text);

  Value at(const Point& x) const override;
  Jet<Interval, 1> enclose(const Point& x) const override;
  Jet<Interval, 2> over(const Box& box) const override;

  /// Longer texts, deeper nesting and larger exponents are refused.
  static constexpr std::size_t max_length = 10'000, max_depth = 24;
  static constexpr int max_exponent = 64;

  enum class Operation : std::uint8_t {
    Number,
    Variable,
    Add,
    Subtract,
    Multiply,
    Divide,
    Power,
    Negate,
    Sqrt,
    Exp,
    Log,
    Sin,
    Cos
  };
  /// One step of a program for a stack.
  struct Step {
    Operation operation;
    double number = 0;  ///< a constant, an axis or an exponent
  };

 private:
  template <class T>
  T evaluate(const Triple<T>& variables) const;

  std::vector<Step> program_;
};

}  // namespace morskin::implicit
