#pragma once

/// Where the skin closes about a circle: necks of the body, about an edge, and tunnels through it,
/// about the normal of a triangle. Narrow ones force small triangles, however coarse a mesh is to
/// be.

#include <vector>

#include "skin/skin_surface.h"

namespace morskin::skin {

struct Waist {
  CellId cell;
  bool is_tunnel;              ///< or else a neck
  Point centre;                ///< the orthocentre of the cell's atoms
  double radius;               ///< of the circle, Angstrom
  double demand;               ///< the integral of rho^-2 over the hyperboloid's part in the cell
  std::vector<Point> on_skin;  ///< of the circle, in the cell, at least one of each arc there
};

/// The narrowest first. A waist is a patch of one sheet that has its orthocentre and some of the
/// circle about it in its cell.
std::vector<Waist> waists(const SkinSurface& skin);

}  // namespace morskin::skin
