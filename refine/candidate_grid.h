#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geometry/id.h"
#include "geometry/point.h"

namespace morskin::refine {

/// A few vertices by place, for triangles that ask which may lie near: filed in their own cell and
/// all around it, so that a question looks into one cell only. Cells follow the length scale in
/// octaves; rho being 1-Lipschitz, a place within `reach` of a vertex has its own length scale
/// within a known factor, and the vertex is filed in every octave from which it can be asked for.
class CandidateGrid {
 public:
  /// @param reach  how far from a place, in units of the length scale there, a vertex is to be
  ///               found; below 1
  /// @param count  how many vertices there will be; each is filed in some fifty cells
  CandidateGrid(double reach, std::size_t count)
      : reach_(reach),
        buckets_(std::bit_ceil(std::clamp<std::size_t>(256 * count, 1U << 10, 1U << 16))),
        is_filled_(buckets_.size() / 64, 0) {}

  void add(const geometry::Point& p, double length_scale, geometry::VertexId v) {
    const int lowest = std::ilogb(length_scale / (1 + reach_));
    const int highest = std::ilogb(length_scale / (1 - reach_));
    for (int octave = lowest; octave <= highest; ++octave) {
      const auto home = cell(p, octave);
      for (std::int64_t i = -1; i <= 1; ++i) {
        for (std::int64_t j = -1; j <= 1; ++j) {
          for (std::int64_t k = -1; k <= 1; ++k) {
            const std::size_t at = place_of({home[0] + i, home[1] + j, home[2] + k}, octave);
            auto& bucket = buckets_[at];
            is_filled_[at / 64] |= std::uint64_t{1} << at % 64;
            if (bucket.empty() || bucket.back() != v) bucket.push_back(v);
          }
        }
      }
    }
  }
  template <class Visit>
  void for_each_near(const geometry::Point& p, double length_scale, Visit visit) const {
    const int octave = std::ilogb(length_scale);
    const std::size_t at = place_of(cell(p, octave), octave);
    if ((is_filled_[at / 64] >> at % 64 & 1) == 0) return;
    for (const geometry::VertexId v : buckets_[at]) visit(v);
  }

 private:
  using Cell = std::array<std::int64_t, 3>;
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
    return ((h ^ (h >> 29)) * 0xBF58476D1CE4E5B9ULL >> 48) & (buckets_.size() - 1);
  }

  double reach_;
  std::vector<std::vector<geometry::VertexId>> buckets_;
  std::vector<std::uint64_t> is_filled_;  ///< a bit for each bucket: most are empty, all are asked
};

}  // namespace morskin::refine
