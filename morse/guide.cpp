#include "morse/guide.h"

#include <algorithm>

namespace morskin::morse {

std::size_t Guide::count(int index) const {
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [&](const auto& p) { return p.index == index; }));
}

}  // namespace morskin::morse
