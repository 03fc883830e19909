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

/// The place of an atom among the vertices: its own, less the hidden atoms before it. Those are
/// few.
std::uint32_t MixedComplex::vertex_of(AtomId atom) const {
  const auto& hidden = triangulation_.hidden;
  if (hidden.empty()) return atom.value;
  return atom.value -
         static_cast<std::uint32_t>(std::ranges::lower_bound(hidden, atom) - hidden.begin());
}

// Which cells are kept ----------------------------------------------------------------------------

/// The places of the facets of the simplex at a place, entry k opposite corner k.
template <std::size_t N>
std::array<std::uint32_t, N> MixedComplex::facets(std::size_t place) const {
  if constexpr (N == 2) {
    const auto& [a, b] = triangulation_.edges[place];
    return {vertex_of(b), vertex_of(a)};
  } else {
    if constexpr (N == 4) {
      if (!are_facets_forgotten_) return triangulation_.tetrahedron_triangles[place];
    } else {
      if (!are_facets_forgotten_) return triangulation_.triangle_edges[place];
    }
    std::array<std::uint32_t, N> result;
    const auto& list = simplices<N - 1>();
    for (std::size_t k = 0; k < N; ++k) {
      std::array<AtomId, N - 1> facet;
      const auto& simplex = simplices<N>()[place];
      const auto rest = std::copy_n(simplex.begin(), k, facet.begin());
      std::copy(simplex.begin() + static_cast<std::ptrdiff_t>(k) + 1, simplex.end(), rest);
      result[k] = static_cast<std::uint32_t>(std::ranges::lower_bound(list, facet) - list.begin());
    }
    return result;
  }
}

/// For each facet of simplices with known largest powers the largest of theirs, which is its own.
/// A facet with fewer than two tetrahedra, or in no simplex at all, has an unbounded dual.
template <std::size_t N>
std::vector<double> MixedComplex::largest_powers_of_facets(
    const std::vector<double>& powers) const {
  const std::size_t count = simplices<N - 1>().size();
  std::vector<double> result(count, -infinity);
  std::vector<std::uint8_t> cofaces(count, 0);
  for (std::size_t s = 0; s < powers.size(); ++s) {
    for (const std::uint32_t f : facets<N>(s)) {
      result[f] = std::max(result[f], powers[s]);
      cofaces[f] = static_cast<std::uint8_t>(std::min(cofaces[f] + 1, 2));
    }
  }
  for (std::size_t f = 0; f < count; ++f) {
    if (cofaces[f] < (N == 4 ? 2 : 1)) result[f] = infinity;
  }
  return result;
}

/// Marks the simplices of one dimension to keep.
///
/// At x = (c + q) / 2 with c in the simplex and q in its dual, 4 G(x) is the power of the simplex's
/// atoms at q less the weight of the ball about c that is orthogonal to theirs. The power is at
/// least minus the orthocentre's weight w, the ball's weight at least w and at most the heaviest
/// atom's; so G has a zero only where these ranges overlap.
///
/// Deep in the body w need not be known: a simplex's dual is part of its facet's, so w is at least
/// that of any tetrahedron about it, and these are at least minus the largest power.
/// @param power   by place, the largest that the atoms have on the simplex's dual
/// @param weight  w of the simplex at a place
template <std::size_t N, class Weight>
void MixedComplex::mark_kept(const std::vector<double>& power, Weight weight) {
  const auto& list = simplices<N>();
  std::uint32_t n = first_number_[N - 1];
  for (std::size_t s = 0; s < list.size(); ++s, ++n) {
    double heaviest = -infinity;
    for (const AtomId a : list[s]) heaviest = std::max(heaviest, points_[a.index()].weight);
    const double slack = 4 * nearness * std::abs(heaviest);
    if (2 * power[s] + slack < 0) continue;  // inside
    const double w = weight(s);
    const bool is_outside = -w > heaviest + slack;
    const bool is_inside = power[s] + slack < w;
    if (!is_outside && !is_inside) kept_bits_[n / 64] |= std::uint64_t{1} << n % 64;
  }
}

/// From the top down: at any time the powers of two dimensions are held.
void MixedComplex::mark_near_skin() {
  const auto weight_of = [&](const auto& list) {
    return [&](std::size_t s) {
      return static_cast<double>(orthocentre(corners(points_, list[s])).weight);
    };
  };
  // On the dual of a tetrahedron, a point, the power is minus the weight.
  std::vector<double> powers(triangulation_.tetrahedra.size());
  for (std::size_t s = 0; s < powers.size(); ++s) {
    powers[s] = -rough_weight(corners(points_, triangulation_.tetrahedra[s]));
  }
  mark_kept<4>(powers, [&](std::size_t s) { return -powers[s]; });
  powers = largest_powers_of_facets<4>(powers);
  mark_kept<3>(powers, weight_of(simplices<3>()));
  powers = largest_powers_of_facets<3>(powers);
  mark_kept<2>(powers, weight_of(simplices<2>()));
  powers = largest_powers_of_facets<2>(powers);
  const VertexList vertices = simplices<1>();
  mark_kept<1>(powers, weight_of(vertices));
}

void MixedComplex::forget_facets() {
  std::vector<std::array<std::uint32_t, 4>>().swap(triangulation_.tetrahedron_triangles);
  std::vector<std::array<std::uint32_t, 3>>().swap(triangulation_.triangle_edges);
  are_facets_forgotten_ = true;
}

void MixedComplex::choose_kept(Keep keep) {
  kept_bits_.assign(size() / 64 + 1, 0);
  if (keep == Keep::NearSkin) mark_near_skin();
  if (keep == Keep::All) {
    for (std::size_t n = 0; n < size(); ++n) kept_bits_[n / 64] |= std::uint64_t{1} << n % 64;
  }
  kept_before_.reserve(kept_bits_.size());
  for (const std::uint64_t bits : kept_bits_) {
    kept_before_.push_back(kept_size_);
    kept_size_ += static_cast<std::uint32_t>(std::popcount(bits));
  }
  number_of_.reserve(kept_size_);
  for (std::size_t word = 0; word < kept_bits_.size(); ++word) {
    for (std::uint64_t bits = kept_bits_[word]; bits != 0; bits &= bits - 1) {
      number_of_.push_back(static_cast<std::uint32_t>(64 * word) +
                           static_cast<std::uint32_t>(std::countr_zero(bits)));
    }
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

/// The orthocentre of the simplex at a place, as its patch has it.
template <std::size_t N>
Point MixedComplex::centre(std::size_t place) const {
  const std::uint32_t n = first_number_[N - 1] + static_cast<std::uint32_t>(place);
  return is_kept_number(n) ? patches_[numbered(n).index()].centre
                           : make_patch(simplices<N>()[place]).centre;
}

/// The wall of a simplex's k-th facet to the simplex.
///
/// @param facet_centre, centre  their orthocentres
template <std::size_t N>
Wall MixedComplex::make_wall(const std::array<AtomId, N>& simplex, std::size_t k,
                             const Point& facet_centre, const Point& centre, CellId cell) const {
  const Vector normal = direction_off_facet(points_, simplex, k);
  const Point middle = (facet_centre + centre) / 2;
  return {normal, normal.dot(middle), cell};
}

template <std::size_t N>
void MixedComplex::add_walls_to_facets(std::size_t place, std::vector<Wall>& walls) const {
  const Point own = centre<N>(place);
  const auto facet = facets<N>(place);
  for (std::size_t k = 0; k < N; ++k) {
    const Wall wall = make_wall(simplices<N>()[place], k, centre<N - 1>(facet[k]), own, CellId());
    walls.push_back({-wall.normal, -wall.offset, cell(N - 2, facet[k])});
  }
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
void MixedComplex::add_walls_to_cofaces(std::size_t place, std::vector<Wall>& walls) const {
  const Point own = centre<N>(place);
  for (const std::uint32_t above : cofaces(simplices<N>()[place])) {
    const auto facet = facets<N + 1>(above);
    const auto k = static_cast<std::size_t>(std::ranges::find(facet, place) - facet.begin());
    walls.push_back(
        make_wall(simplices<N + 1>()[above], k, own, centre<N + 1>(above), cell(N, above)));
  }
}

/// The walls of any cell, in the order in which build_walls() keeps them.
std::vector<Wall> MixedComplex::make_walls(CellId cell) const {
  std::vector<Wall> walls;
  const std::size_t at = place(cell);
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

/// Visits each pair of a simplex and a facet of which one is kept: visit(N, place, k, facet's
/// place), N an integral constant.
template <class Visit>
void MixedComplex::for_each_kept_incidence(Visit visit) const {
  const auto visit_all = [&]<std::size_t N>(std::integral_constant<std::size_t, N> corners) {
    const std::size_t count = simplices<N>().size();
    for (std::size_t s = 0; s < count; ++s) {
      const bool is_kept = is_kept_number(first_number_[N - 1] + static_cast<std::uint32_t>(s));
      const auto facet = facets<N>(s);
      for (std::size_t k = 0; k < N; ++k) {
        if (is_kept || is_kept_number(first_number_[N - 2] + facet[k])) {
          visit(corners, s, k, facet[k]);
        }
      }
    }
  };
  visit_all(std::integral_constant<std::size_t, 2>());
  visit_all(std::integral_constant<std::size_t, 3>());
  visit_all(std::integral_constant<std::size_t, 4>());
}

void MixedComplex::build_walls() {
  first_wall_.assign(kept_size() + 1, 0);
  for_each_kept_incidence([&](auto corners, std::size_t s, std::size_t, std::uint32_t f) {
    const CellId facet = cell(corners - 2, f), simplex = cell(corners - 1, s);
    if (is_kept(facet)) ++first_wall_[facet.index() + 1];
    if (is_kept(simplex)) ++first_wall_[simplex.index() + 1];
  });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  std::vector<std::uint32_t> filled(first_wall_.begin(), first_wall_.end() - 1);
  // A simplex's facets come one after the other, and a cell that is not kept has no centre yet.
  CellId last(size());
  Point centre;
  for_each_kept_incidence([&](auto corners, std::size_t s, std::size_t k, std::uint32_t f) {
    constexpr std::size_t N = decltype(corners)::value;
    const CellId facet = cell(N - 2, f), simplex = cell(N - 1, s);
    if (simplex != last) centre = this->centre<N>(s);
    last = simplex;
    const Wall wall = make_wall(simplices<N>()[s], k, this->centre<N - 1>(f), centre, simplex);
    if (is_kept(facet)) walls_[filled[facet.index()]++] = wall;
    if (is_kept(simplex)) {
      walls_[filled[simplex.index()]++] = {-wall.normal, -wall.offset, facet};
    }
  });
}

}  // namespace morskin::skin
