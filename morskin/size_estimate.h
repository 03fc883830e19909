#pragma once

/// About how many vertices a mesh will have, by points that stand for the skin, without the
/// components to be dropped.
///
/// Even triangles with edges of e length scales make 2 / (sqrt 3 e^2) vertices for each demand,
/// which is the integral of rho^-2 over the skin, with min(rho, limit) for rho where a length
/// limits the edges. Where triangles of different sizes meet there are a few more.

#include "morskin/method.h"
#include "morskin/prepared_skin.h"

namespace morskin {

class SizeEstimate {
 public:
  explicit SizeEstimate(const PreparedSkin& skin);

  /// Angstrom^2; 0 where nothing stands for it.
  double area() const { return area_; }
  double max_length_scale() const { return max_length_scale_; }
  double vertices(const certify::Sizing& sizing, Method method) const;

 private:
  surface::Samples samples_;
  double area_ = 0, max_length_scale_ = 0;
};

}  // namespace morskin
