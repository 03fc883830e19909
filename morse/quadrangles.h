#pragma once

/// The quadrangles of a Morse-Smale complex while pairs of critical points are cancelled
/// (section 3.2, Figure 3).
///
/// Four arcs leave a saddle, to a minimum, a maximum, a minimum and a maximum; the sectors between
/// them belong to quadrangles. A quadrangle has two saddles, hence two sectors, so a matching of
/// the sectors represents the complex. Cancelling a saddle a with a minimum b deletes the four arcs
/// of a. Across each of its arcs to a maximum the two quadrangles become one: the partners of their
/// two sectors at a are matched with each other. The arcs of b's other saddles now lead to a's
/// other minimum c. For a maximum the kinds are exchanged. Each cancellation takes constant time,
/// up to union-find.

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "morse/morse_smale_complex.h"

namespace morskin::morse {

/// The angle between two consecutive arcs of a saddle, numbered as the first, counter-clockwise.
using Sector = std::uint32_t;

/// By sector, the other sector of its region, from the order of the arcs about the extrema. Nothing
/// where the orders about the minima and the maxima make different regions.
/// @pre four consecutive arcs for each saddle, each once in `ends`, at its extremum
std::optional<std::vector<Sector>> matched_sectors(const MorseSmaleComplex& complex);

class Quadrangles {
 public:
  /// @pre validate(complex) finds nothing (validate_complex.h), and the complex outlives this.
  explicit Quadrangles(const MorseSmaleComplex& complex);

  bool survives(CriticalId id) const { return survives_[id.index()]; }

  /// The surviving extremum that replaces this one: itself until it is cancelled.
  CriticalId heir(CriticalId extremum) const;

  /// The current ends of a saddle's arcs, in the order of the complex.
  /// @pre the saddle survives
  std::array<CriticalId, 4> ends(CriticalId saddle) const;

  /// Of the two extrema of b's kind that a's arcs lead to, the one that is not b; nothing if both
  /// arcs lead to b or neither does: then a and b cannot be cancelled.
  std::optional<CriticalId> other_end(CriticalId saddle, CriticalId extremum) const;

  /// Cancels a saddle with an extremum, whose other saddles are then joined to other_end.
  /// @pre other_end(saddle, extremum) has a value, and both survive
  void cancel(CriticalId saddle, CriticalId extremum);

  /// The next arc counter-clockwise about an arc's current extremum.
  /// @pre the arc's saddle survives
  ArcId next_about_extremum(ArcId arc) const;

  /// The remaining complex: all points with their ids, and the arcs, in their old order, regions
  /// and orders of the surviving ones; no lines.
  MorseSmaleComplex remaining() const;

 private:
  void join_across(Sector before, Sector after);
  std::vector<std::array<CriticalId, 4>> regions() const;

  const MorseSmaleComplex& complex_;
  std::vector<std::uint32_t> first_arc_;  ///< by critical point, for saddles
  std::vector<Sector> matched_;
  std::vector<bool> survives_;
  mutable std::vector<CriticalId> heir_;  ///< union-find over the extrema, compressed when read
};

}  // namespace morskin::morse
