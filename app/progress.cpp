#include "app/progress.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace morskin::app {

ProgressLine::ProgressLine(ShowProgress when)
    : is_shown_(when == ShowProgress::Always ||
                (when == ShowProgress::Auto && ::isatty(STDERR_FILENO) == 1)) {}

void ProgressLine::show(std::string_view stage, double share) {
  const auto now = std::chrono::steady_clock::now();
  // A stage begins before anybody can tell its share.
  const bool is_new = stage != stage_ || (share >= 0 && !has_share_);
  if (!is_shown_ || (has_text_ && !is_new && now - last_ < std::chrono::milliseconds(100))) return;
  last_ = now;
  has_text_ = true;
  stage_ = stage;
  has_share_ = share >= 0;
  std::array<char, 16> percent{};
  if (has_share_) {
    std::snprintf(percent.data(), percent.size(), " %3.0f %%", std::floor(100 * share));
  }
  // Padded, so that nothing is left of a longer text.
  const int length = std::fprintf(stderr, "\r%-20s%s", stage_.c_str(), percent.data());
  std::fprintf(stderr, "%*s", std::max(width_ - length, 0), "");
  std::fflush(stderr);
  width_ = std::max(width_, length);
}

void ProgressLine::wipe() {
  if (has_text_) std::fprintf(stderr, "\r%*s\r", width_, "");
  has_text_ = false;
}

}  // namespace morskin::app
