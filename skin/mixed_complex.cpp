#include "skin/mixed_complex.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "skin/mixed_complex_internal.h"

namespace morskin::skin {

namespace {

using geometry::RegularTriangulation;

constexpr std::size_t max_walls = 0xFFFFFFFFU;  // indices have 32 bits

}  // namespace

MixedComplex::MixedComplex(std::vector<WeightedPoint> points, RegularTriangulation triangulation,
                           Keep keep, const geometry::Run& run)
    : points_(std::move(points)), triangulation_(std::move(triangulation)) {
  const std::array sizes{triangulation_.vertices.size(), triangulation_.edges.size(),
                         triangulation_.triangles.size(), triangulation_.tetrahedra.size()};
  // Two walls for each pair of a simplex and a facet; always more than there are cells.
  const std::size_t walls = 2 * (2 * sizes[1] + 3 * sizes[2] + 4 * sizes[3]);
  geometry::require_capacity(walls, max_walls, "walls of the mixed complex");
  for (std::size_t d = 0; d < 4; ++d) {
    first_number_[d + 1] = first_number_[d] + static_cast<std::uint32_t>(sizes[d]);
  }
  double largest = 0;
  for (const AtomId a : triangulation_.vertices) {
    const WeightedPoint& p = points_[a.index()];
    largest = std::max(largest, p.position.cwiseAbs().maxCoeff() + std::sqrt(std::abs(p.weight)));
  }
  wall_tolerance_ = std::ldexp(largest, -42);
  choose_kept(keep, run);
  build_patches(run);
  build_walls(run);
}

/// For each vertex the edges at it.
void MixedComplex::list_edges() {
  const auto& edges = triangulation_.edges;
  edges_at_ = geometry::grouped<std::uint32_t>(triangulation_.vertices.size(), [&](auto visit) {
    for (std::uint32_t e = 0; e < edges.size(); ++e) {
      for (const AtomId a : edges[e]) visit(vertex_of(a), e);
    }
  });
}

void MixedComplex::forget_facets() {
  std::vector<std::array<std::uint32_t, 4>>().swap(triangulation_.tetrahedron_triangles);
  std::vector<std::array<std::uint32_t, 3>>().swap(triangulation_.triangle_edges);
  are_facets_forgotten_ = true;
}

// Numbers and ids ---------------------------------------------------------------------------------

int MixedComplex::dimension_of(std::uint32_t number) const {
  int d = 0;
  while (number >= first_number_[static_cast<std::size_t>(d) + 1]) ++d;
  return d;
}

CellId MixedComplex::numbered(std::uint32_t number) const {
  const std::uint64_t bits = kept_bits_[number / 64], bit = std::uint64_t{1} << number % 64;
  const std::uint32_t kept =
      kept_before_[number / 64] + static_cast<std::uint32_t>(std::popcount(bits & (bit - 1)));
  return (bits & bit) != 0 ? CellId{kept} : CellId{kept_size_ + number - kept};
}

/// Of a cell that is not kept: the number with as many cells before it that are not kept.
std::uint32_t MixedComplex::number(CellId cell) const {
  if (is_kept(cell)) return number_of_[cell.index()];
  const std::size_t before = cell.index() - kept_size();
  std::size_t word = 0, words = kept_bits_.size();  // the last word with at most `before` before it
  while (words > 1) {
    const std::size_t half = words / 2, middle = word + half;
    if (64 * middle - kept_before_[middle] <= before) word = middle;
    words -= half;
  }
  std::uint64_t others = ~kept_bits_[word];
  for (std::size_t i = 64 * word - kept_before_[word]; i < before; ++i) others &= others - 1;
  return static_cast<std::uint32_t>(64 * word) +
         static_cast<std::uint32_t>(std::countr_zero(others));
}

/// The index of an atom among the vertices: its id less the hidden atoms before it, which are few.
std::uint32_t MixedComplex::vertex_of(AtomId atom) const {
  const auto& hidden = triangulation_.hidden;
  if (hidden.empty()) return atom.value;
  return atom.value -
         static_cast<std::uint32_t>(std::ranges::lower_bound(hidden, atom) - hidden.begin());
}

// Making ------------------------------------------------------------------------------------------

Patch MixedComplex::make_patch(CellId cell) const { return make_patch_numbered(number(cell)); }

Patch MixedComplex::make_patch_numbered(std::uint32_t n) const {
  const int d = dimension_of(n);
  const std::size_t index = n - first_number_[static_cast<std::size_t>(d)];
  switch (d) {
    case 0:
      return make_patch(simplices<1>()[index]);
    case 1:
      return make_patch(simplices<2>()[index]);
    case 2:
      return make_patch(simplices<3>()[index]);
    default:
      return make_patch(simplices<4>()[index]);
  }
}

template <std::size_t N>
void MixedComplex::add_walls_to_facets(std::size_t index, std::vector<Wall>& walls) const {
  const Point own = centre<N>(index);
  const auto facet = facets<N>(index);
  for (std::size_t k = 0; k < N; ++k) {
    const Wall wall = make_wall(simplices<N>()[index], k, centre<N - 1>(facet[k]), own, CellId());
    walls.push_back({-wall.normal, -wall.offset, cell(N - 2, facet[k])});
  }
}

/// The indices of a simplex's cofaces of one dimension more, ascending. An edge joins their further
/// corner to each of the simplex's, of which the one with the fewest edges is asked; a large ball
/// may have one to every other. Simplices are sorted.
template <std::size_t N>
std::vector<std::uint32_t> MixedComplex::cofaces(const std::array<AtomId, N>& simplex) const {
  std::vector<std::uint32_t> result;
  const auto edge_count = [this](AtomId a) { return edges_at_.of(vertex_of(a)).size(); };
  const AtomId corner = *std::ranges::min_element(simplex, {}, edge_count);
  for (const std::uint32_t edge : edges_at_.of(vertex_of(corner))) {
    if constexpr (N == 1) {
      result.push_back(edge);
    } else {
      const auto& [a, b] = triangulation_.edges[edge];
      const AtomId apex = a == corner ? b : a;
      std::array<AtomId, N + 1> coface;
      std::copy_n(simplex.begin(), N, coface.begin());
      coface[N] = apex;
      std::sort(coface.begin(), coface.end());
      const auto& list = simplices<N + 1>();
      const auto found = std::lower_bound(list.begin(), list.end(), coface);
      if (found != list.end() && *found == coface) {
        result.push_back(static_cast<std::uint32_t>(found - list.begin()));
      }
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

template <std::size_t N>
void MixedComplex::add_walls_to_cofaces(std::size_t index, std::vector<Wall>& walls) const {
  const Point own = centre<N>(index);
  for (const std::uint32_t above : cofaces(simplices<N>()[index])) {
    const auto facet = facets<N + 1>(above);
    const auto k = static_cast<std::size_t>(std::ranges::find(facet, index) - facet.begin());
    walls.push_back(
        make_wall(simplices<N + 1>()[above], k, own, centre<N + 1>(above), cell(N, above)));
  }
}

/// The walls of any cell, in the order of build_walls().
std::vector<Wall> MixedComplex::make_walls(CellId cell) const {
  std::vector<Wall> walls;
  const std::size_t at = simplex_index(cell);
  switch (dimension(cell)) {
    case 0:
      add_walls_to_cofaces<1>(at, walls);
      break;
    case 1:
      add_walls_to_facets<2>(at, walls);
      add_walls_to_cofaces<2>(at, walls);
      break;
    case 2:
      add_walls_to_facets<3>(at, walls);
      add_walls_to_cofaces<3>(at, walls);
      break;
    default:
      add_walls_to_facets<4>(at, walls);
  }
  return walls;
}

}  // namespace morskin::skin
