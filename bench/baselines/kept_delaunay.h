#pragma once

/// The Delaunay triangulation of space by the samples of a growing mesh, kept up to date while they
/// come, go and move (papers/5-dynamic.md). Nothing in the growth asks it anything: it is here to
/// measure what keeping it costs, to which the paper lays the slowness of growth.
///
/// A sample stands where it was when it was last asked for. It is moved in place where that changes
/// no tetrahedron, which exact predicates on those about it decide, and by removal and insertion
/// otherwise.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/surface_mesh.h"
#include "geometry/triangulator.h"
#include "skin/skin_surface.h"
#include "surface/mesh.h"

namespace morskin::baselines {

struct KeptDelaunayCounts {
  std::size_t insertions = 0, removals = 0;  ///< of samples that come and go
  std::size_t moved_in_place = 0;            ///< moves that change no tetrahedron
  std::size_t moved_by_both = 0;             ///< moves by removal and insertion
  std::size_t made = 0;                      ///< tetrahedra, in all
  std::size_t samples = 0, tetrahedra = 0;   ///< at the end; those without infinity
  double seconds = 0;                        ///< in all of this, by the wall clock
  // Of the mesh at the end.
  std::size_t facets = 0;              ///< its triangles
  std::size_t facets_missing = 0;      ///< no facet of the triangulation
  std::size_t facets_not_crossed = 0;  ///< a facet whose dual edge does not cross the skin
  double worst_miss =
      0;  ///< how far such an edge ends from the skin, over the facet's circumradius
};

class KeptDelaunay {
 public:
  using VertexId = geometry::VertexId;
  using Point = geometry::Point;
  using Corner = geometry::Triangulator::Corner;

  /// Forgets all samples and counts.
  void clear() { *this = KeptDelaunay(); }

  /// @pre v has not been added, or has been removed
  void add(VertexId v, const Point& p);
  /// If v has not been added, nothing is done.
  void move(VertexId v, const Point& p);
  void remove(VertexId v);
  /// Gives the samples new names, by old vertex; those without one are gone already.
  void rename(std::span<const std::optional<VertexId>> names);

  /// Makes the samples those of a mesh: what is at the same place stays, what is not comes or goes.
  void become(std::span<const surface::SurfacePoint> points);
  /// Looks each triangle of the mesh up: whether it is a facet, and its dual edge crosses the skin.
  /// @pre become(mesh.points)
  void compare(const surface::Mesh& mesh, const skin::SkinSurface& skin);

  /// The triangulation, unless the samples do not span space; coordinates on the exact grid.
  const geometry::Triangulator* triangulation() const { return delaunay_ ? &*delaunay_ : nullptr; }
  /// The sample at a corner.
  std::optional<VertexId> vertex(Corner corner) const {
    const std::uint32_t v = corner < vertex_of_.size() ? vertex_of_[corner] : nobody;
    return v == nobody ? std::nullopt : std::optional(VertexId{v});
  }
  /// Samples where another is, or that do not span space with the others.
  std::span<const VertexId> waiting() const { return waiting_; }
  /// @return those of samples and tetrahedra as they are now
  KeptDelaunayCounts counts() const;

 private:
  static constexpr std::uint32_t nobody = 0xffffffff;

  struct Sample {
    Point position = Point::Zero();
    Corner corner = nobody;  ///< in the triangulation
    bool is_in = false;
  };

  void insert(VertexId v);
  void take_out(VertexId v);
  void try_waiting();
  void start();
  void stop();
  void note(std::span<const std::uint32_t> tetrahedra);
  std::optional<geometry::Triangulator::Facet> facet(const std::array<Corner, 3>& corners);

  std::vector<Sample> samples_;  ///< by vertex
  std::vector<VertexId> waiting_;
  std::optional<geometry::Triangulator> delaunay_;
  std::vector<std::uint32_t> vertex_of_;  ///< by corner
  std::vector<std::uint32_t> star_;       ///< by corner, a tetrahedron that has it
  std::uint32_t near_ = 0;                ///< a tetrahedron where something was done last
  std::vector<std::uint32_t> seen_;       ///< of a search
  KeptDelaunayCounts counts_;
};

}  // namespace morskin::baselines
