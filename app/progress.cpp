#include "app/progress.h"

#include <unistd.h>

#include <cstdio>
#include <string>

namespace morskin::app {

ProgressLine::ProgressLine(ShowProgress when)
    : is_shown_(when == ShowProgress::Always ||
                (when == ShowProgress::Auto && ::isatty(STDERR_FILENO) == 1)) {}

void ProgressLine::show(std::string_view stage, double share) {
  const auto now = std::chrono::steady_clock::now();
  if (!is_shown_ || (has_text_ && now - last_ < std::chrono::milliseconds(100))) return;
  last_ = now;
  has_text_ = true;
  const std::string name(stage);
  std::fprintf(stderr, "\r%-20s %3.0f %%", name.c_str(), 100 * share);
  std::fflush(stderr);
}

void ProgressLine::wipe() {
  if (has_text_) std::fprintf(stderr, "\r%26s\r", "");
  has_text_ = false;
}

}  // namespace morskin::app
