#pragma once

/// Memory asked for before it is needed. A pass over a mesh knows early which vertices and
/// neighbours it will come to, and where these lie the processor cannot guess.

#include <cstddef>

namespace morskin::geometry {

/// How many elements ahead a pass asks for what it will visit.
inline constexpr std::size_t prefetch_ahead = 16;

/// A hint, without effect but on time, for any address.
inline void prefetch(const void* address) {
  __builtin_prefetch(address);
  // Says that there is an effect: a function that only asks ahead would be left out as one that
  // does nothing.
  __asm__ volatile("");
}

}  // namespace morskin::geometry
