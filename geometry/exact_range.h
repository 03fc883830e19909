#pragma once

#include <cstddef>
#include <span>

#include "geometry/point.h"

/// The numbers on which the exact predicates are exact (predicates.h): coordinates are multiples of
/// u = 2^-120, weights, which add to squares, of u^2, and both are at most 2^30 in magnitude.
///
/// No polynomial of the predicates has a degree above 8, a weight counting as 2 (the table is in
/// papers/2.1-molecular-skin.md). So every product, every rounded one too, is a multiple of u^8 =
/// 2^-960 and below 2^300: nothing over- or underflows. The smallest bound of a filter is 2^-53
/// u^8; what is lost of it below 2^-1074 is less than its margin of 2^-40.
namespace morskin::geometry {

constexpr double coordinate_unit = 0x1p-120;
constexpr double weight_unit = coordinate_unit * coordinate_unit;
constexpr double largest_exact = 0x1p30;

/// Whether the exact predicates take a coordinate: always if it is 0, or at least 2^-68 and at most
/// 2^30 in magnitude.
bool is_exact_coordinate(double x);

/// The same for a weight: always if it is 0, or at least 2^-188 and at most 2^30 in magnitude.
bool is_exact_weight(double w);

/// Rounds the coordinates that are no multiples of 2^-120 (`on_exact_grid`): noise in the place of
/// 0, unless a weight is below 2^-136. Then 2^-121 is more than a double's rounding of a radius,
/// and nothing is done.
/// @return how many were rounded
std::size_t move_to_exact_grid(std::span<WeightedPoint> points);

}  // namespace morskin::geometry
