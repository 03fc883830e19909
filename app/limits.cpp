#include "app/limits.h"

#include <signal.h>
#include <sys/resource.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <string>

#include "app/exit_codes.h"
#include "app/interruption.h"
#include "app/report.h"
#include "app/standard_streams.h"

namespace morskin::app {
namespace {

// Messages without allocation.
char memory_text[256] = "out of memory: the input is too big for this machine";
char time_text[512];

extern "C" void end_for_lack_of_time(int) {
  remove_watched_files();
  // An error of the message itself is ignored.
  [[maybe_unused]] const ssize_t written =
      ::write(STDERR_FILENO, time_text, std::strlen(time_text));
  ::_exit(static_cast<int>(ExitCode::LimitReached));
}

// A number in a file, the first if not told which; nothing if there is none.
std::optional<std::uint64_t> number_in(const char* path, int field = 0) {
  std::ifstream file(path);
  std::uint64_t number = 0;
  for (int i = 0; i <= field; ++i) file >> number;
  return file ? std::optional(number) : std::nullopt;
}

std::uint64_t page_bytes() { return static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE)); }

// The program's size before its work; terabytes with a sanitizer.
std::uint64_t held_bytes() {
  constexpr int data_field = 5;  // proc(5), statm: data and stack, in pages
  return number_in("/proc/self/statm", data_field).value_or(0) * page_bytes();
}

}  // namespace

std::uint64_t machine_bytes() {
  std::uint64_t bytes = static_cast<std::uint64_t>(::sysconf(_SC_PHYS_PAGES)) * page_bytes();
  for (const char* path :
       {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"}) {
    bytes = std::min(bytes, number_in(path).value_or(bytes));
  }
  return bytes;
}

void limit_memory(const Limits& limits) {
  if (*limits.advice != '\0') {
    std::snprintf(memory_text, sizeof memory_text,
                  "out of memory: the mesh is too big for this machine; %s", limits.advice);
  }
  const std::uint64_t most = limits.max_memory.value_or(machine_bytes());
  rlimit limit{}, space{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0 || ::getrlimit(RLIMIT_AS, &space) != 0) return;
  const rlim_t asked = held_bytes() + most;
  const bool is_felt_first = asked < std::min(limit.rlim_cur, space.rlim_cur);
  limit.rlim_cur = std::min(limit.rlim_cur, asked);
  ::setrlimit(RLIMIT_DATA, &limit);
  if (!limits.max_memory || !is_felt_first) return;
  std::snprintf(memory_text, sizeof memory_text,
                "the memory limit of %llu byte%s (--max-memory) was reached; allow more, or %s",
                static_cast<unsigned long long>(*limits.max_memory),
                *limits.max_memory == 1 ? "" : "s", limits.advice);
}

const char* out_of_memory_text() { return memory_text; }

TimeLimit::TimeLimit(const Limits& limits, const std::filesystem::path& input) {
  if (!limits.timeout) return;
  // On a terminal the line of progress is wiped first.
  const std::string wipe = ::isatty(STDERR_FILENO) == 1 ? "\r\033[K" : "";
  std::snprintf(time_text, sizeof time_text,
                "%smorskin: %.300s: the time limit of %s s (--timeout) was reached; allow more, or "
                "%s\n",
                wipe.c_str(), printable(input.string()).c_str(), brief(*limits.timeout).c_str(),
                limits.advice);
  struct sigaction action {};
  action.sa_handler = end_for_lack_of_time;
  ::sigfillset(&action.sa_mask);
  ::sigaction(SIGALRM, &action, nullptr);
  constexpr double least = 1e-6;  // the timer's unit; 0 would stop it
  const double rounded_up = std::max(*limits.timeout, least);
  itimerval timer{};
  timer.it_value.tv_sec = static_cast<time_t>(rounded_up);
  timer.it_value.tv_usec = static_cast<suseconds_t>((rounded_up - std::floor(rounded_up)) * 1e6);
  ::setitimer(ITIMER_REAL, &timer, nullptr);
}

void TimeLimit::cancel() {
  const itimerval none{};
  ::setitimer(ITIMER_REAL, &none, nullptr);
}

}  // namespace morskin::app
