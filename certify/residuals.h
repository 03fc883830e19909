#pragma once

/// How far the vertices of a mesh lie from the skin.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "certify/located_vertices.h"
#include "geometry/run.h"

namespace morskin::certify {

/// Whether every coordinate is a float.
bool is_single_precision(std::span<const surface::Point> positions);

/// The distance to the surface that a value of G stands for, Angstrom: on the sphere of an atom the
/// exact one, as rho^2 - G is its squared radius, elsewhere to first order.
inline double estimated_distance(double G, double rho) {
  return std::abs(G) / (rho + std::sqrt(std::max(0.0, rho * rho - G)));
}

struct Residuals {
  double max_distance = 0;           ///< bound on a vertex's distance to the skin, Angstrom
  double max_relative_distance = 0;  ///< the same over the length scale
  /// The first vertex farther off than residual_bound() and rounding allow, with its distance by
  /// the least |G|, estimated; 0 where nothing is known of it, infinite where no direction leads to
  /// the skin, as in the middle of a round void, or where |G| exceeds all floats.
  std::optional<std::pair<std::size_t, double>> first_off_skin;
};

/// What follows the name of such a vertex: "lies about 0.1 Angstrom off the skin".
std::string off_skin_in_words(double distance);

/// @param is_single_precision  whether vertices may be off by the rounding to floats
Residuals residuals(const LocatedMesh& on, bool is_single_precision, const geometry::Run& run);

}  // namespace morskin::certify
