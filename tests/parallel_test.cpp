#include "geometry/parallel.h"

#include <atomic>
#include <chrono>
#include <memory>
#include <optional>
#include <stdexcept>
#include <thread>

#include "geometry/unfilled.h"
#include "tests/support/no_more_threads.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;

namespace {

void work_a_while() { std::this_thread::sleep_for(std::chrono::milliseconds(5)); }

}  // namespace

TEST_CASE("blocks cover a range once each and are the same for any number of threads") {
  for (const unsigned threads : {0U, 1U, 2U, 5U}) {
    for (const std::size_t count : {0UL, 1UL, 4096UL, 8191UL, 100003UL}) {
      CAPTURE(threads);
      CAPTURE(count);
      std::vector<int> visits(count, 0);
      std::vector<std::size_t> ends(block_count(count), count + 1);
      for_each_block(threads, count, [&](std::size_t begin, std::size_t end, std::size_t block) {
        CHECK(begin == block * usual_block);
        ends[block] = end;
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      CHECK(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
      for (std::size_t k = 0; k < ends.size(); ++k) {
        CHECK(ends[k] == std::min((k + 1) * usual_block, count));
      }
    }
  }
}

TEST_CASE("of what stands apart no two share a line of the cache, nor a pair of lines") {
  struct Count {
    std::uint32_t value = 0;
  };
  const std::vector<Apart<Count>> counts(3);
  const auto pair_of_lines = [](const Count& c) {
    return reinterpret_cast<std::uintptr_t>(&c) / 128;
  };
  for (std::size_t i = 1; i < counts.size(); ++i) {
    CHECK(pair_of_lines(counts[i]) > pair_of_lines(counts[i - 1]));
  }
}

TEST_CASE("beside a piece of work, done once, each number is in one block") {
  for (const unsigned threads : {1U, 2U, 5U}) {
    for (const std::size_t count : {std::size_t{0}, std::size_t{1}, std::size_t{1000}}) {
      CAPTURE(threads);
      CAPTURE(count);
      std::atomic<int> done = 0;
      std::vector<int> visits(count, 0);
      for_each_block_beside(
          threads, [&] { ++done; }, count,
          [&](std::size_t begin, std::size_t end, std::size_t block) {
            CHECK(begin == 10 * block);
            for (std::size_t i = begin; i < end; ++i) ++visits[i];
          },
          10);
      CHECK(done == 1);
      CHECK(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
    }
  }
}

TEST_CASE("an exception in a block comes out when all threads have ended") {
  for (const unsigned threads : {1U, 2U, 4U}) {
    std::atomic<int> at_work = 0;
    const auto caller = std::this_thread::get_id();
    const auto work = [&](std::size_t, std::size_t, std::size_t block) {
      ++at_work;
      const bool fails = block % 3 == 1 || std::this_thread::get_id() == caller;
      if (!fails) work_a_while();  // others are at work when the caller's own fails
      --at_work;
      if (fails) throw std::runtime_error("no");
    };
    CHECK_THROWS_AS(for_each_block(threads, 1000, work, 10), std::runtime_error);
    CHECK(at_work == 0);
  }
}

TEST_CASE("an exception of either of two works comes out when what was begun has ended") {
  for (const unsigned threads : {1U, 2U}) {
    std::atomic<int> begun = 0, ended = 0;
    const auto fails = [&] {
      ++begun;
      ++ended;
      throw std::runtime_error("no");
    };
    const auto works = [&] {
      ++begun;
      work_a_while();
      ++ended;
    };
    CHECK_THROWS_AS(do_both(threads, works, fails), std::runtime_error);
    CHECK(ended == 2);
    begun = ended = 0;
    CHECK_THROWS_AS(do_both(threads, fails, works), std::runtime_error);
    CHECK(ended == begun);
    CHECK(ended >= 1);
    if (threads == 1) CHECK(ended == 1);  // the second never begins
  }
}

#ifdef __GLIBC__
TEST_CASE("where the system starts no more threads those that there are do all tasks, once each") {
  const support::NoMoreThreads no_more;
  for (const std::size_t count : {std::size_t{2}, std::size_t{1000}}) {
    CAPTURE(count);
    std::vector<std::atomic<int>> visits(count);
    for_each_task(100, count, [&](std::size_t i) { ++visits[i]; });
    CHECK(std::ranges::all_of(visits, [](int n) { return n == 1; }));
  }
  int first = 0, second = 0;
  do_both(
      100, [&] { ++first; }, [&] { ++second; });
  CHECK(first == 1);
  CHECK(second == 1);
  CHECK_THROWS_AS(for_each_task(100, 200, [](std::size_t) { throw std::logic_error("no"); }),
                  std::logic_error);  // the task's, and not the missing thread's
}

TEST_CASE("where the system starts some threads and then no more, those do all tasks, once each") {
  support::for_seeds(20, [](unsigned seed) {
    std::optional<support::NoMoreThreads> no_more;
    std::vector<std::atomic<int>> visits(2000);
    for_each_task(200, visits.size(), [&](std::size_t i) {
      if (i == seed) no_more.emplace();  // while the caller still starts others
      ++visits[i];
    });
    REQUIRE(no_more);
    CHECK(std::ranges::all_of(visits, [](int n) { return n == 1; }));
  });
}
#endif

TEST_CASE("an unfilled vector makes the elements that it is given, and none of a size alone") {
  static int made = 0;
  struct Counted {
    Counted() { ++made; }
    explicit Counted(int number) : value(number) { ++made; }
    int value = 7;
  };
  UnfilledVector<Counted> elements(1000);
  elements.resize(2000);
  CHECK(made == 0);
  std::construct_at(&elements[1999], 5);
  elements.emplace_back(6);
  CHECK(made == 2);
  CHECK(elements[1999].value == 5);
  CHECK(elements[2000].value == 6);
}
