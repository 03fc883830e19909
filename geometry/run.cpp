#include "geometry/run.h"

#include <algorithm>
#include <string>

namespace morskin::geometry {

Run::Run(unsigned threads, Progress progress, std::stop_token stop)
    : threads_(std::max(threads, 1U)), state_(std::make_shared<State>()) {
  state_->progress = std::move(progress);
  state_->stop = std::move(stop);
}

void Run::report(double share, std::string_view detail) const {
  if (state_->stop.stop_requested()) throw Stopped();
  if (!state_->progress) return;
  if (detail.empty()) return state_->progress(state_->stage, share);
  state_->progress(std::string(state_->stage) + ", " + std::string(detail), share);
}

double Run::seconds(std::string_view stage) const {
  const auto found = state_->seconds.find(stage);
  return found == state_->seconds.end() ? 0 : found->second;
}

}  // namespace morskin::geometry
