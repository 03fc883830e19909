#include "implicit/expression.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <string>
#include <utility>

#include "geometry/error.h"

namespace morskin::implicit {

namespace {

using Operation = Expression::Operation;
using Step = Expression::Step;

constexpr std::array<std::pair<std::string_view, Operation>, 5> functions{
    {{"sqrt", Operation::Sqrt},
     {"exp", Operation::Exp},
     {"log", Operation::Log},
     {"sin", Operation::Sin},
     {"cos", Operation::Cos}}};

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// By recursive descent:
///     sum = product (("+" | "-") product)*
///     product = signed (("*" | "/") signed)*
///     signed = ("+" | "-") signed | power
///     power = primary ("^" exponent)?
///     exponent = digits ("^" exponent)?
///     primary = number | variable | function "(" sum ")" | "(" sum ")"
class Parser {
 public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::vector<Step> parse() {
    if (text_.size() > Expression::max_length) {
      fail("it is longer than " + std::to_string(Expression::max_length) + " characters");
    }
    sum();
    next();
    if (at_ < text_.size()) fail("an operator is missing here");
    return std::move(program_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw geometry::UnreadableInput("formula, column " + std::to_string(at_ + 1) + ": " + what);
  }
  /// The next character that is no blank; 0 at the end.
  char next() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
    return at_ < text_.size() ? text_[at_] : '\0';
  }
  bool take(char c) {
    if (next() != c) return false;
    ++at_;
    return true;
  }
  void add(Operation operation, double number = 0) { program_.push_back({operation, number}); }

  void sum() {
    product();
    for (;;) {
      if (take('+')) {
        nested([&] { product(); });
        add(Operation::Add);
      } else if (take('-')) {
        nested([&] { product(); });
        add(Operation::Subtract);
      } else {
        return;
      }
    }
  }
  void product() {
    signed_power();
    for (;;) {
      if (take('*')) {
        nested([&] { signed_power(); });
        add(Operation::Multiply);
      } else if (take('/')) {
        nested([&] { signed_power(); });
        add(Operation::Divide);
      } else {
        return;
      }
    }
  }
  void signed_power() {
    if (take('-')) {
      nested([&] { signed_power(); });
      return add(Operation::Negate);
    }
    if (take('+')) return nested([&] { signed_power(); });
    primary();
    if (take('^')) add(Operation::Power, exponent());
  }
  int exponent() {
    next();
    const std::size_t begin = at_;
    int value = 0;
    const char* const end = text_.data() + text_.size();
    const auto [stop, error] = std::from_chars(text_.data() + at_, end, value);
    bool is_taken = error == std::errc() && (stop == end || *stop != '.') && value >= 0;
    if (is_taken) {
      at_ = static_cast<std::size_t>(stop - text_.data());
      if (take('^')) nested([&] { value = power(value, exponent()); });
      is_taken = value <= Expression::max_exponent;
    }
    if (!is_taken) {
      at_ = begin;
      fail("an exponent is a whole number from 0 to " + std::to_string(Expression::max_exponent) +
           "; write a root as sqrt( )");
    }
    return value;
  }
  /// Of whole numbers; one more than the largest exponent stands for all beyond.
  static int power(int base, int exponent) {
    int result = 1;
    for (int k = 0; k < exponent; ++k) {
      result = std::min(result * std::min(base, Expression::max_exponent + 1),
                        Expression::max_exponent + 1);
    }
    return result;
  }
  void primary() {
    const char c = next();
    if (is_digit(c) || c == '.') return number();
    if (is_letter(c)) return word();
    if (!take('(')) {
      fail(c == '\0' ? "something is missing at the end"
                     : "a number, x, y, z, a function or \"(\" is expected");
    }
    bracket();
  }
  void number() {
    double value = 0;
    const auto [stop, error] =
        std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc()) fail("this is no number that a double holds");
    at_ = static_cast<std::size_t>(stop - text_.data());
    add(Operation::Number, value);
  }
  void word() {
    std::size_t end = at_;
    while (end < text_.size() && (is_letter(text_[end]) || is_digit(text_[end]))) ++end;
    const std::string_view name = text_.substr(at_, end - at_);
    if (name == "x" || name == "y" || name == "z") {
      at_ = end;
      return add(Operation::Variable, name[0] - 'x');
    }
    for (const auto& [known, operation] : functions) {
      if (name != known) continue;
      at_ = end;
      if (!take('(')) fail(std::string("\"(\" is missing after ").append(name));
      bracket();
      return add(operation);
    }
    fail(std::string(name).append(": neither x, y, z nor sqrt, exp, log, sin, cos"));
  }
  void bracket() {
    nested([&] { sum(); });
    if (!take(')')) fail("\")\" is missing here");
  }
  /// Each level takes at most one place on the evaluation's stack.
  template <class Part>
  void nested(Part part) {
    if (++depth_ >= Expression::max_depth) fail("it is nested too deeply");
    part();
    --depth_;
  }

  std::string_view text_;
  std::size_t at_ = 0, depth_ = 0;
  std::vector<Step> program_;
};

bool is_binary(Operation operation) {
  return operation == Operation::Add || operation == Operation::Subtract ||
         operation == Operation::Multiply || operation == Operation::Divide;
}

/// @pre is_binary(operation)
template <class T>
T combined(Operation operation, const T& a, const T& b) {
  switch (operation) {
    case Operation::Add:
      return a + b;
    case Operation::Subtract:
      return a - b;
    case Operation::Multiply:
      return a * b;
    default:
      return a / b;
  }
}

/// @pre  a minus or a function
template <class T>
T applied(Operation operation, const T& a) {
  switch (operation) {
    case Operation::Sqrt:
      return sqrt(a);
    case Operation::Exp:
      return exp(a);
    case Operation::Log:
      return log(a);
    case Operation::Sin:
      return sin(a);
    case Operation::Cos:
      return cos(a);
    default:
      return -a;
  }
}

template <class T>
Triple<T> variables(const T& x, const T& y, const T& z) {
  return {x, y, z};
}

}  // namespace

Expression::Expression(std::string_view text) : program_(Parser(text).parse()) {}

template <class T>
T Expression::evaluate(const Triple<T>& variables) const {
  std::array<T, max_depth> stack;
  std::size_t size = 0;
  for (const auto& [operation, number] : program_) {
    if (operation == Operation::Number) {
      stack[size++] = T(number);
    } else if (operation == Operation::Variable) {
      stack[size++] = variables[static_cast<std::size_t>(number)];
    } else if (operation == Operation::Power) {
      stack[size - 1] = power(stack[size - 1], static_cast<int>(number));
    } else if (is_binary(operation)) {
      --size;
      stack[size - 1] = combined(operation, stack[size - 1], stack[size]);
    } else {
      stack[size - 1] = applied(operation, stack[size - 1]);
    }
  }
  return stack[0];
}

Function::Value Expression::at(const Point& x) const {
  using Number = Jet<double, 1>;
  const Number f = evaluate(variables(Number::variable(x.x(), 0), Number::variable(x.y(), 1),
                                      Number::variable(x.z(), 2)));
  return {f.value, {f.gradient[0], f.gradient[1], f.gradient[2]}};
}

Jet<Interval, 1> Expression::enclose(const Point& x) const {
  using Number = Jet<Interval, 1>;
  return evaluate(variables(Number::variable(x.x(), 0), Number::variable(x.y(), 1),
                            Number::variable(x.z(), 2)));
}

Jet<Interval, 2> Expression::over(const Box& box) const {
  using Number = Jet<Interval, 2>;
  return evaluate(variables(Number::variable(box.side(0), 0), Number::variable(box.side(1), 1),
                            Number::variable(box.side(2), 2)));
}

}  // namespace morskin::implicit
