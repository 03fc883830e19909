#pragma once

/// Counts of a sweep: its operations, and the touches of the front, by whether Morse theory
/// predicts them and whether anything came of them (papers/3.1-morse-functions.md).

#include <cstdint>
#include <vector>

#include "front/sweep_observer.h"
#include "morse/guide.h"

namespace morskin::front {

/// How often each operation of section 4.1 was done.
struct Operations {
  std::size_t creation = 0;  ///< bowls at minima
  std::size_t creep = 0;     ///< fans at departure vertices
  std::size_t wing = 0;      ///< small front angles closed
  std::size_t bridge = 0;    ///< fronts joined across a saddle
  std::size_t seal = 0;      ///< holes closed at maxima
  std::size_t coarsen = 0;   ///< vertices taken out behind the front
  /// Touches of the front found by the collision guard, in and out of protecting spheres.
  std::size_t guard_inside_protecting = 0;
  std::size_t guard_outside_protecting = 0;
  /// Those of them that only split off a loop, which closed again without meeting the front or
  /// coming to a maximum.
  std::size_t futile_inside_protecting = 0;
  std::size_t futile_outside_protecting = 0;

  Operations& operator+=(const Operations& other);
};

/// A polygon that a touch split off, watched until it closes.
struct Loop {
  bool is_predicted = false;  ///< the touch was inside a protecting sphere
  bool met_another = false;   ///< it touched the front again
  bool has_maximum = false;   ///< it came into the protecting sphere of a maximum
  bool is_closed = false;

  /// Nothing came of it: a spot left out that was filled later.
  bool is_futile() const { return is_closed && !met_another && !has_maximum; }
};

/// The loops of a front. When a touch splits a polygon the smaller part is watched from then on.
class TouchLoops {
 public:
  /// Follows a change of the front; a touch takes as long as the part split off has edges.
  void follow(const FrontChange& change, bool is_predicted);
  /// Notes that an edge's polygon has come to a maximum.
  void note_maximum(FrontEdgeId e) { loops_[loop_of(e)].has_maximum = true; }
  /// How many of the touches with this prediction split off a loop of which nothing came.
  std::size_t futile(bool is_predicted) const;
  /// Takes over those of another front, whose edges move up by `offset`.
  void absorb(const TouchLoops& other, std::uint32_t offset);

 private:
  std::uint32_t& loop_of(FrontEdgeId e) {
    if (loop_.size() <= e.index()) loop_.resize(e.index() + 1, 0);
    return loop_[e];
  }
  void follow_touch(const Front& front, FrontEdgeId e, FrontEdgeId added, bool is_predicted);

  std::vector<Loop> loops_{Loop{}};  ///< the first stands for all that are not watched
  geometry::IdVector<FrontEdgeId, std::uint32_t> loop_;  ///< of an edge
};

class OperationCounter : public SweepObserver {
 public:
  /// @param guide  must outlive the counter
  explicit OperationCounter(const morse::Guide& guide) : guide_(guide) {}

  void follow(const FrontChange& change) override;
  void operation_done(Operation operation, const Front&) override;
  void marked(morse::CriticalId c, const Departure& t) override;

  void absorb(const OperationCounter& other, std::uint32_t edge_offset);
  Operations operations() const;

 private:
  bool is_protected(const SurfacePoint& x) const;

  const morse::Guide& guide_;
  Operations operations_;
  TouchLoops loops_;
};

}  // namespace morskin::front
