// The command's large arrays come from a pool of huge pages. Release builds of the command only:
// the library leaves the allocator alone.

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#include "app/page_pool.h"

namespace {

using morskin::app::grain;
using morskin::app::rounded_up;

constexpr std::size_t min_large = 2 * grain;

constinit morskin::app::PagePool pool;

void* allocate(std::size_t size, std::size_t alignment) {
  if (size >= min_large && alignment <= grain) {
    if (void* memory = pool.take(size)) return memory;
  }
  const std::size_t whole = rounded_up(std::max(size, alignment), alignment);
  void* memory = whole < size ? nullptr : std::aligned_alloc(alignment, whole);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void release(void* memory) {
  if (memory != nullptr && !pool.give_back(memory)) std::free(memory);
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { release(memory); }
void operator delete(void* memory, std::size_t) noexcept { release(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { release(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { release(memory); }
