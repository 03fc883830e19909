#pragma once

/// Marching cubes (Lorensen & Cline 1987) of the skin's function G: what most tools do, as a point
/// of comparison that knows of no quality. Vertices lie where grid edges cross the skin, to
/// rounding. The mesh is a closed oriented 2-manifold, but nothing ties its topology to the skin's
/// when the grid is too coarse, and nothing bounds its angles; the certificate says what came out.

#include <cstddef>
#include <vector>

#include "geometry/indexed_mesh.h"
#include "morskin/method.h"

namespace morskin::baselines {

struct GridMesh {
  geometry::IndexedMesh mesh;
  std::vector<geometry::CellId> cells;  ///< by vertex, the mixed cell it lies in
  std::size_t corners = 0;              ///< grid corners at which G was found
  std::size_t grid_cells = 0;           ///< grid cells near the skin, crossed by it or not
};

/// @param step  of the grid, Angstrom. @pre step > 0
/// A grid corner exactly on the skin counts as outside and gives triangles without area; the grid
/// is laid so that the corners of no symmetric molecule do that.
/// @throws geometry::LimitReached  for more than 2^20 steps along an axis.
GridMesh marching_cubes(const skin::SkinSurface& skin, double step);

/// The grid step, Angstrom, with which marching cubes makes about as many triangles as the sweep
/// with these constants. From the skin's area and its integral of 1 / rho^2, on a coarse grid.
double step_like_sweep(const skin::SkinSurface& skin, const certify::Sizing& sizing = {});

/// The same as a method of the mesher.
morskin::Mesher marching_cubes_mesher(double step);

}  // namespace morskin::baselines
