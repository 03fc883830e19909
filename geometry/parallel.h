#pragma once

/// Parallel loops whose result does not depend on the number of threads.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>

#include "geometry/task_trace.h"
#include "geometry/thread_pool.h"

namespace morskin::geometry {

/// Elements in a block, enough to outweigh its overhead.
inline constexpr std::size_t usual_block = 4096;

/// One of several that different threads write at the same time, in lines of the cache of its own:
/// else each thread waits for the line that another has just written. Lines come in pairs.
template <class T>
struct alignas(128) Apart : T {
  using T::T;
};

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
  std::atomic<bool> has_failed{false};
  std::exception_ptr failure;
  const auto take = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        const Traced traced(TaskTrace::Kind::Task, {}, i);
        task(i);
      }
    } catch (...) {
      next = count;
      if (!has_failed.exchange(true)) failure = std::current_exception();
    }
  };
  const Traced loop(TaskTrace::Kind::Loop);
  const std::size_t taking = std::min<std::size_t>(threads, count);
  taking > 1 ? thread_pool().work_together(taking - 1, std::ref(take)) : take();
  if (failure) std::rethrow_exception(failure);
}

/// Runs both, at the same time if `threads` > 1. Throws what either throws.
template <class First, class Second>
void do_both(unsigned threads, First first, Second second) {
  for_each_task(threads, 2, [&](std::size_t i) { i == 0 ? first() : second(); });
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
