#pragma once

#include "papers/exercises/course.h"

// The lowest minimum and the highest maximum, and two saddles for each handle.
Count left_on_gramicidin = 1 + 1 + 2 * 35;

// Pairs closer than about a triangle are cancelled, so this depends on C.
Count saddles_left = 557;

// b is the younger of the two that a joins, and a is its way out. Otherwise the change of f that
// removes a and b would have to go through something else first.
Formula<bool(double b, double c, double a, double lowest_other)> may_cancel =
    [](double b, double c, double a, double lowest_other) {
      return c <= b && b < a && a <= lowest_other;
    };
