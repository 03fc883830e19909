#include "geometry/parallel.h"

#include <doctest/doctest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>

using namespace morskin::geometry;

TEST_CASE("chunks cover a range once each and in order, for any number of threads") {
  for (const unsigned threads : {0U, 1U, 2U, 5U}) {
    for (const std::size_t count : {0UL, 1UL, 4095UL, 8192UL, 100003UL}) {
      CAPTURE(threads);
      CAPTURE(count);
      std::vector<int> visits(count, 0);
      std::vector<std::size_t> begins(chunk_count(threads, count));
      for_each_chunk(threads, count, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
        begins[chunk] = begin;
        for (std::size_t i = begin; i < end; ++i) ++visits[i];
      });
      CHECK(std::all_of(visits.begin(), visits.end(), [](int n) { return n == 1; }));
      CHECK(std::is_sorted(begins.begin(), begins.end()));
    }
  }
}

TEST_CASE("an exception of either of two works comes out when both have ended") {
  for (const unsigned threads : {1U, 2U}) {
    std::atomic<int> ended = 0;
    const auto fails = [&] {
      ++ended;
      throw std::runtime_error("no");
    };
    const auto works = [&] { ++ended; };
    CHECK_THROWS_AS(do_both(threads, works, fails), std::runtime_error);
    CHECK(ended == 2);
    ended = 0;
    CHECK_THROWS_AS(do_both(threads, fails, works), std::runtime_error);
    CHECK(ended == (threads > 1 ? 2 : 1));  // in one thread the second never begins
  }
}
