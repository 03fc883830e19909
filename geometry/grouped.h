#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace morskin::geometry {

/// Items by the group they belong to, those of a group one after the other.
template <class Item>
struct Grouped {
  std::vector<std::uint32_t> first = {0};  ///< by group, into items; then their number
  std::vector<Item> items = {};

  std::size_t group_count() const { return first.size() - 1; }
  std::span<const Item> of(std::size_t group) const {
    return std::span(items).subspan(first[group], first[group + 1] - first[group]);
  }
  std::span<Item> of(std::size_t group) {
    return std::span(items).subspan(first[group], first[group + 1] - first[group]);
  }
};

/// Sorts items by counting; those of a group stay in their order.
/// @param for_each  for_each(visit) calls visit(group, item) for each item, every time the same
template <class Item, class ForEach>
Grouped<Item> grouped(std::size_t group_count, ForEach for_each) {
  std::vector<std::uint32_t> first(group_count + 2, 0);
  for_each([&](std::size_t group, const Item&) { ++first[group + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<Item> items(first.back());
  for_each([&](std::size_t group, const Item& item) { items[first[group + 1]++] = item; });
  first.pop_back();
  return {std::move(first), std::move(items)};
}

}  // namespace morskin::geometry
