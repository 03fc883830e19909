#pragma once

/// Limits of memory and time; at a limit the program ends with a message and exit code 6, and
/// leaves no file.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace morskin::app {

/// From now on allocations fail with std::bad_alloc if they would add more than `bytes` of data to
/// the program's present size. A stricter limit of the shell remains.
/// @param bytes  absent: all memory of the machine or the control group, so that the system need
///               not kill the program
void limit_memory(std::optional<std::uint64_t> bytes);

/// The message for lack of memory. Allocates nothing.
const char* out_of_memory_text();

/// While this exists the program ends after so many seconds of real time.
/// @pre only one exists at a time.
class TimeLimit {
 public:
  /// @param seconds  absent: no limit. @pre 0 < *seconds <= max_seconds
  /// @param advice   for the message: a remedy other than more time
  TimeLimit(std::optional<double> seconds, const std::filesystem::path& input, const char* advice);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit() { cancel(); }

  static constexpr double max_seconds = 1e8;  // three years

  /// Lifts the limit.
  void cancel();
};

}  // namespace morskin::app
