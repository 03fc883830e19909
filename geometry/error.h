#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>

namespace morskin::geometry {

/// Bad input, found at the boundary: a file that cannot be understood. The text reads
/// `file:line: what is wrong; what to do`.
class UnreadableInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Input that was understood but cannot be meshed: NaN, no atoms, a singular skin. The text names
/// the atoms.
class RefusedInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that could not be written; nothing half-written is left.
class UnwritableOutput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A limit was reached: of memory, of time, of what 32-bit ids can tell apart. The text names it
/// and says what to do.
class LimitReached : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

[[noreturn]] void fail_for_lack_of_ids(std::size_t most, const char* things);

/// Keeps 32-bit ids from running over: to be asked before another of `things` is added.
/// @throws LimitReached  when there are `most` of them
inline void require_capacity(std::size_t count, std::size_t most, const char* things) {
  if (count >= most) fail_for_lack_of_ids(most, things);
}

}  // namespace morskin::geometry
