#pragma once

/// What the answers of an exercise are made of (papers/README.md, "The exercises"). A sheet of
/// answers is read by one program only, and stands in no namespace.

#include <array>
#include <functional>
#include <optional>

namespace morskin::course {

/// No answer yet. Put yours in its place, and the exercise's test is on.
inline constexpr std::nullopt_t unanswered = std::nullopt;

using Number = const std::optional<double>;
using Count = const std::optional<long>;
/// Minima, saddles, maxima.
using Counts = const std::optional<std::array<long, 3>>;
/// A formula of so many numbers; answer it with a lambda.
template <class Signature>
using Formula = const std::optional<std::function<Signature>>;

}  // namespace morskin::course

using namespace morskin::course;
