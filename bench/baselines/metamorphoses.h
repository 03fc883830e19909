#pragma once

/// When and where the growing skin changes its topology: at the orthocentres z of simplices that
/// meet their duals, at t = -w. By the dimension of the simplex,
///
///     0  a sphere is born        1  two caps join in a neck
///     2  a tunnel closes         3  a void vanishes
///
/// Near z the skin is |u_n|^2 - |u_s|^2 = g with g = (w + t) / 2, whose length scale falls to
/// sqrt(|g|); so the surface jumps there from g = -h^2 to g = h^2, with h so small that the ball
/// of radius 3.6 h (2 h for spheres) about z lies in the mixed cell.

#include <vector>

#include "skin/skin_surface.h"

namespace morskin::baselines {

enum class Kind : std::uint8_t { Birth, Neck, Tunnel, Void };

/// The mesh is replaced within this many h of the orthocentre. The jump changes lengths there by
/// sqrt((k^2 + 1) / (k^2 - 1)) = 1.18 at k = 2.5, which refinement absorbs.
inline constexpr double hot_radius = 2.5;

struct Metamorphosis {
  double time = 0;  ///< -w of the orthocentre
  Kind kind = Kind::Birth;
  geometry::CellId cell;                ///< whose quadric describes the skin there
  std::vector<geometry::CellId> cells;  ///< that one, and those with the same orthocentre
  double half_width = 0;                ///< h, Angstrom

  double before() const { return time - 2 * half_width * half_width; }  ///< g = -h^2
  double after() const { return time + 2 * half_width * half_width; }   ///< g = +h^2
};

/// All before time `end`, by time and then by cell.
///
/// Cells whose orthocentre lies on a wall, as cospherical balls have them, are taken together: the
/// skin changes there only if one quadric describes it in a whole ball about the orthocentre.
///
/// @param longest_edge  of the mesh, over the length scale; by default as [U] bounds it with
///                      C = 0.08, Q = 1.65
std::vector<Metamorphosis> find_metamorphoses(const skin::SkinSurface& skin, double end,
                                              double longest_edge = 0.23);

/// The least h that doubles resolve, Angstrom: then h^2 is 2^11 units in the last place of the
/// largest weight.
double min_half_width(const skin::SkinSurface& skin);

}  // namespace morskin::baselines
