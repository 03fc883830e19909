#pragma once

#include <array>
#include <cstdint>

#include "geometry/expansion.h"
#include "geometry/id.h"
#include "geometry/point.h"

/// The two exact predicates of a regular triangulation (section 2.1): the orientation of four
/// points, and the side of an orthosphere on which a fifth lies.
///
/// Range: every coordinate is a multiple of 2^-120, every weight one of 2^-240, both of at most
/// 2^30 (exact_range.h), so that no polynomial over- or underflows. In this range results are those
/// of real arithmetic on the stored doubles. Each predicate is a chain of tiers, cheapest first;
/// predicates_internal.h names them.
namespace morskin::geometry {

/// The multiple of 2^-120 nearest to x; x itself whenever |x| >= 2^-68.
///
/// @pre x is finite.
double on_exact_grid(double x);

/// The sign of det[a - d; b - d; c - d]: six times the signed volume of the tetrahedron.
///
/// Law: an odd permutation of the four points changes the sign. Zero if and only if coplanar.
Sign orientation(const Point& a, const Point& b, const Point& c, const Point& d);

/// Whether three points lie on one line; two equal points always do.
bool are_collinear(const Point& a, const Point& b, const Point& c);

/// Inside: of less power at the sphere's centre than the points that define the sphere.
enum class Side : std::int8_t { Inside, Outside };

/// The side of the sphere orthogonal to a, b, c, d on which the weighted point e lies.
///
/// Never "on": symbolic perturbation breaks ties. Each weight grows by an infinitesimal, larger for
/// smaller ids, so that all answers together are consistent. Of two points of equal position and
/// weight the smaller id wins.
/// @param ids  of a, b, c, d, e; used in ties only
/// Law:    an even permutation of a, b, c, d with their ids does not change the answer.
/// @pre    orientation(a, b, c, d) == Sign::Positive, and the five ids differ.
/// Source: Devillers & Teillaud 2011, Perturbations for Delaunay and weighted Delaunay 3D
///         triangulations; Edelsbrunner & Muecke 1990.
Side orthosphere_side(const WeightedPoint& a, const WeightedPoint& b, const WeightedPoint& c,
                      const WeightedPoint& d, const WeightedPoint& e,
                      const std::array<AtomId, 5>& ids);

}  // namespace morskin::geometry
