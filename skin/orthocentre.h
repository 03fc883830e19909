#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "geometry/point.h"

namespace morskin::skin {

/// The longer mantissa keeps orthocentres of fairly flat simplices right, which lie far away.
using Wide = Eigen::Matrix<long double, 3, 1>;

/// The point z of a simplex's span that has equal power to all its weighted points.
struct Orthocentre {
  Wide position;
  long double weight;  ///< w_sigma = w_i - |z - z_i|^2
  Wide normal;         ///< unit: along an edge, orthogonal to a triangle; else zero
};

/// Right to a relative 2^-40 at least: the position for the larger of its distance from the first
/// point and the simplex's first edge, the weight for itself. What long doubles would lose to
/// cancellation, for flat simplices and for weights near zero (the thinnest necks), is computed
/// exactly and then rounded.
///
/// @param simplex  1 to 4 weighted points in the range of geometry/predicates.h, affinely
///                 independent
/// Law:    but for that error the order of the points does not matter.
Orthocentre orthocentre(std::span<const geometry::WeightedPoint> simplex);

/// The weight of a tetrahedron's orthocentre, off by 2^-20 of its first point's weight at most: in
/// doubles where these do, as in nearly all tetrahedra of a molecule.
double rough_weight(const std::array<geometry::WeightedPoint, 4>& tetrahedron);

/// The unit direction from a facet of a simplex towards the vertex that it lacks, orthogonal to the
/// facet and right to a few last bits.
/// @param points  2 to 4 affinely independent points, the vertex last
geometry::Vector direction_off_facet(std::span<const geometry::Point> points);

}  // namespace morskin::skin
