#pragma once

#include "papers/exercises/course.h"

// The edge's orthocentre is the middle, its weight w = 2 - (d/2)^2. The skin is singular where that
// is zero: d = 2 sqrt(2). The balls of radius sqrt(2) touch there, and the patch of the edge is a
// cone with its apex in the middle.
Number touching_distance = 2 * std::sqrt(2.0);

// What `info` counts: the edges of the triangulation whose patch is one sheet that has its waist in
// the edge's own cell.
Count necks = 345;

// The meridian r^2 - s^2 = w/2 has the normal (r, -s)/|u| and the tangent (s, r)/|u|. With
// f = r^2 - s^2 the curvature is t.Hess f.t / |grad f| = 2 (s^2 - r^2)/|u|^2 / (2 |u|), which is
// (w/2)/|u|^3 in size. On the hyperboloid |u|^2 >= |w/2|, so this is at most 1/|u|.
Formula<double(double half_weight, double distance)> smaller_curvature = [](double half_weight,
                                                                            double distance) {
  return std::abs(half_weight) / (distance * distance * distance);
};
