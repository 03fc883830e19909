#include "python/interruptible.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <set>
#include <string_view>
#include <thread>

namespace morskin::python {

namespace {

/// Guarded by the global lock.
std::set<Interruption*> runs;
/// The thread in which Python ends, once it does; only this one may begin a run then.
std::optional<std::thread::id> last_thread;

/// No machine has as many; any larger number is as good as this.
constexpr unsigned most_threads = 1U << 20U;

unsigned threads_of(const py::object& threads) {
  if (threads.is_none()) return std::max(1U, std::thread::hardware_concurrency());
  const auto number = py::reinterpret_steal<py::object>(PyNumber_Index(threads.ptr()));
  if (!number) throw py::error_already_set();
  int beyond = 0;
  const long long count = PyLong_AsLongLongAndOverflow(number.ptr(), &beyond);
  if (beyond < 0 || (beyond == 0 && count < 1)) throw py::value_error("threads must be at least 1");
  const bool is_small = beyond == 0 && count < most_threads;
  return is_small ? static_cast<unsigned>(count) : most_threads;
}

py::error_already_set system_exit() {
  PyErr_SetNone(PyExc_SystemExit);
  return {};
}

/// Asks all runs to stop and gives the lock away until they have.
void end_runs() {
  using namespace std::chrono_literals;
  constexpr auto patience = 5s;
  const auto start = std::chrono::steady_clock::now();
  const auto is_to_wait = [&] {
    const bool is_late = std::chrono::steady_clock::now() - start > patience;
    return std::ranges::any_of(runs, [&](auto* run) { return run->is_heeded() || !is_late; });
  };
  last_thread = std::this_thread::get_id();
  while (is_to_wait()) {
    for (Interruption* run : runs) run->interrupt(system_exit());
    const py::gil_scoped_release unlocked;
    std::this_thread::sleep_for(10ms);
  }
}

}  // namespace

Interruption::Interruption(bool is_heeded) : is_heeded_(is_heeded) {
  if (last_thread && *last_thread != std::this_thread::get_id()) throw system_exit();
  runs.insert(this);
}
Interruption::~Interruption() { runs.erase(this); }

void end_runs_with_python() {
  py::module_::import("atexit").attr("register")(py::cpp_function(end_runs));
  // A forked process has one thread, and none of the others' runs.
  py::module_::import("os").attr("register_at_fork")(py::arg("after_in_child") =
                                                         py::cpp_function([] { runs.clear(); }));
}

RunOptions RunArguments::options(Interruption& interruption) const {
  RunOptions result;
  result.threads = threads_of(threads);
  result.stop = interruption.token();
  if (progress.is_none()) return result;
  result.progress = [call = py::handle(progress), &interruption](std::string_view stage,
                                                                 double share) {
    const py::gil_scoped_acquire locked;
    try {
      call(stage, share < 0 ? py::object(py::none()) : py::object(py::float_(share)));
    } catch (py::error_already_set& raised) {
      interruption.interrupt(std::move(raised));
    }
  };
  return result;
}

}  // namespace morskin::python
