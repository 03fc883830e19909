#include "app/interruption.h"

#include <signal.h>
#include <unistd.h>

#include <atomic>
#include <utility>

namespace morskin::app {
namespace {

constexpr int time_limit_signal = SIGALRM;  // app/limits.cpp handles it

// The files that the handler removes: it may read lock-free atomics only.
std::atomic<const char* const*> watched = nullptr;
static_assert(std::atomic<const char* const*>::is_always_lock_free);

extern "C" void remove_and_end(int number) {
  remove_watched_files();
  ::signal(number, SIG_DFL);
  ::raise(number);
}

sigset_t signal_set() {
  sigset_t set;
  ::sigemptyset(&set);
  for (const int number : end_signals) ::sigaddset(&set, number);
  ::sigaddset(&set, time_limit_signal);
  return set;
}

}  // namespace

void remove_watched_files() {
  for (const char* const* name = watched.load(); name != nullptr && *name != nullptr; ++name) {
    ::unlink(*name);
  }
}

RemovedOnInterrupt::RemovedOnInterrupt() {
  // Makes a closed pipe an error of the write, with its own message and exit code.
  ::signal(SIGPIPE, SIG_IGN);
  struct sigaction action {};
  action.sa_handler = remove_and_end;
  action.sa_mask = signal_set();
  for (const int number : end_signals) {
    // A signal that the caller chose to ignore (nohup) stays ignored.
    struct sigaction old {};
    ::sigaction(number, nullptr, &old);
    if (old.sa_handler != SIG_IGN) ::sigaction(number, &action, nullptr);
  }
}

RemovedOnInterrupt::~RemovedOnInterrupt() { watched.store(nullptr); }

void RemovedOnInterrupt::watch(std::vector<std::string> names) {
  watched.store(nullptr);
  names_ = std::move(names);
  list_.clear();
  for (const std::string& name : names_) list_.push_back(name.c_str());
  list_.push_back(nullptr);
  watched.store(list_.data());
}

void RemovedOnInterrupt::hold_signals() {
  const sigset_t set = signal_set();
  ::sigprocmask(SIG_BLOCK, &set, nullptr);
}

void RemovedOnInterrupt::release_signals() {
  const sigset_t set = signal_set();
  ::sigprocmask(SIG_UNBLOCK, &set, nullptr);
}

}  // namespace morskin::app
