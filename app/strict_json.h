#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

namespace morskin::app {

/// A report as text: one JSON object over several lines, ended by a newline.
///
/// JSON knows neither infinities nor NaN: a field `x` that is one becomes null, and a field
/// `x_reason` after it says why. The same holds of an array with such a number.
std::string strict_json(const nlohmann::ordered_json& report);

}  // namespace morskin::app
