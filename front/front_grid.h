#pragma once

/// Front corners by place: a hash of cells whose size follows the length scale in octaves.
///
/// A query at a point of length scale rho looks into the octave of rho. Since rho is 1-Lipschitz, a
/// corner within reach() rho of the point has its own length scale within a known factor,
/// so a corner is filed in every octave from which it can be asked for, its own and mostly one
/// more: nothing within reach is missed.

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::front {

using FrontEdgeId = geometry::Id<struct FrontEdgeTag>;

class FrontGrid {
 public:
  /// @param reach  largest query radius in units of the length scale, below 1
  /// @param largest_length_scale  a larger one counts as this
  explicit FrontGrid(double reach,
                     double largest_length_scale = std::numeric_limits<double>::infinity())
      : reach_(reach), largest_length_scale_(largest_length_scale), slots_(1024) {}

  /// The largest query radius at a place, Angstrom.
  double reach(double length_scale) const { return reach_ * counted(length_scale); }

  void insert(FrontEdgeId corner, const geometry::Point& position, double length_scale) {
    for_each_octave(length_scale, [&](int octave) {
      const Place place = place_of(octave, position);
      Cell& cell = cells_[cell_with_room(place.key)];
      cell.entries[cell.count++] = {place.offset, corner};
    });
    if (2 * keyed_ > slots_.size()) rebuild();
  }

  /// @pre the corner was inserted with the same position and length scale.
  void erase(FrontEdgeId corner, const geometry::Point& position, double length_scale) {
    for_each_octave(length_scale, [&](int octave) {
      const std::uint32_t key = place_of(octave, position).key;
      for (std::size_t slot = first_slot(key);; slot = next_slot(slot)) {
        if (slots_[slot].key != key || slots_[slot].cell == no_cell) continue;
        Cell& cell = cells_[slots_[slot].cell];
        for (std::uint32_t i = 0; i < cell.count; ++i) {
          if (cell.entries[i].corner != corner) continue;
          cell.entries[i] = cell.entries[--cell.count];
          if (cell.count == 0) unused_.push_back(std::exchange(slots_[slot].cell, no_cell));
          return;
        }
      }
    });
  }

  /// Calls visit(corner) for every corner within `reach` of a position. When two cells share a key,
  /// a corner may be visited twice, and one that lies far away may be visited.
  /// @pre reach <= reach(length_scale)
  template <class Visit>
  void for_each_within(const geometry::Point& p, double length_scale, double reach,
                       Visit visit) const {
    const int octave = octave_of(counted(length_scale));
    const double size = cell_size(octave), s = cells_per_angstrom(octave);
    const std::array low{whole((p.x() - reach) * s), whole((p.y() - reach) * s),
                         whole((p.z() - reach) * s)};
    const std::array high{whole((p.x() + reach) * s), whole((p.y() + reach) * s),
                          whole((p.z() + reach) * s)};
    // Offsets are rounded to single precision, by less than a millionth of the cell.
    const float squared_reach = static_cast<float>(reach * reach * 1.001);
    for (std::int64_t i = low[0]; i <= high[0]; ++i) {
      for (std::int64_t j = low[1]; j <= high[1]; ++j) {
        for (std::int64_t k = low[2]; k <= high[2]; ++k) {
          const Offset at = offset(p, i, j, k, size);
          const std::uint32_t key = key_of(octave, i, j, k);
          for (std::size_t slot = first_slot(key); slots_[slot].key != free_slot;
               slot = next_slot(slot)) {
            if (slots_[slot].key != key || slots_[slot].cell == no_cell) continue;
            const Cell& cell = cells_[slots_[slot].cell];
            for (std::uint32_t n = 0; n < cell.count; ++n) {
              const Entry& entry = cell.entries[n];
              const float dx = entry.offset[0] - at[0], dy = entry.offset[1] - at[1],
                          dz = entry.offset[2] - at[2];
              if (dx * dx + dy * dy + dz * dz <= squared_reach) visit(entry.corner);
            }
          }
        }
      }
    }
  }

 private:
  using Offset = std::array<float, 3>;  ///< from the cell's low corner
  struct Entry {
    Offset offset;
    FrontEdgeId corner;
  };
  static constexpr std::uint32_t free_slot = 0, no_cell = 0xFFFFFFFFU;
  /// The table's entry: a key is never taken back until the table is rebuilt, a cell is as soon as
  /// it is empty. A full cell goes on in a later slot under the same key.
  struct Slot {
    std::uint32_t key = free_slot;
    std::uint32_t cell = no_cell;
  };
  struct alignas(64) Cell {
    std::uint32_t count = 0;
    std::array<Entry, 7> entries;
  };
  struct Place {
    std::uint32_t key;
    Offset offset;
  };

  /// Twice the reach at the top of the octave, so that a query touches two cells an axis at most.
  double cell_size(int octave) const { return 4 * reach_ * power_of_two(octave); }
  double cells_per_angstrom(int octave) const { return power_of_two(-octave) / (4 * reach_); }
  /// 2^n and the octave of x from the bits: the library's functions are calls, and this is the
  /// innermost loop. @pre both are normal numbers.
  static double power_of_two(int n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + n) << 52);
  }
  static int octave_of(double x) {
    return static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023;
  }
  static std::int64_t whole(double x) {
    const auto i = static_cast<std::int64_t>(x);
    return x < static_cast<double>(i) ? i - 1 : i;
  }
  static Offset offset(const geometry::Point& p, std::int64_t i, std::int64_t j, std::int64_t k,
                       double size) {
    return {static_cast<float>(p.x() - static_cast<double>(i) * size),
            static_cast<float>(p.y() - static_cast<double>(j) * size),
            static_cast<float>(p.z() - static_cast<double>(k) * size)};
  }
  static std::uint32_t key_of(int octave, std::int64_t i, std::int64_t j, std::int64_t k) {
    std::uint64_t h = static_cast<std::uint64_t>(i) * 0x9E3779B97F4A7C15ULL +
                      static_cast<std::uint64_t>(j) * 0xC2B2AE3D27D4EB4FULL +
                      static_cast<std::uint64_t>(k) * 0x165667B19E3779F9ULL +
                      static_cast<std::uint64_t>(octave) * 0xD6E8FEB86659FD93ULL;
    h = (h ^ (h >> 32)) * 0xD6E8FEB86659FD93ULL;
    const auto key = static_cast<std::uint32_t>(h >> 32);
    return key == free_slot ? 1 : key;
  }
  Place place_of(int octave, const geometry::Point& p) const {
    const double size = cell_size(octave), s = cells_per_angstrom(octave);
    const std::int64_t i = whole(p.x() * s), j = whole(p.y() * s), k = whole(p.z() * s);
    return {key_of(octave, i, j, k), offset(p, i, j, k, size)};
  }
  template <class Visit>
  void for_each_octave(double length_scale, Visit visit) const {
    const int lowest = octave_of(counted(length_scale) / (1 + reach_));
    const int highest = octave_of(counted(length_scale) / (1 - reach_));
    for (int octave = lowest; octave <= highest; ++octave) visit(octave);
  }

  double counted(double length_scale) const {
    return std::min(length_scale, largest_length_scale_);
  }
  std::size_t first_slot(std::uint32_t key) const { return key & (slots_.size() - 1); }
  std::size_t next_slot(std::size_t slot) const { return (slot + 1) & (slots_.size() - 1); }
  bool has_room(const Slot& slot) const {
    return slot.cell == no_cell || cells_[slot.cell].count < cells_[slot.cell].entries.size();
  }
  std::uint32_t cell_with_room(std::uint32_t key) {
    std::size_t i = first_slot(key);
    while (slots_[i].key != free_slot && !(slots_[i].key == key && has_room(slots_[i]))) {
      i = next_slot(i);
    }
    if (slots_[i].key == free_slot) ++keyed_;
    slots_[i].key = key;
    if (slots_[i].cell == no_cell) slots_[i].cell = new_cell();
    return slots_[i].cell;
  }
  std::uint32_t new_cell() {
    if (unused_.empty()) {
      cells_.emplace_back();
      return static_cast<std::uint32_t>(cells_.size() - 1);
    }
    const std::uint32_t cell = unused_.back();
    unused_.pop_back();
    return cell;
  }
  /// Forgets the keys of cells that the front has left; grows when the front has grown.
  void rebuild() {
    const std::size_t live = cells_.size() - unused_.size();
    const std::size_t size = 4 * live > slots_.size() ? 2 * slots_.size() : slots_.size();
    const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(size));
    keyed_ = 0;
    for (const Slot& slot : old) {
      if (slot.cell == no_cell) continue;
      std::size_t i = first_slot(slot.key);
      while (slots_[i].key != free_slot) i = next_slot(i);
      slots_[i] = slot;
      ++keyed_;
    }
  }

  double reach_, largest_length_scale_;
  std::vector<Slot> slots_;
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> unused_;  ///< cells in no slot
  std::size_t keyed_ = 0;              ///< slots that are not free
};

}  // namespace morskin::front
