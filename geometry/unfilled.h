#pragma once

/// Large arrays that are first written by the threads that fill them.

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace morskin::geometry {

/// Makes no elements of a size alone, so that pages are first touched, and cleared by the system,
/// in the threads that fill the array.
template <class T>
struct MakesNone : std::allocator<T> {
  static_assert(std::is_trivially_destructible_v<T>);
  template <class Other>
  struct rebind {
    using other = MakesNone<Other>;
  };
  using std::allocator<T>::allocator;

  template <class Made>
  void construct(Made*) noexcept {}
  template <class Made, class... Arguments>
  void construct(Made* at, Arguments&&... arguments) {
    std::construct_at(at, std::forward<Arguments>(arguments)...);
  }
};

/// A vector whose elements, after resize(), are to be made with std::construct_at before they are
/// read.
template <class T>
using UnfilledVector = std::vector<T, MakesNone<T>>;

}  // namespace morskin::geometry
