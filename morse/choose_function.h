#pragma once

/// The choice of a skin's Morse function: the requested one, or the first default that is not
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

/// The requested function, or every default, is degenerate for a skin; the text names the remedy
/// and, unless only the sum of the critical points is wrong, the position.
class DegenerateFunction : public geometry::RefusedInput {
 public:
  using geometry::RefusedInput::RefusedInput;
};

/// Heights along y with small, fixed, different tilts; the first is MorseFunction{}.
std::vector<MorseFunction> default_functions();

/// The requested function, else the first default, whose critical points are not degenerate, add up
/// to the skin's Euler characteristic and meet no objection. The sum shows that none was lost or
/// found twice.
///
/// @param euler_characteristic  of the skin, from its skin::DualComplex
/// @param asked                 the requested function, if any
/// @throws DegenerateFunction
ChosenFunction choose_function(const skin::SkinSurface& skin, long euler_characteristic,
                               const std::optional<MorseFunction>& asked,
                               const Objection& objection = {});

}  // namespace morskin::morse
