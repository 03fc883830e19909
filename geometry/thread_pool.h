#pragma once

/// Threads that wait between the loops of parallel.h: to start one takes as long as a small loop.

#include <condition_variable>
#include <cstddef>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace morskin::geometry {

/// Starts threads as they are asked for and keeps them. Calls from any thread, its own too.
class ThreadPool {
 public:
  ThreadPool() = default;
  ThreadPool(const ThreadPool&) = delete;
  ThreadPool& operator=(const ThreadPool&) = delete;
  ~ThreadPool();

  /// Calls work() in this thread and, at the same time, in up to `others` threads of the pool; in
  /// fewer if the system starts no more. Returns when every call that has begun is done. A thread
  /// that has not begun by the time this one is done is neither waited for nor used.
  /// @param work  must not throw
  void work_together(std::size_t others, const std::function<void()>& work);

 private:
  struct Job;
  void start_threads(std::size_t count);
  void serve();

  std::mutex mutex_;
  std::condition_variable offered_, done_;
  std::vector<Job*> offers_;    ///< that more threads may begin
  std::size_t unassigned_ = 0;  ///< threads that have no job
  bool is_ending_ = false;
  std::vector<std::thread> threads_;
};

/// The one of this process. A forked process has one of its own, without threads at first.
ThreadPool& thread_pool();

}  // namespace morskin::geometry
