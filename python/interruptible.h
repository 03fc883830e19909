#pragma once

/// A run of the library under Python: without the global lock, so that other threads of Python go
/// on, and ended by Ctrl-C or by an exception of the progress function.

#include <pybind11/pybind11.h>

#include <chrono>
#include <exception>
#include <future>
#include <stop_token>
#include <utility>

#include "morskin/morskin.h"

namespace morskin::python {

namespace py = pybind11;

/// A run that is on, and the Python exception that ends it early. Every call is made with the
/// global lock.
class Interruption {
 public:
  /// @param is_heeded  whether the run ends soon after it is asked to
  /// @throws py::error_already_set  SystemExit, where Python is ending
  explicit Interruption(bool is_heeded = true);
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  ~Interruption();

  /// Asks the run to stop, for the first reason given.
  void interrupt(py::error_already_set reason) {
    if (!reason_) reason_ = std::make_exception_ptr(std::move(reason));
    stop_.request_stop();
  }
  bool is_heeded() const { return is_heeded_; }
  std::stop_token token() const { return stop_.get_token(); }
  void rethrow() const {
    if (reason_) std::rethrow_exception(reason_);
  }

 private:
  const bool is_heeded_;
  std::stop_source stop_;
  std::exception_ptr reason_;
};

/// Does without the global lock what cannot be interrupted, until its end. Python waits for it some
/// seconds before it ends; what takes longer, a pipe that nobody writes to, is not waited for.
class Unlocked {
 public:
  Unlocked() = default;

 private:
  Interruption run_{false};  // first, since runs are counted with the lock
  py::gil_scoped_release unlocked_;
};

/// Has all runs end when Python does, and no thread begin another. A thread that is still on then,
/// a daemon, would have to wait for a lock that is gone, which ends the process with a signal.
void end_runs_with_python();

/// How a run is done, as Python asks for it.
struct RunArguments {
  py::object threads;   ///< a whole number; None: as many as the machine has
  py::object progress;  ///< None, or called with the stage and the share that is done

  /// @param interruption  told of what `progress` raises; must outlive the run, as this must
  /// @throws py::value_error  for threads below 1
  /// @throws py::error_already_set  TypeError, for what is no whole number
  RunOptions options(Interruption& interruption) const;
};

/// Returns what work(run options) does. The work is done in a thread of its own while this one
/// looks after signals, which Python handles in its first thread only.
/// @pre  the global lock is held
/// @throws py::error_already_set  KeyboardInterrupt, or what `progress` raised
/// @throws  what `work` does
template <class Work>
auto interruptible(const RunArguments& run, const Work& work) {
  using namespace std::chrono_literals;
  Interruption interruption;
  const RunOptions options = run.options(interruption);
  auto result = std::async(std::launch::async, [&] { return work(options); });
  {
    const py::gil_scoped_release unlocked;
    while (result.wait_for(50ms) != std::future_status::ready) {
      const py::gil_scoped_acquire locked;
      if (PyErr_CheckSignals() != 0) interruption.interrupt(py::error_already_set());
    }
  }
  try {
    auto value = result.get();
    interruption.rethrow();
    return value;
  } catch (const Error&) {
    interruption.rethrow();  // whether the run was stopped or had failed before it looked
    throw;
  }
}

}  // namespace morskin::python
