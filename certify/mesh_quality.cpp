#include "certify/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "geometry/mesh_shape.h"
#include "geometry/parallel.h"

namespace morskin::certify {

namespace {

using geometry::IndexedMesh;
using geometry::Point;

constexpr int bin_deg = MeshQuality::bin_deg;
constexpr std::size_t bin_count = 180 / bin_deg;
/// No smallest angle is in a later bin, no largest one in an earlier; they meet at 60 degrees.
constexpr std::size_t last_of_smallest = 60 / bin_deg - 1, first_of_largest = 60 / bin_deg;

/// Bins of angles, found from cosines from -1 to 1, but for rounding: of 257 cells none has more
/// than one of the bounds between bins.
class Bins {
 public:
  Bins() {
    for (std::size_t k = 1; k < bin_count; ++k) {
      const double off_right_angle = 90 - static_cast<double>(k * bin_deg);
      const double bound = std::sin(off_right_angle * std::numbers::pi / 180);  // 0 at 90 degrees
      cells_[cell(bound)].bound = bound;
    }
    for (std::size_t i = cells_.size() - 1; i-- > 0;) {
      cells_[i].bin = cells_[i + 1].bin + (cells_[i + 1].bound == none ? 0 : 1);
    }
  }

  /// The bin of an angle; if it is a bound, the bin above, or that below.
  std::size_t upper(double cosine) const {
    const Cell& at = cells_[cell(cosine)];
    return at.bin + (cosine <= at.bound ? 1 : 0);
  }
  std::size_t lower(double cosine) const {
    const Cell& at = cells_[cell(cosine)];
    return at.bin + (cosine < at.bound ? 1 : 0);
  }

 private:
  static constexpr double none = -2;
  struct Cell {
    double bound = none;
    std::size_t bin = 0;  ///< of the angles below the bound
  };

  static std::size_t cell(double cosine) { return static_cast<std::uint32_t>(128 * (1 + cosine)); }

  std::array<Cell, 257> cells_;
};

/// What is counted of some triangles.
struct Counts {
  std::array<std::size_t, bin_count> smallest_angles{}, largest_angles{};
  double min_ratio = 1, ratio_sum = 0;

  void add(const Point& p, const Point& q, const Point& r, const Bins& bins) {
    const auto [at_p, at_q, at_r] = geometry::cosines(q - p, r - q, p - r);
    const double largest = std::max({at_p, at_q, at_r}), smallest = std::min({at_p, at_q, at_r});
    const double ratio = 2 * (at_p + at_q + at_r - 1);  // that of the radii, in any triangle
    // Where squares underflow, cosines may be anything.
    constexpr double rounded_one = 1 + 1e-9;
    if (!(largest <= rounded_one && -smallest <= rounded_one) || std::isnan(ratio)) {
      return add_degenerate();
    }
    ++smallest_angles[bins.upper(largest)];
    ++largest_angles[bins.lower(smallest)];
    min_ratio = std::min(min_ratio, ratio);
    ratio_sum += ratio;
  }
  void add_degenerate() {
    ++smallest_angles.front();
    ++largest_angles.back();
    min_ratio = 0;
  }
};

/// By vertex, how many corners of triangles it is.
std::vector<std::uint32_t> valences(const IndexedMesh& mesh) {
  std::vector<std::uint32_t> corners(mesh.positions.size());
  for (const geometry::TriangleCorners& t : mesh.triangles) {
    for (const std::uint32_t v : t) ++corners[v];
  }
  return corners;
}

void add_valences(MeshQuality& quality, const std::vector<std::uint32_t>& valences) {
  if (valences.empty()) return;
  quality.min_valence = valences[0];
  for (const std::uint32_t k : valences) {
    quality.min_valence = std::min(quality.min_valence, k);
    quality.max_valence = std::max(quality.max_valence, k);
    ++quality.valences[std::min<std::size_t>(k, quality.valences.size() - 1)];
  }
}

/// @pre there are triangles
void add_counts(MeshQuality& quality, const std::vector<Counts>& found) {
  double min_ratio = 1, ratio_sum = 0;
  for (const Counts& part : found) {
    for (std::size_t k = 0; k < bin_count; ++k) {
      quality.smallest_angles[std::min(k, last_of_smallest)] += part.smallest_angles[k];
      quality.largest_angles[std::max(k, first_of_largest) - first_of_largest] +=
          part.largest_angles[k];
    }
    min_ratio = std::min(min_ratio, part.min_ratio);
    ratio_sum += part.ratio_sum;
  }
  quality.min_radius_ratio = std::max(min_ratio, 0.0);
  quality.mean_radius_ratio = ratio_sum / static_cast<double>(quality.triangles);
}

/// @pre there are triangles
MeshQuality::EdgeLengths edge_lengths(const IndexedMesh& mesh) {
  constexpr std::size_t max_triangles = 1 << 16;
  const std::size_t step = (mesh.triangles.size() - 1) / max_triangles + 1;
  std::vector<double> lengths;
  for (std::size_t t = 0; t < mesh.triangles.size(); t += step) {
    const auto& [a, b, c] = mesh.triangles[t];
    const Point &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    for (const double length : {(q - p).norm(), (r - q).norm(), (p - r).norm()}) {
      if (!std::isnan(length)) lengths.push_back(length);
    }
  }
  if (lengths.empty()) return {};
  const auto rank = [&](double share) {
    return lengths.begin() +
           static_cast<std::ptrdiff_t>(share * static_cast<double>(lengths.size() - 1));
  };
  const auto low = rank(0.05), median = rank(0.5), high = rank(0.95);
  MeshQuality::EdgeLengths found{};
  std::nth_element(lengths.begin(), median, lengths.end());
  found.median = *median;
  std::nth_element(lengths.begin(), low, median);
  found.short_end = *low;
  std::nth_element(median, high, lengths.end());
  found.long_end = *high;
  return found;
}

}  // namespace

MeshQuality measure_quality(const IndexedMesh& mesh, const geometry::Run& run) {
  const std::size_t count = mesh.triangles.size();
  MeshQuality quality;
  quality.vertices = mesh.positions.size();
  quality.triangles = count;
  const Bins bins;
  std::vector<Counts> found(geometry::block_count(count));
  geometry::for_each_block_beside(
      run.threads(),
      [&] {
        add_valences(quality, valences(mesh));
        if (count > 0) quality.edges = edge_lengths(mesh);
      },
      count,
      [&](std::size_t begin, std::size_t end, std::size_t block) {
        Counts counts;
        for (std::size_t i = begin; i < end; ++i) {
          const auto& [a, b, c] = mesh.triangles[i];
          counts.add(mesh.positions[a], mesh.positions[b], mesh.positions[c], bins);
        }
        found[block] = counts;
      });
  if (count > 0) add_counts(quality, found);
  return quality;
}

std::size_t MeshQuality::triangles_below(int angle_deg) const {
  const auto begin = smallest_angles.begin();
  return std::accumulate(begin, begin + angle_deg / bin_deg, std::size_t{0});
}

std::size_t MeshQuality::triangles_above(int angle_deg) const {
  const auto begin = largest_angles.begin();
  return std::accumulate(begin + (angle_deg - 60) / bin_deg, largest_angles.end(), std::size_t{0});
}

}  // namespace morskin::certify
