#pragma once

namespace morskin::app {

/// Scripts rely on these numbers.
enum class ExitCode {
  Success = 0,  ///< meshed and certified; a check passed
  Usage = 2,    ///< the command line makes no sense
  UnreadableInput = 3,
  RefusedInput = 4,  ///< understood, but it has no smooth skin; the atoms are named
  NotCertified = 5,  ///< meshed, but the certificate failed: written as OUT.unverified
  LimitReached = 6,  ///< a limit was reached: memory, time, what growth can resolve
  UnwritableOutput = 7,
  InternalError = 70,
};

}  // namespace morskin::app
