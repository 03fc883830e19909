#include "implicit/room.h"

#include <algorithm>
#include <numeric>

namespace morskin::implicit {

namespace {

/// Above the rounding of the few operations that follow.
constexpr double up = 1 + 1e-12;

std::vector<Point> centres_of(const Cover& cover) {
  std::vector<Point> centres;
  centres.reserve(cover.boxes.size());
  for (const CoverBox& b : cover.boxes) centres.push_back(b.box.centre);
  return centres;
}

}  // namespace

Room::Room(const Cover& cover, double M) : centres_(centres_of(cover)), tree_(centres_) {
  for (const CoverBox& b : cover.boxes) {
    box_radii_.push_back(b.box.radius());
    radii_.push_back(up * (b.box.radius() + reach * b.max_gradient / M));
    max_box_radius_ = std::max(max_box_radius_, box_radii_.back());
    max_radius_ = std::max(max_radius_, radii_.back());
  }
}

bool Room::contains(const Point& x, double radius) const {
  const auto in_ball = [&](geometry::Id<Room> id) {
    return up * ((x - centres_[id.index()]).norm() + radius) <= radii_[id.index()];
  };
  return radius <= max_radius_ && tree_.nearest(x, max_radius_, in_ball).has_value();
}

bool Room::may_meet_cover(const Point& x, double radius) const {
  const auto may_meet = [&](geometry::Id<Room> id) {
    return (x - centres_[id.index()]).norm() <= up * (box_radii_[id.index()] + radius);
  };
  return tree_.nearest(x, up * (max_box_radius_ + radius), may_meet).has_value();
}

Room::Ids Room::all() const {
  Ids ids(centres_.size());
  std::iota(ids.begin(), ids.end(), 0U);
  return ids;
}

Box Room::cube() const {
  Point low = Point::Constant(Interval::infinity), high = -low;
  for (std::size_t i = 0; i < centres_.size(); ++i) {
    low = low.cwiseMin(centres_[i] - Vector::Constant(radii_[i]));
    high = high.cwiseMax(centres_[i] + Vector::Constant(radii_[i]));
  }
  return {(low + high) / 2, up * (high - low).maxCoeff() / 2};
}

Room::Ids Room::meeting(const Box& box, std::span<const std::uint32_t> balls) const {
  Ids result;
  for (const std::uint32_t id : balls) {
    const Vector off = (box.centre - centres_[id]).cwiseAbs();
    const double radius = radii_[id];
    if (up * (off + Vector::Constant(box.half)).norm() <= radius) return {id};
    const Vector gap = (off - Vector::Constant(box.half)).cwiseMax(0);
    if (gap.norm() <= up * radius) result.push_back(id);
  }
  return result;
}

}  // namespace morskin::implicit
