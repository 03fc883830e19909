#include "geometry/task_trace.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

namespace morskin::geometry {

namespace {

/// A number that no other living thread has.
class ThreadNumber {
 public:
  ThreadNumber() {
    const std::lock_guard lock(mutex);
    const auto free = std::ranges::find(taken, false);
    value = static_cast<std::uint32_t>(free - taken.begin());
    free == taken.end() ? taken.push_back(true) : void(*free = true);
  }
  ~ThreadNumber() {
    const std::lock_guard lock(mutex);
    taken[value] = false;
  }
  ThreadNumber(const ThreadNumber&) = delete;
  ThreadNumber& operator=(const ThreadNumber&) = delete;

  std::uint32_t value;

 private:
  static inline std::mutex mutex;
  static inline std::vector<bool> taken;
};

}  // namespace

std::uint32_t number_of_this_thread() {
  thread_local const ThreadNumber number;
  return number.value;
}

std::string TaskTrace::json() const {
  constexpr std::array kinds{"stage", "loop", "task", "box"};
  constexpr double microseconds = 1e6;  // Chrome's unit
  const std::lock_guard lock(mutex_);
  nlohmann::ordered_json events = nlohmann::ordered_json::array();
  for (const Span& span : spans_) {
    const char* const kind = kinds[static_cast<std::size_t>(span.kind)];
    events.push_back({{"ph", "X"},
                      {"cat", kind},
                      {"name", span.name.empty() ? kind : std::string(span.name)},
                      {"pid", 1},
                      {"tid", span.thread},
                      {"ts", span.begin * microseconds},
                      {"dur", (span.end - span.begin) * microseconds},
                      {"args", {{"number", span.number}}}});
  }
  return nlohmann::ordered_json{{"traceEvents", std::move(events)}}.dump() + "\n";
}

}  // namespace morskin::geometry
