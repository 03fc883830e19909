#pragma once

/// Simplification of the Morse-Smale complex (section 3.2): cancelling a saddle a with a minimum or
/// maximum b that an arc joins it to.
///
/// A pair is cancelled only if a's two arcs of that kind lead to different extrema b and c. Then a
/// and b are deleted and b's other saddles joined to c. The function can be changed to one with
/// these arcs, by no more than |f(a) - f(b)| and only near the arcs of a, if the pair is a
/// persistence pair and those inside it are gone. For a minimum that means: f(c) <= f(b), and a is
/// the lowest saddle of b but for those whose two descending arcs both lead to b.
///
/// What the front must know of a cancelled minimum b: no bowl is laid there, no event is recorded
/// at a, and the basin of b, all that is below f(a) about it, is entered from c's side over a. The
/// front then moves down by at most |f(a) - f(b)| and meets itself without an event. That is
/// harmless while the basin is not larger than about a triangle; `distance` tells.
///
/// Errata: papers/errata.md, E10 (spheres that no cancellation can separate shrink) and E11 (pairs
/// are not chosen by distance alone).

#include <cstddef>
#include <vector>

#include "morse/persistence.h"

namespace morskin::morse {

struct Cancellation {
  CriticalId saddle, extremum;
  CriticalId heir;         ///< c, which takes the extremum's place
  double persistence = 0;  ///< |f(saddle) - f(extremum)|, unit of the function
  double distance = 0;     ///< between saddle and extremum, Angstrom
};

struct Simplification {
  /// What is left. All points stand in it with their ids; arcs and regions are those of the points
  /// that survive. Each line is a path on the skin from the saddle to the extremum that its arc
  /// leads to now: its old line, then through cancelled saddles and extrema along their lines. So
  /// it is monotone only where nothing was cancelled.
  MorseSmaleComplex complex;
  std::vector<bool> survives;           ///< by critical point
  std::vector<Cancellation> cancelled;  ///< in the order done
  /// By critical point, of its protecting sphere, Angstrom; 0 for those that are cancelled. No two
  /// spheres overlap.
  std::vector<double> radius;
  std::size_t overlaps_before = 0;  ///< pairs of protecting spheres that overlapped at first
  std::size_t overlaps_left = 0;    ///< and after the cancellations: these were shrunk
  std::size_t shrunk = 0;           ///< spheres smaller than radius_share x length scale
};

/// The paper's: contracts arcs between overlapping protecting spheres where that is allowed, the
/// least persistent first, until no more can be; spheres that still overlap shrink.
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
