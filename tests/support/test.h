#pragma once

/// What nearly every test takes: doctest, the standard headers that tests use all over, random
/// balls, molecules, and laws tried over seeds. Nearly every header of this folder brings it along.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <random>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/support/molecules.h"
#include "tests/support/seeds.h"

namespace morskin::support {

inline bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != text.npos;
}

}  // namespace morskin::support
