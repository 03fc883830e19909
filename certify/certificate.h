#pragma once

/// The certificate (papers/certificate.md): from the mesh alone, in O(n), a proof that it is
/// homeomorphic (even isotopic) to the skin, and the measure of its quality.
///
/// Proved when all of these hold:
///   manifold    the triangles form a closed oriented 2-manifold without degenerate elements;
///   on skin     every vertex lies on the skin within residual_bound(), or, where all coordinates
///               are floats as STL has them, within the rounding to floats;
///   tube        every triangle lies where the flow along grad G reaches the skin (c2), and
///   upright     faces the way the skin does there (c1), so that the flow is a covering map;
///   degree 1    at one vertex of every component the covering has one sheet (c3);
///   counts      components, Euler characteristic and genus equal the dual complex's.

#include <array>
#include <optional>
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

/// What is proved, one after the other, and what is asked beyond: [L] and [U].
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
  double worst_L = 0;  ///< smallest R_ab over its bound in [L]: above 1 is good
  double worst_U = 0;  ///< largest R_abc over its bound in [U]: below 1 is good
  std::size_t violations_L = 0;
  std::size_t violations_U = 0;
  double max_distance_to_skin = 0;           ///< of a vertex, Angstrom
  double max_relative_distance_to_skin = 0;  ///< the same over the length scale
  bool is_single_precision = false;          ///< every coordinate is a float
  double area = 0;                           ///< Angstrom^2
  double volume = 0;                         ///< Angstrom^3, voids taken off
  bool covering_degree_ok = false;
  /// Triangles with the far corner of a neighbour in their surface ball; of a mesh that is not
  /// closed, none were looked at. No part of the proof (restricted_delaunay.h).
  std::size_t restricted_delaunay_violations = 0;

  /// Homeomorphic to the skin: none of the points above is broken.
  bool is_homeomorphic = false;
  /// Homeomorphic, and [L] and [U] hold everywhere.
  bool certified = false;
  /// Why not, naming the first element that breaks it; empty when certified.
  std::string reason;
  /// By Claim, the first element that breaks it in words; empty where it holds. Without a manifold
  /// degree and counts cannot be looked at and stay empty.
  std::array<std::string, claim_count> broken;

  const std::string& broken_by(Claim claim) const {
    return broken[static_cast<std::size_t>(claim)];
  }
};

/// What somebody says of a mesh. None of it is believed: what is so saves a search, and what is not
/// changes nothing.
struct Hearsay {
  std::vector<geometry::HalfEdgeId> twins;  ///< by half-edge; given up when looked at
  std::span<const surface::CellId> cells;   ///< by vertex, the mixed cell that it lies in
};

/// @param expected  the surface's topology, known from elsewhere
/// Never throws on a bad mesh: the reason says what is wrong with it.
Certificate certify(const geometry::IndexedMesh& mesh, const surface::Surface& surface,
                    const surface::Topology& expected, const Sizing& sizing = {},
                    const geometry::Run& run = geometry::Run());
/// The same, when the vertices have been located already.
/// @param points  locate_vertices() of the mesh; if empty they are located here
Certificate certify(const geometry::IndexedMesh& mesh, std::span<const SurfacePoint> points,
                    const surface::Surface& surface, const surface::Topology& expected,
                    const Sizing& sizing, const geometry::Run& run);
/// The same, with what the maker of the mesh says of it.
Certificate certify(const geometry::IndexedMesh& mesh, Hearsay said,
                    const surface::Surface& surface, const surface::Topology& expected,
                    const Sizing& sizing, const geometry::Run& run);

}  // namespace morskin::certify
