// Which cells are kept, and the patches and walls of these.

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <numeric>
#include <type_traits>
#include <utility>

#include "geometry/parallel.h"
#include "skin/mixed_complex_internal.h"

namespace morskin::skin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

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

/// Marks those simplices of one dimension to keep that have a place in [begin, end).
///
/// At x = (c + q) / 2 with c in the simplex and q in its dual, 4 G(x) is the power of the simplex's
/// atoms at q less the weight of the ball about c that is orthogonal to theirs. The power is at
/// least minus the orthocentre's weight w, the ball's weight at least w and at most the heaviest
/// atom's; so G has a zero only where these ranges overlap.
///
/// Deep in the body w need not be known: a simplex's dual is part of its facet's, so w is at least
/// that of any tetrahedron about it, and these are at least minus the largest power.
/// @param powers  by place, the largest that the atoms have on the simplex's dual
template <std::size_t N>
void MixedComplex::mark_kept(const std::vector<double>& powers, std::size_t begin,
                             std::size_t end) {
  const auto& list = simplices<N>();
  for (std::size_t s = begin; s < end; ++s) {
    double heaviest = -infinity;
    for (const AtomId a : list[s]) heaviest = std::max(heaviest, points_[a.index()].weight);
    const double slack = 4 * nearness * std::abs(heaviest);
    if (2 * powers[s] + slack < 0) continue;  // inside
    // On the dual of a tetrahedron, a point, the power is minus the weight.
    const double w =
        N == 4 ? -powers[s] : static_cast<double>(orthocentre(corners(points_, list[s])).weight);
    const bool is_outside = -w > heaviest + slack;
    const bool is_inside = powers[s] + slack < w;
    if (is_outside || is_inside) continue;
    const std::size_t n = first_number_[N - 1] + s;
    // Another thread may be at other bits of the word.
    std::atomic_ref(kept_bits_[n / 64]).fetch_or(std::uint64_t{1} << n % 64);
  }
}

/// @return the powers of their facets
template <std::size_t N>
std::vector<double> MixedComplex::mark_kept_and_pass_down(std::vector<double> powers,
                                                          unsigned threads) {
  std::vector<double> below;
  geometry::for_each_block_beside(
      threads, [&] { below = largest_powers_of_facets<N>(powers); }, powers.size(),
      [&](std::size_t begin, std::size_t end, std::size_t) { mark_kept<N>(powers, begin, end); });
  return below;
}

/// From the top down: at any time the powers of two dimensions are held.
void MixedComplex::mark_near_skin(unsigned threads) {
  std::vector<double> powers(triangulation_.tetrahedra.size());
  geometry::for_each_block(
      threads, powers.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t s = begin; s < end; ++s) {
          powers[s] = -rough_weight(corners(points_, triangulation_.tetrahedra[s]));
        }
      });
  powers = mark_kept_and_pass_down<4>(std::move(powers), threads);
  powers = mark_kept_and_pass_down<3>(std::move(powers), threads);
  powers = mark_kept_and_pass_down<2>(std::move(powers), threads);
  mark_kept<1>(powers, 0, powers.size());
}

void MixedComplex::choose_kept(Keep keep, unsigned threads) {
  kept_bits_.assign(size() / 64 + 1, 0);
  if (keep == Keep::NearSkin) mark_near_skin(threads);
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

void MixedComplex::build_patches(unsigned threads) {
  patches_.resize(number_of_.size());
  geometry::for_each_block(threads, patches_.size(),
                           [&](std::size_t begin, std::size_t end, std::size_t) {
                             for (std::size_t i = begin; i < end; ++i) {
                               patches_[i] = make_patch_numbered(number_of_[i]);
                             }
                           });
}

/// Visits each pair of a simplex with N corners and a facet of which one is kept: visit(place, k,
/// facet's place).
template <std::size_t N, class Visit>
void MixedComplex::for_each_kept_incidence(Visit visit) const {
  const std::size_t count = simplices<N>().size();
  for (std::size_t s = 0; s < count; ++s) {
    const bool is_kept = is_kept_number(first_number_[N - 1] + static_cast<std::uint32_t>(s));
    const auto facet = facets<N>(s);
    for (std::size_t k = 0; k < N; ++k) {
      if (is_kept || is_kept_number(first_number_[N - 2] + facet[k])) visit(s, k, facet[k]);
    }
  }
}

/// Counts the walls between simplices with N corners and their facets, by facet: first_wall_, one
/// place on.
template <std::size_t N>
void MixedComplex::count_walls() {
  for_each_kept_incidence<N>([&](std::size_t, std::size_t, std::uint32_t f) {
    const CellId facet = cell(N - 2, f);
    if (is_kept(facet)) ++first_wall_[facet.index() + 1];
  });
}

/// A cell's walls to facets come first, in their order, then those to cofaces, in theirs.
template <std::size_t N>
void MixedComplex::fill_walls() {
  // By facet: how many walls it has already. Those to its own facets have their places.
  std::vector<std::uint32_t> filled(simplices<N - 1>().size(), N == 2 ? 0 : N - 1);
  // A simplex's facets come one after the other, and a cell that is not kept has no centre yet.
  std::size_t last = simplices<N>().size();
  Point centre = Point::Zero();
  for_each_kept_incidence<N>([&](std::size_t s, std::size_t k, std::uint32_t f) {
    const CellId facet = cell(N - 2, f), simplex = cell(N - 1, s);
    if (s != last) centre = this->centre<N>(s);
    last = s;
    const Wall wall = make_wall(simplices<N>()[s], k, this->centre<N - 1>(f), centre, simplex);
    if (is_kept(facet)) walls_[first_wall_[facet.index()] + filled[f]++] = wall;
    if (is_kept(simplex)) {
      walls_[first_wall_[simplex.index()] + k] = {-wall.normal, -wall.offset, facet};
    }
  });
}

/// The three kinds of walls, by dimension, have places of their own.
void MixedComplex::build_walls(unsigned threads) {
  const auto for_each_kind = [&](auto work) {
    geometry::for_each_task(threads, 3, [&](std::size_t task) {
      if (task == 0) work(std::integral_constant<std::size_t, 3>());  // the most
      if (task == 1) work(std::integral_constant<std::size_t, 4>());
      if (task == 2) work(std::integral_constant<std::size_t, 2>());
    });
  };
  first_wall_.assign(kept_size() + 1, 0);
  for (std::uint32_t i = 0; i < kept_size(); ++i) {
    const int d = dimension_of(number_of_[i]);
    first_wall_[i + 1] = d == 0 ? 0 : static_cast<std::uint32_t>(d) + 1;
  }
  for_each_kind([&](auto corners) { count_walls<corners>(); });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  for_each_kind([&](auto corners) { fill_walls<corners>(); });
}

}  // namespace morskin::skin
