#include "skin/skin_components.h"

#include <algorithm>
#include <limits>

#include "geometry/union_find.h"

namespace morskin::skin {

namespace {

using geometry::UnionFind;

/// The walls of a cell to cells of one dimension.
template <class Visit>
void for_each_wall_to(const MixedComplex& complex, CellId cell, int dimension, Visit visit) {
  for (const Wall& wall : complex.walls(cell)) {
    if (complex.dimension(wall.beyond) == dimension) visit(wall);
  }
}

/// Whether the cell's orthocentre lies between those of its neighbours of that dimension: on the
/// simplex if they are facets, on the dual cell if they are cofaces.
bool is_centre_between(const MixedComplex& complex, CellId cell, int dimension) {
  const Point& centre = complex.patch(cell).centre;
  bool is_between = true;
  for_each_wall_to(complex, cell, dimension, [&](const Wall& wall) {
    is_between = is_between && wall.normal.dot(complex.patch(wall.beyond).centre - centre) >= 0;
  });
  return is_between;
}

}  // namespace

SkinComponents::SkinComponents(const SkinSurface& skin) : skin_(skin) {
  find_bodies();
  find_voids();
}

/// Atoms of positive weight, joined along edges on which the weight stays positive. Its minimum on
/// the edge is at the orthocentre or at an end.
void SkinComponents::find_bodies() {
  const geometry::RegularTriangulation& t = skin_.triangulation();
  const MixedComplex& complex = skin_.complex();
  UnionFind sets(t.vertices.size());
  const auto is_body = [&](std::uint32_t v) {
    return complex.patch(complex.cell(0, v)).half_weight > 0;
  };
  for (std::size_t e = 0; e < t.edges.size(); ++e) {
    const CellId cell = complex.cell(1, e);
    std::vector<std::uint32_t> ends;
    for_each_wall_to(complex, cell, 0, [&](const Wall& wall) {
      ends.push_back(static_cast<std::uint32_t>(complex.simplex_index(wall.beyond)));
    });
    if (!is_body(ends[0]) || !is_body(ends[1])) continue;
    if (complex.patch(cell).half_weight > 0 || !is_centre_between(complex, cell, 0)) {
      sets.join(ends[0], ends[1]);
    }
  }
  body_of_vertex_.resize(t.vertices.size());
  for (std::uint32_t v = 0; v < t.vertices.size(); ++v) {
    const std::uint32_t root = sets.root(v);
    body_of_vertex_[v] = body_of_vertex_[root];
    if (root != v || !is_body(v)) continue;
    body_of_vertex_[v] = static_cast<std::uint32_t>(bodies_.size());
    bodies_.push_back(t.vertices[v]);
  }
}

/// The dual: tetrahedra of negative weight, joined through triangles on whose dual segment it stays
/// negative. The last set is the outside.
void SkinComponents::find_voids() {
  const geometry::RegularTriangulation& t = skin_.triangulation();
  const MixedComplex& complex = skin_.complex();
  const auto outside = static_cast<std::uint32_t>(t.tetrahedra.size());
  UnionFind sets(t.tetrahedra.size() + 1);
  const auto is_void = [&](std::uint32_t v) {
    return v == outside || complex.patch(complex.cell(3, v)).half_weight < 0;
  };
  for (std::size_t f = 0; f < t.triangles.size(); ++f) {
    const CellId cell = complex.cell(2, f);
    std::array ends{outside, outside};
    std::size_t count = 0;
    for_each_wall_to(complex, cell, 3, [&](const Wall& wall) {
      ends[count++] = static_cast<std::uint32_t>(complex.simplex_index(wall.beyond));
    });
    if (!is_void(ends[0]) || !is_void(ends[1])) continue;
    if (complex.patch(cell).half_weight < 0 || !is_centre_between(complex, cell, 3)) {
      sets.join(ends[0], ends[1]);
    }
  }
  void_of_tetrahedron_.resize(t.tetrahedra.size());
  for (std::uint32_t v = 0; v < t.tetrahedra.size(); ++v) {
    const std::uint32_t root = sets.root(v);
    if (root == sets.root(outside)) continue;
    void_of_tetrahedron_[v] = void_of_tetrahedron_[root];
    if (root != v || !is_void(v)) continue;
    void_of_tetrahedron_[v] = static_cast<std::uint32_t>(voids_.size());
    voids_.push_back(complex.patch(complex.cell(3, v)).centre);
  }
}

/// Goes from cell to cell, away from the orthocentres, to one of the last dimension, 0 or 3.
std::optional<SkinComponents::End> SkinComponents::path_end(const SurfacePoint& x,
                                                            int last_dimension) const {
  const MixedComplex& complex = skin_.complex();
  const bool is_down = last_dimension == 0;
  Point at = x.position;
  CellId cell = x.cell;
  for (int d = complex.dimension(cell); d != last_dimension; d += is_down ? -1 : 1) {
    const Patch& patch = complex.patch(cell);
    const Vector u = at - patch.centre;
    // c or q moves alone, along one half of u.
    Vector line = is_down ? Vector(u - patch.reflect(u)) : Vector(u + patch.reflect(u));
    std::optional<CellId> nearest;
    double step = std::numeric_limits<double>::infinity();
    for_each_wall_to(complex, cell, is_down ? d - 1 : d + 1, [&](const Wall& wall) {
      if (line.isZero(0)) line = wall.normal;  // at the orthocentre any direction will do
      const double slope = wall.normal.dot(line);
      if (!(slope > 0)) return;
      const double to_wall = std::max(0.0, (wall.offset - wall.normal.dot(at)) / slope);
      if (to_wall >= step) return;
      step = to_wall;
      nearest = wall.beyond;
    });
    if (!nearest) {
      if (is_down) return std::nullopt;  // lost to rounding: a simplex is bounded
      return End{cell, true};
    }
    at += step * line;
    cell = *nearest;
  }
  return End{cell, false};
}

std::optional<SkinComponents::Sides> SkinComponents::sides(const SurfacePoint& x) const {
  const MixedComplex& complex = skin_.complex();
  const std::optional<End> down = path_end(x, 0), up = path_end(x, 3);
  if (!down || !up || !(complex.patch(down->cell).half_weight > 0)) return std::nullopt;
  Sides sides{body_of_vertex_[complex.simplex_index(down->cell)], std::nullopt};
  if (up->is_at_infinity) return sides;
  if (!(complex.patch(up->cell).half_weight < 0)) return std::nullopt;
  sides.cavity = void_of_tetrahedron_[complex.simplex_index(up->cell)];
  return sides;
}

}  // namespace morskin::skin
