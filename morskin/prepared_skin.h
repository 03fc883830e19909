#pragma once

#include <cstdint>
#include <vector>

#include "certify/sizing.h"
#include "geometry/error.h"
#include "geometry/run.h"
#include "skin/dual_complex.h"
#include "surface/topology.h"

namespace morskin {

using geometry::Run;

/// The skin that a mesh is made of, with its topology: built once, used to mesh and to certify.
/// What was made from it names its cells, so it must live as long.
struct PreparedSkin {
  skin::SkinSurface surface;
  skin::DualComplex topology;         ///< of the whole skin
  std::vector<char> is_dropped = {};  ///< by void, not to be meshed; empty: none (voids.h)

  bool has_dropped(std::uint32_t cavity) const {
    return !is_dropped.empty() && is_dropped[cavity] != 0;
  }
  /// Of the components to be meshed.
  surface::Topology expected() const;
};

/// Angstrom^2, a radius of 4e-22. The certificate's bounds are floats, which underflow below.
constexpr double least_provable_weight = 0x1p-141;

/// The balls differ so much in size, or lie so far out, that doubles cannot carry both ends.
///
/// A wall of the mixed complex is known to 2^-42 of the largest coordinate, and a cell narrower
/// than 64 of these tolerances counts as one without width (morse::Tracer::no_width). So a ball
/// that shares skin with another must have a patch of at least that radius, 2^-36 of the largest
/// coordinate. One that shares none needs a radius of one tolerance, or no function has critical
/// points on it that can be told apart.
class ScalesTooFarApart : public geometry::RefusedInput {
 public:
  ScalesTooFarApart(geometry::AtomId too_small, geometry::AtomId far_out);

  geometry::AtomId small;    ///< its patch is too small
  geometry::AtomId largest;  ///< beside the coordinate and radius of this one
};

/// Half the width of a neck, a tunnel or a gap between two sheets is below 2^-50 of the largest
/// coordinate there, which is at most eight units in its last place: too few doubles lie inside.
class UnresolvedNeck : public geometry::RefusedInput {
 public:
  explicit UnresolvedNeck(std::vector<geometry::AtomId> between);

  std::vector<geometry::AtomId> atoms;  ///< between which it lies
};

/// In the stages "triangulate", "mixed complex" and "dual complex".
/// @param points  Angstrom and Angstrom^2; used as they are, never rounded
/// @throws skin::SingularSkin, ScalesTooFarApart, UnresolvedNeck
/// @throws geometry::RefusedInput  also for a number out of the range of the exact predicates
PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Run& run = Run());

/// Radius of a protecting sphere over the length scale: that of the front's disks, on the largest
/// ball too.
double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing);

}  // namespace morskin
