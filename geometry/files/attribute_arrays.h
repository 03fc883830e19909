#pragma once

/// The columns of a mesh's attributes as arrays, for what is made of arrays.

#include <vector>

#include "geometry/mesh_attributes.h"

namespace morskin::geometry {

/// An array of each column by vertex, then of each by triangle, with face_ before its name; whole
/// numbers as int32. Not the normals if they have their own place, and not `arrays`, `msms` and
/// `provenance`.
std::vector<NamedArray> attribute_arrays(const MeshAttributes& attributes);

}  // namespace morskin::geometry
