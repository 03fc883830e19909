#pragma once

#include <cstddef>

namespace morskin::geometry {

/// How many triangles ahead a loop over a big mesh asks for their corners' data: about what the
/// work on one triangle leaves of a memory access, and again.
constexpr std::size_t triangles_ahead = 8;

/// Asks the processor to fetch an object that will be read soon, all its cache lines. Changes
/// nothing but the time. In a big mesh the corners of triangles laid one after the other lie all
/// over the front, so that each would be waited for.
template <class T>
void prefetch(const T& object) {
  const char* const first = reinterpret_cast<const char*>(&object);
  __builtin_prefetch(first);
  if constexpr (sizeof(T) > 8) __builtin_prefetch(first + sizeof(T) - 1);
}

}  // namespace morskin::geometry
