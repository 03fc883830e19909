#pragma once

/// Child processes that run this program on one molecule each, and the signals that end a batch.

#include <signal.h>
#include <sys/types.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace morskin::app {

/// A child process that has ended.
struct EndedChild {
  pid_t id;
  int exit_code;  ///< of one that was not ended by a signal
  int signal;     ///< that ended it, or 0
  double cpu_seconds;
};

/// Children of this process, which must start them all from one thread. They die at once when this
/// process does, however it dies.
class Children {
 public:
  /// From now on signals wait for next_ended().
  Children();
  Children(const Children&) = delete;
  Children& operator=(const Children&) = delete;
  /// Ends those that run. Signals that still wait are spent.
  ~Children();

  /// Exit code of a child that did not become this program: there is no space for the file of its
  /// errors, or no /proc, which knows the program.
  static constexpr int not_started = 127;

  /// Runs this very program with the words as its arguments.
  /// @param errors  the file for what it says on standard error
  /// @throws geometry::LimitReached  the system grants no more processes
  pid_t start(const std::vector<std::string>& words, const std::filesystem::path& errors);

  /// Waits for one of these children to end; nothing if one of the end_signals came first.
  /// @pre one is running
  std::optional<EndedChild> next_ended();

  /// The signal that came.
  int stop_signal() const { return stop_signal_; }

 private:
  sigset_t waited_for_{}, before_{};
  std::vector<pid_t> running_;
  int stop_signal_ = 0;
};

}  // namespace morskin::app
