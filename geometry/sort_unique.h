#pragma once

#include <algorithm>
#include <vector>

namespace morskin::geometry {

/// Sorts, and keeps one of those that are equal. Not by std::ranges::unique, which clang 14 cannot
/// compile with the library of GCC 12.
template <class Value>
void sort_unique(std::vector<Value>& values) {
  std::sort(values.begin(), values.end());
  values.erase(std::unique(values.begin(), values.end()), values.end());
}

}  // namespace morskin::geometry
