#pragma once

/// The component of the skin that a point lies on.
///
/// A component of the skin separates a component of the body from one of the complement, and no two
/// components separate the same two (the graph of these separations is a tree). The mixed complex
/// alone gives both from a point x of the skin, the midpoint of c in a simplex and q in its dual
/// (section 2.1). The segment from x to c lies in the body, and so does the path from c along the
/// simplex, away from the orthocentre, to a facet and so down to an atom, since the weight of the
/// orthogonal balls grows along it. From q the same holds for the complement and the dual cells, up
/// to a tetrahedron or to infinity.

#include <compare>
#include <cstdint>
#include <optional>

#include "skin/dual_complex.h"

namespace morskin::skin {

class SkinComponents {
 public:
  /// @param skin, topology  must outlive this object.
  SkinComponents(const SkinSurface& skin, const DualComplex& topology)
      : skin_(skin), topology_(topology) {}

  /// A component of the skin by its two sides.
  struct Sides {
    std::uint32_t body = 0;               ///< in DualComplex::bodies
    std::optional<std::uint32_t> cavity;  ///< in DualComplex::voids; nothing for the outside
    friend auto operator<=>(const Sides&, const Sides&) = default;
  };
  /// Walked in doubles, between parts that were found exactly. Nothing if rounding loses the path.
  /// @pre x lies on the skin.
  std::optional<Sides> sides(const SurfacePoint& x) const;
  /// The side away from the body.
  struct OuterSide {
    std::optional<std::uint32_t> cavity;  ///< in DualComplex::voids; nothing for the outside
  };
  /// The same walk, without the one to the body, which is the longer.
  std::optional<OuterSide> outer_side(const SurfacePoint& x) const;
  /// The void that a point of the complement lies in; nothing outside them all.
  /// @pre G(x) > 0, and x lies in the cell
  std::optional<std::uint32_t> void_at(const Point& x, CellId cell) const;

 private:
  struct End {
    CellId cell;
    bool is_at_infinity = false;
  };
  std::optional<End> path_end(const Point& x, CellId cell, int last_dimension) const;
  std::optional<std::uint32_t> body_below(const Point& x, CellId cell) const;
  std::optional<std::uint32_t> void_of(const End& end) const;

  const SkinSurface& skin_;
  const DualComplex& topology_;
};

}  // namespace morskin::skin
