// Asks for huge pages for large arrays. Meshing walks over a few arrays of tens of megabytes in an
// order that follows the front; with 4 kB pages a good part of the time goes into page faults and
// address translation. Release builds of the command only: the library leaves the allocator alone.

#include <malloc.h>
#include <sys/mman.h>

#include <cstdlib>
#include <new>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

// Large arrays are mapped by themselves and go back to the system when they are freed. Left alone,
// the C library raises the threshold with the first large array freed, up to 32 MB, and what is
// freed below it stays with the program.
[[maybe_unused]] const int threshold = mallopt(M_MMAP_THRESHOLD, huge_page);

void* allocate(std::size_t size) {
  if (size < huge_page) return std::malloc(size == 0 ? 1 : size);
  const std::size_t whole = (size + huge_page - 1) / huge_page * huge_page;
  if (whole < size) return nullptr;
  void* memory = std::aligned_alloc(huge_page, whole);
  if (memory != nullptr) madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
