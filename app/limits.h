#pragma once

/// Ends to memory and time, met with a message, exit code 6 and no file left behind.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace morskin::app {

/// From now on allocations fail, with std::bad_alloc, when they would make the program hold more
/// than `bytes` of data beyond what it holds already. A stricter limit of the shell's stays.
/// @param bytes  absent: all memory that the machine, or the control group the program runs in,
///               has; so that the system need not kill it.
void limit_memory(std::optional<std::uint64_t> bytes);

/// What to say when memory has run out. Needs none itself.
const char* out_of_memory_text();

/// While this exists the program ends after so many seconds of real time, wherever it is.
/// @pre only one exists at a time.
class TimeLimit {
 public:
  /// @param seconds  absent: no limit. @pre 0 < *seconds <= max_seconds
  /// @param advice   what else than more time would help
  TimeLimit(std::optional<double> seconds, const std::filesystem::path& input, const char* advice);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit() { cancel(); }

  static constexpr double max_seconds = 1e8;  // three years

  /// Lifts the limit: the work is done.
  void cancel();
};

}  // namespace morskin::app
