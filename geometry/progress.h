#pragma once

#include <functional>
#include <string_view>

namespace morskin::geometry {

/// Where a run stands: the stage's name and how much of it is done, 0 to 1, or below 0 where nobody
/// can tell.
using Progress = std::function<void(std::string_view stage, double share)>;
inline constexpr double unknown_share = -1;

/// How much of one stage is done. May be empty.
using Told = std::function<void(double share)>;

}  // namespace morskin::geometry
