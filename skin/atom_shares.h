#pragma once

/// Which atoms make the skin at a point, and in what shares. Not in the paper.
///
/// A mixed cell is (sigma + nu) / 2, so a point of it is x = (s + t) / 2 with s in the simplex
/// sigma and t in its dual cell nu; N(x) = x - s (enclosure.h). The barycentric coordinates of
/// s = x - N(x) in sigma are the shares. They are continuous over the skin, and 1 for one atom on
/// its own sphere, so any property of atoms can be interpolated with them.

#include <array>
#include <cstddef>

#include "skin/skin_surface.h"

namespace morskin::skin {

struct AtomShares {
  std::array<AtomId, 4> atoms{};   ///< the first `size`, corners of the cell's simplex
  std::array<double, 4> shares{};  ///< not negative, 1 in sum; 0 beyond `size`
  std::size_t size = 0;            ///< 1 to 4
};

AtomShares atom_shares(const SkinSurface& skin, const SurfacePoint& x);

}  // namespace morskin::skin
