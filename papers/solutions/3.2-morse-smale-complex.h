#pragma once

#include "papers/exercises/course.h"

// Each saddle is a corner of four regions, and each region has two saddles among its corners: twice
// as many regions as saddles.
Count regions_of_6_saddles = 12;

// Four to a saddle.
Count arcs_of_2buk = 4312;

// f(x) - f(p) = grad f . d + (c/2) d . d, grad f = mu N(p), and 0 = G(x) = G(p) + 2 N(p) . d + d .
// M d gives N(p) . d = -d . M d / 2.
Formula<double(double c, double mu, double d_d, double d_Md)> rise =
    [](double c, double mu, double d_d, double d_Md) { return c / 2 * d_d - mu / 2 * d_Md; };
