#pragma once

/// Algorithm 1 of the paper (section 4.1): the sweep that lays triangles from the minima of the
/// height function to its maxima, always at the lowest vertex of the front.
///
/// The loop is algorithm_1.cpp, with the paper's line numbers; the five operations are
/// operations.cpp; what both ask of the sweep's parts is sweep.cpp. Statistics, progress, snapshots
/// and coarsening are observers.

#include <optional>
#include <span>
#include <vector>

#include "certify/sizing.h"
#include "front/coverage.h"
#include "front/departures.h"
#include "front/fresh_corners.h"
#include "front/front.h"
#include "front/guard_policy.h"
#include "front/marks.h"
#include "front/neighbourhood.h"
#include "front/sweep_observer.h"
#include "front/sweep_region.h"
#include "front/tangent_disk.h"
#include "morse/guide.h"
#include "surface/surface.h"

namespace morskin::front {

struct SweepOptions {
  certify::Sizing sizing = {};
  Spacing spacing = {};
  const GuardPolicy* guard = &see_everything;  ///< must outlive the sweep
  bool record_births = false;                  ///< fills Mesh::births
};

class Sweep {
 public:
  /// @pre the mesh is empty. Surface, guide, mesh and observers must outlive the sweep.
  Sweep(const surface::Surface& surface, const morse::Guide& guide, const SweepOptions& options,
        Mesh& mesh, std::vector<SweepObserver*> observers = {});
  Sweep(const Sweep&) = delete;  // its parts refer to each other
  Sweep& operator=(const Sweep&) = delete;

  /// Lays bowls at points, in this order, and sweeps until no bare surface is left that the front
  /// can reach within the region. May be called again with a larger region.
  /// @pre no triangle is near the points
  void run(const SweepRegion& region, std::span<const SurfacePoint> bowls);

  /// Unites another sweep of the same surface with this one: mesh, front, departures, marks and
  /// coverage. Nothing is laid. Associative; nothing is left of the other's mesh.
  /// @pre both have run, along the same function, over disjoint regions.
  /// @return  by how much the other's ids moved up
  IdOffsets absorb(Sweep& other);

  std::size_t triangles_laid() const { return front_.triangles_added(); }
  /// Front edges left open: 0 when the mesh is closed.
  std::size_t open_edges() const { return front_.open_edges(); }

 private:
  // The loop, and what comes after it.
  void creep_triangles();
  void sweep_on();
  void release_red_marks();

  // Its conditions.
  std::optional<Departure> lowest_departure();
  std::optional<CriticalId> protecting_sphere(const Departure& t) const;
  bool is_saddle(std::optional<CriticalId> c) const;
  bool is_maximum(std::optional<CriticalId> c) const;
  void mark_red(CriticalId saddle, const Departure& t);
  bool is_ready(CriticalId saddle) const { return marks_.is_marked_on_both_sides(saddle); }
  void mark_green(CriticalId maximum, const Departure& t);
  void defer(const Departure& t) { departures_.defer(t); }
  bool is_surrounded(CriticalId maximum);

  // The operations.
  void create(const SurfacePoint& p0);
  bool creep(const Departure& t);
  void break_long_edge(FrontEdgeId e, const SurfacePoint& centre);
  void lay_fan(FrontEdgeId e, const SurfacePoint& centre, double angle, int count);
  bool attach_new(FrontEdgeId e, const std::optional<SurfacePoint>& x, double r);
  std::optional<FrontEdgeId> last_apex(FrontEdgeId e) const;
  void wing();
  void bridge(CriticalId saddle);
  bool bridge_from(const Departure& t, CriticalId saddle, std::size_t side);
  void seal(CriticalId maximum);

  // What they ask.
  void inspect(FrontEdgeId corner);
  bool may_depart(const Departure& t) const;
  certify::Circumcircle ear(FrontEdgeId corner) const;
  bool is_ear_small(FrontEdgeId corner) const;
  std::size_t side_of_saddle(CriticalId saddle, VertexId v) const;
  void done(Operation operation) const;

  const morse::Guide& guide_;
  SweepRegion region_;
  const TangentDisk disk_;
  Mesh& mesh_;
  Front front_;
  const GuardPolicy& policy_;
  Neighbourhood guard_;
  Departures departures_;
  Marks marks_;
  FreshCorners fresh_;
  Coverage coverage_;
  std::vector<SweepObserver*> observers_;
};

}  // namespace morskin::front
