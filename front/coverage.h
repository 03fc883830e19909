#pragma once

#include <cstdint>
#include <vector>

#include "front/front.h"
#include "front/tangent_disk.h"
#include "surface/surface.h"

namespace morskin::front {

/// Counts by patch, in the space of the parts of the surface that are met.
class PatchCounts {
 public:
  /// @pre cell.index() is below the number that all are told
  explicit PatchCounts(std::size_t patches) : pages_((patches + page_size - 1) / page_size) {}

  std::uint32_t& operator[](geometry::CellId cell) {
    std::vector<std::uint32_t>& page = pages_[cell.index() / page_size];
    if (page.empty()) page.resize(page_size, 0);
    return page[cell.index() % page_size];
  }
  /// @pre both are of as many patches
  void add(const PatchCounts& other);

 private:
  static constexpr std::size_t page_size = 256;
  std::vector<std::vector<std::uint32_t>> pages_;
};

/// The alarm that a patch of the surface has more vertices than fit: the front has passed itself
/// unseen, lays triangles over finished ones, and would not end by itself
/// (papers/4.3-large-molecules.md).
class Coverage : public FrontMirror {
 public:
  Coverage(const surface::Surface& surface, const TangentDisk& disk);

  bool is_overlapping() const { return is_overlapping_; }
  void follow(const FrontChange& change) override;
  void absorb(const Coverage& other);

 private:
  bool is_covered_twice(const SurfacePoint& x);

  const surface::Surface& surface_;
  const TangentDisk& disk_;
  double max_on_sphere_;             ///< vertices on a whole sphere
  PatchCounts vertices_;             ///< that lie on a patch
  double largest_length_scale_ = 0;  ///< of a vertex
  bool is_overlapping_ = false;
};

}  // namespace morskin::front
