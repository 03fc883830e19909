#pragma once

/// Which components of the surface a mesh covers, given that each of its own covers one, another
/// each: those between parts of space that it winds round differently.

#include <string>

#include "certify/located_vertices.h"
#include "surface/topology.h"

namespace morskin::certify {

/// Why a mesh does not cover the expected components, or is not known to; empty if it does.
///
/// A point of a part is passed by no path from a triangle to the surface, so the mesh winds round
/// it as the components do that it covers.
/// @pre (c1) and (c2) hold for every triangle
std::string objection_to_parts(const LocatedMesh& mesh, const surface::Topology& expected);

}  // namespace morskin::certify
