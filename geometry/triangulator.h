#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"
#include "geometry/predicates.h"
#include "geometry/run.h"

namespace morskin::geometry {

/// The incremental construction behind `regular_triangulation`, in flat arrays: tetrahedra over
/// numbered corners, closed to a 3-sphere by ghost tetrahedra, which join each facet of the convex
/// hull to a corner at infinity.
///
/// To points in fewer than three dimensions it adds 3 - dimension apexes, off the points' span, as
/// last corners. The span is then a face of the hull, with the lower-dimensional regular
/// triangulation in it, wherever the apexes are.
///
/// Law:    every live tetrahedron is positively oriented, and no corner is inside its orthosphere
///         in the sense of `orthosphere_side` under the atoms' ids. Hence the triangulation depends
///         on points and ids alone, not on the order of insertions.
/// Source: Bowyer 1981, Watson 1981; Devillers, Pion & Teillaud 2002, Walking in a triangulation.
class Triangulator {
 public:
  using Corner = std::uint32_t;
  /// A tetrahedron's facet: 4 * tetrahedron + the index of the opposite corner.
  using Facet = std::uint32_t;

  static constexpr std::uint32_t tetrahedron_of(Facet facet) { return facet >> 2; }
  static constexpr std::size_t index_of(Facet facet) { return facet & 3; }

  static constexpr std::size_t max_points = (std::size_t{1} << 27) - 1;
  static constexpr std::size_t max_tetrahedra = std::size_t{1}
                                                << 30;  ///< a Facet has two bits less

  struct alignas(32) Tetrahedron {
    std::array<Corner, 4> corners;
    std::array<Facet, 4> neighbours;  ///< opposite each corner, the same facet of the neighbour
  };

  /// Triangulates the points.
  ///
  /// @pre in the range of predicates.h
  /// @throws LimitReached  for more than max_points or max_tetrahedra
  explicit Triangulator(std::span<const WeightedPoint> points, const Run& run = Run());

  /// Of the points' span: -1 (no points) to 3.
  int dimension() const { return dimension_; }
  /// Some are not live: their slots are free for reuse.
  std::span<const Tetrahedron> tetrahedra() const { return tetrahedra_; }
  bool is_live(std::size_t tetrahedron) const { return states_[tetrahedron] == State::Live; }
  /// The point at a corner; nothing for an apex or infinity.
  std::optional<AtomId> atom(Corner corner) const {
    return corner < atom_count_ ? std::optional(ids_[corner]) : std::nullopt;
  }
  bool is_ghost(const Tetrahedron& t) const { return t.corners[3] == infinity; }

  /// Adds one more point, unless it is redundant, as the last corner and with the next id.
  ///
  /// @param hints  live tetrahedra near the point. One that is in conflict with it saves the walk.
  /// @pre    dimension() == 3; the point is in the range of predicates.h.
  /// @throws LimitReached  as the constructor does
  std::optional<Corner> add(const WeightedPoint& point, std::array<std::uint32_t, 2> hints);
  const WeightedPoint& point(Corner corner) const { return points_[corner]; }
  /// The tetrahedra that the last successful add() removed, and those it made. An index may be in
  /// both.
  std::span<const std::uint32_t> removed() const { return {cavity_.data(), cavity_size_}; }
  std::span<const std::uint32_t> added() const { return fillers_; }

 private:
  enum class State : std::uint8_t { Live, InCavity, Free };
  struct alignas(32) StoredPoint : WeightedPoint {};  // never across two cache lines
  static constexpr Corner infinity = no_index;

  void find_first_tetrahedron(std::span<const WeightedPoint> points, std::vector<AtomId>& order);
  void add_apexes(std::span<const WeightedPoint> points);
  void make_first_tetrahedron();
  void insert(Corner p);
  std::uint32_t locate(Corner p) const;
  bool is_in_conflict(std::uint32_t tetrahedron, Corner p) const;
  bool is_in_conflict_exactly(const Tetrahedron& t, Corner p) const;
  void grow_cavity(Corner p);
  void fill_cavity(Corner p);
  void link_by_table();
  void link_by_turning();
  Facet turn_to_rim(Facet rim, std::size_t exit) const;
  std::uint32_t allocate();

  int dimension_ = -1;
  std::size_t atom_count_ = 0;
  std::vector<StoredPoint> points_;  // in the order of insertion, then the apexes
  std::vector<AtomId> ids_;          // of the same
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<State> states_;
  std::vector<std::uint32_t> free_;
  // Of the current insertion. The vectors keep their greatest size.
  std::vector<std::uint32_t> cavity_ = std::vector<std::uint32_t>(64);  // tetrahedra in conflict
  std::size_t cavity_size_ = 0;
  std::vector<Facet> rim_ = std::vector<Facet>(64);  // the cavity's facets, seen from inside
  std::size_t rim_size_ = 0;
  std::vector<std::uint32_t> fillers_;  // the new tetrahedron on each
  // For link_by_table: corners of the current rim by small numbers, valid if the stamp is current;
  // and the new facet at each directed edge of the rim.
  struct RimNumber {
    std::uint32_t stamp = 0;
    std::uint32_t number = 0;
  };
  static constexpr std::uint32_t table_side = 64;
  std::vector<RimNumber> rim_numbers_;  // by corner + 1, so that infinity is 0
  std::vector<Facet> edge_table_ = std::vector<Facet>(table_side * table_side);
  std::uint32_t stamp_ = 0;
  std::uint32_t last_ = 0;  // where the next walk starts
};

}  // namespace morskin::geometry
