#pragma once

/// Three equations in three unknowns, with intervals.

#include "implicit/function.h"

namespace morskin::implicit {

using IntervalMatrix = Triple<Triple<Interval>>;  ///< by rows

/// f, or a system, at the centre of a box, and its Jacobian matrix over all of it.
struct SystemBounds {
  Triple<Interval> at_centre;
  IntervalMatrix jacobian;
};

/// What Krawczyk's test tells of the zeros of a system in a box: the box they can lie in,
///
///     K = c - Y F(c) + (1 - Y J) (box - c),   Y nearly J^-1.
///
/// K inside the box proves that there is one zero in it, exactly one, and that it is regular.
struct Krawczyk {
  enum class Verdict { None, One, Undecided };
  Verdict verdict = Verdict::Undecided;
  Triple<Interval> zeros;  ///< where they can lie, in the box; without meaning where there are none
};
Krawczyk krawczyk(const Box& box, const SystemBounds& bounds);

/// The box about a triple of intervals.
Box box_about(const Triple<Interval>& x);

}  // namespace morskin::implicit
