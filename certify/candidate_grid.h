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

using geometry::VertexId;

/// A vertex that is to be found.
struct Candidate {
  VertexId vertex;
  const geometry::Point& position;
  double length_scale;
};

/// A few vertices by place, for triangles that ask which may lie near: filed in their own cell and
/// all around it, so that a question looks into one cell only. Cells follow the length scale in
/// octaves; rho being 1-Lipschitz, a place within `reach` of a vertex has its own length scale
/// within a known factor, and the vertex is filed in every octave from which it can be asked for.
class CandidateGrid {
 public:
  /// @param reach  how far from a place, in units of the length scale there, a vertex is to be
  ///               found; below 1
  CandidateGrid(double reach, std::span<const Candidate> candidates)
      : reach_(reach),
        bucket_count_(
            std::bit_ceil(std::clamp<std::size_t>(256 * candidates.size(), 1U << 10, 1U << 22))),
        is_filled_(bucket_count_ / 64, 0),
        first_(bucket_count_ + 1, 0) {
    // In first_ how many each bucket holds, then where it ends; filled backwards, where it begins.
    for (const Candidate& candidate : candidates) {
      for_each_place(candidate, [&](std::size_t at) {
        is_filled_[at / 64] |= std::uint64_t{1} << at % 64;
        ++first_[at];
      });
    }
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    filed_.resize(first_.back());
    for (const Candidate& candidate : candidates) {
      for_each_place(candidate, [&](std::size_t at) { filed_[--first_[at]] = candidate.vertex; });
    }
  }

  /// Visits every candidate within reach of p, and others.
  template <class Visit>
  void for_each_near(const geometry::Point& p, double length_scale, Visit visit) const {
    const int octave = octave_of(length_scale);
    const std::size_t at = place_of(cell(p, octave), octave);
    if ((is_filled_[at / 64] >> at % 64 & 1) == 0) return;
    for (std::uint32_t i = first_[at]; i < first_[at + 1]; ++i) visit(filed_[i]);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
  /// Of a length scale; below a millionth of an Angstrom all are one, lest cells be countless.
  static int octave_of(double length_scale) { return std::ilogb(std::max(length_scale, 1e-6)); }
  Cell cell(const geometry::Point& p, int octave) const {
    const double scale = std::ldexp(1 / reach_, -(octave + 1));
    const auto whole = [&](double x) { return static_cast<std::int64_t>(std::floor(x * scale)); };
    return {whole(p.x()), whole(p.y()), whole(p.z())};
  }
  std::size_t place_of(const Cell& c, int octave) const {
    const std::uint64_t h = static_cast<std::uint64_t>(c[0]) * 0x9E3779B97F4A7C15ULL +
                            static_cast<std::uint64_t>(c[1]) * 0xC2B2AE3D27D4EB4FULL +
                            static_cast<std::uint64_t>(c[2]) * 0x165667B19E3779F9ULL +
                            static_cast<std::uint64_t>(octave) * 0xD6E8FEB86659FD93ULL;
    return ((h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ULL >> 40) & (bucket_count_ - 1);
  }
  /// The buckets that a candidate is filed in, some fifty; one may come twice.
  template <class Visit>
  void for_each_place(const Candidate& candidate, Visit visit) const {
    const int lowest = octave_of(candidate.length_scale / (1 + reach_));
    const int highest = octave_of(candidate.length_scale / (1 - reach_));
    for (int octave = lowest; octave <= highest; ++octave) {
      const auto home = cell(candidate.position, octave);
      for (std::int64_t i = -1; i <= 1; ++i) {
        for (std::int64_t j = -1; j <= 1; ++j) {
          for (std::int64_t k = -1; k <= 1; ++k) {
            visit(place_of({home[0] + i, home[1] + j, home[2] + k}, octave));
          }
        }
      }
    }
  }

  double reach_;
  std::size_t bucket_count_;              ///< a power of two
  std::vector<std::uint64_t> is_filled_;  ///< a bit for each bucket: most are empty, all are asked
  std::vector<std::uint32_t> first_;      ///< of each bucket in filed_, and the end of the last
  std::vector<VertexId> filed_;
};

}  // namespace morskin::certify
