// `mesh` of several models of a file: each is a run of its own, in a process of its own, so that
// its limits, its failures and its memory are no other's.

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <iostream>
#include <string>
#include <system_error>
#include <vector>

#include "app/commands.h"
#include "app/interruption.h"
#include "app/output_names.h"
#include "geometry/files/atomic_file.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

/// "a/OUT.ply" becomes "a/OUT-3.ply"; devices and pipes keep their names.
std::filesystem::path numbered(const std::filesystem::path& path, std::int64_t model) {
  if (is_special(path)) return path;
  std::filesystem::path name = path.stem();
  name += "-";
  name += std::to_string(model);
  name += path.extension();
  return path.parent_path() / name;
}

MeshArguments for_model(const MeshArguments& all, std::int64_t model) {
  MeshArguments one = all;
  one.models.reset();
  one.molecule.selection.model = model;
  one.typed.selection.model_number = std::to_string(model);
  for (std::filesystem::path& path : one.outputs) path = numbered(path, model);
  for (auto* path : {&one.report, &one.certificate, &one.areas, &one.task_trace}) {
    if (*path) *path = numbered(**path, model);
  }
  check_outputs(one);
  return one;
}

volatile pid_t running = 0;             // the run that signals are for
volatile std::sig_atomic_t passed = 0;  // the last of them

void pass_on(int signal) {
  passed = signal;
  ::kill(running, signal);
}

/// While it exists, signals that end a run go to the run alone, which removes its files first.
class PassedSignals {
 public:
  PassedSignals() {
    ::sigemptyset(&signals_);
    for (const int number : end_signals) ::sigaddset(&signals_, number);
    ::sigprocmask(SIG_BLOCK, &signals_, &before_);
    struct sigaction action {};
    action.sa_handler = pass_on;
    for (std::size_t i = 0; i < end_signals.size(); ++i)
      ::sigaction(end_signals[i], &action, &old_[i]);
  }
  PassedSignals(const PassedSignals&) = delete;
  PassedSignals& operator=(const PassedSignals&) = delete;
  ~PassedSignals() { restore(); }

  void begin(pid_t run) const {
    running = run;
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }
  /// In the run itself, and at the end.
  void restore() const {
    for (std::size_t i = 0; i < end_signals.size(); ++i)
      ::sigaction(end_signals[i], &old_[i], nullptr);
    ::sigprocmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t signals_{}, before_{};
  std::array<struct sigaction, end_signals.size()> old_{};
};

/// Whether the signal that ended a run is for all: whoever ends one means all, but a run can reach
/// a limit that is its own.
bool ends_all(int signal) {
  return signal == SIGINT || signal == SIGTERM || signal == SIGHUP ||
         (signal != 0 && signal == passed);
}

/// @return what waitpid tells of it
int run_apart(const MeshArguments& one, MeshRun run) {
  const PassedSignals signals;
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // a run does not outlive the command
    signals.restore();
    const bool is_orphan = ::getppid() != parent;
    std::_Exit(is_orphan ? EXIT_FAILURE : static_cast<int>(run(one)));
  }
  signals.begin(child);
  int status = 0;
  while (::waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  return status;
}

}  // namespace

ExitCode mesh_models(const MeshArguments& arguments, MeshRun run) {
  const std::string name = arguments.molecule.input.string();
  std::vector<MeshArguments> runs;
  {
    const skin::ReadOptions options;
    const geometry::FileBytes bytes =
        geometry::read_file(arguments.molecule.input, options.max_bytes);
    const auto present = skin::model_numbers(bytes.view(), name, options);
    for (const std::int64_t model : arguments.models->chosen_from(present, name)) {
      runs.push_back(for_model(arguments, model));
    }
  }
  int worst = 0;
  for (const MeshArguments& one : runs) {
    const int status = run_apart(one, run);
    const int signal = WIFSIGNALED(status) ? WTERMSIG(status) : 0;
    if (ends_all(signal)) ::raise(signal);
    const int code =
        WIFEXITED(status) ? WEXITSTATUS(status) : static_cast<int>(ExitCode::InternalError);
    if (code == 0) continue;
    worst = std::max(worst, code);
    std::cerr << "morskin: " << name << ": model " << *one.molecule.selection.model
              << (signal == 0 ? ": exit code " : ": ended by signal ")
              << (signal == 0 ? code : signal) << "\n";
    if (arguments.fail_fast) break;
  }
  return static_cast<ExitCode>(worst);
}

}  // namespace morskin::app
