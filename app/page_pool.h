#pragma once

/// Large arrays in huge pages, and what one leaves given to the next.
///
/// Meshing walks over a few arrays of tens of megabytes in an order that follows the front, and
/// each stage makes its own: with pages of 4 kB, each array's from the system, a good part of the
/// time goes into page faults, address translation and the clearing of pages. Where no free range
/// is large enough for an array, the pages of several get addresses side by side, which leaves them
/// as they are. What an array never wrote, or gave back on a last visit (geometry/last_visit.h), is
/// not kept. So no more pages are cleared than are in memory at once, but for those given back,
/// unless there are more free ranges than it can count, or the system refuses to move them.

#include <sys/mman.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <mutex>

namespace morskin::app {

inline constexpr std::size_t huge_page = std::size_t{2} << 20;
inline constexpr std::size_t grain = std::size_t{64} << 10;  ///< arrays take whole ones

constexpr std::size_t rounded_up(std::size_t size, std::size_t step) {
  return (size + step - 1) / step * step;
}

/// The part of an address beyond a multiple of `step`.
inline std::size_t beyond(const char* address, std::size_t step) {
  return reinterpret_cast<std::uintptr_t>(address) % step;
}
inline char* rounded_up(char* address, std::size_t step) {
  return address + (step - beyond(address, step)) % step;
}

struct Range {
  char* begin;
  std::size_t size;
  char* end() const { return begin + size; }
};

/// Ranges by ascending address, in place.
class Ranges {
 public:
  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == ranges_.size(); }
  Range& operator[](std::size_t i) { return ranges_[i]; }
  /// The index of the first that does not begin before an address.
  std::size_t index_of(const char* address) const {
    const auto begins_before = [](const Range& r, const char* a) {
      return std::less<>()(r.begin, a);
    };
    const auto* const end = ranges_.data() + size_;
    return static_cast<std::size_t>(std::lower_bound(ranges_.data(), end, address, begins_before) -
                                    ranges_.data());
  }
  /// @pre not full
  void insert(const Range& range) {
    const std::size_t i = index_of(range.begin);
    std::move_backward(&ranges_[i], ranges_.data() + size_, ranges_.data() + size_ + 1);
    ranges_[i] = range;
    ++size_;
  }
  void erase(std::size_t i) {
    std::move(ranges_.data() + i + 1, ranges_.data() + size_, ranges_.data() + i);
    --size_;
  }

 private:
  std::array<Range, 4096> ranges_{};
  std::size_t size_ = 0;
};

/// Memory for large arrays. Calls from any thread; itself in no need of memory, and ready before
/// anything is constructed.
class PagePool {
 public:
  /// Memory for an array of so many bytes, at a multiple of `grain`; nullptr where there is none,
  /// or too many arrays have some.
  void* take(std::size_t asked) {
    if (asked > max_size) return nullptr;
    const std::size_t size = rounded_up(asked, grain);
    const std::lock_guard lock(mutex_);
    if (in_use_.is_full()) return nullptr;
    std::size_t best = smallest_of_at_least(size);
    if (best == free_.size()) {
      if (!map(rounded_up(size, huge_page))) return nullptr;
      best = smallest_of_at_least(size);
      if (best == free_.size()) return nullptr;
    }
    Range& from = free_[best];
    const Range array{from.begin, size};
    from = {from.begin + size, from.size - size};
    if (from.size == 0) free_.erase(best);
    in_use_.insert(array);
    return array.begin;
  }

  /// Takes an array's memory back. @return false for memory that is not this pool's
  bool give_back(void* memory) {
    auto* const begin = static_cast<char*>(memory);
    if (beyond(begin, grain) != 0) return false;
    const std::lock_guard lock(mutex_);
    const std::size_t i = in_use_.index_of(begin);
    if (i == in_use_.size() || in_use_[i].begin != begin) return false;
    const Range array = in_use_[i];
    in_use_.erase(i);
    keep_resident(array);
    return true;
  }

 private:
  static constexpr std::size_t max_size = PTRDIFF_MAX / 2;  // more than any system has

  std::size_t smallest_of_at_least(std::size_t size) {
    std::size_t best = free_.size();
    for (std::size_t i = 0; i < free_.size(); ++i) {
      if (free_[i].size >= size && (best == free_.size() || free_[i].size < free_[best].size)) {
        best = i;
      }
    }
    return best;
  }

  /// Keeps what the system has of a range as free, and gives up the huge pages that were never
  /// written or were given back on a last visit: an array in their place would have to clear them,
  /// and pages that need no clearing would stay free beside it.
  void keep_resident(Range range) {
    char* begin = range.begin;
    for (char* page = rounded_up(begin, huge_page); page + huge_page <= range.end();
         page += huge_page) {
      if (is_resident(page)) continue;
      if (begin < page) add_free({begin, size_between(begin, page)});
      begin = page + huge_page;
      unmap(page, begin);
    }
    if (begin < range.end()) add_free({begin, size_between(begin, range.end())});
  }

  static bool is_resident(char* page) {
    unsigned char is_in_memory = 1;
    return mincore(page, 1, &is_in_memory) != 0 || (is_in_memory & 1) != 0;
  }

  void add_free(Range range) {
    const std::size_t after = free_.index_of(range.begin);
    if (after < free_.size() && range.end() == free_[after].begin) {
      range.size += free_[after].size;
      free_.erase(after);
    }
    if (after > 0 && free_[after - 1].end() == range.begin) {
      free_[after - 1].size += range.size;
    } else if (!free_.is_full()) {
      free_.insert(range);
    } else {
      unmap(range.begin, range.end());
    }
  }

  /// Makes a free range: of the huge pages of free ranges, which were too small, and of new ones.
  bool map(std::size_t size) {
    void* memory =
        mmap(nullptr, size + huge_page, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return false;
    auto* const got = static_cast<char*>(memory);
    const Range pages{rounded_up(got, huge_page), size};
    unmap(got, pages.begin);
    unmap(pages.end(), got + size + huge_page);
#ifdef MADV_HUGEPAGE  // Linux's; without it, and where its kernel refuses, pages are ordinary ones
    madvise(pages.begin, pages.size, MADV_HUGEPAGE);
#endif
    char* const end = move_free_to(pages);
    if (end == pages.begin) return false;
    add_free({pages.begin, size_between(pages.begin, end)});
    return true;
  }

  /// Gives free huge pages the addresses of a range, as many as fit into it.
  /// @return the end of the range, or where the system refused; it is unmapped from there on
  char* move_free_to(Range to) {
    for (std::size_t i = free_.size(); i-- > 0 && to.size > 0;) {
      const Range range = free_[i];
      char* const begin = rounded_up(range.begin, huge_page);
      char* const last = range.end() - beyond(range.end(), huge_page);
      if (begin >= last) continue;
      char* const end = begin + std::min(size_between(begin, last), to.size);
      const std::size_t size = size_between(begin, end);
      if (!move(begin, size, to.begin)) {
        unmap(to.begin, to.end());
        return to.begin;
      }
      to = {to.begin + size, to.size - size};
      free_.erase(i);
      if (begin > range.begin) add_free({range.begin, size_between(range.begin, begin)});
      if (end < range.end()) add_free({end, size_between(end, range.end())});
    }
    return to.end();
  }

  static std::size_t size_between(const char* begin, const char* end) {
    return static_cast<std::size_t>(end - begin);
  }
  static bool move(char* from, std::size_t size, char* to) {
#ifdef MREMAP_FIXED  // Linux's; elsewhere the range keeps as many new ones
    return mremap(from, size, size, MREMAP_MAYMOVE | MREMAP_FIXED, to) != MAP_FAILED;
#else
    unmap(from, from + size);
    return true;
#endif
  }
  static void unmap(char* begin, const char* end) {
    if (begin != end) munmap(begin, size_between(begin, end));
  }

  std::mutex mutex_;
  Ranges in_use_, free_;
};

}  // namespace morskin::app
