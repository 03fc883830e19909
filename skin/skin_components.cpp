#include "skin/skin_components.h"

#include <limits>

namespace morskin::skin {

namespace {

/// The walls of a cell to cells of one dimension.
template <class Visit>
void for_each_wall_to(const MixedComplex& complex, CellId cell, int dimension, Visit visit) {
  for (const Wall& wall : complex.walls(cell)) {
    if (complex.dimension(wall.beyond) == dimension) visit(wall);
  }
}

}  // namespace

/// Goes from cell to cell, away from the orthocentres, to one of the last dimension, 0 or 3.
///
/// c or q moves, along a ray from the orthocentre in each cell, but x need not be moved with it:
/// the orthocentre of a simplex projects to those of its facets, so that x and the moved point
/// project to one ray in the next cell, and have its walls before them in the same order.
std::optional<SkinComponents::End> SkinComponents::path_end(const Point& x, CellId cell,
                                                            int last_dimension) const {
  const MixedComplex& complex = skin_.complex();
  const bool is_down = last_dimension == 0;
  for (int d = complex.dimension(cell); d != last_dimension; d += is_down ? -1 : 1) {
    const Patch& patch = complex.patch(cell);
    const Vector u = x - patch.centre;
    // c or q moves alone, along one half of u.
    Vector line = is_down ? Vector(u - patch.reflect(u)) : Vector(u + patch.reflect(u));
    std::optional<CellId> nearest;
    double step = std::numeric_limits<double>::infinity();
    for_each_wall_to(complex, cell, is_down ? d - 1 : d + 1, [&](const Wall& wall) {
      if (line.isZero(0)) line = wall.normal;  // at the orthocentre any direction will do
      const double slope = wall.normal.dot(line);
      if (!(slope > 0)) return;
      const double to_wall = (wall.offset - wall.normal.dot(x)) / slope;
      if (to_wall >= step) return;
      step = to_wall;
      nearest = wall.beyond;
    });
    if (!nearest) {
      if (is_down) return std::nullopt;  // lost to rounding: a simplex is bounded
      return End{cell, true};
    }
    cell = *nearest;
  }
  return End{cell, false};
}

std::optional<std::uint32_t> SkinComponents::void_of(const End& end) const {
  if (end.is_at_infinity) return std::nullopt;
  const std::uint32_t part = topology_.void_of_tetrahedron[skin_.complex().simplex_index(end.cell)];
  return part == DualComplex::no_part ? std::nullopt : std::optional(part);
}

/// An atom that others cover is not in K, though it lies in the body: from there the path goes on,
/// to a heavier one. For at its centre z, with c in the simplex of z's cell, |z - c|^2 - w_c / 2 is
/// G(z), at most -w / 2 by the atom alone, so w_c >= w; and from c on the weight grows.
std::optional<std::uint32_t> SkinComponents::body_below(const Point& x, CellId cell) const {
  Point at = x;
  double last = -std::numeric_limits<double>::infinity();  // half a weight
  for (;;) {
    const std::optional<End> down = path_end(at, cell, 0);
    if (!down) return std::nullopt;
    const std::uint32_t body = topology_.body_of_vertex[skin_.complex().simplex_index(down->cell)];
    if (body != DualComplex::no_part) return body;
    const Patch atom = skin_.patch(down->cell);
    if (!(atom.half_weight > last)) return std::nullopt;  // lost to rounding
    last = atom.half_weight;
    at = atom.centre;
    cell = skin_.locate(at, down->cell);
  }
}

std::optional<SkinComponents::Sides> SkinComponents::sides(const SurfacePoint& x) const {
  const std::optional<std::uint32_t> body = body_below(x.position, x.cell);
  const std::optional<OuterSide> outer = outer_side(x);
  if (!body || !outer) return std::nullopt;
  return Sides{*body, outer->cavity};
}

std::optional<SkinComponents::OuterSide> SkinComponents::outer_side(const SurfacePoint& x) const {
  const std::optional<End> up = path_end(x.position, x.cell, 3);
  if (!up) return std::nullopt;
  const bool is_free = up->is_at_infinity || skin_.patch(up->cell).half_weight < 0;
  return is_free ? std::optional(OuterSide{void_of(*up)}) : std::nullopt;
}

std::optional<std::uint32_t> SkinComponents::void_at(const Point& x, CellId cell) const {
  const std::optional<End> up = path_end(x, cell, 3);
  return up ? void_of(*up) : std::nullopt;
}

}  // namespace morskin::skin
