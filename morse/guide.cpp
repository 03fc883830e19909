#include "morse/guide.h"

#include <algorithm>
#include <utility>

namespace morskin::morse {

Guide Guide::reversed() const {
  Guide other = *this;
  other.function = function.reversed();
  for (CriticalPoint& p : other.points) p = p.reversed();
  std::swap(other.found[0], other.found[2]);
  return other;
}

std::size_t Guide::count(int index) const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.index == index; }));
}

}  // namespace morskin::morse
