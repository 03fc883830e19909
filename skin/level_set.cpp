#include "skin/level_set.h"

#include <algorithm>
#include <cmath>

#include "skin/line_crossings.h"
#include "skin/slide.h"

namespace morskin::skin {

surface::Enclosure LevelSet::enclose(const Point& x, CellId cell) const {
  surface::Enclosure e = skin_->enclose(x, cell);
  const auto rounding = [](double value) { return 0x1p-51 * std::abs(value); };
  e.low -= half_time_, e.high -= half_time_;
  e.low -= rounding(e.low), e.high += rounding(e.high);
  return e;
}

std::optional<SurfacePoint> LevelSet::project(const Point& x, CellId hint) const {
  return slide_onto(*this, x, hint);
}

LineCrossings LevelSet::crossings(const Point& p, const Point& q, CellId hint) const {
  return line_crossings(*this, p, q, hint);
}

BoundingBall LevelSet::bounding_ball() const {
  BoundingBall ball = skin_->bounding_ball();
  ball.radius += std::sqrt(std::max(2 * half_time_, 0.0));
  return ball;
}

double LevelSet::max_length_scale() const {
  const double rho = skin_->max_length_scale();
  return std::sqrt(std::max(rho * rho + half_time_, 0.0));
}

surface::Samples LevelSet::samples() const {
  const surface::Samples of_skin = skin_->samples();
  surface::Samples samples{{}, of_skin.each};
  for (const SurfacePoint& p : of_skin.points) {
    if (const auto x = project(p.position, p.cell)) samples.points.push_back(*x);
  }
  return samples;
}

PatchExtent LevelSet::extent(CellId cell, double max_length_scale) const {
  return extent_of(patch(cell), max_length_scale);
}

}  // namespace morskin::skin
