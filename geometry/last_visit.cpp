#include "geometry/last_visit.h"

#include <sys/mman.h>

#include <cstdint>

namespace morskin::geometry {

const char* drop_pages(const char* begin, const char* end) {
  // Of huge pages only whole ones: the system would break the others up.
  constexpr std::uintptr_t page = std::uintptr_t{2} << 20;
  const auto first = (reinterpret_cast<std::uintptr_t>(begin) + page - 1) / page * page;
  const auto last = reinterpret_cast<std::uintptr_t>(end) / page * page;
  if (first >= last) return begin;
#ifdef MADV_DONTNEED  // without it they stay, which costs memory and nothing else
  madvise(reinterpret_cast<void*>(first), last - first, MADV_DONTNEED);
#endif
  return reinterpret_cast<const char*>(last);
}

}  // namespace morskin::geometry
