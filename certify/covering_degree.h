#pragma once

/// The third condition of the certificate (papers/certificate.md): each component has a vertex for
/// which
///
///     (c3) degree   its own triangles go round it once, and the flow carries no other point of the
///                   mesh to where it carries the vertex,
///
/// so that the component covers its part of the skin once.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "certify/located_vertices.h"
#include "certify/tube.h"
#include "geometry/glued_triangles.h"
#include "geometry/indexed_mesh.h"

namespace morskin::certify {

/// Bounds on the distance from a triangle's corners to its image under the flow.
class FlowBounds {
 public:
  /// @param max_path   bound on the path of a point of the triangle, Angstrom
  /// @param rho        lower bound on the length scale at the corners
  /// @param max_error  of N at the corners
  void add(std::uint32_t triangle, double circumradius, double max_path, double rho,
           double max_error);
  void add(FlowBounds others);
  /// Reserves memory for far triangles.
  void reserve(std::size_t far) { far_.reserve(far); }

  /// Bound on the distance to the nearest corner over rho there, for all but the far triangles.
  double ratio() const { return ratio_; }
  /// A triangle whose ratio exceeds max_ratio, or with a corner whose length scale is in doubt.
  struct Far {
    std::uint32_t triangle;
    float from_first_corner;  ///< bound on the distance, Angstrom
  };
  std::span<const Far> far() const { return far_; }

  /// The doubt about a length scale, over it, that is small.
  static constexpr double max_doubt = 0x1p-9;

 private:
  static constexpr double max_ratio = 0.8;
  double ratio_ = 0;
  std::vector<Far> far_;
};

class CoveringDegree {
 public:
  /// @param connectivity  the mesh's, closed
  /// @param components    geometry::vertex_components() of the mesh
  /// @param bounds        of all triangles
  /// @pre (c1) and (c2) are proved for all triangles.
  CoveringDegree(const LocatedMesh& mesh, const geometry::GluedTriangles& connectivity,
                 std::span<const std::uint32_t> components, const FlowBounds& bounds)
      : on_(mesh), connectivity_(connectivity), components_(components), bounds_(bounds) {}

  /// By component, in the order of their first triangles as geometry::check_mesh() has them, a
  /// vertex for which (c3) is proved, if there is one.
  std::vector<std::optional<VertexId>> proved_vertices(unsigned threads = 1) const;

 private:
  /// By component, in that order, vertices at which to try (c3).
  using Candidates = std::vector<std::vector<VertexId>>;
  Candidates candidates() const;
  bool is_candidate(VertexId v) const;
  bool own_triangles_do_not_return(VertexId v) const;
  bool turns_once(VertexId v) const;
  /// By vertex, whether it is a candidate that only its own triangles may cover.
  std::vector<char> free_candidates(const Candidates& candidates, unsigned threads) const;
  template <class Test>
  void test_far_triangles(const std::vector<VertexId>& candidates, unsigned threads,
                          Test test) const;
  template <class Test>
  void test_near_triangles(const std::vector<VertexId>& candidates, unsigned threads,
                           Test test) const;
  bool may_cover(const geometry::TriangleCorners& triangle, VertexId v) const;
  double min_length_scale(VertexId v) const {
    const LocatedVertex& at = on_.vertices[v.index()];
    return at.length_scale() - at.error;
  }
  double path_to_skin(VertexId v) const {
    return max_flow_path(min_length_scale(v), on_.vertices[v.index()].max_value());
  }

  const LocatedMesh on_;
  const geometry::GluedTriangles& connectivity_;
  const std::span<const std::uint32_t> components_;
  const FlowBounds& bounds_;
};

}  // namespace morskin::certify
