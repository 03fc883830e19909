#pragma once

/// Shared by mixed_complex.cpp, which makes single cells, and mixed_complex_kept.cpp, which makes
/// all kept ones.

#include <algorithm>

#include "skin/mixed_complex.h"
#include "skin/orthocentre.h"

namespace morskin::skin {

template <std::size_t N>
std::array<WeightedPoint, N> corners(std::span<const WeightedPoint> points,
                                     const std::array<AtomId, N>& simplex) {
  std::array<WeightedPoint, N> result;
  for (std::size_t i = 0; i < N; ++i) result[i] = points[simplex[i].index()];
  return result;
}

/// The vertices as simplices.
struct VertexList {
  const std::vector<AtomId>& atoms;
  std::size_t size() const { return atoms.size(); }
  std::array<AtomId, 1> operator[](std::size_t i) const { return {atoms[i]}; }
};

/// The triangulation's simplices with N corners.
template <std::size_t N>
decltype(auto) MixedComplex::simplices() const {
  if constexpr (N == 1) return VertexList{triangulation_.vertices};
  if constexpr (N == 2) return (triangulation_.edges);
  if constexpr (N == 3) return (triangulation_.triangles);
  if constexpr (N == 4) return (triangulation_.tetrahedra);
}

/// The indices of a simplex's facets, entry k opposite corner k.
template <std::size_t N>
std::array<std::uint32_t, N> MixedComplex::facets(std::size_t index) const {
  if constexpr (N == 2) {
    const auto& [a, b] = triangulation_.edges[index];
    return {vertex_of(b), vertex_of(a)};
  } else {
    if constexpr (N == 4) {
      if (!are_facets_forgotten_) return triangulation_.tetrahedron_triangles[index];
    } else {
      if (!are_facets_forgotten_) return triangulation_.triangle_edges[index];
    }
    std::array<std::uint32_t, N> result;
    const auto& list = simplices<N - 1>();
    for (std::size_t k = 0; k < N; ++k) {
      std::array<AtomId, N - 1> facet;
      const auto& simplex = simplices<N>()[index];
      const auto rest = std::copy_n(simplex.begin(), k, facet.begin());
      std::copy(simplex.begin() + static_cast<std::ptrdiff_t>(k) + 1, simplex.end(), rest);
      result[k] = static_cast<std::uint32_t>(std::ranges::lower_bound(list, facet) - list.begin());
    }
    return result;
  }
}

/// The patch of a simplex: about its orthocentre, w its weight.
template <std::size_t N>
Patch MixedComplex::make_patch(const std::array<AtomId, N>& simplex) const {
  const Orthocentre z = orthocentre(corners(points_, simplex));
  Patch patch;
  patch.centre = z.position.template cast<double>();
  patch.axis = z.normal.template cast<double>();
  patch.sign = N <= 2 ? +1 : -1;
  patch.half_weight = static_cast<double>(z.weight / 2);
  return patch;
}

/// The orthocentre of a simplex, as stored in its patch.
template <std::size_t N>
Point MixedComplex::centre(std::size_t index) const {
  const std::uint32_t n = first_number_[N - 1] + static_cast<std::uint32_t>(index);
  return is_kept_number(n) ? patches_[numbered(n).index()].centre
                           : make_patch(simplices<N>()[index]).centre;
}

/// The wall of a simplex's k-th facet to the simplex.
///
/// @param facet_centre, centre  their orthocentres
template <std::size_t N>
Wall MixedComplex::make_wall(const std::array<AtomId, N>& simplex, std::size_t k,
                             const Point& facet_centre, const Point& centre, CellId cell) const {
  std::array<Point, N> p;  // the corners, that opposite the facet last
  for (std::size_t i = 0; i < N; ++i) p[i] = points_[simplex[(k + 1 + i) % N].index()].position;
  const Vector normal = direction_off_facet(p);
  const Point middle = (facet_centre + centre) / 2;
  return {normal, normal.dot(middle), cell};
}

}  // namespace morskin::skin
