#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"
#include "geometry/run.h"

namespace morskin::geometry {

/// A regular (weighted Delaunay) triangulation as a simplicial complex: every simplex once, with
/// ascending corners, in lexicographic order. `orthosphere_side` breaks ties between cospherical
/// points by id, so it is always a triangulation, without flat simplices.
///
/// Law: vertices - edges + triangles - tetrahedra = 1, if there is any point at all.
struct RegularTriangulation {
  int dimension = -1;            ///< of the points' span; -1: no points
  std::vector<AtomId> vertices;  ///< ascending
  std::vector<std::array<AtomId, 2>> edges;
  std::vector<std::array<AtomId, 3>> triangles;
  std::vector<std::array<AtomId, 4>> tetrahedra;
  /// Entry k: the index in `edges` of the edge opposite corner k.
  std::vector<std::array<std::uint32_t, 3>> triangle_edges;
  /// Entry k: the index in `triangles` of the facet opposite corner k.
  std::vector<std::array<std::uint32_t, 4>> tetrahedron_triangles;
  /// Ascending: the redundant points, whose power is nowhere the smallest. They include all points
  /// at one position but the heaviest, and of equal ones all but the smallest id.
  std::vector<AtomId> hidden;
};

/// The regular triangulation of any number of weighted points in any position.
///
/// @param run  receives the share of points inserted
/// @pre    in the range of predicates.h
/// @throws LimitReached  for 2^27 points or more than 2^30 tetrahedra
/// Source: Edelsbrunner & Shah 1996, Incremental topological flipping works for regular
///         triangulations (definition); mechanism in triangulator.h.
RegularTriangulation regular_triangulation(std::span<const WeightedPoint> points,
                                           const Run& run = Run());

}  // namespace morskin::geometry
