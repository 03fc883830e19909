#pragma once

/// Leaving no temporary file behind when the user or the system ends the program.

#include <string>
#include <vector>

namespace morskin::app {

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
    hold_signals();
    try {
      watch(create());
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
