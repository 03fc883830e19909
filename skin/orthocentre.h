#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <span>

#include "geometry/point.h"

namespace morskin::skin {

/// Long doubles, for orthocentres of fairly flat simplices, which lie far away.
using Wide = Eigen::Matrix<long double, 3, 1>;

/// The point z of a simplex's span that has equal power to all its weighted points.
struct Orthocentre {
  Wide position;
  long double weight;  ///< w_sigma = w_i - |z - z_i|^2
  Wide normal;         ///< unit: along an edge, orthogonal to a triangle; else zero
};

/// Relative error at most 2^-40: of the weight, and of the position relative to the larger of its
/// distance from the first point and the first edge. Where long doubles would cancel, for flat
/// simplices and weights near zero (the thinnest necks), it is computed exactly and then rounded.
///
/// @param simplex  1 to 4 affinely independent weighted points in the range of
///                 geometry/predicates.h
/// Law:    but for that error the order of the points does not matter.
Orthocentre orthocentre(std::span<const geometry::WeightedPoint> simplex);

/// The weight of a tetrahedron's orthocentre, Angstrom^2, with an error of at most 2^-20 of its
/// first point's weight: in doubles where these suffice, as for nearly all tetrahedra of a
/// molecule.
double rough_weight(const std::array<geometry::WeightedPoint, 4>& tetrahedron);

/// A stored point in the free ball about a tetrahedron's orthocentre z: nearer to z than the root
/// of -w / 2, for its weight w. It is z, rounded; nothing where there is no such ball or rounding
/// leaves it. Both are decided exactly.
/// @param tetrahedron  affinely independent, in the range of geometry/predicates.h
std::optional<geometry::Point> point_in_free_ball(
    const std::array<geometry::WeightedPoint, 4>& tetrahedron);

/// The unit vector orthogonal to a facet of a simplex, towards the opposite vertex, with an error
/// below 2^-42.
/// @param points  2 to 4 affinely independent points, the vertex last
geometry::Vector direction_off_facet(std::span<const geometry::Point> points);

}  // namespace morskin::skin
