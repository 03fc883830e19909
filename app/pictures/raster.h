#pragma once

/// The samples of a grid that a triangle, a ball or a stick covers, with their depths, under
/// parallel rays. Sample (x, y) lies at (x + 1/2, y + 1/2); z runs towards the eye.

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/point.h"

namespace morskin::pictures {

using geometry::Vector;

struct Grid {
  int width, height;
};

/// First and one past the last sample between two coordinates, within the grid.
struct Range {
  int first, last;
};
inline Range samples_between(double low, double high, int count) {
  const double first = std::clamp(std::ceil(low - 0.5), 0.0, static_cast<double>(count));
  const double last = std::clamp(std::floor(high - 0.5) + 1, first, static_cast<double>(count));
  return {static_cast<int>(first), static_cast<int>(last)};
}

/// The columns in which row y may meet the strip of a half width about the line from a along d.
inline Range span_of_strip(const Vector& a, const Eigen::Vector2d& d, double half_width, int y,
                           const Range& columns) {
  constexpr double level = 1e-6;  // few rows
  if (!(std::abs(d.y()) > level * std::abs(d.x()))) return columns;
  const double x = a.x() + (y + 0.5 - a.y()) * (d.x() / d.y());
  const double half = half_width * d.norm() / std::abs(d.y()) + 1;  // 1: far above rounding
  const Range span = samples_between(x - half, x + half, columns.last);
  return {std::max(span.first, columns.first), span.last};
}

/// Twice the area of a triangle as seen; negative when its corners run counter-clockwise for an eye
/// that has y upwards, which is when its outer side is seen.
inline double seen_area(const Vector& a, const Vector& b, const Vector& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// The columns that a triangle may cover in each row, so that the cost of a long thin triangle is
/// that of its rows and not that of its box.
class RowSpans {
 public:
  RowSpans(const Vector& a, const Vector& b, const Vector& c, const Range& columns)
      : columns_(columns), corners_{&a, &b, &c} {
    std::ranges::sort(corners_, {}, [](const Vector* p) { return p->y(); });
    long_ = slope(0, 2);
    upper_ = slope(0, 1);
    lower_ = slope(1, 2);
  }

  Range at(int y) const {
    const double row = y + 0.5;
    const Vector &low = *corners_[0], &middle = *corners_[1];
    const double x = low.x() + (row - low.y()) * long_;
    const double other = row < middle.y() ? low.x() + (row - low.y()) * upper_
                                          : middle.x() + (row - middle.y()) * lower_;
    constexpr double margin = 1e-3;  // far above rounding on a grid
    const double first = std::min(x, other) - margin, last = std::max(x, other) + margin;
    return {column(first), column(last)};
  }

 private:
  double slope(std::size_t i, std::size_t j) const {
    const double height = corners_[j]->y() - corners_[i]->y();
    return height > 0 ? (corners_[j]->x() - corners_[i]->x()) / height : 0;
  }
  /// The first column beyond x, within the box; of NaN, which covers nothing, that of the box.
  int column(double x) const {
    const double begin = columns_.first, end = columns_.last;
    return static_cast<int>(x > begin ? (x < end ? x + 0.5 : end) : begin);
  }

  Range columns_;
  std::array<const Vector*, 3> corners_;
  double long_ = 0, upper_ = 0, lower_ = 0;  ///< columns a row along the edges
};

/// visit(x, y, depth, u, v): u and v are the weights of the first and second corner.
template <class Visit>
void for_each_sample_of_triangle(const Grid& grid, const Vector& a, const Vector& b,
                                 const Vector& c, const Visit& visit) {
  const double area = seen_area(a, b, c);
  if (area == 0) return;
  const Range rows = samples_between(std::min({a.y(), b.y(), c.y()}),
                                     std::max({a.y(), b.y(), c.y()}), grid.height);
  const Range columns =
      samples_between(std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()}), grid.width);
  if (columns.first == columns.last) return;
  const double du = (b.y() - c.y()) / area, dv = (c.y() - a.y()) / area;
  const RowSpans spans(a, b, c, columns);
  for (int y = rows.first; y < rows.last; ++y) {
    const Range span = spans.at(y);
    if (span.first >= span.last) continue;
    const Vector p(span.first + 0.5, y + 0.5, 0);
    double u = seen_area(p, b, c) / area, v = seen_area(a, p, c) / area;
    for (int x = span.first; x < span.last; ++x, u += du, v += dv) {
      const double w = 1 - u - v;
      if (u >= 0 && v >= 0 && w >= 0) visit(x, y, u * a.z() + v * b.z() + w * c.z(), u, v);
    }
  }
}

/// visit(x, y, depth, normal)
template <class Visit>
void for_each_sample_of_ball(const Grid& grid, const Vector& centre, double radius,
                             const Visit& visit) {
  const Range rows = samples_between(centre.y() - radius, centre.y() + radius, grid.height);
  const Range columns = samples_between(centre.x() - radius, centre.x() + radius, grid.width);
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      const double dx = x + 0.5 - centre.x(), dy = y + 0.5 - centre.y();
      const double squared = radius * radius - dx * dx - dy * dy;
      if (squared < 0) continue;
      const double dz = std::sqrt(squared);
      visit(x, y, centre.z() + dz, Vector(Vector(dx, dy, dz) / radius));
    }
  }
}

/// A cylinder without lids. visit(x, y, depth, normal)
template <class Visit>
void for_each_sample_of_stick(const Grid& grid, const Vector& from, const Vector& to, double radius,
                              const Visit& visit) {
  const Vector axis = to - from;
  const double length = axis.norm();
  if (length == 0) return;
  const Vector e = axis / length;
  const double steepness = 1 - e.z() * e.z();  // squared sine of the angle to the rays
  if (steepness <= 0) return;                  // parallel to the rays: only its lids are visible
  const Range rows = samples_between(std::min(from.y(), to.y()) - radius,
                                     std::max(from.y(), to.y()) + radius, grid.height);
  const Range columns = samples_between(std::min(from.x(), to.x()) - radius,
                                        std::max(from.x(), to.x()) + radius, grid.width);
  for (int y = rows.first; y < rows.last; ++y) {
    for (int x = columns.first; x < columns.last; ++x) {
      // The point q + z (0, 0, 1) is at distance `radius` from the axis, z the larger root.
      const Vector q(x + 0.5 - from.x(), y + 0.5 - from.y(), 0);
      const double along = q.dot(e);
      const double half = -along * e.z();
      const double squared =
          half * half - steepness * (q.squaredNorm() - along * along - radius * radius);
      if (squared < 0) continue;
      const double z = (-half + std::sqrt(squared)) / steepness;
      const double t = along + z * e.z();
      if (t < 0 || t > length) continue;
      const Vector outward = q + Vector(0, 0, z) - t * e;
      visit(x, y, from.z() + z, Vector(outward / radius));
    }
  }
}

}  // namespace morskin::pictures
