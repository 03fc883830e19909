#include "app/page_pool.h"

#include <cstdlib>
#include <fstream>
#include <memory>
#include <thread>

#include "geometry/last_visit.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;
using app::PagePool;

namespace {

struct Array {
  char* memory;
  std::size_t size;
  std::uint64_t tag;

  // A word in every fourth kilobyte and at the end.
  template <class Visit>
  void for_each_word(Visit visit) const {
    for (std::size_t i = 0; i + 8 <= size; i += 4096) visit(memory + i);
    if (size >= 8) visit(memory + (size - 8) / 8 * 8);
  }
  void write() const {
    for_each_word([&](char* at) { *reinterpret_cast<std::uint64_t*>(at) = tag; });
  }
  bool is_kept() const {
    bool all = true;
    for_each_word([&](char* at) { all = all && *reinterpret_cast<std::uint64_t*>(at) == tag; });
    return all;
  }
};

/// Takes and gives back at random.
void use(PagePool& pool, unsigned seed, int steps) {
  Random random(seed);
  std::vector<Array> arrays;
  for (int i = 0; i < steps; ++i) {
    if (!arrays.empty() && random.uniform() < 0.48) {
      const std::size_t k = random.below(arrays.size());
      REQUIRE(arrays[k].is_kept());
      REQUIRE(pool.give_back(arrays[k].memory));
      arrays[k] = arrays.back();
      arrays.pop_back();
    } else {
      const auto size = static_cast<std::size_t>(std::exp2(random.between(3, 23)));
      auto* memory = static_cast<char*>(pool.take(size));
      REQUIRE(memory != nullptr);
      REQUIRE(reinterpret_cast<std::uintptr_t>(memory) % app::grain == 0);
      arrays.push_back({memory, size, (std::uint64_t{seed} << 32) + static_cast<unsigned>(i)});
      arrays.back().write();
    }
  }
  for (const Array& array : arrays) {
    REQUIRE(array.is_kept());
    REQUIRE(pool.give_back(array.memory));
  }
}

/// Bytes of this program in memory.
long long resident() {
  std::ifstream statm("/proc/self/statm");
  long long size = 0, pages = 0;
  statm >> size >> pages;
  return 4096 * pages;
}

}  // namespace

TEST_CASE(
    "arrays of the pool lie apart and keep what is written in them, whatever comes and goes") {
  const auto pool = std::make_unique<PagePool>();
  for_seeds(40, [&](unsigned seed) { use(*pool, seed, 120); });
}

TEST_CASE("two threads may take from the pool at once") {
  const auto pool = std::make_unique<PagePool>();
  std::thread other([&] {
    for (unsigned seed = 100; seed < 110; ++seed) use(*pool, seed, 120);
  });
  for (unsigned seed = 200; seed < 210; ++seed) use(*pool, seed, 120);
  other.join();
}

TEST_CASE("what an array leaves serves the next") {
  const auto pool = std::make_unique<PagePool>();
  const std::size_t size = 8 << 20;
  REQUIRE(pool->take(size) != nullptr);
  auto* first = static_cast<char*>(pool->take(size));
  REQUIRE(first != nullptr);
  Array{first, size, 1}.write();
  REQUIRE(pool->give_back(first));
  auto* second = static_cast<char*>(pool->take(size / 2));
  auto* third = static_cast<char*>(pool->take(size / 2));
  CHECK((second >= first && second + size / 2 <= first + size));
  CHECK((third >= first && third + size / 2 <= first + size));
  CHECK(pool->give_back(second));
  CHECK(pool->give_back(third));
  CHECK(pool->take(size) == first);
}

TEST_CASE("free pages that lie apart serve a larger array, and no more are in memory for it") {
  const std::size_t size = 8 << 20, count = 8;
  const auto pool = std::make_unique<PagePool>();
  std::vector<Array> arrays;
  for (std::size_t i = 0; i < 2 * count; ++i) {
    arrays.push_back({static_cast<char*>(pool->take(size)), size, i});
    REQUIRE(arrays.back().memory != nullptr);
    arrays.back().write();
  }
  const long long written = resident();
  for (std::size_t i = 0; i < arrays.size(); i += 2) REQUIRE(pool->give_back(arrays[i].memory));
  const Array large{static_cast<char*>(pool->take(count * size)), count * size, 100};
  REQUIRE(large.memory != nullptr);
  large.write();
  CHECK(resident() < written + static_cast<long long>(size));
  CHECK(large.is_kept());
  for (std::size_t i = 1; i < arrays.size(); i += 2) CHECK(arrays[i].is_kept());
}

TEST_CASE("pages that hold nothing are not kept, and the next array takes those that do") {
  const std::size_t size = 16 << 20;
  const auto pool = std::make_unique<PagePool>();
  std::vector<Array> halves;
  for (const std::uint64_t tag : {0U, 1U, 2U, 3U, 4U}) {
    halves.push_back({static_cast<char*>(pool->take(size / 2)), size / 2, tag});
    REQUIRE(halves.back().memory != nullptr);
    halves.back().write();
  }
  const Array dropped{static_cast<char*>(pool->take(size)), size, 10};
  REQUIRE(dropped.memory != nullptr);
  dropped.write();
  geometry::drop_pages(dropped.memory, dropped.memory + size);
  const long long before = resident();
  for (const std::size_t k : {1U, 3U}) REQUIRE(pool->give_back(halves[k].memory));
  REQUIRE(pool->give_back(dropped.memory));
  const Array next{static_cast<char*>(pool->take(size)), size, 11};
  REQUIRE(next.memory != nullptr);
  next.write();
  CHECK(resident() < before + static_cast<long long>(size / 4));
  CHECK(next.is_kept());
  for (const std::size_t k : {0U, 2U, 4U}) CHECK(halves[k].is_kept());
}

TEST_CASE("the pool takes nothing back that is not its own") {
  const auto pool = std::make_unique<PagePool>();
  auto* array = static_cast<char*>(pool->take(1 << 20));
  REQUIRE(array != nullptr);
  void* foreign = std::aligned_alloc(app::grain, app::grain);
  CHECK_FALSE(pool->give_back(foreign));
  std::free(foreign);
  CHECK_FALSE(pool->give_back(array + 16));
  CHECK_FALSE(pool->give_back(array + app::grain));
  CHECK(pool->give_back(array));
  CHECK_FALSE(pool->give_back(array));
}

TEST_CASE("the pool refuses what no system has, and more arrays than it can count, and goes on") {
  const auto pool = std::make_unique<PagePool>();
  for (const std::size_t size : {SIZE_MAX, SIZE_MAX - 1, SIZE_MAX / 2, SIZE_MAX / 4}) {
    CHECK(pool->take(size) == nullptr);
  }
  std::vector<void*> arrays;
  while (void* memory = pool->take(1)) {
    arrays.push_back(memory);
    REQUIRE(arrays.size() < 100000);
  }
  CHECK(arrays.size() > 1000);
  // Every other one first, so that as much is free in as many ranges.
  for (const std::size_t from : {0U, 1U}) {
    for (std::size_t i = from; i < arrays.size(); i += 2) CHECK(pool->give_back(arrays[i]));
  }
  CHECK(pool->take(1 << 20) != nullptr);
}
