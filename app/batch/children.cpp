#include "app/batch/children.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "app/interruption.h"
#include "geometry/error.h"

namespace morskin::app {
namespace {

void redirect(int stream, const char* file, int flags) {
  const int opened = ::open(file, flags, 0666);
  if (opened < 0 || ::dup2(opened, stream) < 0) ::_exit(Children::not_started);
  ::close(opened);
}

/// Between fork and exec: only calls that are safe there.
[[noreturn]] void become(char* const* words, const char* errors, pid_t parent) {
  // The parent may have died before it was asked for.
  if (::prctl(PR_SET_PDEATHSIG, SIGKILL) != 0 || ::getppid() != parent)
    ::_exit(Children::not_started);
  sigset_t none;
  ::sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  redirect(STDIN_FILENO, "/dev/null", O_RDONLY);
  redirect(STDOUT_FILENO, "/dev/null", O_WRONLY);
  redirect(STDERR_FILENO, errors, O_WRONLY | O_CREAT | O_TRUNC);
  ::execv("/proc/self/exe", words);
  ::_exit(Children::not_started);
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

Children::Children() {
  ::signal(SIGCHLD, SIG_DFL);  // ignored by whoever started this, children would leave no trace
  ::sigemptyset(&waited_for_);
  ::sigaddset(&waited_for_, SIGCHLD);
  for (const int number : end_signals) {
    // A signal that the caller chose to ignore (nohup) stays ignored.
    struct sigaction action {};
    ::sigaction(number, nullptr, &action);
    if (action.sa_handler != SIG_IGN) ::sigaddset(&waited_for_, number);
  }
  ::sigprocmask(SIG_BLOCK, &waited_for_, &before_);
}

Children::~Children() {
  for (const pid_t child : running_) {
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);
  }
  // Another one that asks for the end would come before the caller has cleared away.
  constexpr timespec at_once{};
  while (::sigtimedwait(&waited_for_, nullptr, &at_once) > 0) {
  }
  ::sigprocmask(SIG_SETMASK, &before_, nullptr);
}

pid_t Children::start(const std::vector<std::string>& words, const std::filesystem::path& errors) {
  std::string program = "morskin";
  std::vector<std::string> copies = words;
  std::vector<char*> pointers{program.data()};
  for (std::string& word : copies) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) {
    throw geometry::LimitReached(
        "no worker could be started: " + std::generic_category().message(errno) +
        "; take fewer --workers, or see ulimit -u");
  }
  if (child == 0) become(pointers.data(), errors.c_str(), parent);
  running_.push_back(child);
  return child;
}

std::optional<EndedChild> Children::next_ended() {
  while (true) {
    int status = 0;
    rusage used{};
    const pid_t child = ::wait4(-1, &status, WNOHANG, &used);
    if (child < 0) {
      throw std::system_error(errno, std::generic_category(), "waiting for a worker");
    }
    // A process may inherit children from the program that it replaced, or be everyone's heir as
    // the first one of a container.
    if (child > 0 && std::erase(running_, child) == 0) continue;
    if (child > 0) {
      return EndedChild{child, WIFEXITED(status) ? WEXITSTATUS(status) : 0,
                        WIFSIGNALED(status) ? WTERMSIG(status) : 0,
                        seconds(used.ru_utime) + seconds(used.ru_stime)};
    }
    const int number = ::sigwaitinfo(&waited_for_, nullptr);
    if (number > 0 && number != SIGCHLD) {
      stop_signal_ = number;
      return std::nullopt;
    }
  }
}

}  // namespace morskin::app
