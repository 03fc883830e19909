#include "front/two_fronts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "front/sweep_progress.h"
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
                       const SweepOptions& options, const SweepExtras& extras,
                       const std::vector<SweepObserver*>& observers) {
  PassedAtoms passed(skin, guide.function, extras.progress);
  ProgressObserver progress([&](double value) { passed.passed_from_below(value); });
  std::vector<SweepObserver*> all{&progress};
  all.insert(all.end(), observers.begin(), observers.end());
  PartialSweep sweep(skin, guide, options, {}, extras.coarsening, all);
  if (extras.record_births) sweep.record_births();
  sweep.run();
  return sweep.take_result();
}

SweepResult sweep_from_both_ends(const surface::Surface& skin, const morse::Guide& guide,
                                 const SweepOptions& options, unsigned threads,
                                 const SweepExtras& extras) {
  const double middle = middle_level(skin, guide);
  const morse::Guide reversed = guide.reversed();
  PassedAtoms passed(skin, guide.function, extras.progress);
  ProgressObserver lower([&](double value) { passed.passed_from_below(value); });
  ProgressObserver upper([&](double value) { passed.passed_from_above(value); });
  PartialSweep below(skin, guide, options, {.high = middle}, extras.coarsening, {&lower});
  PartialSweep above(skin, reversed, options, {.high = -middle}, extras.coarsening, {&upper});
  if (extras.record_births) {
    below.record_births();
    above.record_births();
  }
  geometry::do_both(
      threads, [&] { below.run(); }, [&] { above.run(); });
  below.absorb(above, threads);
  below.finish();
  return below.take_result();
}

}  // namespace morskin::front
