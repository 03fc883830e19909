#include "front/two_fronts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <mutex>
#include <vector>

#include "geometry/parallel.h"

namespace morskin::front {

namespace {

/// An open interval of values.
struct Interval {
  double low, high;
};

/// The values between a minimum and a higher maximum that lie within a length scale of each other.
std::vector<Interval> close_pairs(const std::vector<morse::CriticalPoint>& points) {
  std::vector<const morse::CriticalPoint*> extrema;
  double largest = 0;
  for (const morse::CriticalPoint& p : points) {
    if (p.index == 1) continue;
    extrema.push_back(&p);
    largest = std::max(largest, p.point.length_scale);
  }
  // Along an axis: points that are close in space are close there.
  std::sort(extrema.begin(), extrema.end(), [](const auto* p, const auto* q) {
    return p->point.position.x() < q->point.position.x();
  });
  std::vector<Interval> pairs;
  for (std::size_t i = 0; i < extrema.size(); ++i) {
    const surface::SurfacePoint& p = extrema[i]->point;
    for (std::size_t j = i + 1; j < extrema.size(); ++j) {
      const surface::SurfacePoint& q = extrema[j]->point;
      if (q.position.x() - p.position.x() > largest) break;
      const bool is_close =
          (p.position - q.position).norm() <= std::min(p.length_scale, q.length_scale);
      const auto [low, high] = std::minmax(extrema[i]->value, extrema[j]->value);
      if (is_close && extrema[i]->index != extrema[j]->index) pairs.push_back({low, high});
    }
  }
  std::sort(pairs.begin(), pairs.end(), [](const Interval& a, const Interval& b) {
    return std::pair(a.low, a.high) < std::pair(b.low, b.high);
  });
  return pairs;
}

/// Turns the values that the fronts have come to into the share of atoms that they have passed.
class PassedAtoms {
 public:
  PassedAtoms(const surface::Surface& skin, const morse::Guide& guide,
              const std::function<void(double)>& told)
      : told_(told) {
    if (!told_) return;
    const std::vector<Point> samples = skin.samples();
    constexpr std::size_t most = 1 << 14;  // enough
    for (std::size_t i = 0; i < samples.size(); i += 1 + samples.size() / most) {
      values_.push_back(guide.function(samples[i]));
    }
    std::sort(values_.begin(), values_.end());
  }

  /// What the sweep from below, or the one from above, is to call; either from its own thread.
  std::function<void(double)> from_below() {
    return [this](double value) { tell(from_below_, value, false); };
  }
  std::function<void(double)> from_above() {
    return [this](double value) { tell(from_above_, -value, true); };
  }

 private:
  void tell(double& reached, double value, bool is_above) {
    if (!told_) return;
    const std::lock_guard lock(mutex_);
    const auto place = std::upper_bound(values_.begin(), values_.end(), value) - values_.begin();
    const double below = static_cast<double>(place) / static_cast<double>(values_.size());
    reached = std::max(reached, is_above ? 1 - below : below);
    told_(std::min(from_below_ + from_above_, 1.0));
  }

  const std::function<void(double)>& told_;
  std::vector<double> values_;
  std::mutex mutex_;
  double from_below_ = 0, from_above_ = 0;
};

}  // namespace

double middle_level(const surface::Surface& skin, const morse::Guide& guide) {
  std::vector<double> values;
  for (const Point& sample : skin.samples()) values.push_back(guide.function(sample));
  const auto median = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), median, values.end());
  double level = *median;
  for (const Interval& pair : close_pairs(guide.points)) {
    if (pair.low <= level && level <= pair.high) level = std::nextafter(pair.high, INFINITY);
  }
  return level;
}

SweepResult sweep_once(const surface::Surface& skin, const morse::Guide& guide,
                       const SweepOptions& options) {
  SweepResult result;
  PassedAtoms passed(skin, guide, options.progress);
  SweepOptions told = options;
  told.progress = passed.from_below();
  Sweep sweep(skin, guide, told, result.mesh);
  sweep.run();
  result.operations = sweep.operations();
  result.open_edges = sweep.open_edges();
  return result;
}

SweepResult sweep_from_both_ends(const surface::Surface& skin, const morse::Guide& guide,
                                 const SweepOptions& options, unsigned threads) {
  const double middle = middle_level(skin, guide);
  const morse::Guide reversed = guide.reversed();
  SweepResult result;
  surface::Mesh upper_mesh;
  PassedAtoms passed(skin, guide, options.progress);
  SweepOptions lower = options, upper = options;
  lower.progress = passed.from_below();
  upper.progress = passed.from_above();
  upper.operation = {};
  Sweep below(skin, guide, lower, result.mesh, middle);
  Sweep above(skin, reversed, upper, upper_mesh, -middle);
  geometry::do_both(
      threads, [&] { below.run(); }, [&] { above.run(); });
  below.join(above, threads);
  result.operations = below.operations();
  result.open_edges = below.open_edges();
  return result;
}

}  // namespace morskin::front
