#include "geometry/task_trace.h"

#include <array>
#include <nlohmann/json.hpp>

namespace morskin::geometry {

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
                      {"tid", span.worker},
                      {"ts", span.begin * microseconds},
                      {"dur", (span.end - span.begin) * microseconds},
                      {"args", {{"number", span.number}}}});
  }
  return nlohmann::ordered_json{{"traceEvents", std::move(events)}}.dump() + "\n";
}

}  // namespace morskin::geometry
