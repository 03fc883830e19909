#pragma once

/// The third condition of the certificate (papers/certificate.md): at one vertex of every component
///
///     (c3) degree   no other triangle is carried onto it by the flow, and its own go round it
///     once,
///
/// so that the component covers its part of the skin once.

#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/tube.h"
#include "geometry/indexed_mesh.h"
#include "geometry/surface_mesh.h"

namespace morskin::certify {

/// How far it is from the corners of triangles to all that the flow makes of them, at most.
class FlowReach {
 public:
  /// @param way  no farther than this does the flow move a point of the triangle, Angstrom
  /// @param rho  the least length scale at the corners
  void add(std::uint32_t triangle, double circumradius, double way, double rho);
  void add(FlowReach others);
  /// Makes room for what others have listed as far.
  void reserve(std::size_t far) { far_.reserve(far); }

  /// Over the length scale at the corner; but for the triangles that reach beyond `most`.
  double ratio() const { return ratio_; }
  struct Far {
    std::uint32_t triangle;
    float from_first_corner;  ///< Angstrom
  };
  std::span<const Far> far() const { return far_; }
  /// How many of these are not proved, so that nothing bounds how far they reach.
  std::size_t unbounded_count() const { return unbounded_count_; }

 private:
  static constexpr double most = 0.8;
  double ratio_ = 0;
  std::vector<Far> far_;
  std::size_t unbounded_count_ = 0;
};

/// |G| at the corners of a triangle, at most, if at each vertex it is that share of rho^2.
inline double residual_at(const std::array<const SurfacePoint*, 3>& p, double share) {
  const double most_rho = std::max({p[0]->length_scale, p[1]->length_scale, p[2]->length_scale});
  return share * most_rho * most_rho;
}

/// The closed mesh that is asked, and where it lies.
struct FlowingMesh {
  const geometry::IndexedMesh& mesh;
  const geometry::SurfaceMesh& connectivity;
  const geometry::Components& parts;     ///< its components
  std::span<const SurfacePoint> points;  ///< where its vertices lie
  const surface::Surface& surface;
  double largest_residual;  ///< of |G| over rho^2 at a vertex
};

class CoveringDegree {
 public:
  /// @param reach  of all triangles
  CoveringDegree(const FlowingMesh& mesh, const FlowReach& reach) : on_(mesh), reach_(reach) {}

  /// @return the first component of which (c3) could not be shown
  std::optional<std::size_t> first_not_shown() const;

 private:
  /// By component, vertices that may show it.
  using Candidates = std::vector<std::vector<VertexId>>;
  Candidates candidates() const;
  /// Whether no triangle but its own may cover the vertex, for each candidate; empty if there are
  /// too many triangles that nothing bounds.
  std::vector<char> free_candidates(const Candidates& candidates) const;
  template <class Look>
  void look_from_far(const std::vector<VertexId>& candidates, Look look_at) const;
  template <class Look>
  void look_from_near(const std::vector<VertexId>& candidates, Look look_at) const;
  bool turns_once(VertexId v) const;
  bool may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const;
  const Point& position(std::uint32_t v) const { return on_.mesh.positions[v]; }

  const FlowingMesh on_;
  const FlowReach& reach_;
};

}  // namespace morskin::certify
