#pragma once

/// Parallel loops whose result does not depend on the number of threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <vector>

namespace morskin::geometry {

/// Elements in a block, enough to outweigh its overhead.
inline constexpr std::size_t usual_block = 4096;

/// Runs both, at the same time if `threads` > 1. Throws what either throws, after both have ended.
template <class First, class Second>
void do_both(unsigned threads, First first, Second second) {
  // The future's destructor waits for its thread, also if first() throws.
  std::future<void> other =
      std::async(threads > 1 ? std::launch::async : std::launch::deferred, second);
  first();
  other.get();
}

/// The number of blocks of `size` elements, the last shorter, that for_each_block() makes: at least
/// one.
inline std::size_t block_count(std::size_t count, std::size_t size = usual_block) {
  return std::max<std::size_t>((count + size - 1) / size, 1);
}

/// Calls task(i) for each i below `count`; each thread takes the next i when it is done with one.
/// After an exception, which comes out here, no other i is begun.
template <class Task>
void for_each_task(unsigned threads, std::size_t count, Task task) {
  std::atomic<std::size_t> next{0};
  const auto take = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    } catch (...) {
      next = count;
      throw;
    }
  };
  std::vector<std::future<void>> others;
  for (std::size_t i = 1; i < std::min<std::size_t>(threads, count); ++i) {
    others.push_back(std::async(std::launch::async, take));
  }
  take();
  for (std::future<void>& other : others) other.get();
}

/// Calls work(begin, end, block) for consecutive blocks of [0, count), which do not depend on the
/// number of threads.
template <class Work>
void for_each_block(unsigned threads, std::size_t count, Work work,
                    std::size_t size = usual_block) {
  for_each_task(threads, block_count(count, size), [&](std::size_t block) {
    work(block * size, std::min((block + 1) * size, count), block);
  });
}

/// The same, with first() as an additional task, the first.
template <class First, class Work>
void for_each_block_beside(unsigned threads, First first, std::size_t count, Work work,
                           std::size_t size = usual_block) {
  for_each_task(threads, 1 + block_count(count, size), [&](std::size_t task) {
    if (task == 0) return first();
    work((task - 1) * size, std::min(task * size, count), task - 1);
  });
}

}  // namespace morskin::geometry
