#pragma once

/// How far a mesh is from the skin and from the size conditions: extremes and the worst elements.
/// Not part of the proof.

#include <cstdint>
#include <span>
#include <vector>

#include "certify/located_vertices.h"
#include "certify/sizing.h"
#include "geometry/indexed_mesh.h"

namespace morskin::certify {

/// An element and how bad it is.
struct BadVertex {
  std::uint32_t vertex;
  double distance;  ///< to the skin, Angstrom, as estimated_distance() has it
  double relative;  ///< the same over the length scale
};
struct BadTriangle {
  std::uint32_t triangle;
  double value;
};
struct BadEdge {
  std::uint32_t a, b;
  double value;
};

struct Deviations {
  /// Distances to the skin, as estimated_distance() has them, of vertices and of centroids.
  double max_vertex_distance = 0, max_vertex_relative = 0, mean_vertex_relative = 0;
  double max_centroid_distance = 0, max_centroid_relative = 0, mean_centroid_relative = 0;
  double max_normal_deg = 0;  ///< between a triangle's normal and the skin's at a corner

  // The worst ten of each, the worst first.
  std::vector<BadVertex> farthest_vertices;     ///< by relative distance
  std::vector<BadTriangle> farthest_centroids;  ///< relative distance
  std::vector<BadEdge> shortest_edges;          ///< R_ab over its bound in [L]
  std::vector<BadTriangle> largest_triangles;   ///< R_abc over its bound in [U]
  std::vector<BadTriangle> steepest_triangles;  ///< the angle of max_normal_deg
};

/// @param points  locate_vertices() of the mesh
/// @param sides   of edges, if the mesh is not closed
Deviations measure_deviations(const geometry::IndexedMesh& mesh, const surface::Surface& surface,
                              std::span<const SurfacePoint> points, const Sizing& sizing,
                              const EdgeSides& sides = EdgeSides());

}  // namespace morskin::certify
