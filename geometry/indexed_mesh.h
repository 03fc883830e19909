#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/point.h"

namespace morskin::geometry {

/// Three indices of vertices, counter-clockwise seen from outside.
using TriangleCorners = std::array<std::uint32_t, 3>;
using TriangleList = std::vector<TriangleCorners>;

inline bool repeats_a_corner(const TriangleCorners& t) {
  return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// A triangle mesh as in files. Any connectivity, valid or not.
struct IndexedMesh {
  std::vector<Point> positions;  ///< Angstrom
  TriangleList triangles;        ///< each index < positions.size()

  bool operator==(const IndexedMesh&) const = default;

  /// Adds the vertices and triangles of another mesh behind these.
  void append(const IndexedMesh& other) {
    const auto shift = static_cast<std::uint32_t>(positions.size());
    positions.insert(positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.triangles) {
      triangles.push_back({a + shift, b + shift, c + shift});
    }
  }
};

}  // namespace morskin::geometry
