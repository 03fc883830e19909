#pragma once

#include <cstdint>
#include <vector>

#include "front/front.h"
#include "front/tangent_disk.h"
#include "surface/surface.h"

namespace morskin::front {

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
  double max_on_sphere_;                                          ///< vertices on a whole sphere
  geometry::IdVector<geometry::CellId, std::uint32_t> vertices_;  ///< how many lie on its patch
  double largest_length_scale_ = 0;                               ///< of a vertex
  bool is_overlapping_ = false;
};

}  // namespace morskin::front
