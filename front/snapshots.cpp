#include "front/snapshots.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace morskin::front {

Snapshots::Snapshots(const morse::Guide& guide, std::vector<double> values, std::size_t count,
                     Callback callback)
    : guide_(guide), values_(std::move(values)), callback_(std::move(callback)) {
  if (guide.points.empty()) return;
  const auto [lowest, highest] =
      std::minmax_element(guide.points.begin(), guide.points.end(),
                          [](const auto& p, const auto& q) { return p.value < q.value; });
  for (std::size_t k = 1; k <= count; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(count);
    values_.push_back(lowest->value + share * (highest->value - lowest->value));
  }
  std::sort(values_.begin(), values_.end());
}

void Snapshots::finished(Front& front) {
  show_up_to(std::numeric_limits<double>::infinity(), front);
}

void Snapshots::show_up_to(double value, const Front& front) {
  for (; shown_ < values_.size() && values_[shown_] <= value; ++shown_) {
    callback_({guide_.function, front.mesh(), front});
  }
}

}  // namespace morskin::front
