#include "skin/mixed_complex.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

#include "geometry/error.h"
#include "skin/orthocentre.h"

namespace morskin::skin {

namespace {

using geometry::RegularTriangulation;

constexpr std::size_t most_walls = 0xFFFFFFFFU;  // places in them have 32 bits

/// The patch of a simplex: about its orthocentre, w its weight.
Patch patch_of(std::span<const WeightedPoint> simplex) {
  const Orthocentre z = orthocentre(simplex);
  Patch patch;
  patch.centre = z.position.cast<double>();
  patch.axis = z.normal.cast<double>();
  patch.sign = simplex.size() <= 2 ? +1 : -1;
  patch.half_weight = static_cast<double>(z.weight / 2);
  return patch;
}

/// The direction from the k-th facet of a simplex towards the vertex that it lacks.
template <std::size_t N>
Vector direction_off_facet(std::span<const WeightedPoint> points,
                           const std::array<AtomId, N>& simplex, std::size_t k) {
  std::array<Point, N> p;
  for (std::size_t i = 0; i < N; ++i) p[i] = points[simplex[(k + 1 + i) % N].index()].position;
  return skin::direction_off_facet(p);
}

}  // namespace

MixedComplex::MixedComplex(std::span<const WeightedPoint> points,
                           const RegularTriangulation& triangulation) {
  const std::array sizes{triangulation.vertices.size(), triangulation.edges.size(),
                         triangulation.triangles.size(), triangulation.tetrahedra.size()};
  // A wall of either cell for each simplex and facet of it; there are always more walls than cells.
  const std::size_t walls = 2 * (2 * sizes[1] + 3 * sizes[2] + 4 * sizes[3]);
  geometry::require_room(walls, most_walls, "walls of the mixed complex");
  for (std::size_t d = 0; d < 4; ++d) {
    first_cell_[d + 1] = first_cell_[d] + static_cast<std::uint32_t>(sizes[d]);
  }
  double largest = 0;
  for (const AtomId a : triangulation.vertices) {
    const WeightedPoint& p = points[a.index()];
    largest = std::max(largest, p.position.cwiseAbs().maxCoeff() + std::sqrt(std::abs(p.weight)));
  }
  wall_tolerance_ = std::ldexp(largest, -42);
  build_patches(points, triangulation);
  build_walls(points, triangulation);
}

int MixedComplex::dimension(CellId cell) const {
  int d = 0;
  while (cell.value >= first_cell_[static_cast<std::size_t>(d) + 1]) ++d;
  return d;
}

void MixedComplex::build_patches(std::span<const WeightedPoint> points,
                                 const RegularTriangulation& triangulation) {
  patches_.reserve(first_cell_[4]);
  const auto add = [&]<std::size_t N>(const std::array<AtomId, N>& simplex) {
    std::array<WeightedPoint, N> corners;
    for (std::size_t i = 0; i < N; ++i) corners[i] = points[simplex[i].index()];
    patches_.push_back(patch_of(corners));
  };
  for (const AtomId a : triangulation.vertices) add(std::array{a});
  for (const auto& simplex : triangulation.edges) add(simplex);
  for (const auto& simplex : triangulation.triangles) add(simplex);
  for (const auto& simplex : triangulation.tetrahedra) add(simplex);
}

void MixedComplex::build_walls(std::span<const WeightedPoint> points,
                               const RegularTriangulation& triangulation) {
  std::vector<std::uint32_t> vertex_of_atom(points.size(), 0);
  for (std::uint32_t v = 0; v < triangulation.vertices.size(); ++v) {
    vertex_of_atom[triangulation.vertices[v].index()] = v;
  }
  // Visits each pair (facet cell, simplex cell, unit direction from one to the other).
  const auto for_each_incidence = [&](auto visit) {
    for (std::size_t s = 0; s < triangulation.edges.size(); ++s) {
      const auto& simplex = triangulation.edges[s];
      for (std::size_t k = 0; k < 2; ++k) {
        visit(cell(0, vertex_of_atom[simplex[1 - k].index()]), cell(1, s),
              [&] { return direction_off_facet(points, simplex, k); });
      }
    }
    for (std::size_t s = 0; s < triangulation.triangles.size(); ++s) {
      for (std::size_t k = 0; k < 3; ++k) {
        visit(cell(1, triangulation.triangle_edges[s][k]), cell(2, s),
              [&] { return direction_off_facet(points, triangulation.triangles[s], k); });
      }
    }
    for (std::size_t s = 0; s < triangulation.tetrahedra.size(); ++s) {
      for (std::size_t k = 0; k < 4; ++k) {
        visit(cell(2, triangulation.tetrahedron_triangles[s][k]), cell(3, s),
              [&] { return direction_off_facet(points, triangulation.tetrahedra[s], k); });
      }
    }
  };
  first_wall_.assign(patches_.size() + 1, 0);
  for_each_incidence([&](CellId facet, CellId simplex, auto) {
    ++first_wall_[facet.index() + 1];
    ++first_wall_[simplex.index() + 1];
  });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  std::vector<std::uint32_t> filled(first_wall_.begin(), first_wall_.end() - 1);
  for_each_incidence([&](CellId facet, CellId simplex, auto direction) {
    const Vector normal = direction();
    const Point middle = (patch(facet).centre + patch(simplex).centre) / 2;
    const double offset = normal.dot(middle);
    walls_[filled[facet.index()]++] = {normal, offset, simplex};
    walls_[filled[simplex.index()]++] = {-normal, -offset, facet};
  });
}

}  // namespace morskin::skin
