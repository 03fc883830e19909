#pragma once

/// The parts of the complement of the dual complex K: the voids and the outside (dual_complex.cpp).

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "geometry/sort_unique.h"
#include "geometry/union_find.h"
#include "skin/dual_complex.h"

namespace morskin::skin {

/// The cofaces of all simplices of one dimension, by index.
struct Cofaces {
  std::vector<std::uint32_t> first;  ///< by simplex, into indices
  std::vector<std::uint32_t> indices;

  std::span<const std::uint32_t> of(std::size_t simplex) const {
    return {indices.data() + first[simplex], first[simplex + 1] - first[simplex]};
  }
};

template <std::size_t N, class FacetIndex>
Cofaces cofaces(std::size_t facets, const std::vector<std::array<AtomId, N>>& simplices,
                FacetIndex facet_index) {
  Cofaces result;
  result.first.assign(facets + 2, 0);
  for (std::size_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t k = 0; k < N; ++k) ++result.first[facet_index(s, k) + 2];
  }
  std::partial_sum(result.first.begin(), result.first.end(), result.first.begin());
  result.indices.resize(result.first.back());
  for (std::uint32_t s = 0; s < simplices.size(); ++s) {
    for (std::size_t k = 0; k < N; ++k) {
      result.indices[result.first[facet_index(s, k) + 1]++] = s;
    }
  }
  result.first.pop_back();
  return result;
}

/// Numbers the sets among the elements that count, in the order of their roots, from 0; the others
/// get no_part.
template <class Counted>
std::vector<std::uint32_t> numbered(geometry::UnionFind& sets, std::size_t n, Counted counted) {
  std::vector<std::uint32_t> number(n, DualComplex::no_part);
  std::uint32_t next = 0;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (!counted(i)) continue;
    const std::uint32_t root = sets.root(i);
    number[i] = root == i ? next++ : number[root];
  }
  return number;
}

/// By tetrahedron, the void it is in: tetrahedra not in K are joined through triangles not in K.
/// Those in K get no_part, those outside Complement::outside.
std::vector<std::uint32_t> void_of_tetrahedron(const Cofaces& tetrahedra_of,
                                               const std::vector<char>& triangle_in,
                                               const std::vector<char>& tetrahedron_in);

/// The voids and the outside, found from the tetrahedra down. A simplex not in K lies in the part
/// of its cofaces; one in K with such a coface is part of the wall. The hull's outside counts as a
/// coface of its triangles, and of all that has no other.
class Complement {
 public:
  /// Takes the place of a void's number.
  static constexpr std::uint32_t outside = DualComplex::no_part - 1;

  Complement(const SkinSurface& skin, std::span<const std::uint32_t> void_of_tetrahedron);

  /// Goes on to the next lower dimension, of which the simplices are given.
  /// @param vertex_of  a vertex of a simplex
  template <class VertexOf>
  void descend(const Cofaces& cofaces, const std::vector<char>& in, int dimension,
               VertexOf vertex_of) {
    std::vector<std::uint32_t> here(in.size(), DualComplex::no_part);
    const auto add = [&](std::size_t s, std::uint32_t part) {
      if (part == DualComplex::no_part) return;
      if (in[s]) walls_.emplace_back(part, vertex_of(s));
      if (!in[s]) here[s] = part;
    };
    for (std::size_t s = 0; s < in.size(); ++s) {
      const auto around = cofaces.of(s);
      for (const std::uint32_t c : around) add(s, above_[c]);
      if (around.empty() || (dimension == 2 && around.size() == 1)) add(s, outside);
      if (here[s] == DualComplex::no_part || here[s] == outside) continue;
      voids_[here[s]].euler_characteristic += dimension == 1 ? 1 : -1;
    }
    geometry::sort_unique(walls_);
    above_ = std::move(here);
  }

  /// Fills in the voids, and the bodies about each part. @pre body_of_vertex is there
  void give_to(DualComplex& result);

 private:
  std::vector<std::uint32_t> above_;  ///< the part by simplex of the dimension above
  std::vector<std::pair<std::uint32_t, std::uint32_t>> walls_;  ///< parts, and vertices in K
  std::vector<Void> voids_;
};

}  // namespace morskin::skin
