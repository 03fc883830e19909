#include "skin/mixed_complex.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "geometry/error.h"
#include "skin/orthocentre.h"

namespace morskin::skin {

namespace {

using geometry::RegularTriangulation;

constexpr std::size_t most_walls = 0xFFFFFFFFU;  // places in them have 32 bits
constexpr double infinity = std::numeric_limits<double>::infinity();

/// The direction from the k-th facet of a simplex towards the vertex that it lacks.
template <std::size_t N>
Vector direction_off_facet(std::span<const WeightedPoint> points,
                           const std::array<AtomId, N>& simplex, std::size_t k) {
  std::array<Point, N> p;
  for (std::size_t i = 0; i < N; ++i) p[i] = points[simplex[(k + 1 + i) % N].index()].position;
  return skin::direction_off_facet(p);
}

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

}  // namespace

/// The triangulation's simplices with N corners.
template <std::size_t N>
decltype(auto) MixedComplex::simplices() const {
  if constexpr (N == 1) return VertexList{triangulation_.vertices};
  if constexpr (N == 2) return (triangulation_.edges);
  if constexpr (N == 3) return (triangulation_.triangles);
  if constexpr (N == 4) return (triangulation_.tetrahedra);
}

MixedComplex::MixedComplex(std::vector<WeightedPoint> points, RegularTriangulation triangulation,
                           Keep keep)
    : points_(std::move(points)), triangulation_(std::move(triangulation)) {
  const std::array sizes{triangulation_.vertices.size(), triangulation_.edges.size(),
                         triangulation_.triangles.size(), triangulation_.tetrahedra.size()};
  // A wall of either cell for each simplex and facet of it; there are always more walls than cells.
  const std::size_t walls = 2 * (2 * sizes[1] + 3 * sizes[2] + 4 * sizes[3]);
  geometry::require_room(walls, most_walls, "walls of the mixed complex");
  for (std::size_t d = 0; d < 4; ++d) {
    first_number_[d + 1] = first_number_[d] + static_cast<std::uint32_t>(sizes[d]);
  }
  double largest = 0;
  for (const AtomId a : triangulation_.vertices) {
    const WeightedPoint& p = points_[a.index()];
    largest = std::max(largest, p.position.cwiseAbs().maxCoeff() + std::sqrt(std::abs(p.weight)));
  }
  wall_tolerance_ = std::ldexp(largest, -42);
  list_edges();
  choose_kept(keep);
  build_patches();
  build_walls();
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

/// Of a cell that is not kept: the number with so many others of its kind before it.
std::uint32_t MixedComplex::number(CellId cell) const {
  if (is_kept(cell)) return number_of_[cell.index()];
  const std::size_t before = cell.index() - kept_size();
  std::size_t word = 0, words = kept_bits_.size();  // the last word with no more before it
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

std::uint32_t MixedComplex::vertex_of(AtomId atom) const {
  const auto& vertices = triangulation_.vertices;
  return static_cast<std::uint32_t>(std::ranges::lower_bound(vertices, atom) - vertices.begin());
}

// Which cells are kept ----------------------------------------------------------------------------

/// By number, the weight of the orthocentre.
std::vector<double> MixedComplex::weights() const {
  std::vector<double> result;
  result.reserve(size());
  const auto add = [&](const auto& list) {
    for (std::size_t s = 0; s < list.size(); ++s) {
      result.push_back(static_cast<double>(orthocentre(corners(points_, list[s])).weight));
    }
  };
  add(simplices<1>());
  add(simplices<2>());
  add(simplices<3>());
  add(simplices<4>());
  return result;
}

/// By number, the largest power that the simplex's atoms have on its dual power cell: at one of the
/// orthocentres of the tetrahedra about it, or none on a cell that is unbounded.
std::vector<double> MixedComplex::largest_powers(const std::vector<double>& weights) const {
  std::vector<double> powers(size(), -infinity);
  for (std::uint32_t n = first_number_[3]; n < first_number_[4]; ++n) powers[n] = -weights[n];
  const auto raise = [&](std::uint32_t number, double power) {
    powers[number] = std::max(powers[number], power);
  };
  std::vector<char> sides(triangulation_.triangles.size(), 0);
  for (std::size_t s = 0; s < triangulation_.tetrahedra.size(); ++s) {
    for (const std::uint32_t f : triangulation_.tetrahedron_triangles[s]) {
      raise(first_number_[2] + f, powers[first_number_[3] + s]);
      ++sides[f];
    }
  }
  for (std::size_t s = 0; s < triangulation_.triangles.size(); ++s) {
    if (sides[s] < 2) powers[first_number_[2] + s] = infinity;
    for (const std::uint32_t e : triangulation_.triangle_edges[s]) {
      raise(first_number_[1] + e, powers[first_number_[2] + s]);
    }
  }
  for (std::uint32_t v = 0; v < triangulation_.vertices.size(); ++v) {
    for (std::uint32_t i = first_edge_[v]; i < first_edge_[v + 1]; ++i) {
      double& power = powers[first_number_[1] + edges_at_[i]];
      if (power == -infinity) power = infinity;  // no triangle about it
      raise(v, power);
    }
    if (first_edge_[v] == first_edge_[v + 1]) powers[v] = infinity;
  }
  return powers;
}

/// At x = (c + q) / 2 with c in the simplex and q in its dual, 4 G(x) is the power of the simplex's
/// atoms at q less the weight of the ball about c that is orthogonal to theirs. The power is at
/// least minus the orthocentre's weight, the ball's weight at least the orthocentre's and at most
/// the heaviest atom's; so G has a zero only where these ranges overlap.
void MixedComplex::choose_kept(Keep keep) {
  const std::vector<double> weight = weights();
  const std::vector<double> largest_power = largest_powers(weight);
  kept_bits_.assign(size() / 64 + 1, 0);
  const auto choose = [&](const auto& list, std::uint32_t n) {
    for (std::size_t s = 0; s < list.size(); ++s, ++n) {
      double heaviest = -infinity;
      for (const AtomId a : list[s]) heaviest = std::max(heaviest, points_[a.index()].weight);
      const double slack = 4 * nearness * std::abs(heaviest);
      const bool is_outside = -weight[n] > heaviest + slack;
      const bool is_inside = largest_power[n] + slack < weight[n];
      if (keep == Keep::NearSkin && (is_outside || is_inside)) continue;
      kept_bits_[n / 64] |= std::uint64_t{1} << n % 64;
      number_of_.push_back(n);
    }
  };
  choose(simplices<1>(), first_number_[0]);
  choose(simplices<2>(), first_number_[1]);
  choose(simplices<3>(), first_number_[2]);
  choose(simplices<4>(), first_number_[3]);
  number_of_.shrink_to_fit();
  kept_size_ = static_cast<std::uint32_t>(number_of_.size());
  kept_before_.reserve(kept_bits_.size());
  std::uint32_t kept = 0;
  for (const std::uint64_t bits : kept_bits_) {
    kept_before_.push_back(kept);
    kept += static_cast<std::uint32_t>(std::popcount(bits));
  }
}

// Making ------------------------------------------------------------------------------------------

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

Patch MixedComplex::make_patch(CellId cell) const {
  const std::uint32_t n = number(cell);
  const int d = dimension_of(n);
  const std::size_t place = n - first_number_[static_cast<std::size_t>(d)];
  switch (d) {
    case 0:
      return make_patch(simplices<1>()[place]);
    case 1:
      return make_patch(simplices<2>()[place]);
    case 2:
      return make_patch(simplices<3>()[place]);
    default:
      return make_patch(simplices<4>()[place]);
  }
}

/// The wall of a simplex's k-th facet to the simplex.
template <std::size_t N>
Wall MixedComplex::make_wall(const std::array<AtomId, N>& simplex, std::size_t k, CellId facet,
                             CellId cell) const {
  const Vector normal = direction_off_facet(points_, simplex, k);
  const Point middle = (patch(facet).centre + patch(cell).centre) / 2;
  return {normal, normal.dot(middle), cell};
}

/// Visits each facet of a simplex: k and the facet's cell.
template <std::size_t N, class Visit>
void MixedComplex::for_each_facet(std::size_t place, Visit visit) const {
  for (std::size_t k = 0; k < N; ++k) {
    if constexpr (N == 2) visit(k, cell(0, vertex_of(triangulation_.edges[place][1 - k])));
    if constexpr (N == 3) visit(k, cell(1, triangulation_.triangle_edges[place][k]));
    if constexpr (N == 4) visit(k, cell(2, triangulation_.tetrahedron_triangles[place][k]));
  }
}

template <std::size_t N>
void MixedComplex::add_walls_to_facets(const std::array<AtomId, N>& simplex, CellId cell,
                                       std::vector<Wall>& walls) const {
  for_each_facet<N>(place(cell), [&](std::size_t k, CellId facet) {
    const Wall wall = make_wall(simplex, k, facet, cell);
    walls.push_back({-wall.normal, -wall.offset, facet});
  });
}

/// The places of a simplex's cofaces of one dimension more, ascending. Their last corner is joined
/// to the simplex's first by an edge, and simplices are sorted.
template <std::size_t N>
std::vector<std::uint32_t> MixedComplex::cofaces(const std::array<AtomId, N>& simplex) const {
  std::vector<std::uint32_t> result;
  const std::uint32_t v = vertex_of(simplex[0]);
  for (std::uint32_t i = first_edge_[v]; i < first_edge_[v + 1]; ++i) {
    if constexpr (N == 1) {
      result.push_back(edges_at_[i]);
    } else {
      const auto& [a, b] = triangulation_.edges[edges_at_[i]];
      const AtomId apex = a == simplex[0] ? b : a;
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
void MixedComplex::add_walls_to_cofaces(const std::array<AtomId, N>& simplex, CellId cell,
                                        std::vector<Wall>& walls) const {
  for (const std::uint32_t place : cofaces(simplex)) {
    const auto& coface = simplices<N + 1>()[place];
    const CellId coface_cell = this->cell(N, place);
    for_each_facet<N + 1>(place, [&](std::size_t k, CellId facet) {
      if (facet == cell) walls.push_back(make_wall(coface, k, cell, coface_cell));
    });
  }
}

/// The walls of any cell, in the order in which build_walls() keeps them.
std::vector<Wall> MixedComplex::make_walls(CellId cell) const {
  std::vector<Wall> walls;
  const std::size_t at = place(cell);
  switch (dimension(cell)) {
    case 0:
      add_walls_to_cofaces<1>(simplices<1>()[at], cell, walls);
      break;
    case 1:
      add_walls_to_facets<2>(simplices<2>()[at], cell, walls);
      add_walls_to_cofaces<2>(simplices<2>()[at], cell, walls);
      break;
    case 2:
      add_walls_to_facets<3>(simplices<3>()[at], cell, walls);
      add_walls_to_cofaces<3>(simplices<3>()[at], cell, walls);
      break;
    default:
      add_walls_to_facets<4>(simplices<4>()[at], cell, walls);
  }
  return walls;
}

// Building what is kept ---------------------------------------------------------------------------

/// For each vertex the edges at it.
void MixedComplex::list_edges() {
  const auto& edges = triangulation_.edges;
  first_edge_.assign(triangulation_.vertices.size() + 2, 0);
  for (const auto& edge : edges) {
    for (const AtomId a : edge) ++first_edge_[vertex_of(a) + 2];
  }
  std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
  edges_at_.resize(2 * edges.size());
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    for (const AtomId a : edges[e]) edges_at_[first_edge_[vertex_of(a) + 1]++] = e;
  }
  first_edge_.pop_back();
}

void MixedComplex::build_patches() {
  patches_.reserve(number_of_.size());
  const auto build = [&](const auto& list, int d) {
    const auto dimension = static_cast<std::size_t>(d);
    for (std::size_t i = patches_.size();
         i < number_of_.size() && number_of_[i] < first_number_[dimension + 1]; ++i) {
      patches_.push_back(make_patch(list[number_of_[i] - first_number_[dimension]]));
    }
  };
  build(simplices<1>(), 0);
  build(simplices<2>(), 1);
  build(simplices<3>(), 2);
  build(simplices<4>(), 3);
}

/// Visits each pair of a facet's and a simplex's cell of which one is kept, with a function that
/// makes the wall between.
template <class Visit>
void MixedComplex::for_each_incidence(Visit visit) const {
  const auto visit_all = [&]<std::size_t N>(std::integral_constant<std::size_t, N>) {
    const auto& list = simplices<N>();
    for (std::size_t s = 0; s < list.size(); ++s) {
      const CellId simplex = cell(N - 1, s);
      for_each_facet<N>(s, [&](std::size_t k, CellId facet) {
        if (!is_kept(facet) && !is_kept(simplex)) return;
        visit(facet, simplex, [&] { return make_wall(list[s], k, facet, simplex); });
      });
    }
  };
  visit_all(std::integral_constant<std::size_t, 2>());
  visit_all(std::integral_constant<std::size_t, 3>());
  visit_all(std::integral_constant<std::size_t, 4>());
}

void MixedComplex::build_walls() {
  first_wall_.assign(kept_size() + 1, 0);
  for_each_incidence([&](CellId facet, CellId simplex, auto) {
    if (is_kept(facet)) ++first_wall_[facet.index() + 1];
    if (is_kept(simplex)) ++first_wall_[simplex.index() + 1];
  });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  std::vector<std::uint32_t> filled(first_wall_.begin(), first_wall_.end() - 1);
  for_each_incidence([&](CellId facet, CellId simplex, auto make) {
    const Wall wall = make();
    if (is_kept(facet)) walls_[filled[facet.index()]++] = wall;
    if (is_kept(simplex)) {
      walls_[filled[simplex.index()]++] = {-wall.normal, -wall.offset, facet};
    }
  });
}

}  // namespace morskin::skin
