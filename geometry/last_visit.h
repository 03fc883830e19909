#pragma once

/// What is made from a large array and the array itself need not be in memory at once: on a last
/// visit the pages that have been read are given back to the system on the way.

#include <algorithm>
#include <cstddef>
#include <span>
#include <type_traits>

namespace morskin::geometry {

/// Tells the system that nothing between two addresses is read before it is written again. Whole
/// large pages of it hold nothing from then on, as far as the system follows.
/// @return where the last of these pages ends, or `begin`
const char* drop_pages(const char* begin, const char* end);

/// Calls visit(block) for an array's blocks, spans that follow each other.
/// @post the elements of a large array may have lost their values
template <class Array, class Visit>
void visit_last(Array& array, Visit visit) {
  using Element = Array::value_type;
  // Smaller arrays are no large part of the peak, and their pages are soon needed again.
  constexpr std::size_t large = std::size_t{8} << 20, step = std::size_t{2} << 20;
  const std::span all(array.data(), array.size());
  const std::size_t block = step / sizeof(Element);
  const char* kept = reinterpret_cast<const char*>(all.data());
  for (std::size_t i = 0; i < all.size(); i += block) {
    const std::span part = all.subspan(i, std::min(block, all.size() - i));
    visit(part);
    if (!std::is_trivially_destructible_v<Element> || all.size_bytes() < large) continue;
    kept = drop_pages(kept, reinterpret_cast<const char*>(part.data() + part.size()));
  }
}

}  // namespace morskin::geometry
