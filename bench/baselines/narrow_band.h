#pragma once

/// The cells of a cubic grid that the skin may pass through, found without a visit to the others.
///
/// Blocks of cells are halved again and again and left out where the skin cannot be: N being
/// 1-Lipschitz, |G(y)| >= |G(x)| - 2 |N(x)| d - d^2 at a distance d from x, so that about x there
/// is no skin within
///
///     d = |G| / (|N| + sqrt(|N|^2 + |G|)).
///
/// No cell that the skin meets is lost, however fine the parts of the skin are against the grid.

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "skin/skin_surface.h"

namespace morskin::baselines {

using geometry::CellId;
using geometry::Point;

/// The index of a corner in the grid, or of the cell of which it is the lowest corner.
using GridIndex = std::array<std::uint32_t, 3>;

/// A cubic grid over the box of all balls, which holds the body.
struct Grid {
  Point origin;  ///< Angstrom
  double step;   ///< Angstrom
  int levels;    ///< 2^levels cells along each axis

  Point at(const GridIndex& p) const { return origin + step * Point(p[0], p[1], p[2]); }
};

/// @pre  step > 0, Angstrom.
/// @throws geometry::LimitReached  for more than 2^20 cells along an axis.
Grid grid_over(const skin::SkinSurface& skin, double step);

/// G at a point, with what comes along with it.
struct Sample {
  double value;         ///< G, Angstrom^2
  double length_scale;  ///< |N|, Angstrom
  CellId cell;          ///< the mixed cell that holds the point
};
inline Sample sample(const skin::SkinSurface& skin, const Point& x, CellId near) {
  const CellId cell = skin.locate(x, near);
  const skin::Patch& patch = skin.complex().patch(cell);
  const geometry::Vector n = patch.half_gradient(x);
  return {(x - patch.centre).dot(n) - patch.half_weight, n.norm(), cell};
}

/// Distance, Angstrom, about a sampled point within which there is no skin.
inline double free_distance(const Sample& s) {
  const double g = std::abs(s.value);
  return g / (s.length_scale + std::sqrt(s.length_scale * s.length_scale + g));
}

/// Calls visit(index, near) for each cell that the skin may pass through, `near` a mixed cell
/// nearby.
template <class Visit>
void for_each_cell_near_skin(const skin::SkinSurface& skin, const Grid& grid, Visit visit) {
  struct Block {
    GridIndex low;
    int level;  // 2^level cells wide
    CellId near;
  };
  // Half a block's diagonal, with 2^-20 of it added: far above the rounding of G.
  const double half_diagonal = std::sqrt(0.75) * (1 + 0x1p-20) * grid.step;
  std::vector<Block> waiting{{{0, 0, 0}, grid.levels, CellId{0U}}};
  while (!waiting.empty()) {
    const Block block = waiting.back();
    waiting.pop_back();
    const double width = std::uint32_t{1} << block.level;
    const Point middle = grid.at(block.low) + Point::Constant(0.5 * width * grid.step);
    const Sample s = sample(skin, middle, block.near);
    if (free_distance(s) > half_diagonal * width) continue;
    if (block.level == 0) {
      visit(block.low, s.cell);
      continue;
    }
    const std::uint32_t half = std::uint32_t{1} << (block.level - 1);
    for (std::uint32_t child = 8; child-- > 0;) {
      const GridIndex low{block.low[0] + half * (child & 1), block.low[1] + half * (child >> 1 & 1),
                          block.low[2] + half * (child >> 2)};
      waiting.push_back({low, block.level - 1, s.cell});
    }
  }
}

}  // namespace morskin::baselines
