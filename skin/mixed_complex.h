#pragma once

/// The mixed complex (section 2.1): space cut into cells mu = (sigma + nu) / 2, one for each
/// simplex sigma of the regular triangulation and its dual power cell nu. In each cell the skin is
/// one quadratic patch (patch.h).
///
/// Two cells share a wall exactly when one simplex is a facet of the other. With v the vertex that
/// the larger has more, the wall lies in the plane through the midpoint of the two orthocentres,
/// normal to the part of v's direction that is orthogonal to the smaller simplex.
///
/// Cells are numbered by dimension: vertices, edges, triangles, tetrahedra, in the order of the
/// triangulation's arrays. Ties of the triangulation give cells of no volume; they do no harm.

#include <array>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"
#include "geometry/regular_triangulation.h"
#include "skin/patch.h"

namespace morskin::skin {

using geometry::AtomId;
using geometry::CellId;
using geometry::WeightedPoint;

/// One wall of a cell, seen from inside: the cell is where normal . x <= offset.
struct Wall {
  Vector normal;  ///< unit, out of the cell
  double offset;  ///< Angstrom
  CellId beyond;  ///< the cell on the other side
};

class MixedComplex {
 public:
  /// @param points         the weighted points
  /// @param triangulation  theirs
  MixedComplex(std::span<const WeightedPoint> points,
               const geometry::RegularTriangulation& triangulation);

  std::size_t size() const { return patches_.size(); }
  const Patch& patch(CellId cell) const { return patches_[cell.index()]; }
  std::span<const Wall> walls(CellId cell) const {
    return {walls_.data() + first_wall_[cell.index()],
            first_wall_[cell.index() + 1] - first_wall_[cell.index()]};
  }

  /// Dimension of the cell's simplex, 0 to 3.
  int dimension(CellId cell) const;
  /// The simplex's place in the triangulation's array of that dimension.
  std::size_t place(CellId cell) const {
    return cell.index() - first_cell_[static_cast<std::size_t>(dimension(cell))];
  }
  /// The cell of the simplex at a place in the triangulation's array of a dimension.
  CellId cell(int dimension, std::size_t place) const {
    return CellId{first_cell_[static_cast<std::size_t>(dimension)] + place};
  }

  /// Distance, Angstrom, within which a point counts as inside a cell: 2^-42 of the largest
  /// coordinate, above the rounding of a wall's offset. G is C^1 across walls, so a point taken on
  /// the wrong side by d has its G wrong by at most d^2 (papers/2.1-molecular-skin.md).
  double wall_tolerance() const { return wall_tolerance_; }

 private:
  void build_patches(std::span<const WeightedPoint> points,
                     const geometry::RegularTriangulation& triangulation);
  void build_walls(std::span<const WeightedPoint> points,
                   const geometry::RegularTriangulation& triangulation);

  std::array<std::uint32_t, 5> first_cell_{};  ///< by dimension; the last is the number of cells
  std::vector<Patch> patches_;
  std::vector<std::uint32_t> first_wall_;
  std::vector<Wall> walls_;
  double wall_tolerance_ = 0;
};

}  // namespace morskin::skin
