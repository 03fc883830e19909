#pragma once

/// How fast edges may grow from where the curvature makes them short. The length scale is
/// 1-Lipschitz, so edges of s length scales grow by s for each Angstrom; a solver may want less.

#include <memory>

#include "certify/sizing.h"
#include "geometry/indexed_mesh.h"
#include "geometry/run.h"
#include "surface/graded_surface.h"

namespace morskin {

/// A smaller growth than this would make all of a molecule's edges as short as its shortest.
inline constexpr double min_grading = 0.01;

struct PreparedSkin;
struct MeshingOptions;

/// The size field that limits the length scales of a skin so that edges grow by options.grading, or
/// none where the sizing lets them grow no faster anyway. Its sources are the vertices of a trial
/// mesh that is fine enough to find every place where the skin bends.
///
/// Law: with the limited length scale s of two points of the skin x and y,
///      s(x) <= 1.5 s(y) + slope |x - y|,
///      for some vertex of the trial near y allows no more there than 1.5 times y's length scale.
/// @throws what make_mesh() does
std::shared_ptr<const surface::SizeField> size_field(const PreparedSkin& skin,
                                                     const MeshingOptions& options,
                                                     const geometry::Run& run);

/// A surface, its length scales limited where there is a size field.
class SizedSurface {
 public:
  /// @param surface  must outlive this object
  /// @param sizes    may be none
  SizedSurface(const surface::Surface& surface, std::shared_ptr<const surface::SizeField> sizes)
      : surface_(surface), sizes_(std::move(sizes)) {
    if (sizes_) graded_.emplace(surface, *sizes_);
  }
  const surface::Surface& operator*() const {
    return graded_ ? static_cast<const surface::Surface&>(*graded_) : surface_;
  }
  surface::SurfacePoint sized(const surface::SurfacePoint& x) const {
    return graded_ ? graded_->graded(x) : x;
  }

 private:
  const surface::Surface& surface_;
  std::shared_ptr<const surface::SizeField> sizes_;
  std::optional<surface::GradedSurface> graded_;
};

/// How the edges of a mesh grow. An edge length e(v), the mean of those at a vertex, is set against
/// the least of e(w) + allowed |v - w| over all vertices.
struct Grading {
  double allowed = 0;  ///< Angstrom for an Angstrom
  double median = 0;   ///< of the ratios; 1 where nothing nearby is much smaller
  double most = 0;     ///< the ratio that one in a hundred exceeds
  double largest = 0;
};
/// @pre the mesh has a triangle
Grading measure_grading(const geometry::IndexedMesh& mesh, double allowed);

}  // namespace morskin
