#pragma once

// VTU: VTK's unstructured grid in XML, for ParaView. Cells of any kind over points, with data on
// both.

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "geometry/mesh_attributes.h"
#include "geometry/point.h"

namespace morskin::geometry {

/// VTK's cell types. Lines have two corners, as not every reader knows polylines.
enum class VtuCell : unsigned char { Vertex = 1, Line = 3, Triangle = 5, QuadraticTriangle = 22 };

struct VtuGrid {
  std::span<const Point> points;
  std::vector<std::int64_t> corners;  ///< of all cells in a row, into points
  std::vector<std::int64_t> ends;     ///< by cell, the end of its corners
  std::vector<VtuCell> kinds;         ///< by cell

  std::span<const Attribute> point_attributes, cell_attributes;
  std::span<const Provenance::Entry> field_data;  ///< numbers, and texts by bytes
};

/// The bytes of the file, every coordinate to the last bit.
/// @pre one number for each point or cell, and names that need no escaping in XML
std::string vtu(const VtuGrid& grid);

}  // namespace morskin::geometry
