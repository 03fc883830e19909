#pragma once

/// The least power distance from a point to any of many weighted points, as a proved lower bound.
///
/// Over the regular triangulation the power to a fixed q, interpolated between the vertices, is a
/// convex function, so an atom that has less than all its neighbours has the least of all. Where
/// rounding leaves that open, as where several tie, or the atoms tried are the wrong ones, a search
/// over all atoms decides.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/grouped.h"
#include "geometry/id.h"
#include "geometry/point.h"
#include "skin/power_tree.h"

namespace morskin::skin {

class LeastPower {
 public:
  /// @param edges   all of the points' regular triangulation; without any, all is searched
  explicit LeastPower(std::span<const geometry::WeightedPoint> points,
                      std::span<const std::array<geometry::AtomId, 2>> edges = {});

  /// The atom of the least power distance to x, rounded; of equals the one with the lowest id. By
  /// a walk that ends there, for no other atom has less than all its neighbours.
  /// @param start  not hidden; best one near x
  geometry::AtomId nearest(const geometry::Point& x, geometry::AtomId start) const;

  /// @param tried  at least one atom; that of the least power among them, if all goes well
  template <class Real>
  PowerTree::Least<Real> at(const Vector3<Real>& q, std::span<const geometry::AtomId> tried) const;

 private:
  template <class Real>
  std::optional<PowerTree::Least<Real>> among(const Vector3<Real>& q,
                                              std::span<const geometry::AtomId> tried) const;
  std::span<const geometry::AtomId> neighbours(geometry::AtomId atom) const {
    return neighbours_.of(atom.index());
  }

  std::vector<geometry::WeightedPoint> points_;
  geometry::Grouped<geometry::AtomId> neighbours_;  ///< by atom
  PowerTree tree_;
};

}  // namespace morskin::skin
