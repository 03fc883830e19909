#include "front/sweep_progress.h"

#include <algorithm>

namespace morskin::front {

PassedAtoms::PassedAtoms(const surface::Surface& surface, const morse::MorseFunction& function,
                         const geometry::Run& run)
    : run_(run) {
  if (!run_.is_watched()) return;
  const std::vector<Point> samples = surface.samples();
  constexpr std::size_t max_sample = 1 << 14;
  for (std::size_t i = 0; i < samples.size(); i += 1 + samples.size() / max_sample) {
    values_.push_back(function(samples[i]));
  }
  std::sort(values_.begin(), values_.end());
}

void PassedAtoms::passed_from_below(double value) {
  if (run_.is_watched()) raise(from_below_, share_below(value));
}

void PassedAtoms::passed_from_above(double value) {
  if (run_.is_watched()) raise(from_above_, 1 - share_below(-value));
}

double PassedAtoms::share_below(double value) const {
  const auto below = std::upper_bound(values_.begin(), values_.end(), value) - values_.begin();
  return static_cast<double>(below) / static_cast<double>(values_.size());
}

void PassedAtoms::raise(double& share, double to) {
  const std::lock_guard lock(mutex_);
  share = std::max(share, to);
  run_.report(std::min(from_below_ + from_above_, 1.0));
}

}  // namespace morskin::front
