#pragma once

/// Front corners by position: a hash of cells whose size follows the length scale in bands, each
/// from a power of four to the next.
///
/// A query at a point of length scale rho looks into the band of rho. Since rho is 1-Lipschitz, a
/// corner within max_radius() of the point has its own length scale within a known factor,
/// so a corner is filed in every band from which it can be asked for, its own and perhaps one
/// or two more: nothing within the radius is missed.

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

using geometry::no_index;
using FrontEdgeId = geometry::Id<struct FrontEdgeTag>;

class FrontGrid {
 public:
  /// The keys of the boxes that a corner is filed in, from the lowest band up.
  using Keys = std::array<std::uint32_t, 3>;

  /// @param radius  largest query radius in units of the length scale, at most 0.85: corners within
  ///                it differ by less than a factor 16 in length scale, and take three bands
  /// @param largest_length_scale  a larger one counts as this
  explicit FrontGrid(double radius,
                     double largest_length_scale = std::numeric_limits<double>::infinity())
      : radius_(radius),
        largest_length_scale_(largest_length_scale),
        lowest_share_((1 - margin) / (1 + radius)),
        highest_share_((1 + margin) / (1 - radius)),
        cells_per_angstrom_(1 / (8 * radius)),
        first_(1024, no_index) {}

  /// The largest query radius at a point of this length scale, Angstrom.
  double max_radius(double length_scale) const { return radius_ * counted(length_scale); }

  /// @return the keys for erase()
  Keys insert(FrontEdgeId corner, const geometry::Point& position, double length_scale) {
    const double counts_as = counted(length_scale);
    const int highest = band_of(counts_as * highest_share_);
    Keys keys{no_index, no_index, no_index};
    std::size_t filed = 0;
    for (int band = band_of(counts_as * lowest_share_); band <= highest; ++band) {
      const double size = cell_size(band);
      const Box box = box_of(band, position);
      const std::uint32_t key = keys[filed++] = key_of(band, box);
      Cell& cell = cells_[cell_with_space(key)];
      const std::uint32_t n = cell.count++;
      cell.x[n] = offset(position.x(), box[0], size);
      cell.y[n] = offset(position.y(), box[1], size);
      cell.z[n] = offset(position.z(), box[2], size);
      cell.corners[n] = corner;
    }
    return keys;
  }

  /// @pre insert() returned these keys.
  void erase(FrontEdgeId corner, const Keys& keys) {
    for (const std::uint32_t key : keys) {
      if (key != no_index) erase(corner, key);
    }
  }

  /// Calls visit(corner) for every corner within `radius` of a position. When two boxes share a
  /// key, a corner may be visited twice, and one that lies far away may be visited.
  /// @pre radius <= max_radius(length_scale)
  template <class Visit>
  void for_each_within(const geometry::Point& p, double length_scale, double radius,
                       Visit visit) const {
    const int band = band_of(counted(length_scale));
    const double size = cell_size(band), s = cells_per_angstrom(band);
    const Box low{whole((p.x() - radius) * s), whole((p.y() - radius) * s),
                  whole((p.z() - radius) * s)};
    const Box high{whole((p.x() + radius) * s), whole((p.y() + radius) * s),
                   whole((p.z() + radius) * s)};
    // Offsets are rounded to single precision, by less than a millionth of the cell.
    const float squared_radius = static_cast<float>(radius * radius * 1.001);
    // Visited together: a loop over the few of each cell would end where no processor can guess.
    std::array<FrontEdgeId, 8 * cell_capacity> near;
    std::uint32_t found = 0;
    const auto visit_all = [&] {
      for (std::uint32_t n = 0; n < found; ++n) visit(near[n]);
      found = 0;
    };
    Box box;
    for (box[0] = low[0]; box[0] <= high[0]; ++box[0]) {
      const float x = offset(p.x(), box[0], size);
      for (box[1] = low[1]; box[1] <= high[1]; ++box[1]) {
        const float y = offset(p.y(), box[1], size);
        for (box[2] = low[2]; box[2] <= high[2]; ++box[2]) {
          const float z = offset(p.z(), box[2], size);
          const std::uint32_t key = key_of(band, box);
          for (std::uint32_t c = first(key); c != no_index; c = cells_[c].next) {
            if (cells_[c].key != key) continue;
            if (found > near.size() - cell_capacity) visit_all();
            found += find_near(cells_[c], x, y, z, squared_radius, &near[found]);
          }
        }
      }
    }
    visit_all();
  }

 private:
  using Box = std::array<std::int64_t, 3>;  ///< a cell's position, in cells from the origin
  static constexpr std::uint32_t cell_capacity = 8;
  static constexpr double margin = 1e-12;  ///< for rounding, at the border of two bands
  static constexpr float far = std::numeric_limits<float>::infinity();
  static constexpr std::array<float, cell_capacity> all_far{far, far, far, far, far, far, far, far};
  /// Corners in one box, as offsets from its low corner; what is empty lies infinitely far. Boxes
  /// with the same slot in the table of first cells are a list, and so are the cells of a box that
  /// needs more than one.
  struct alignas(64) Cell {
    std::array<float, cell_capacity> x = all_far, y{}, z{};
    std::uint32_t key = 0, next = no_index, count = 0;
    std::array<FrontEdgeId, cell_capacity> corners;
  };

  /// Puts those of a cell that are near into an array that holds all. The distances are
  /// calculated together, so that the compiler can take four in one instruction; a quarter of the
  /// corners are near, and no branch guesses which.
  /// @return how many
  static std::uint32_t find_near(const Cell& cell, float x, float y, float z, float squared_radius,
                                 FrontEdgeId* near) {
    std::array<float, cell_capacity> squared;
    for (std::uint32_t n = 0; n < cell_capacity; ++n) {
      const float dx = cell.x[n] - x, dy = cell.y[n] - y, dz = cell.z[n] - z;
      squared[n] = dx * dx + dy * dy + dz * dz;
    }
    std::uint32_t count = 0;
    for (std::uint32_t n = 0; n < cell_capacity; ++n) {
      near[count] = cell.corners[n];
      count += static_cast<std::uint32_t>(squared[n] <= squared_radius);
    }
    return count;
  }

  /// Twice the radius at the top of the band, so that a query touches two cells an axis at most.
  double cell_size(int band) const { return 8 * radius_ * power_of_four(band); }
  double cells_per_angstrom(int band) const { return power_of_four(-band) * cells_per_angstrom_; }
  /// 4^n and the band of x from the bits: the library's functions are calls, and this is the
  /// innermost loop. @pre both are normal numbers.
  static double power_of_four(int n) {
    return std::bit_cast<double>(static_cast<std::uint64_t>(1023 + 2 * n) << 52);
  }
  static int band_of(double x) {
    return (static_cast<int>(std::bit_cast<std::uint64_t>(x) >> 52) - 1023) >> 1;
  }
  static std::int64_t whole(double x) {
    const auto i = static_cast<std::int64_t>(x);
    return x < static_cast<double>(i) ? i - 1 : i;
  }
  static float offset(double x, std::int64_t i, double size) {
    return static_cast<float>(x - static_cast<double>(i) * size);
  }
  Box box_of(int band, const geometry::Point& p) const {
    const double s = cells_per_angstrom(band);
    return {whole(p.x() * s), whole(p.y() * s), whole(p.z() * s)};
  }
  static std::uint32_t key_of(int band, const Box& box) {
    const std::uint64_t h = static_cast<std::uint64_t>(box[0]) * 0x9E3779B97F4A7C15ULL +
                            static_cast<std::uint64_t>(box[1]) * 0xC2B2AE3D27D4EB4FULL +
                            static_cast<std::uint64_t>(box[2]) * 0x165667B19E3779F9ULL +
                            static_cast<std::uint64_t>(band) * 0xD6E8FEB86659FD93ULL;
    return static_cast<std::uint32_t>(((h ^ (h >> 32)) * 0xD6E8FEB86659FD93ULL) >> 33);
  }

  double counted(double length_scale) const {
    return std::min(length_scale, largest_length_scale_);
  }
  std::uint32_t& first(std::uint32_t key) { return first_[key & (first_.size() - 1)]; }
  std::uint32_t first(std::uint32_t key) const { return first_[key & (first_.size() - 1)]; }

  void erase(FrontEdgeId corner, std::uint32_t key) {
    for (std::uint32_t* link = &first(key);; link = &cells_[*link].next) {
      Cell& cell = cells_[*link];
      if (cell.key != key || !take_out(cell, corner)) continue;
      if (cell.count == 0) {
        unused_.push_back(*link);
        *link = cell.next;
      }
      return;
    }
  }
  static bool take_out(Cell& cell, FrontEdgeId corner) {
    std::uint32_t i = 0;
    while (i < cell.count && cell.corners[i] != corner) ++i;
    if (i == cell.count) return false;
    const std::uint32_t last = --cell.count;
    cell.x[i] = cell.x[last];
    cell.y[i] = cell.y[last];
    cell.z[i] = cell.z[last];
    cell.corners[i] = cell.corners[last];
    cell.x[last] = far;
    return true;
  }
  std::uint32_t cell_with_space(std::uint32_t key) {
    for (std::uint32_t c = first(key); c != no_index; c = cells_[c].next) {
      if (cells_[c].key == key && cells_[c].count < cell_capacity) return c;
    }
    if (unused_.empty()) {
      unused_.push_back(static_cast<std::uint32_t>(cells_.size()));
      cells_.emplace_back();
      if (4 * cells_.size() > first_.size()) grow();
    }
    const std::uint32_t cell = unused_.back();
    unused_.pop_back();
    cells_[cell].key = key;
    cells_[cell].next = std::exchange(first(key), cell);
    return cell;
  }
  /// Doubles the table of first cells; with four slots for each cell, lists are short.
  void grow() {
    const std::vector<std::uint32_t> old =
        std::exchange(first_, std::vector<std::uint32_t>(2 * first_.size(), no_index));
    for (std::uint32_t c : old) {
      while (c != no_index) {
        const std::uint32_t after = cells_[c].next;
        cells_[c].next = std::exchange(first(cells_[c].key), c);
        c = after;
      }
    }
  }

  double radius_, largest_length_scale_;
  double lowest_share_, highest_share_;  ///< of the length scale: of corners within the radius
  double cells_per_angstrom_;            ///< in band 0
  std::vector<std::uint32_t> first_;     ///< by key modulo its size: a cell, or none
  std::vector<Cell> cells_;
  std::vector<std::uint32_t> unused_;  ///< cells in no list
};

}  // namespace morskin::front
