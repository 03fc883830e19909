#pragma once

/// Removal of temporary files when the user or the system ends the program.

#include <array>
#include <csignal>
#include <string>
#include <vector>

namespace morskin::app {

/// By which users and systems end a program; the last three are how queues tell of a limit.
inline constexpr std::array end_signals = {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGUSR1, SIGUSR2};

/// Removes the files of the current RemovedOnInterrupt. Safe in a signal handler.
void remove_watched_files();

/// While this exists the signals that end a program remove the named files first.
/// @pre only one exists at a time.
class RemovedOnInterrupt {
 public:
  RemovedOnInterrupt();
  RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
  RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;
  ~RemovedOnInterrupt();

  /// Calls `create`, which makes and names the files, with signals blocked.
  template <class Create>
  void guard(Create create) {
    undisturbed([&] { watch(create()); });
  }

  /// Does some quick work with signals blocked.
  template <class Work>
  void undisturbed(Work work) {
    hold_signals();
    try {
      work();
    } catch (...) {
      release_signals();
      throw;
    }
    release_signals();
  }

 private:
  void watch(std::vector<std::string> names);
  static void hold_signals();
  static void release_signals();

  std::vector<std::string> names_;
  std::vector<const char*> list_;  ///< of names_, ended by a null: all that the handler touches
};

}  // namespace morskin::app
