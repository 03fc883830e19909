#pragma once

/// What the small programs share: the last line of each says whether its claim holds.

#include <cstdio>

namespace step {

/// @return  the exit code
inline int claim(const char* words, bool holds) {
  std::printf("claim: %s: %s\n", words, holds ? "holds" : "FAILS");
  return holds ? 0 : 1;
}

}  // namespace step
