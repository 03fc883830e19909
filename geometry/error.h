#pragma once

#include <stdexcept>
#include <string>

namespace morskin::geometry {

/// Bad input, found at the boundary: a file that cannot be understood. The text reads
/// `file:line: what is wrong; what to do`. The command's exit code is 3.
class UnreadableInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Input that was understood but cannot be meshed: NaN, no atoms, a singular skin. The text names
/// the atoms. The command's exit code is 4.
class RefusedInput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file that could not be written; nothing half-written is left. The command's exit code is 7.
class UnwritableOutput : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace morskin::geometry
