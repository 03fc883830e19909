#pragma once

#ifdef __GLIBC__

#include <pthread.h>

#include <cstddef>

namespace morskin::support {

/// While it lives the system starts no thread: none has room for its stack.
class NoMoreThreads {
 public:
  NoMoreThreads() {
    ::pthread_getattr_default_np(&usual_);
    pthread_attr_t attributes = usual_;
    ::pthread_attr_setstacksize(&attributes, std::size_t{1} << 60);
    ::pthread_setattr_default_np(&attributes);
  }
  NoMoreThreads(const NoMoreThreads&) = delete;
  NoMoreThreads& operator=(const NoMoreThreads&) = delete;
  ~NoMoreThreads() { ::pthread_setattr_default_np(&usual_); }

 private:
  pthread_attr_t usual_{};
};

}  // namespace morskin::support

#endif
