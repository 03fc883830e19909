#include "geometry/thread_pool.h"

#include <pthread.h>
#include <signal.h>

#include <system_error>

namespace morskin::geometry {

namespace {

/// The program's own threads block signals where these would interrupt a write. A thread of the
/// pool must not take such a signal in their place, so it blocks all but those of its own faults.
void block_signals() {
  sigset_t signals;
  sigfillset(&signals);
  for (const int fault : {SIGSEGV, SIGBUS, SIGFPE, SIGILL}) {
    sigdelset(&signals, fault);
  }
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
}

// Never destroyed: static objects may still use it while the process ends.
ThreadPool* pool_of_process = new ThreadPool;

// A forked process has only the thread that forked.
[[maybe_unused]] const int registered =
    pthread_atfork(nullptr, nullptr, [] { pool_of_process = new ThreadPool; });

}  // namespace

struct ThreadPool::Job {
  const std::function<void()>& work;
  std::size_t open;  ///< how many more threads may begin it
  std::size_t at_work = 0;
};

ThreadPool& thread_pool() { return *pool_of_process; }

ThreadPool::~ThreadPool() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  offered_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void ThreadPool::work_together(std::size_t others, const std::function<void()>& work) {
  Job job{work, others};
  std::unique_lock lock(mutex_);
  std::size_t wanted = others;
  for (const Job* offer : offers_) wanted += offer->open;
  if (wanted > unassigned_) start_threads(wanted - unassigned_);
  offers_.push_back(&job);
  lock.unlock();
  for (std::size_t i = 0; i < others; ++i) offered_.notify_one();
  work();
  lock.lock();
  std::erase(offers_, &job);
  done_.wait(lock, [&] { return job.at_work == 0; });
}

void ThreadPool::start_threads(std::size_t count) {
  try {
    for (; count > 0; --count) {
      threads_.emplace_back(&ThreadPool::serve, this);
      ++unassigned_;
    }
  } catch (const std::system_error&) {
    // The system gives no more threads: those that there are do it all.
  }
}

void ThreadPool::serve() {
  block_signals();
  std::unique_lock lock(mutex_);
  while (true) {
    offered_.wait(lock, [&] { return is_ending_ || !offers_.empty(); });
    if (is_ending_) return;
    Job& job = *offers_.back();
    if (--job.open == 0) std::erase(offers_, &job);
    ++job.at_work;
    --unassigned_;
    lock.unlock();
    job.work();
    lock.lock();
    ++unassigned_;
    if (--job.at_work == 0) done_.notify_all();
  }
}

}  // namespace morskin::geometry
