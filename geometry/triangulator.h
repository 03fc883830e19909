#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"
#include "geometry/predicates.h"
#include "geometry/run.h"
#include "geometry/unfilled.h"

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
///
/// Of many points those of one round of `spatial_order` are inserted in several regions of space at
/// once. A region has the tetrahedra with their centre in it and those that it makes, and takes a
/// point only if all that the point removes, and all that borders on it, belongs to the region.
/// What other regions do can neither change nor see it: a tetrahedron that borders on another
/// region's is in no cavity, so it stays, and of it the other region reads only the corners and
/// whose it is. So each insertion is the one that it would be alone, before or after those of any
/// other region; the whole is always the triangulation of the points inserted so far. Points left
/// over at the borders are inserted in the regions united two by two, and at last in all of space,
/// each as soon as its region and the one that it would have touched are united.
/// By the law above the result is the same. The regions depend on the points alone, never on the
/// number of threads. Source: Bowyer 1981, Watson 1981; Devillers, Pion & Teillaud 2002, Walking in
/// a triangulation.
class Triangulator {
 public:
  using Corner = std::uint32_t;
  /// A tetrahedron's facet: 4 * tetrahedron + the index of the opposite corner.
  using Facet = std::uint32_t;

  static constexpr std::uint32_t tetrahedron_of(Facet facet) { return facet >> 2; }
  static constexpr std::size_t index_of(Facet facet) { return facet & 3; }

  static constexpr std::size_t max_points = (std::size_t{1} << 27) - 1;
  /// A Facet has two bits less.
  static constexpr std::size_t max_tetrahedra = std::size_t{1} << 30;

  struct alignas(32) Tetrahedron {
    std::array<Corner, 4> corners;
    std::array<Facet, 4> neighbours;  ///< opposite each corner, the same facet of the neighbour
  };

  static constexpr std::size_t usual_region = 4096;

  /// Triangulates the points.
  ///
  /// @param region  the points that a region gets, at least; fewer than twice as many are inserted
  ///                one after another
  /// @pre in the range of predicates.h
  /// @throws LimitReached  for more than max_points or max_tetrahedra
  explicit Triangulator(std::span<const WeightedPoint> points, const Run& run = Run(),
                        std::size_t region = usual_region);

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
  std::span<const std::uint32_t> removed() const { return {all_.cavity.data(), all_.cavity_size}; }
  std::span<const std::uint32_t> added() const { return all_.fillers; }

 private:
  enum class State : std::uint8_t { Live, InCavity, Free };
  struct alignas(32) StoredPoint : WeightedPoint {};  // never across two cache lines
  static constexpr Corner infinity = no_index;

  void find_first_tetrahedron(std::span<const WeightedPoint> points, std::vector<AtomId>& order);
  void add_apexes(std::span<const WeightedPoint> points);
  void make_first_tetrahedron();
  void insert_rounds(std::span<const std::size_t> ends, const Run& run, std::size_t region);
  class Batches;

  static constexpr std::uint32_t table_side = 64;
  static constexpr int whole = 8;  // the height of all of space: there are 2^8 regions at most

  /// Who inserts points in a region. The vectors keep their greatest size.
  struct Worker {
    std::uint32_t region = 0;         // its number among those of its size
    int height = whole;               // how often the smallest regions were united for it
    std::uint32_t last = 0;           // where the next walk starts
    int next_height = whole;          // at which a point that was refused may be tried again
    std::vector<std::uint32_t> free;  // slots to use, then the unused ones
    std::uint32_t unused = 0, unused_end = 0;
    // Of the current insertion.
    std::vector<std::uint32_t> cavity = std::vector<std::uint32_t>(64);  // in conflict
    std::size_t cavity_size = 0;
    std::vector<Facet> rim = std::vector<Facet>(64);  // the cavity's facets, seen from inside
    std::size_t rim_size = 0;
    std::vector<std::uint32_t> fillers;  // the new tetrahedron on each
    // For link_by_table: corners of the rim by small numbers, valid if the stamp is current; and
    // the new facet at each directed edge of the rim.
    struct RimNumber {
      std::uint32_t stamp = 0;
      std::uint32_t number = 0;
    };
    std::vector<RimNumber> rim_numbers;  // by corner + 1, so that infinity is 0
    std::vector<Facet> edge_table = std::vector<Facet>(table_side * table_side);
    std::uint32_t stamp = 0;
  };

  // In all of space there is nothing to ask of regions.
  bool insert(Corner p, Worker& worker);
  template <bool InRegion>
  bool insert_in(Corner p, Worker& worker);
  template <bool InRegion>
  std::uint32_t locate(Corner p, Worker& worker) const;
  bool is_in_conflict(std::uint32_t tetrahedron, Corner p) const;
  bool is_in_conflict_exactly(const Tetrahedron& t, Corner p) const;
  bool is_own(std::uint32_t tetrahedron, const Worker& worker) const {
    return std::uint32_t{regions_[tetrahedron]} >> worker.height == worker.region;
  }
  /// At which the tetrahedron belongs to the worker's region.
  int height_with(std::uint32_t tetrahedron, const Worker& worker) const {
    return static_cast<int>(
        std::bit_width(regions_[tetrahedron] ^ (worker.region << worker.height)));
  }
  template <bool InRegion>
  bool grow_cavity(Corner p, Worker& worker);
  void leave_cavity(const Worker& worker);
  void fill_cavity(Corner p, Worker& worker);
  void link_by_table(Worker& worker);
  void link_by_turning(const Worker& worker);
  Facet turn_to_rim(Facet rim, std::size_t exit) const;
  std::uint32_t allocate(Worker& worker);

  int dimension_ = -1;
  std::size_t atom_count_ = 0;
  std::vector<StoredPoint> points_;         // in the order of insertion, then the apexes
  std::vector<AtomId> ids_;                 // of the same
  UnfilledVector<Tetrahedron> tetrahedra_;  // filled when taken: so many zeros would take time
  std::vector<State> states_;
  std::vector<std::uint8_t> regions_;  // the smallest of each; current while several are at work
  Worker all_;                         // of all of space
};

}  // namespace morskin::geometry
