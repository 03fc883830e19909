#pragma once

/// A closed free-form surface, sampled, and the skin of the balls inside it (section 6: "every
/// orientable closed surface has a skin representation"; Figure 10b).

#include <vector>

#include "geometry/point.h"

namespace morskin::figures {

using geometry::Point;
using geometry::Vector;

/// Below 0 inside a human head: ellipsoids and rods, blended smoothly. About a distance; the head
/// is about 2.6 high, looks along +z and has +y upwards.
double head_function(const Point& x);

/// Points of the zero set of a function, about `spacing` apart.
std::vector<Point> samples_of(double (*function)(const Point&), const Point& low, const Point& high,
                              double spacing);

/// The inner poles of samples: of each sample, the largest of the Delaunay balls at it whose centre
/// lies inside. Their weights are 2 r^2, so that the skin's body contains the balls
/// (papers/2.1-molecular-skin.md) and wraps them smoothly.
/// Source: Amenta, Choi & Kolluri 2001, The power crust.
std::vector<geometry::WeightedPoint> inner_polar_balls(const std::vector<Point>& samples,
                                                       double (*function)(const Point&));

}  // namespace morskin::figures
