#pragma once

#include "papers/exercises/course.h"

// 4 pi over sqrt(3)/4 e^2.
Number triangles_on_a_ball = 4 * M_PI / (std::sqrt(3.0) / 4 * 0.181 * 0.181);

Count benzene_triangles = 28776;

// R = CQ/(1 + 2CQ), 1 - R^2 = (1 + 4CQ + 3 C^2 Q^2)/(1 + 2CQ)^2 = (1 + CQ)(1 + 3CQ)/(1 + 2CQ)^2.
Formula<double(double C, double Q)> disk_share = [](double C, double Q) {
  const double q = C * Q;
  return 2 * q / ((1 + 2 * q) * (1 + 2 * q)) * std::sqrt((1 + q) * (1 + 3 * q));
};
