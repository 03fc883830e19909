#pragma once

/// Work in threads where the answer does not depend on how many there are.

#include <algorithm>
#include <cstddef>
#include <future>
#include <vector>

namespace morskin::geometry {

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

/// How many chunks for_each_chunk() makes of a count: one for each thread, none below `least`, so
/// that each is worth a thread.
inline std::size_t chunk_count(unsigned threads, std::size_t count, std::size_t least = 4096) {
  return std::clamp<std::size_t>(count / least, 1, std::max(threads, 1U));
}

/// Calls work(begin, end, chunk) for consecutive parts of [0, count), each in its own thread.
template <class Work>
void for_each_chunk(unsigned threads, std::size_t count, Work work, std::size_t least = 4096) {
  const std::size_t chunks = chunk_count(threads, count, least);
  std::vector<std::future<void>> others;
  for (std::size_t c = 1; c < chunks; ++c) {
    others.push_back(std::async(std::launch::async, [&work, c, count, chunks] {
      work(c * count / chunks, (c + 1) * count / chunks, c);
    }));
  }
  work(std::size_t{0}, count / chunks, std::size_t{0});
  for (std::future<void>& other : others) other.get();
}

}  // namespace morskin::geometry
