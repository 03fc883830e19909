#pragma once

/// Leaving no temporary file behind when the user or the system ends the program.

#include <string>
#include <vector>

namespace morskin::app {

/// Removes what the living RemovedOnInterrupt watches. Fit for a signal handler.
void remove_watched_files();

/// While this exists SIGINT, SIGTERM and SIGHUP remove the named files before they end the program.
/// @pre only one exists at a time.
class RemovedOnInterrupt {
 public:
  RemovedOnInterrupt();
  RemovedOnInterrupt(const RemovedOnInterrupt&) = delete;
  RemovedOnInterrupt& operator=(const RemovedOnInterrupt&) = delete;
  ~RemovedOnInterrupt();

  /// Files that `create` makes and names are never left behind: no signal comes in between.
  template <class Create>
  void guard(Create create) {
    undisturbed([&] { watch(create()); });
  }

  /// Does some quick work that must not be left half done: signals wait until it is over.
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
