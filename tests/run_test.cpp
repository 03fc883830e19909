#include "geometry/run.h"

#include <atomic>

#include "geometry/parallel.h"
#include "tests/support/test.h"

using morskin::geometry::Run;
using morskin::geometry::Stopped;

TEST_CASE("a stage reports under its name, gives on its result and adds up its time") {
  std::vector<std::string> stages;
  const Run run(1, [&](std::string_view stage, double share) {
    stages.push_back(std::string(stage) + " " + std::to_string(share > 0));
  });
  const Run copy = run;
  CHECK(run.stage("one", [&] {
    copy.report(0.5);
    return 7;
  }) == 7);
  const double first = run.seconds("one");
  run.stage("two", [&] { copy.report(0.5, "2 samples"); });
  copy.stage("one", [] {});
  CHECK(stages == std::vector<std::string>{"one 0", "one 1", "two 0", "two, 2 samples 1", "one 0"});
  CHECK(run.seconds("one") >= first);
  CHECK(first > 0);
  CHECK(run.seconds("three") == 0);
}

TEST_CASE("a stopped run ends at its next report, and the time until then is counted") {
  std::stop_source source;
  const Run run(1, {}, source.get_token());
  CHECK(run.is_watched());
  CHECK_FALSE(Run(4).is_watched());
  run.stage("one", [&] { run.report(0.1); });
  bool is_reached = false;
  CHECK_THROWS_AS(run.stage("two",
                            [&] {
                              source.request_stop();
                              run.report(0.2);
                              is_reached = true;
                            }),
                  Stopped);
  CHECK_FALSE(is_reached);
  CHECK(run.seconds("two") > 0);
}

TEST_CASE("no thread begins another task once one has thrown") {
  for (const unsigned threads : {1U, 2U, 4U}) {
    std::atomic<int> begun = 0;
    const auto task = [&](std::size_t i) {
      ++begun;
      if (i == 3) throw Stopped();
    };
    CHECK_THROWS_AS(morskin::geometry::for_each_task(threads, 1000000, task), Stopped);
    CHECK(begun < 500000);
  }
}

TEST_CASE("no threads counts as one") { CHECK(Run(0).threads() == 1); }
