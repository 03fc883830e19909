#include "geometry/thread_pool.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <latch>
#include <set>
#include <thread>

#include "tests/support/no_more_threads.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::ThreadPool;

TEST_CASE("work is done by the calling thread and by as many others as begin, at the same time") {
  for (const std::size_t others : {0UL, 1UL, 7UL}) {
    CAPTURE(others);
    ThreadPool pool;
    std::latch all_at_work(static_cast<std::ptrdiff_t>(others) + 1);
    std::mutex mutex;
    std::set<std::thread::id> workers;
    pool.work_together(others, [&] {
      all_at_work.arrive_and_wait();
      const std::lock_guard lock(mutex);
      workers.insert(std::this_thread::get_id());
    });
    CHECK(workers.size() == others + 1);
    CHECK(workers.contains(std::this_thread::get_id()));
  }
}

TEST_CASE("one piece of work after another is done by the same threads, and is done in the end") {
  ThreadPool pool;
  std::mutex mutex;
  std::set<std::thread::id> workers;
  for (int piece = 0; piece < 200; ++piece) {
    std::atomic<int> begun = 0, ended = 0;
    pool.work_together(3, [&] {
      ++begun;
      {
        const std::lock_guard lock(mutex);
        workers.insert(std::this_thread::get_id());
      }
      ++ended;
    });
    CHECK(ended == begun);
  }
  CHECK(workers.size() <= 4);
}

TEST_CASE("work within work, and from several threads at once, is done to its end") {
  ThreadPool pool;
  std::atomic<int> done = 0;
  const auto outer = [&] {
    for (int i = 0; i < 50; ++i) {
      std::atomic<int> begun = 0, ended = 0;
      pool.work_together(2, [&] { ++begun, ++ended; });
      CHECK(ended == begun);
      CHECK(begun >= 1);
    }
    ++done;
  };
  std::thread beside([&] { pool.work_together(2, outer); });
  pool.work_together(2, outer);
  beside.join();
  CHECK(done >= 2);
}

TEST_CASE("no thread of the pool takes a signal to the process") {
  ThreadPool pool;
  std::latch both_at_work(2);
  pool.work_together(1, [&] { both_at_work.arrive_and_wait(); });
  sigset_t user_signal, before, pending;
  sigemptyset(&user_signal);
  sigaddset(&user_signal, SIGUSR2);
  pthread_sigmask(SIG_BLOCK, &user_signal, &before);
  ::kill(::getpid(), SIGUSR2);  // ends the process if a thread takes it
  sigpending(&pending);
  CHECK(sigismember(&pending, SIGUSR2) == 1);
  int taken = 0;
  sigwait(&user_signal, &taken);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
}

#ifdef __GLIBC__
TEST_CASE("a pool that the system gives no threads leaves the work to the calling one") {
  const support::NoMoreThreads no_more;
  CHECK_THROWS_AS(std::thread([] {}).join(), std::system_error);
  ThreadPool pool;
  int calls = 0;
  pool.work_together(5, [&] { ++calls; });
  CHECK(calls == 1);
}

TEST_CASE("a call does not wait for threads that are at other work") {
  ThreadPool pool;
  std::latch both_at_work(3), is_over(1);
  std::thread other([&] {
    pool.work_together(1, [&] {
      both_at_work.arrive_and_wait();
      is_over.wait();
    });
  });
  both_at_work.arrive_and_wait();
  int calls = 0;
  {
    const support::NoMoreThreads no_more;
    pool.work_together(1, [&] { ++calls; });
  }
  CHECK(calls == 1);
  is_over.count_down();
  other.join();
}
#endif

// The thread sanitizer has no threads in a process that is forked from one with some.
#ifndef __SANITIZE_THREAD__
TEST_CASE("a forked process has a pool of its own") {
  const auto has_two_at_work = [] {
    std::latch both_at_work(2);
    geometry::thread_pool().work_together(1, [&] { both_at_work.arrive_and_wait(); });
  };
  has_two_at_work();
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    ::alarm(60);  // a wait for a thread of the parent's would have no end
    has_two_at_work();
    ::_exit(0);
  }
  int status = 0;
  REQUIRE(::waitpid(child, &status, 0) == child);
  CHECK(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
}
#endif
