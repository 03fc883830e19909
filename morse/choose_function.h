#pragma once

/// The Morse function to use on a skin: the one asked for, or the first of a few that is not
/// degenerate.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "morse/critical_points.h"

namespace morskin::morse {

struct ChosenFunction {
  MorseFunction function;
  CriticalPoints critical;
};

/// A further reason against a function, in words, or nothing.
using Objection = std::function<std::optional<std::string>(const ChosenFunction&)>;

/// Thrown when the function asked for, or every default, is degenerate for a skin; the text says
/// where and what to do.
class DegenerateFunction : public geometry::RefusedInput {
 public:
  using geometry::RefusedInput::RefusedInput;
};

/// Heights along y with small tilts, off the axes and off each other, fixed for all time; the
/// first is MorseFunction{}.
std::vector<MorseFunction> default_functions();

/// The function asked for, else the first default, whose critical points are not degenerate, add up
/// to the skin's Euler characteristic and meet no objection. The sum is the witness that none was
/// lost or found twice.
///
/// @param euler_characteristic  of the skin, from elsewhere: skin::DualComplex
/// @throws DegenerateFunction
ChosenFunction choose_function(const skin::SkinSurface& skin, long euler_characteristic,
                               const std::optional<MorseFunction>& asked,
                               const Objection& objection = {});

}  // namespace morskin::morse
