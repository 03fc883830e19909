#pragma once

/// SHA-256 of a mesh as a file stores it, defined in papers/provenance.md.

#include <string>

#include "geometry/indexed_mesh.h"

namespace morskin::app {

/// What a format stores of the coordinates.
enum class Stored {
  Doubles,
  Floats,        ///< by vertex
  FloatCorners,  ///< of the three corners by triangle, as STL does, without faces
};

struct MeshHashes {
  std::string coordinates;  ///< of little-endian IEEE numbers, x y z
  std::string faces;        ///< of little-endian uint32, three by triangle, from 0; else empty
};

/// @param threads  at most; two do the work
MeshHashes hashes_of(const geometry::IndexedMesh& mesh, Stored stored, unsigned threads);

}  // namespace morskin::app
