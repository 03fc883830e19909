#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::certify {

/// A vertex in the grid.
struct Candidate {
  geometry::VertexId vertex;
  const geometry::Point& position;
  double length_scale;
};

/// A hash grid of a few vertices, for queries by far more points. Each vertex is stored in its own
/// cell and the 26 around it, so that a query reads one cell. Cells follow the length scale in
/// octaves: rho being 1-Lipschitz, a query point within the radius of a vertex has a length scale
/// within a known factor of the vertex's, and the vertex is stored in each of these octaves.
class CandidateGrid {
 public:
  /// @param radius  of a query, over the length scale at the query point; below 1
  CandidateGrid(double radius, std::span<const Candidate> candidates)
      : radius_(radius),
        bucket_count_(
            std::bit_ceil(std::clamp<std::size_t>(256 * candidates.size(), 1U << 10, 1U << 22))),
        is_filled_(bucket_count_ / 64, 0),
        first_(bucket_count_ + 1, 0) {
    // Counting sort: first_ holds each bucket's size, then its end, then its beginning.
    for (const Candidate& candidate : candidates) {
      for_each_bucket(candidate, [&](std::size_t at) {
        is_filled_[at / 64] |= std::uint64_t{1} << at % 64;
        ++first_[at];
      });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    vertices_.resize(first_.back());
    for (const Candidate& candidate : candidates) {
      for_each_bucket(candidate,
                      [&](std::size_t at) { vertices_[--first_[at]] = candidate.vertex; });
    }
  }

  /// Visits every candidate within the query radius of p, and others.
  template <class Visit>
  void for_each_near(const geometry::Point& p, double length_scale, Visit visit) const {
    const int octave = octave_of(length_scale);
    const std::size_t at = bucket_of(cell(p, octave), octave);
    if ((is_filled_[at / 64] >> at % 64 & 1) == 0) return;
    for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i) visit(vertices_[i]);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  /// One octave for all below 1e-6 Angstrom, to bound the number of cells.
  static int octave_of(double length_scale) { return std::ilogb(std::max(length_scale, 1e-6)); }
  Cell cell(const geometry::Point& p, int octave) const {
    const double scale = std::ldexp(1 / radius_, -(octave + 1));
    const auto whole = [&](double x) { return static_cast<std::int64_t>(std::floor(x * scale)); };
    return {whole(p.x()), whole(p.y()), whole(p.z())};
  }
  std::size_t bucket_of(const Cell& c, int octave) const {
    const std::uint64_t h = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15ULL +
                            static_cast<std::uint64_t>(c[1]) * 0xC2B2AE3D27D4EB4FULL +
                            static_cast<std::uint64_t>(c[2]) * 0x165667B19E3779F9ULL +
                            static_cast<std::uint64_t>(octave) * 0xD6E8FEB86659FD93ULL;
    return ((h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ULL >> 40) & (bucket_count_ - 1);
  }
  /// The buckets of a candidate, some fifty; one may come twice.
  template <class Visit>
  void for_each_bucket(const Candidate& candidate, Visit visit) const {
    const int lowest = octave_of(candidate.length_scale / (1 + radius_));
    const int highest = octave_of(candidate.length_scale / (1 - radius_));
    for (int octave = lowest; octave <= highest; ++octave) {
      const auto home = cell(candidate.position, octave);
      for (std::int64_t i = -1; i <= 1; ++i) {
        for (std::int64_t j = -1; j <= 1; ++j) {
          for (std::int64_t k = -1; k <= 1; ++k) {
            visit(bucket_of({home[0] + i, home[1] + j, home[2] + k}, octave));
          }
        }
      }
    }
  }

  double radius_;
  std::size_t bucket_count_;              ///< a power of two
  std::vector<std::uint64_t> is_filled_;  ///< one bit by bucket; most are empty
  std::vector<std::uint32_t> first_;      ///< by bucket, its first in vertices_; then the end
  std::vector<geometry::VertexId> vertices_;
};

}  // namespace morskin::certify
