#include "morse/overlaps.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <set>

namespace morskin::morse {

namespace {

/// Spheres by octave of the radius and by place. An octave's cells are as wide as four radii of the
/// next larger octave, so that two spheres of it or of smaller ones that overlap have centres less
/// than half a cell apart: at most two cells on each axis. Cells share buckets by their hash; what
/// does not belong there is told by the test of distance.
class SphereGrid {
 public:
  struct Sphere {
    Point centre;
    double radius;
    CriticalId id;
  };

  SphereGrid(const std::vector<CriticalPoint>& points, const std::vector<double>& radii)
      : mask_(std::bit_ceil(2 * points.size() + 1) - 1), first_(mask_ + 2, 0) {
    std::vector<std::size_t> bucket(points.size());
    std::set<int> octaves;
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!(radii[i] > 0)) continue;
      const int octave = octave_of(radii[i]);
      octaves.insert(octave);
      const double width = cell_width(octave);
      const Point& p = points[i].point.position;
      bucket[i] = bucket_of(octave, cell(p.x(), width), cell(p.y(), width), cell(p.z(), width));
      ++first_[bucket[i] + 1];
    }
    octaves_.assign(octaves.begin(), octaves.end());
    std::partial_sum(first_.begin(), first_.end(), first_.begin());
    spheres_.resize(first_.back());
    std::vector<std::uint32_t> filled(first_.begin(), first_.end() - 1);
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (radii[i] > 0) {
        spheres_[filled[bucket[i]]++] = {points[i].point.position, radii[i], CriticalId{i}};
      }
    }
  }

  /// Calls with every sphere of the same octave or a larger one that may overlap one, sometimes
  /// twice.
  template <class Visit>
  void near(const Point& centre, double radius, Visit visit) const {
    const auto own = std::lower_bound(octaves_.begin(), octaves_.end(), octave_of(radius));
    for (auto octave = own; octave != octaves_.end(); ++octave) {
      const double width = cell_width(*octave), reach = radius + width / 4;
      const auto low = [&](int axis) { return cell(centre[axis] - reach, width); };
      const auto high = [&](int axis) { return cell(centre[axis] + reach, width); };
      for (std::int64_t x = low(0); x <= high(0); ++x) {
        for (std::int64_t y = low(1); y <= high(1); ++y) {
          for (std::int64_t z = low(2); z <= high(2); ++z) {
            const std::size_t bucket = bucket_of(*octave, x, y, z);
            for (std::uint32_t k = first_[bucket]; k < first_[bucket + 1]; ++k) visit(spheres_[k]);
          }
        }
      }
    }
  }

 private:
  /// Coordinates are at most 2^30; cells finer than this one's would not fit a 64-bit integer.
  static constexpr int finest_octave = -24;

  static int octave_of(double radius) { return std::max(std::ilogb(radius), finest_octave); }
  static double cell_width(int octave) { return std::ldexp(8.0, octave); }
  static std::int64_t cell(double x, double width) {
    return static_cast<std::int64_t>(std::floor(x / width));
  }
  std::size_t bucket_of(int octave, std::int64_t x, std::int64_t y, std::int64_t z) const {
    std::uint64_t hash = static_cast<std::uint64_t>(octave);
    for (const std::int64_t i : {x, y, z}) {
      hash = (hash ^ static_cast<std::uint64_t>(i)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32;
    }
    return hash & mask_;
  }

  std::size_t mask_;
  std::vector<std::uint32_t> first_;  ///< by bucket, into spheres_
  std::vector<Sphere> spheres_;
  std::vector<int> octaves_;  ///< that any sphere is in, upwards
};

}  // namespace

std::vector<std::pair<CriticalId, CriticalId>> overlapping_spheres(
    const std::vector<CriticalPoint>& points, const std::vector<double>& radii) {
  const SphereGrid grid(points, radii);
  std::vector<std::pair<CriticalId, CriticalId>> pairs;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!(radii[i] > 0)) continue;
    const Point& centre = points[i].point.position;
    grid.near(centre, radii[i], [&](const SphereGrid::Sphere& other) {
      const double reach = radii[i] + other.radius;
      if ((other.centre - centre).squaredNorm() < reach * reach && other.id != CriticalId{i}) {
        pairs.emplace_back(std::minmax(CriticalId{i}, other.id));
      }
    });
  }
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

std::vector<double> shrunk_apart(
    const std::vector<CriticalPoint>& points, const std::vector<double>& radii,
    const std::vector<std::pair<CriticalId, CriticalId>>& overlapping) {
  std::vector<double> result = radii;
  for (const auto& [a, b] : overlapping) {
    const double apart =
        (points[a.index()].point.position - points[b.index()].point.position).norm();
    const double share = apart / (radii[a.index()] + radii[b.index()]);
    for (const CriticalId id : {a, b}) {
      result[id.index()] = std::min(result[id.index()], share * radii[id.index()]);
    }
  }
  return result;
}

}  // namespace morskin::morse
