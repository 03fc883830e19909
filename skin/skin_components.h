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
#include <vector>

#include "skin/skin_surface.h"

namespace morskin::skin {

class SkinComponents {
 public:
  /// Computed in doubles, so it may be wrong where the skin is singular to rounding: compare
  /// body_count() and void_count() with the exact numbers of the dual complex.
  /// @param skin  must outlive this object.
  explicit SkinComponents(const SkinSurface& skin);

  std::size_t body_count() const { return bodies_.size(); }
  std::size_t void_count() const { return voids_.size(); }

  /// A component of the skin by its two sides.
  struct Sides {
    std::uint32_t body = 0;               ///< component of the body, < body_count()
    std::optional<std::uint32_t> cavity;  ///< void, < void_count(); nothing for the outside
    friend auto operator<=>(const Sides&, const Sides&) = default;
  };
  /// Nothing if rounding loses the path from x. @pre x lies on the skin.
  std::optional<Sides> sides(const SurfacePoint& x) const;

  /// The first atom in a component of the body.
  AtomId atom(std::uint32_t body) const { return bodies_[body]; }
  /// A point in a void.
  const Point& centre(std::uint32_t cavity) const { return voids_[cavity]; }

 private:
  struct End {
    CellId cell;
    bool is_at_infinity = false;
  };
  std::optional<End> path_end(const SurfacePoint& x, int last_dimension) const;
  void find_bodies();
  void find_voids();

  const SkinSurface& skin_;
  std::vector<std::uint32_t> body_of_vertex_;  ///< by index in the triangulation
  std::vector<std::optional<std::uint32_t>> void_of_tetrahedron_;  ///< nothing: outside
  std::vector<AtomId> bodies_;
  std::vector<Point> voids_;
};

}  // namespace morskin::skin
