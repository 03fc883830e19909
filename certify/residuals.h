#pragma once

/// How far the vertices of a mesh lie from the skin.

#include <optional>
#include <span>
#include <utility>

#include "certify/located_vertices.h"
#include "geometry/run.h"

namespace morskin::certify {

/// Whether every coordinate is a float.
bool is_single_precision(std::span<const surface::Point> positions);

struct Residuals {
  double max_distance = 0;           ///< bound on a vertex's distance to the skin, Angstrom
  double max_relative_distance = 0;  ///< the same over the length scale
  /// The first vertex farther off than residual_bound() and rounding allow, with its distance; 0
  /// where nothing is known of it.
  std::optional<std::pair<std::size_t, double>> first_off_skin;
};

/// @param points, bounds       by vertex
/// @param is_single_precision  whether vertices may be off by the rounding to floats
Residuals residuals(std::span<const surface::SurfacePoint> points,
                    std::span<const VertexBounds> bounds, const surface::Surface& surface,
                    bool is_single_precision, const geometry::Run& run);

}  // namespace morskin::certify
