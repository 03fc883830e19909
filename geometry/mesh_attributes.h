#pragma once

/// Numbers beside a mesh: what a file can hold of its vertices and triangles besides where they
/// are.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/point.h"
#include "geometry/provenance.h"

namespace morskin::geometry {

/// One or more numbers for each vertex, or for each triangle.
struct Attribute {
  std::string name;                  ///< "curvature": what VTU calls them together
  std::vector<std::string> columns;  ///< a name for each: what PLY calls them
  std::vector<double> numbers;       ///< all of the first element, then of the next
  bool is_whole = false;             ///< whole numbers of at most 32 bits
};

/// An array beside the mesh: of its atoms, say, or a part of a sparse matrix.
struct NamedArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>,
               std::vector<std::string>>
      values;               ///< texts in ASCII
  std::size_t columns = 1;  ///< values of each row, side by side; 1 for an array of one dimension
};

/// What MSMS's two files hold besides the mesh and its normals.
struct MsmsColumns {
  std::optional<int> decimals;  ///< of lengths and normals, in columns; absent: all that there are
  std::uint32_t sphere_count = 0;
  std::vector<std::uint32_t> spheres;    ///< by vertex, the nearest, from 0
  std::vector<std::uint8_t> kinds;       ///< by vertex
  std::vector<std::uint8_t> face_kinds;  ///< by triangle: 1 toric, 2 reentrant, 3 contact
};

struct MeshAttributes {
  std::vector<Attribute> vertices, triangles;
  std::vector<Vector> normals;     ///< by vertex, for formats with a place of their own for them
  std::vector<NamedArray> arrays;  ///< for formats that are made of arrays
  MsmsColumns msms;                ///< empty unless such a file is to be written
  Provenance provenance;
};

}  // namespace morskin::geometry
