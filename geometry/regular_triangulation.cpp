#include "geometry/regular_triangulation.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "geometry/triangulator.h"

namespace morskin::geometry {
namespace {

template <std::size_t Size>
using Simplices = std::vector<std::array<AtomId, Size>>;

/// By atom, the index of the first simplex that begins with it; then the end.
template <std::size_t Size>
std::vector<std::uint32_t> starts_by_first(const Simplices<Size>& simplices,
                                           std::size_t atom_count) {
  std::vector<std::uint32_t> starts(atom_count + 1, 0);
  for (const auto& simplex : simplices) ++starts[simplex[0].index() + 1];
  for (std::size_t i = 0; i < atom_count; ++i) starts[i + 1] += starts[i];
  return starts;
}

/// The second corner, and the third if any, as one number with the same order.
template <std::size_t Size>
std::uint64_t middle(const std::array<AtomId, Size>& simplex) {
  if constexpr (Size == 2) return simplex[1].value;
  return std::uint64_t{simplex[1].value} << 32 | simplex[Size == 2 ? 1 : 2].value;
}

/// Lexicographic order of simplices with the same first corner.
template <std::size_t Size>
bool precedes(const std::array<AtomId, Size>& a, const std::array<AtomId, Size>& b) {
  const std::uint64_t middle_a = middle(a);
  const std::uint64_t middle_b = middle(b);
  if (Size < 4 || middle_a != middle_b) return middle_a < middle_b;
  return a[Size - 1] < b[Size - 1];
}

/// Sorts lexicographically and drops repetitions: by the first corner with a counting sort, then
/// within each corner's few.
template <std::size_t Size>
void sort_unique(Simplices<Size>& simplices, std::size_t atom_count) {
  const std::vector<std::uint32_t> starts = starts_by_first(simplices, atom_count);
  std::vector<std::uint32_t> next(starts.begin(), starts.end() - 1);
  Simplices<Size> sorted(simplices.size());
  for (const auto& simplex : simplices) sorted[next[simplex[0].index()]++] = simplex;
  for (std::size_t i = 0; i < atom_count; ++i) {
    std::sort(sorted.begin() + starts[i], sorted.begin() + starts[i + 1], precedes<Size>);
  }
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  simplices = std::move(sorted);
}

template <std::size_t Size>
std::array<AtomId, Size - 1> without(const std::array<AtomId, Size>& simplex, std::size_t corner) {
  std::array<AtomId, Size - 1> rest;
  for (std::size_t k = 0; k + 1 < Size; ++k) rest[k] = simplex[k < corner ? k : k + 1];
  return rest;
}

/// By simplex, the indices of its facets, entry k opposite corner k. The binary search uses a
/// conditional move, since its branches are unpredictable.
template <std::size_t Size>
std::vector<std::array<std::uint32_t, Size>> facet_indices(const Simplices<Size>& simplices,
                                                           const Simplices<Size - 1>& facets,
                                                           std::size_t atom_count) {
  static_assert(Size <= 4, "middle() must tell apart all facets with one first corner");
  const std::vector<std::uint32_t> starts = starts_by_first(facets, atom_count);
  std::vector<std::array<std::uint32_t, Size>> indices(simplices.size());
  for (std::size_t i = 0; i < simplices.size(); ++i) {
    for (std::size_t k = 0; k < Size; ++k) {
      const auto facet = without(simplices[i], k);
      const std::uint64_t wanted = middle(facet);
      std::uint32_t index = starts[facet[0].index()];
      std::uint32_t candidates = starts[facet[0].index() + 1] - index;
      while (candidates > 1) {
        const std::uint32_t half = candidates / 2;
        index += middle(facets[index + half]) <= wanted ? half : 0;
        candidates -= half;
      }
      indices[i][k] = index;
    }
  }
  return indices;
}

/// The edges of sorted triangles, most of them several times.
Simplices<2> edges_of(const Simplices<3>& triangles) {
  Simplices<2> edges;
  edges.reserve(5 * triangles.size() / 2);
  for (const auto& [a, b, c] : triangles) {
    if (edges.empty() || edges.back() != std::array{a, b}) edges.push_back({a, b});
    edges.push_back({b, c});
    edges.push_back({a, c});
  }
  return edges;
}

/// The simplices with Size atoms as corners and apexes as the others, none at infinity.
template <std::size_t Size>
Simplices<Size> top_simplices(const Triangulator& triangulator) {
  Simplices<Size> simplices;
  for (std::size_t i = 0; i < triangulator.tetrahedra().size(); ++i) {
    const Triangulator::Tetrahedron& t = triangulator.tetrahedra()[i];
    if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
    std::array<AtomId, 4> atoms;
    std::size_t count = 0;
    for (const Triangulator::Corner corner : t.corners) {
      if (const auto atom = triangulator.atom(corner)) atoms[count++] = *atom;
    }
    if (count != Size) continue;
    std::sort(atoms.begin(), atoms.begin() + Size);
    std::array<AtomId, Size>& simplex = simplices.emplace_back();
    std::copy_n(atoms.begin(), Size, simplex.begin());
  }
  return simplices;
}

/// The facets of finite tetrahedra, each from one of its two sides.
Simplices<3> facets(const Triangulator& triangulator) {
  Simplices<3> triangles;
  const auto tetrahedra = triangulator.tetrahedra();
  triangles.reserve(2 * tetrahedra.size());
  for (std::size_t i = 0; i < tetrahedra.size(); ++i) {
    const Triangulator::Tetrahedron& t = tetrahedra[i];
    if (!triangulator.is_live(i) || triangulator.is_ghost(t)) continue;
    std::array<AtomId, 4> atoms;
    for (std::size_t k = 0; k < 4; ++k) atoms[k] = *triangulator.atom(t.corners[k]);
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t behind = Triangulator::tetrahedron_of(t.neighbours[k]);
      if (behind < i && !triangulator.is_ghost(tetrahedra[behind])) continue;
      std::array<AtomId, 3> triangle = without(atoms, k);
      std::sort(triangle.begin(), triangle.end());
      triangles.push_back(triangle);
    }
  }
  return triangles;
}

/// The heaviest of points at one position, the smallest id if equal.
AtomId heaviest(std::span<const WeightedPoint> points) {
  const auto best = std::max_element(
      points.begin(), points.end(),
      [](const WeightedPoint& a, const WeightedPoint& b) { return a.weight < b.weight; });
  return AtomId(static_cast<std::size_t>(best - points.begin()));
}

}  // namespace

RegularTriangulation regular_triangulation(std::span<const WeightedPoint> points, const Run& run) {
  RegularTriangulation result;
  std::vector<bool> is_vertex(points.size(), false);
  {
    const Triangulator triangulator(points, run);
    result.dimension = triangulator.dimension();
    if (result.dimension == 0) is_vertex[heaviest(points).index()] = true;
    if (result.dimension == 1) result.edges = top_simplices<2>(triangulator);
    if (result.dimension == 2) result.triangles = top_simplices<3>(triangulator);
    if (result.dimension == 3) result.tetrahedra = top_simplices<4>(triangulator);
    if (result.dimension == 3) result.triangles = facets(triangulator);
  }
  sort_unique(result.tetrahedra, points.size());
  sort_unique(result.triangles, points.size());
  if (result.dimension >= 2) result.edges = edges_of(result.triangles);
  sort_unique(result.edges, points.size());
  result.tetrahedron_triangles = facet_indices(result.tetrahedra, result.triangles, points.size());
  result.triangle_edges = facet_indices(result.triangles, result.edges, points.size());
  for (const auto& [a, b] : result.edges) is_vertex[a.index()] = is_vertex[b.index()] = true;
  for (std::size_t i = 0; i < points.size(); ++i) {
    (is_vertex[i] ? result.vertices : result.hidden).push_back(AtomId(i));
  }
  return result;
}

}  // namespace morskin::geometry
