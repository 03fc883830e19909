// The choice of kept cells, with their patches and walls.

#include <algorithm>
#include <atomic>
#include <bit>
#include <limits>
#include <memory>
#include <numeric>
#include <utility>

#include "geometry/parallel.h"
#include "skin/mixed_complex_internal.h"

namespace morskin::skin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

/// The largest power on each facet's dual: the largest of the simplices it bounds, or infinity for
/// a facet with fewer than two tetrahedra or none, whose dual is unbounded.
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

/// Marks the simplices to keep among those with indices in [begin, end).
///
/// At x = (c + q) / 2 with c in the simplex and q in its dual, 4 G(x) is the power of the simplex's
/// atoms at q less the weight of the ball about c that is orthogonal to theirs. The power is at
/// least minus the orthocentre's weight w, the ball's weight at least w and at most the heaviest
/// atom's; so G has a zero only if these ranges overlap.
///
/// Deep in the body w is not needed: a simplex's dual is part of its facet's, so w is at least that
/// of any tetrahedron about it, and these are at least minus the largest power.
/// @param powers  by simplex, the largest power of its atoms on its dual, Angstrom^2
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
    // Another thread may set other bits of the word.
    std::atomic_ref(kept_bits_[n / 64]).fetch_or(std::uint64_t{1} << n % 64);
  }
}

/// @return the largest powers of the facets
template <std::size_t N>
std::vector<double> MixedComplex::mark_kept_and_pass_down(std::vector<double> powers,
                                                          const geometry::Run& run) {
  std::vector<double> below;
  geometry::for_each_block_beside(
      run.threads(), [&] { below = largest_powers_of_facets<N>(powers); }, powers.size(),
      [&](std::size_t begin, std::size_t end, std::size_t) { mark_kept<N>(powers, begin, end); });
  return below;
}

/// From the highest dimension down, with the powers of two dimensions in memory at a time.
void MixedComplex::mark_near_skin(const geometry::Run& run) {
  std::vector<double> powers(triangulation_.tetrahedra.size());
  geometry::for_each_block(
      run.threads(), powers.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t s = begin; s < end; ++s) {
          powers[s] = -rough_weight(corners(points_, triangulation_.tetrahedra[s]));
        }
      });
  powers = mark_kept_and_pass_down<4>(std::move(powers), run);
  powers = mark_kept_and_pass_down<3>(std::move(powers), run);
  powers = mark_kept_and_pass_down<2>(std::move(powers), run);
  mark_kept<1>(powers, 0, powers.size());
}

void MixedComplex::choose_kept(Keep keep, const geometry::Run& run) {
  kept_bits_.assign(size() / 64 + 1, 0);
  if (keep == Keep::NearSkin) mark_near_skin(run);
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

/// Lists the edges at each vertex beside, which is one task.
void MixedComplex::build_patches(const geometry::Run& run) {
  patches_.resize(number_of_.size());
  geometry::for_each_block_beside(
      run.threads(), [&] { list_edges(); }, patches_.size(),
      [&](std::size_t begin, std::size_t end, std::size_t) {
        for (std::size_t i = begin; i < end; ++i) patches_[i] = make_patch_numbered(number_of_[i]);
      });
}

/// Visits each pair of a simplex with N corners, of the indices from begin to end, and a facet of
/// which one is kept: visit(simplex, k, facet), by index.
template <std::size_t N, class Visit>
void MixedComplex::for_each_kept_incidence(std::size_t begin, std::size_t end, Visit visit) const {
  for (std::size_t s = begin; s < end; ++s) {
    const bool is_kept = is_kept_number(first_number_[N - 1] + static_cast<std::uint32_t>(s));
    const auto facet = facets<N>(s);
    for (std::size_t k = 0; k < N; ++k) {
      if (is_kept || is_kept_number(first_number_[N - 2] + facet[k])) visit(s, k, facet[k]);
    }
  }
}

/// Numbers each facet's walls to simplices with N corners, behind those to its own facets, which
/// first_wall_ counts already, by cell and shifted by one. There they are counted too.
template <std::size_t N>
MixedComplex::WallNumbers<N> MixedComplex::number_walls() {
  WallNumbers<N> numbers(simplices<N>().size());
  for_each_kept_incidence<N>(0, numbers.size(), [&](std::size_t s, std::size_t k, std::uint32_t f) {
    const CellId facet = cell(N - 2, f);
    if (is_kept(facet)) numbers[s][k] = first_wall_[facet.index() + 1]++;
  });
  return numbers;
}

/// A cell's walls to facets come first, in their order, then those to cofaces, in theirs.
template <std::size_t N>
void MixedComplex::fill_walls(const WallNumbers<N>& numbers, const geometry::Run& run) {
  geometry::for_each_block(
      run.threads(), numbers.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
        // A simplex's facets are visited in a row; only kept cells have stored centres.
        std::size_t last = end;
        Point centre = Point::Zero();
        for_each_kept_incidence<N>(begin, end, [&](std::size_t s, std::size_t k, std::uint32_t f) {
          const CellId facet = cell(N - 2, f), simplex = cell(N - 1, s);
          if (s != last) centre = this->centre<N>(s);
          last = s;
          const Wall wall =
              make_wall(simplices<N>()[s], k, this->centre<N - 1>(f), centre, simplex);
          if (is_kept(facet)) {
            std::construct_at(&walls_[first_wall_[facet.index()] + numbers[s][k]], wall);
          }
          if (is_kept(simplex)) {
            std::construct_at(&walls_[first_wall_[simplex.index()] + k],
                              Wall{-wall.normal, -wall.offset, facet});
          }
        });
      });
}

void MixedComplex::build_walls(const geometry::Run& run) {
  first_wall_.assign(kept_size() + 1, 0);
  for (std::uint32_t i = 0; i < kept_size(); ++i) {
    const int d = dimension_of(number_of_[i]);
    first_wall_[i + 1] = d == 0 ? 0 : static_cast<std::uint32_t>(d) + 1;
  }
  // By dimension, so that no two count the walls of one cell.
  WallNumbers<2> of_edges;
  WallNumbers<3> of_triangles;
  WallNumbers<4> of_tetrahedra;
  geometry::for_each_task(run.threads(), 3, [&](std::size_t task) {
    if (task == 0) of_triangles = number_walls<3>();  // the most
    if (task == 1) of_tetrahedra = number_walls<4>();
    if (task == 2) of_edges = number_walls<2>();
  });
  std::partial_sum(first_wall_.begin(), first_wall_.end(), first_wall_.begin());
  walls_.resize(first_wall_.back());
  fill_walls<2>(of_edges, run);
  fill_walls<3>(of_triangles, run);
  fill_walls<4>(of_tetrahedra, run);
}

}  // namespace morskin::skin
