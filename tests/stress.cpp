// Meshes many seeded sets of balls and counts how they came out. Each has a process of its own, so
// that a crash or an endless loop is one failure among the others.
//
//   morskin_stress SETS [FIRST_SEED [METHOD [C [GOAL]]]]
//       all of them, with a line now and then and a total; METHOD is auto (default), sweep or
//       static; a mesh with an angle below GOAL degrees has failed
//   morskin_stress --balls SEED
//       one set's balls as XYZR, for the command (--model vdw)

#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "geometry/stopwatch.h"
#include "skin/model.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;
using support::Outcome;

namespace {

constexpr unsigned max_seconds = 60;  // of work on one set
constexpr unsigned max_waiting = 20;  // times as long by the clock, on a busy machine

// What the child tells its parent; short enough for one write to a pipe.
struct Message {
  Outcome::Kind kind;
  std::size_t triangles;
  std::array<char, 400> why;
};

[[noreturn]] void run_child(unsigned seed, const morskin::MeshingOptions& options, int pipe) {
  const rlimit work{max_seconds, max_seconds + 5};  // SIGXCPU at the first, SIGKILL at the second
  ::setrlimit(RLIMIT_CPU, &work);
  ::alarm(max_waiting * max_seconds);
  const Outcome outcome = support::outcome_of(support::nasty_set(seed), options);
  Message message{outcome.kind, outcome.triangles, {}};
  outcome.why.copy(message.why.data(), message.why.size() - 1);
  const bool is_told = ::write(pipe, &message, sizeof message) == sizeof message;
  ::_exit(is_told ? 0 : 1);
}

Outcome run_set(unsigned seed, const morskin::MeshingOptions& options) {
  int ends[2];
  if (::pipe(ends) != 0) return {Outcome::Kind::Failed, "no pipe", 0};
  const pid_t child = ::fork();
  if (child == 0) run_child(seed, options, ends[1]);
  ::close(ends[1]);
  Message message{};
  const bool is_told = ::read(ends[0], &message, sizeof message) == sizeof message;
  ::close(ends[0]);
  int status = 0;
  ::waitpid(child, &status, 0);
  if (is_told) return {message.kind, message.why.data(), message.triangles};
  if (!WIFSIGNALED(status)) return {Outcome::Kind::Failed, "ended without a word", 0};
  const int signal = WTERMSIG(status);
  const bool is_late = signal == SIGALRM || signal == SIGXCPU;
  const unsigned seconds = signal == SIGALRM ? max_waiting * max_seconds : max_seconds;
  return {Outcome::Kind::Failed,
          is_late ? "took more than " + std::to_string(seconds) + " s"
                  : "crashed: " + std::string(::strsignal(signal)),
          0};
}

struct Tally {
  std::size_t certified = 0, singular = 0, failed = 0, triangles = 0;

  void add(const Outcome& outcome) {
    certified += outcome.kind == Outcome::Kind::Certified;
    singular += outcome.kind == Outcome::Kind::Singular;
    failed += outcome.kind == Outcome::Kind::Failed;
    triangles += outcome.triangles;
  }
};

void print(const char* name, const Tally& tally) {
  std::printf("  %-18s %7zu certified, %6zu singular, %4zu failed, %12zu triangles\n", name,
              tally.certified, tally.singular, tally.failed, tally.triangles);
}

int run_all(unsigned sets, unsigned first, const morskin::MeshingOptions& options) {
  const geometry::Stopwatch stopwatch;
  std::array<Tally, support::nasty_kinds> by_kind;
  Tally total;
  for (unsigned i = 0; i < sets; ++i) {
    const unsigned seed = first + i;
    const Outcome outcome = run_set(seed, options);
    total.add(outcome);
    by_kind[seed % support::nasty_kinds].add(outcome);
    if (outcome.kind == Outcome::Kind::Failed) {
      std::printf("FAILED seed %u, %s: %s\n", seed,
                  support::nasty_names[seed % support::nasty_kinds].data(), outcome.why.c_str());
    }
    if ((i + 1) % 1000 == 0 && i + 1 < sets) {
      std::printf("%u of %u sets, %zu failed\n", i + 1, sets, total.failed);
    }
    std::fflush(stdout);
  }
  std::printf("%u sets from seed %u in %.0f s\n", sets, first, stopwatch.seconds());
  for (std::size_t kind = 0; kind < by_kind.size(); ++kind) {
    print(support::nasty_names[kind].data(), by_kind[kind]);
  }
  print("total", total);
  return total.failed == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

unsigned number(const char* word) { return static_cast<unsigned>(std::strtoul(word, nullptr, 10)); }

}  // namespace

int main(int count, char** words) {
  if (count == 3 && std::string_view(words[1]) == "--balls") {
    std::fputs(skin::xyzr_text(support::nasty_set(number(words[2]))).c_str(), stdout);
    return EXIT_SUCCESS;
  }
  morskin::MeshingOptions options;
  const std::string_view method = count >= 4 ? words[3] : "auto";
  const bool is_method = method == "auto" || method == "sweep" || method == "static";
  if (count >= 5) options.sizing.C = std::strtod(words[4], nullptr);
  if (count == 6) options.angle_goal_deg = std::strtod(words[5], nullptr);
  if (count < 2 || count > 6 || number(words[1]) == 0 || !is_method || !(options.sizing.C > 0)) {
    std::fputs("usage: morskin_stress SETS [FIRST_SEED [METHOD [C [GOAL]]]] | --balls SEED\n",
               stderr);
    return 2;
  }
  if (method == "static") options.method = morskin::Method::Static;
  if (method == "sweep") options.method = morskin::Method::Sweep;
  options.sizing.Q = certify::Sizing::quality_for(options.sizing.C);
  return run_all(number(words[1]), count >= 3 ? number(words[2]) : 0, options);
}
