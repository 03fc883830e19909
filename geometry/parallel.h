#pragma once

/// Work in threads where the answer does not depend on how many there are.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <vector>

namespace morskin::geometry {

/// Elements that are worth taking another block for.
inline constexpr std::size_t usual_block = 4096;

/// Does both, at once when two threads are allowed. An exception of either comes out here, when
/// both have ended.
template <class First, class Second>
void do_both(unsigned threads, First first, Second second) {
  // The future waits for its thread when it goes out of scope, whatever is thrown here.
  std::future<void> other =
      std::async(threads > 1 ? std::launch::async : std::launch::deferred, second);
  first();
  other.get();
}

/// How many blocks for_each_block() makes of a count: consecutive ones of `size`, the last shorter,
/// and at least one.
inline std::size_t block_count(std::size_t count, std::size_t size = usual_block) {
  return std::max<std::size_t>((count + size - 1) / size, 1);
}

/// Calls task(i) for each i below a count. Threads take the next when they are done with one, so
/// none waits long for another. After an exception, which comes out here, no new one is begun.
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

/// Calls work(begin, end, block) for consecutive parts of [0, count), as tasks. The blocks are the
/// same for any number of threads.
template <class Work>
void for_each_block(unsigned threads, std::size_t count, Work work,
                    std::size_t size = usual_block) {
  for_each_task(threads, block_count(count, size), [&](std::size_t block) {
    work(block * size, std::min((block + 1) * size, count), block);
  });
}

/// The same beside a piece of work, which one thread begins with.
template <class First, class Work>
void for_each_block_beside(unsigned threads, First first, std::size_t count, Work work,
                           std::size_t size = usual_block) {
  for_each_task(threads, 1 + block_count(count, size), [&](std::size_t task) {
    if (task == 0) return first();
    work((task - 1) * size, std::min(task * size, count), task - 1);
  });
}

}  // namespace morskin::geometry
