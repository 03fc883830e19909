#pragma once

/// The dynamic skin triangulation of Cheng, Dey, Edelsbrunner and Sullivan, the paper's baseline:
/// the skin grows from nothing to its final shape and its mesh with it. A queue holds when
/// each triangle must be inspected again; then it is flipped, contracted or broken where needed.
/// Where the topology changes, the mesh about the critical point is replaced (papers/5-dynamic.md).

#include <functional>
#include <vector>

#include "bench/baselines/hot_region.h"
#include "bench/baselines/inspection_queue.h"
#include "bench/baselines/inspection_times.h"
#include "geometry/run.h"

namespace morskin::baselines {

struct GrowthOptions {
  certify::Sizing sizing;  ///< of the mesh at all times
  Slack slack;
  double end = 0;  ///< the time to stop at, Angstrom^2 added to every weight
  /// Called before and after every metamorphosis; may be empty.
  std::function<void(const Metamorphosis&, const SurfaceMesh&, bool is_after)> observer;
  /// Times at which `snapshot` is to see the mesh, ascending.
  std::vector<double> snapshot_times;
  std::function<void(double time, const surface::Mesh&)> snapshot;
};

struct GrowthCounts {
  refine::RefinementCounts operations;
  std::array<std::size_t, 4> metamorphoses{};  ///< by Kind
  std::size_t failed = 0;       ///< metamorphoses whose hot region was not as it should be
  std::size_t inspections = 0;  ///< of triangles
};

class Growth {
 public:
  /// @param skin  at time 0; must outlive this object
  Growth(const SkinSurface& skin, const GrowthOptions& options);

  /// Grows from the empty mesh to options.end.
  /// @param run  receives the share of the metamorphoses that have taken place
  /// @throws geometry::LimitReached  if the mesh grows out of all proportion
  void run(const geometry::Run& run = geometry::Run());

  /// The mesh at the end, removed elements dropped.
  surface::Mesh mesh();
  const GrowthCounts& counts() const { return counts_; }

 private:
  /// The mesh about a critical point that is to go.
  struct HotRegion {
    std::vector<VertexId> vertices;
    std::vector<TriangleId> triangles;
    std::vector<HalfEdgeId> open;  ///< of triangles that stay
    std::vector<Ring> loops;       ///< with the region on their left
  };

  void inspect(TriangleId t, double time);
  void mend_changed(double time);
  bool is_waiting_for_metamorphosis(const std::array<VertexId, 3>& corners, double time,
                                    double& until);
  double next_inspection(const std::array<VertexId, 3>& corners, const Ratios& ratios);
  void schedule(TriangleId t, double time);
  void schedule(TriangleId t, double time, double length_scale);
  void compact();
  void require_sane_size() const;

  void undergo(const Metamorphosis& m, std::uint32_t number);
  HotRegion hot_region(const Metamorphosis& m, std::uint32_t number, double radius);
  bool find_loops(HotRegion& region);
  bool replace(const Metamorphosis& m, std::uint32_t number);
  bool refill(const Metamorphosis& m, HotRegion& region);
  void show(double time);

  const SkinSurface& skin_;
  const GrowthOptions options_;
  MovingMesh mesh_;
  /// Between two inspections. Where the skin passes a singular state that is no event, the length
  /// scale falls below what doubles resolve, and shorter steps would round to none.
  const double min_step_;
  std::vector<Metamorphosis> metamorphoses_;
  /// By cell, the index of the metamorphosis still to come there, or no_index.
  geometry::IdVector<CellId, std::uint32_t> metamorphosis_at_;
  InspectionQueue queue_;
  geometry::TriangleData<double>
      next_inspection_;                 ///< an entry of the queue with another time is void
  geometry::VertexData<char> is_seen_;  ///< all 0 but during hot_region()
  GrowthCounts counts_;
};

}  // namespace morskin::baselines
