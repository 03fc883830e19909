#pragma once

// VTU: the XML form of VTK's unstructured grid, for ParaView. Cells of any kind over points, with
// numbers on both.

#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// VTK's numbers for kinds of cells. A line has two corners: polylines of more are in VTK, but not
/// every reader knows them.
enum class VtuCell : unsigned char { Vertex = 1, Line = 3, Triangle = 5 };

struct VtuGrid {
  std::span<const Point> points;
  std::vector<std::int64_t> corners;  ///< of all cells, one after the other, into points
  std::vector<std::int64_t> ends;     ///< by cell, where its corners end
  std::vector<VtuCell> kinds;         ///< by cell

  template <class Number>
  using Named = std::vector<std::pair<std::string, std::vector<Number>>>;
  Named<double> point_numbers;        ///< name and a number for each point
  Named<double> cell_numbers;         ///< name and a number for each cell
  Named<std::int64_t> cell_integers;  ///< name and an integer for each cell
};

/// The bytes of the file, every coordinate to the last bit.
/// @pre the numbers are as many as points or cells, and names need no escaping in XML
std::string vtu(const VtuGrid& grid);

}  // namespace morskin::geometry
