#include "python/interruptible.h"

#include <algorithm>
#include <string_view>
#include <thread>

namespace morskin::python {

RunOptions RunArguments::options(Interruption& interruption) const {
  if (threads && *threads < 1) throw py::value_error("threads must be at least 1");
  RunOptions result;
  result.threads =
      threads ? static_cast<unsigned>(*threads) : std::max(1U, std::thread::hardware_concurrency());
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
