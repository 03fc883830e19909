#pragma once

/// The certificate (papers/certificate.md): from the mesh alone, in O(n), a proof that it is
/// homeomorphic (even isotopic) to the skin, and a measure of its quality.
///
/// Proved when all of these hold, with the rounding of every step counted:
///   manifold    the triangles form a closed oriented 2-manifold without degenerate elements;
///   upright     every triangle faces as the skin does (c1), so that the flow along grad G is a
///               covering map;
///   tube        the flow carries every point of a triangle to the skin (c2);
///   degree 1    at one vertex of every component the covering has one sheet (c3);
///   counts      components, Euler characteristic and genus equal the dual complex's, and where
///               only some components are meshed it is these: each bounds two parts of space, and
///               the mesh winds round a point of every part as they do.
///
/// Vertices need not lie on the skin for that. Whether they do, to residual_bound(), and to the
/// rounding to floats where all coordinates are floats, as in STL, is a claim of its own.

#include <array>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "certify/sizing.h"
#include "geometry/indexed_mesh.h"
#include "geometry/run.h"
#include "geometry/surface_mesh.h"
#include "surface/surface.h"
#include "surface/topology.h"

namespace morskin::certify {

/// The claims, in the order in which the first broken one is the reason. The last two and OnSkin
/// are no part of the proof.
enum class Claim { Manifold, OnSkin, Upright, Tube, Degree, Counts, L, U };
inline constexpr std::size_t claim_count = 8;

struct Certificate {
  std::size_t vertices = 0;
  std::size_t triangles = 0;
  std::size_t components = 0;
  long euler_characteristic = 0;
  long genus = 0;  ///< summed over components

  long expected_euler_characteristic = 0;
  std::size_t expected_components = 0;
  long expected_genus = 0;

  double min_angle_deg = 0;
  double max_angle_deg = 0;
  /// Lower bound on the sine of the smallest angle, rounding counted, and a triangle that has it.
  double min_sine = 1;
  std::size_t sharpest_triangle = 0;
  double claimed_angle_deg = 0;  ///< the sizing's
  double worst_L = 0;            ///< smallest R_ab over its bound in [L]: above 1 is good
  double worst_U = 0;            ///< largest R_abc over its bound in [U]: below 1 is good
  std::size_t violations_L = 0;
  std::size_t violations_U = 0;
  /// Bound on the distance of a vertex, Angstrom; infinite where there is none.
  double max_distance_to_skin = 0;
  double max_relative_distance_to_skin = 0;  ///< the same over the length scale
  bool is_single_precision = false;          ///< every coordinate is a float
  double area = 0;                           ///< Angstrom^2
  /// Angstrom^3, without voids; NaN where the mesh is no closed oriented 2-manifold.
  double volume = std::numeric_limits<double>::quiet_NaN();
  bool covering_degree_ok = false;
  /// A vertex of each component at which its covering is shown to have one sheet, where it is.
  std::vector<geometry::VertexId> degree_vertices;
  /// Triangles with the far corner of a neighbour in their surface ball; 0 if the mesh is not
  /// closed. Not part of the proof (restricted_delaunay.h).
  std::size_t restricted_delaunay_violations = 0;

  /// Every claim of the proof holds. False also where nothing could be decided.
  bool is_homeomorphic = false;
  /// Homeomorphic, all vertices on the skin, [U] everywhere, and all angles as large as claimed: by
  /// [L], or each by itself (Sizing::claimed_angle_deg).
  bool certified = false;
  /// Why not, naming the first element that breaks a claim, or how many break [L] and [U]; empty
  /// when certified.
  std::string reason;
  /// By Claim, the first element that breaks it, in words; empty where it holds. Counts stay empty
  /// where the mesh is no manifold.
  std::array<std::string, claim_count> broken;

  const std::string& broken_by(Claim claim) const {
    return broken[static_cast<std::size_t>(claim)];
  }
  bool holds(Claim claim) const { return broken_by(claim).empty(); }
  /// What breaks the first broken claim of the proof; empty if none is.
  const std::string& objection() const;
  /// No angle is smaller, rounding counted, degrees.
  double proved_angle_deg() const;
  /// Records why a claim does not hold; the first reason stays.
  void fail(Claim claim, const std::string& why) {
    std::string& first = broken[static_cast<std::size_t>(claim)];
    if (first.empty()) first = why;
  }
  /// The numbers of components, and so on, from those of vertices and triangles; and whether they
  /// are as expected.
  void compare_counts();
  /// The verdict, once all claims have been looked at.
  void conclude(const Sizing& sizing);
};

/// The mesher's hints: checked, never trusted. A right hint saves a search, a wrong one changes
/// nothing. Any size, any values.
struct Hints {
  std::vector<geometry::HalfEdgeId> twins;  ///< by half-edge; kept where they are right
  std::span<const surface::CellId> cells;   ///< by vertex, the cell that contains it
};

/// Never throws on a bad mesh: the reason names the defect.
/// @param expected  the surface's topology, from a source independent of the mesh
Certificate certify(const geometry::IndexedMesh& mesh, const surface::Surface& surface,
                    const surface::Topology& expected, const Sizing& sizing = {},
                    const geometry::Run& run = geometry::Run());
/// The same with hints.
Certificate certify(const geometry::IndexedMesh& mesh, Hints hints, const surface::Surface& surface,
                    const surface::Topology& expected, const Sizing& sizing,
                    const geometry::Run& run);

}  // namespace morskin::certify
