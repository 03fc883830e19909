#pragma once

#include <vector>

#include "certify/sizing.h"
#include "geometry/error.h"
#include "geometry/run.h"
#include "skin/dual_complex.h"

namespace morskin {

using geometry::Run;

/// The skin that a mesh is made of, with its topology: built once, used to mesh and to certify.
/// What was made from it names its cells, so it must live as long.
struct PreparedSkin {
  skin::SkinSurface surface;
  skin::DualComplex topology;
};

/// In the stages "triangulate", "mixed complex" and "dual complex".
/// @param points  coordinates and weights of at most 2^30, Angstrom and Angstrom^2; they are
///                rounded to multiples of 2^-64, the grid of the exact predicates
/// @throws skin::SingularSkin, geometry::RefusedInput
PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Run& run = Run());

/// Radius of a protecting sphere over the length scale: that of the front's disks, on the largest
/// ball too.
double sphere_share(const skin::SkinSurface& skin, const certify::Sizing& sizing);

}  // namespace morskin
