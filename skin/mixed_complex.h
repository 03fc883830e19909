#pragma once

/// The mixed complex (section 2.1): space cut into cells mu = (sigma + nu) / 2, one for each
/// simplex sigma of the regular triangulation and its dual power cell nu. In each cell the skin is
/// one quadratic patch (patch.h).
///
/// Two cells share a wall exactly when one simplex is a facet of the other. With v the vertex that
/// the facet lacks, the wall lies in the plane through the midpoint of the two orthocentres, normal
/// to the part of v's direction that is orthogonal to the facet.
///
/// Cells at or near the skin are kept with their patches and walls; the others, by far the most in
/// a big molecule, are made on demand. Ids of kept cells come first, then those of the others, both
/// by dimension: vertices, edges, triangles, tetrahedra, in the order of the triangulation's
/// arrays. Ties of the triangulation give cells without volume, which may have no walls along their
/// plane: SkinSurface::locate() asks more than walls there.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "geometry/grouped.h"
#include "geometry/id.h"
#include "geometry/point.h"
#include "geometry/regular_triangulation.h"
#include "geometry/run.h"
#include "geometry/unfilled.h"
#include "skin/patch.h"

namespace morskin::skin {

using geometry::AtomId;
using geometry::CellId;
using geometry::WeightedPoint;

/// One wall of a cell, which lies where normal . x <= offset.
struct Wall {
  Vector normal;  ///< unit, out of the cell
  double offset;  ///< Angstrom
  CellId beyond;  ///< the cell on the other side
};

/// The walls of a cell: those of kept cells by reference, others by value.
class Walls {
 public:
  explicit Walls(std::span<const Wall> kept) : kept_(kept) {}
  explicit Walls(std::vector<Wall> made) : made_(std::move(made)) {}

  const Wall* begin() const { return made_.empty() ? kept_.data() : made_.data(); }
  const Wall* end() const { return begin() + size(); }
  std::size_t size() const { return made_.empty() ? kept_.size() : made_.size(); }
  const Wall& operator[](std::size_t i) const { return begin()[i]; }

 private:
  std::span<const Wall> kept_;
  std::vector<Wall> made_;
};

class MixedComplex {
 public:
  /// The cells to keep: those near the skin, or all, for the skins of all times (level_set.h).
  enum class Keep { NearSkin, All };

  /// @param triangulation  of the points
  MixedComplex(std::vector<WeightedPoint> points, geometry::RegularTriangulation triangulation,
               Keep keep = Keep::NearSkin, const geometry::Run& run = geometry::Run());

  const std::vector<WeightedPoint>& points() const { return points_; }
  const geometry::RegularTriangulation& triangulation() const { return triangulation_; }

  /// Frees the triangulation's lists of facets, some 270 bytes an atom. Only the dual complex needs
  /// them; cells made on demand search for theirs.
  void forget_facets();

  std::size_t size() const { return first_number_[4]; }
  /// The number of kept cells; their ids are below it. They contain, up to rounding, every x with
  /// |G(x)| at most `nearness` times the weight of the cell's heaviest atom.
  std::uint32_t kept_size() const { return kept_size_; }
  bool is_kept(CellId cell) const { return cell.value < kept_size_; }

  Patch patch(CellId cell) const {
    return is_kept(cell) ? patches_[cell.index()] : make_patch(cell);
  }
  Walls walls(CellId cell) const {
    return is_kept(cell) ? Walls(kept_walls(cell)) : Walls(make_walls(cell));
  }
  /// @pre is_kept(cell)
  const Patch& kept_patch(CellId cell) const { return patches_[cell.index()]; }
  std::span<const Wall> kept_walls(CellId cell) const {
    return {walls_.data() + first_wall_[cell.index()],
            first_wall_[cell.index() + 1] - first_wall_[cell.index()]};
  }
  std::vector<Wall> make_walls(CellId cell) const;

  /// Dimension of the cell's simplex, 0 to 3.
  int dimension(CellId cell) const { return dimension_of(number(cell)); }
  /// The number of the cell's simplex, counted by dimension, then by index.
  std::uint32_t number(CellId cell) const;
  /// The simplex's index in the triangulation's array of its dimension.
  std::size_t simplex_index(CellId cell) const {
    const std::uint32_t n = number(cell);
    return n - first_number_[static_cast<std::size_t>(dimension_of(n))];
  }
  /// The cell of a simplex by its index in the triangulation's array of its dimension.
  CellId cell(int dimension, std::size_t index) const {
    return numbered(first_number_[static_cast<std::size_t>(dimension)] +
                    static_cast<std::uint32_t>(index));
  }

  /// The cell of an atom that is not hidden.
  CellId cell(AtomId atom) const { return cell(0, vertex_of(atom)); }

  /// The cell of the same simplex, given its cell in another complex of the same points.
  CellId same(CellId cell, const MixedComplex& other) const { return numbered(other.number(cell)); }

  /// Distance, Angstrom, by which a point may be beyond a wall and count as inside: 2^-42 of the
  /// largest coordinate, above the rounding of a wall's offset but for nearly flat simplices, for
  /// which 64 of it allow (morse/tracer.h). G is C^1 across walls, so at a distance d beyond one
  /// its value is wrong by 2 d^2 (papers/2.1-molecular-skin.md).
  double wall_tolerance() const { return wall_tolerance_; }

  static constexpr double nearness = 1.0 / 64;

 private:
  // Cell ids are the simplices' numbers with the kept ones moved to the front. A bit by number, and
  // the count of kept ones before each word of bits, convert in both directions.
  CellId numbered(std::uint32_t number) const;
  int dimension_of(std::uint32_t number) const;
  bool is_kept_number(std::uint32_t n) const { return (kept_bits_[n / 64] >> (n % 64) & 1) != 0; }

  void choose_kept(Keep keep, const geometry::Run& run);
  void mark_near_skin(const geometry::Run& run);
  template <std::size_t N>
  void mark_kept(const std::vector<double>& powers, std::size_t begin, std::size_t end);
  template <std::size_t N>
  std::vector<double> mark_kept_and_pass_down(std::vector<double> powers, const geometry::Run& run);
  template <std::size_t N>
  std::vector<double> largest_powers_of_facets(const std::vector<double>& powers) const;
  void list_edges();
  void build_patches(const geometry::Run& run);
  void build_walls(const geometry::Run& run);
  /// By simplex with N corners and facet, of the facet's walls.
  template <std::size_t N>
  using WallNumbers = std::vector<std::array<std::uint32_t, N>>;
  template <std::size_t N>
  WallNumbers<N> number_walls();
  template <std::size_t N>
  void fill_walls(const WallNumbers<N>& numbers, const geometry::Run& run);

  Patch make_patch(CellId cell) const;
  Patch make_patch_numbered(std::uint32_t number) const;
  template <std::size_t N>
  Patch make_patch(const std::array<AtomId, N>& simplex) const;
  template <std::size_t N>
  Point centre(std::size_t index) const;
  template <std::size_t N>
  Wall make_wall(const std::array<AtomId, N>& simplex, std::size_t k, const Point& facet_centre,
                 const Point& centre, CellId cell) const;
  template <std::size_t N>
  void add_walls_to_facets(std::size_t index, std::vector<Wall>& walls) const;
  template <std::size_t N>
  void add_walls_to_cofaces(std::size_t index, std::vector<Wall>& walls) const;
  template <std::size_t N>
  std::vector<std::uint32_t> cofaces(const std::array<AtomId, N>& simplex) const;
  template <std::size_t N>
  std::array<std::uint32_t, N> facets(std::size_t index) const;
  template <std::size_t N, class Visit>
  void for_each_kept_incidence(std::size_t begin, std::size_t end, Visit visit) const;
  template <std::size_t N>
  decltype(auto) simplices() const;
  std::uint32_t vertex_of(AtomId atom) const;

  std::vector<WeightedPoint> points_;
  geometry::RegularTriangulation triangulation_;
  bool are_facets_forgotten_ = false;
  std::array<std::uint32_t, 5> first_number_{};  ///< by dimension; the last is the number of cells
  std::vector<std::uint64_t> kept_bits_;         ///< by number
  std::vector<std::uint32_t> kept_before_;       ///< by word of kept_bits_
  std::uint32_t kept_size_ = 0;
  std::vector<std::uint32_t> number_of_;   ///< by kept cell
  std::vector<Patch> patches_;             ///< by kept cell
  std::vector<std::uint32_t> first_wall_;  ///< by kept cell, into walls_
  geometry::UnfilledVector<Wall> walls_;
  geometry::Grouped<std::uint32_t> edges_at_;  ///< indices of edges, ascending, by vertex
  double wall_tolerance_ = 0;
};

}  // namespace morskin::skin
