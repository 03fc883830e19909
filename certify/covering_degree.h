#pragma once

/// The third condition of the certificate (papers/certificate.md): each component has a vertex for
/// which
///
///     (c3) degree   its own triangles go round it once, and the flow carries no other onto it,
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

/// Bounds on the distance from a triangle's corners to its image under the flow.
class FlowBounds {
 public:
  /// @param max_path  bound on the path of a point of the triangle, Angstrom; may be infinite
  /// @param rho       smallest length scale at the corners
  void add(std::uint32_t triangle, double circumradius, double max_path, double rho);
  void add(FlowBounds others);
  /// Reserves memory for far triangles.
  void reserve(std::size_t far) { far_.reserve(far); }

  /// Bound on the distance to the nearest corner over rho there, for all but the far triangles.
  double ratio() const { return ratio_; }
  /// A triangle whose ratio exceeds max_ratio.
  struct Far {
    std::uint32_t triangle;
    float from_first_corner;  ///< bound on the distance, Angstrom
  };
  std::span<const Far> far() const { return far_; }
  /// Far triangles without a bound.
  std::size_t unbounded_count() const { return unbounded_count_; }

 private:
  static constexpr double max_ratio = 0.8;
  double ratio_ = 0;
  std::vector<Far> far_;
  std::size_t unbounded_count_ = 0;
};

/// Bound on |G| at a triangle's corners. @param ratio  bound on |G| / rho^2 at every vertex
inline double max_residual(const Corners& p, double ratio) {
  const double rho = max_length_scale(p);
  return ratio * rho * rho;
}

/// A closed mesh with its vertices on a surface.
struct LocatedMesh {
  const geometry::IndexedMesh& mesh;
  const geometry::SurfaceMesh& connectivity;
  const geometry::Components& components;
  std::span<const SurfacePoint> points;  ///< by vertex
  const surface::Surface& surface;
  double max_residual_ratio;  ///< |G| / rho^2 at a vertex
};

class CoveringDegree {
 public:
  /// @param bounds  of all triangles
  CoveringDegree(const LocatedMesh& mesh, const FlowBounds& bounds) : on_(mesh), bounds_(bounds) {}

  /// The first component without a proof of (c3).
  std::optional<std::size_t> first_unproved() const;

 private:
  /// By component, vertices at which to try (c3).
  using Candidates = std::vector<std::vector<VertexId>>;
  Candidates candidates() const;
  /// By vertex, whether it is a candidate that only its own triangles may cover; empty if too many
  /// triangles are unbounded.
  std::vector<char> free_candidates(const Candidates& candidates) const;
  template <class Test>
  void test_far_triangles(const std::vector<VertexId>& candidates, Test test) const;
  template <class Test>
  void test_near_triangles(const std::vector<VertexId>& candidates, Test test) const;
  bool turns_once(VertexId v) const;
  bool may_cover(const std::array<std::uint32_t, 3>& triangle, VertexId v) const;
  const Point& position(std::uint32_t v) const { return on_.mesh.positions[v]; }

  const LocatedMesh on_;
  const FlowBounds& bounds_;
};

}  // namespace morskin::certify
