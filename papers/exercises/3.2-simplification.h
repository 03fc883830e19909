#pragma once

#include "papers/exercises/course.h"

/// Predict. Gramicidin A has one component of genus 35. All pairs that can be are cancelled: how
/// many critical points are left?
Count left_on_gramicidin = unanswered;

/// Run. `2buk.pdb.gz`, meshed with -C 0.2: how many saddles are left?
Count saddles_left = unanswered;

/// Explain. May the saddle a be cancelled with the minimum b, when a also leads down to c, given
/// f(b), f(c), f(a) and the value of the lowest other saddle of b (of those that do not lead to b
/// twice)?
Formula<bool(double b, double c, double a, double lowest_other)> may_cancel = unanswered;
