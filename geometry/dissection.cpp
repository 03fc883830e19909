#include "geometry/dissection.h"

#include <algorithm>

namespace morskin::geometry {

namespace {

/// The axis along which points extend farthest.
int longest_axis(std::span<const Point> points) {
  Point low = points.front(), high = points.front();
  for (const Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  int axis = 0;
  (high - low).maxCoeff(&axis);
  return axis;
}

}  // namespace

Dissection::Dissection(std::vector<Point> samples, int depth)
    : boxes_((std::size_t{2} << depth) - 1) {
  halve(0, samples);
}

void Dissection::halve(std::size_t k, std::span<Point> samples) {
  if (is_leaf(k)) return;
  Box& below = boxes_[lower_half(k)] = boxes_[k];
  Box& above = boxes_[upper_half(k)] = boxes_[k];
  if (samples.empty()) {  // nothing to cut: all stays with one half
    above.low = above.high;
    halve(lower_half(k), samples);
    return halve(upper_half(k), samples);
  }
  const int axis = longest_axis(samples);
  const auto median = samples.begin() + static_cast<std::ptrdiff_t>(samples.size() / 2);
  std::nth_element(samples.begin(), median, samples.end(),
                   [axis](const Point& p, const Point& q) { return p[axis] < q[axis]; });
  below.high[axis] = above.low[axis] = (*median)[axis];
  halve(lower_half(k), {samples.begin(), median});
  halve(upper_half(k), {median, samples.end()});
}

}  // namespace morskin::geometry
