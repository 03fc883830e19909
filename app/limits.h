#pragma once

/// Limits of memory and time; at a limit the program ends with a message and exit code 6, and
/// leaves no file.

#include <cstdint>
#include <filesystem>
#include <optional>

namespace morskin::app {

/// The limits that a command was given.
struct Limits {
  std::optional<double> timeout = {};            ///< seconds of real time, up to max_timeout
  std::optional<std::uint64_t> max_memory = {};  ///< bytes
  const char* advice = "";  ///< for the message: a remedy other than a higher limit

  static constexpr double max_timeout = 1e8;  // three years
};

/// The memory of the machine or of the control group, bytes.
std::uint64_t machine_bytes();

/// From now on allocations fail with std::bad_alloc if they would add more than max_memory of data
/// to the program's present size. A stricter limit of the shell remains. If max_memory is absent,
/// it is all memory of the machine or the control group, so that the system need not kill the
/// program.
void limit_memory(const Limits& limits);

/// The message for lack of memory, with the advice of the limits. Allocates nothing.
const char* out_of_memory_text();

/// While this exists the program ends after the time of the limits, if they have one.
/// @pre only one exists at a time.
class TimeLimit {
 public:
  TimeLimit(const Limits& limits, const std::filesystem::path& input);
  TimeLimit(const TimeLimit&) = delete;
  TimeLimit& operator=(const TimeLimit&) = delete;
  ~TimeLimit() { cancel(); }

  /// Lifts the limit.
  void cancel();
};

}  // namespace morskin::app
