#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

namespace morskin::geometry {

/// The index that stands for none: the last that 32 bits hold.
inline constexpr std::uint32_t no_index = 0xFFFFFFFFU;

/// The position of one Tag in its array. Never an integer, never another Tag's Id.
template <class Tag>
struct Id {
  std::uint32_t value = 0;

  constexpr Id() = default;
  constexpr explicit Id(std::uint32_t position) : value(position) {}
  constexpr explicit Id(std::size_t position) : value(static_cast<std::uint32_t>(position)) {}

  /// Stands for no position in an array of ids; elsewhere use std::optional.
  static constexpr Id none() { return Id{no_index}; }

  /// The position as an array index.
  constexpr std::size_t index() const { return value; }
  friend constexpr auto operator<=>(Id, Id) = default;
};

using AtomId = Id<struct AtomTag>;          ///< a weighted point, by its index in the input
using VertexId = Id<struct VertexTag>;      ///< a vertex of a surface mesh
using TriangleId = Id<struct TriangleTag>;  ///< a triangle of a surface mesh
using CellId = Id<struct CellTag>;  ///< a simplex of the regular triangulation = a mixed cell

}  // namespace morskin::geometry
