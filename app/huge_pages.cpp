// Asks for huge pages for large arrays, and keeps some of those given back. Meshing walks over a
// few arrays of tens of megabytes in an order that follows the front; with 4 kB pages a good part
// of the time goes into page faults and address translation. And the kernel clears every page that
// it hands out: as arrays grow and stages follow each other the same memory would be cleared again
// and again. Release builds of the command only: the library leaves the allocator alone.

#include <malloc.h>
#include <sys/mman.h>

#include <array>
#include <cstdlib>
#include <mutex>
#include <new>
#include <utility>

namespace {

constexpr std::size_t huge_page = std::size_t{2} << 20;

// Large arrays are mapped by themselves and go back to the system when they are freed. Left alone,
// the C library raises the threshold with the first large array freed, up to 32 MB, and what is
// freed below it stays with the program.
[[maybe_unused]] const int threshold = mallopt(M_MMAP_THRESHOLD, huge_page);

std::size_t whole_pages(std::size_t size) { return (size + huge_page - 1) / huge_page * huge_page; }

// A few arrays that were given back, for the next that are asked for. What is kept has a bound that
// matters to no molecule big enough to fill the memory.
class GivenBack {
 public:
  // An array of at least `size`, not so large that much of it would lie idle; or nothing.
  void* take(std::size_t size) {
    const std::lock_guard lock(mutex_);
    Array* best = nullptr;
    for (Array& array : arrays_) {
      const bool fits = array.size >= size && array.size <= 2 * size;
      if (fits && (best == nullptr || array.size < best->size)) best = &array;
    }
    if (best == nullptr) return nullptr;
    kept_ -= best->size;
    return std::exchange(*best, {}).memory;
  }

  // Whether the array was kept.
  bool keep(void* memory, std::size_t size) {
    const std::lock_guard lock(mutex_);
    if (kept_ + size > most_kept) return false;
    for (Array& array : arrays_) {
      if (array.memory != nullptr) continue;
      array = {memory, size};
      kept_ += size;
      return true;
    }
    return false;
  }

  // Gives everything back to the system.
  void release() {
    const std::lock_guard lock(mutex_);
    for (Array& array : arrays_) std::free(std::exchange(array, {}).memory);
    kept_ = 0;
  }

 private:
  static constexpr std::size_t most_kept = std::size_t{32} << 20;
  struct Array {
    void* memory = nullptr;
    std::size_t size = 0;
  };
  std::mutex mutex_;
  std::array<Array, 16> arrays_;
  std::size_t kept_ = 0;
};
constinit GivenBack given_back;

void* allocate(std::size_t size) {
  if (size < huge_page) return std::malloc(size == 0 ? 1 : size);
  const std::size_t whole = whole_pages(size);
  if (whole < size) return nullptr;
  if (void* memory = given_back.take(whole)) return memory;
  void* memory = std::aligned_alloc(huge_page, whole);
  if (memory == nullptr) {
    given_back.release();
    memory = std::aligned_alloc(huge_page, whole);
  }
  if (memory != nullptr) madvise(memory, whole, MADV_HUGEPAGE);
  return memory;
}

}  // namespace

void* operator new(std::size_t size) {
  if (void* memory = allocate(size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t size) noexcept {
  if (size >= huge_page && given_back.keep(memory, whole_pages(size))) return;
  std::free(memory);
}
