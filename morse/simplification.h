#pragma once

/// Simplification of the Morse-Smale complex (section 3.2): cancelling a saddle a with a minimum or
/// maximum b at the end of one of its arcs.
///
/// A pair is cancelled only if a's two arcs of that kind lead to different extrema b and c. Then a
/// and b are deleted and b's other saddles joined to c. There is a function with these arcs that
/// differs by at most |f(a) - f(b)|, and only near the arcs of a, if the pair is a persistence pair
/// and those inside it are gone. For a minimum that means: f(c) <= f(b), and a is the lowest saddle
/// of b, apart from those whose descending arcs both lead to b.
///
/// For the front a cancelled minimum b has no bowl, its saddle a is no event, and it enters the
/// basin of b, the part about b below f(a), from c's side over a. It then moves down by at most
/// |f(a) - f(b)| and meets itself without an event, which is harmless while the basin is not much
/// larger than a triangle (`distance`).
///
/// Errata: papers/errata.md, E10 (spheres that no cancellation can separate shrink) and E11 (pairs
/// are not chosen by distance alone).

#include <cstddef>
#include <vector>

#include "morse/persistence.h"

namespace morskin::morse {

struct Cancellation {
  CriticalId saddle, extremum;
  CriticalId heir;         ///< c, which replaces the extremum
  double persistence = 0;  ///< |f(saddle) - f(extremum)|, unit of the function
  double distance = 0;     ///< between saddle and extremum, Angstrom
};

struct Simplification {
  /// The remaining complex: all points with their ids, and arcs and regions of the surviving ones.
  /// Each line is a path on the skin from the saddle to its arc's current extremum: the old line,
  /// then the lines of cancelled saddles. It is monotone only where nothing was cancelled.
  MorseSmaleComplex complex;
  std::vector<bool> survives;           ///< by critical point
  std::vector<Cancellation> cancelled;  ///< in order
  /// By critical point, of its protecting sphere, Angstrom; 0 for cancelled ones. No two spheres
  /// overlap.
  std::vector<double> radius;
  std::size_t overlaps_before = 0;  ///< overlapping pairs of protecting spheres at first
  std::size_t overlaps_left = 0;    ///< and after the cancellations, before shrinking
  std::size_t shrunk = 0;           ///< spheres smaller than radius_share x length scale
};

/// The paper's: contracts arcs between overlapping protecting spheres where that is allowed, the
/// least persistent first; spheres that still overlap shrink.
///
/// @param radius_share  radius of a protecting sphere over the length scale at its centre
/// @pre validate(complex) finds nothing
Simplification contract_short_arcs(const MorseSmaleComplex& complex, double radius_share);

/// Cancels all pairs of at most this persistence; infinite leaves one minimum and one maximum for
/// each component and two saddles for each handle. Then overlapping spheres shrink.
Simplification cancel_up_to(const MorseSmaleComplex& complex, double persistence,
                            double radius_share);

/// Cancels nothing: all points survive, and overlapping spheres shrink.
Simplification keep_all(const MorseSmaleComplex& complex, double radius_share);

}  // namespace morskin::morse
