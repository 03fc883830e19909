#pragma once

/// How an answer is judged, as papers/lessons/answers.py does it: a wrong one gets the first case
/// in which it fails and, where the mistake is a known one, a hint. The right answer is never said.
///
/// A right answer is asked for its known mistakes: each must be wrong, and get its own hint. So the
/// tests of the solutions are tests of the hints too.

#include <doctest/doctest.h>

#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "papers/exercises/course.h"

namespace morskin::course {

/// A wrong answer that is often given, and what it overlooks.
template <class Answer>
struct Mistake {
  Answer answer;
  std::string hint;
};

inline std::string text_of(double x) {
  std::ostringstream out;
  out << x;
  return out.str();
}
inline std::string text_of(long n) { return std::to_string(n); }
inline std::string text_of(bool is_so) { return is_so ? "true" : "false"; }
inline std::string text_of(const std::array<long, 3>& counts) {
  return text_of(counts[0]) + ", " + text_of(counts[1]) + ", " + text_of(counts[2]);
}

/// Three digits of a number are enough to know a mistake by.
inline bool agree(double a, double b) { return std::abs(a - b) <= 2e-3 * std::abs(b); }
template <class T>
bool agree(const T& a, const T& b) {
  return a == b;
}

/// Shown, and nothing else, where `is_right` is false.
inline void show_unless(bool is_right, const std::string& reply) { CHECK_MESSAGE(is_right, reply); }

/// Judges a number, or several.
template <class T, class IsRight>
void judge(const std::optional<T>& answer, const IsRight& is_right,
           const std::vector<Mistake<T>>& mistakes) {
  const auto hint_for = [&](const T& given) -> std::string {
    for (const Mistake<T>& m : mistakes) {
      if (agree(given, m.answer)) return m.hint;
    }
    return "";
  };
  show_unless(is_right(*answer), text_of(*answer) + " is not it. " + hint_for(*answer));
  if (!is_right(*answer)) return;
  for (const Mistake<T>& m : mistakes) {
    show_unless(!is_right(m.answer), "no mistake: " + text_of(m.answer));
    show_unless(hint_for(m.answer) == m.hint, "not its hint: " + text_of(m.answer));
    show_unless(m.hint.find(text_of(*answer)) == std::string::npos, "said: " + m.hint);
  }
}

/// Judges what the command reports; `words` are what has to be typed behind `build/morskin`.
inline void judge_run(Count& answer, std::size_t right, const std::string& words) {
  show_unless(*answer == static_cast<long>(right),
              text_of(*answer) + " is not it. The command is: build/morskin " + words);
}

/// The cases on which a formula is tried.
template <class Signature>
class Cases;

template <class Result, class... Inputs>
class Cases<Result(Inputs...)> {
 public:
  using Function = std::function<Result(Inputs...)>;

  /// @param names  of the inputs, with blanks between them.
  explicit Cases(const std::string& names) {
    std::istringstream words(names);
    for (std::string name; words >> name;) names_.push_back(name);
  }

  /// @param tolerance  by how much an answer may be off; for numbers only.
  void add_within(double tolerance, Result right, Inputs... inputs) {
    cases_.push_back({{inputs...}, right, tolerance});
  }
  void add(Result right, Inputs... inputs) {
    add_within(1e-5 * (1 + std::abs(static_cast<double>(right))), right, inputs...);
  }

  void judge(const std::optional<Function>& answer,
             const std::vector<Mistake<Function>>& mistakes) const {
    const std::string reply = reply_to(*answer, mistakes);
    show_unless(reply.empty(), reply);
    if (!reply.empty()) return;
    for (const Mistake<Function>& m : mistakes) {
      const std::string to_mistake = reply_to(m.answer, mistakes);
      show_unless(!to_mistake.empty(), "no mistake, whose hint is: " + m.hint);
      show_unless(to_mistake.ends_with(m.hint), "not the hint \"" + m.hint + "\": " + to_mistake);
    }
  }

 private:
  struct Case {
    std::tuple<Inputs...> inputs;
    Result right;
    double tolerance;
  };

  bool is_right(const Case& c, const Function& answer) const {
    const Result given = std::apply(answer, c.inputs);
    if constexpr (std::is_same_v<Result, bool>) return given == c.right;
    return std::abs(given - c.right) <= c.tolerance;
  }

  /// Nothing to a right answer.
  std::string reply_to(const Function& answer,
                       const std::vector<Mistake<Function>>& mistakes) const {
    for (const Case& c : cases_) {
      if (is_right(c, answer)) continue;
      std::string reply = "With " + inputs_of(c) + " it gives " +
                          text_of(std::apply(answer, c.inputs)) + ", which is not it. ";
      for (const Mistake<Function>& m : mistakes) {
        if (are_alike(answer, m.answer)) return reply + m.hint;
      }
      return reply;
    }
    return "";
  }

  std::string inputs_of(const Case& c) const {
    std::string text;
    std::size_t i = 0;
    const auto add = [&](double input) {
      text += (i == 0 ? "" : ", ") + names_.at(i) + " = " + text_of(input);
      ++i;
    };
    std::apply([&](const auto&... input) { (add(input), ...); }, c.inputs);
    return text;
  }

  /// Whether two formulas agree on all cases.
  bool are_alike(const Function& one, const Function& other) const {
    for (const Case& c : cases_) {
      const Result a = std::apply(one, c.inputs), b = std::apply(other, c.inputs);
      const bool is_one_undefined = std::isnan(static_cast<double>(a));
      if (is_one_undefined != std::isnan(static_cast<double>(b))) return false;
      if (!is_one_undefined && a != b && !agree(a, b)) return false;
    }
    return true;
  }

  std::vector<std::string> names_;
  std::vector<Case> cases_;
};

}  // namespace morskin::course
