#include "morse/cell_contact.h"

#include <algorithm>
#include <cmath>

#include "geometry/orthogonal.h"

namespace morskin::morse {

using skin::CellId;
using skin::MixedComplex;

Where side(const MixedComplex& complex, CellId cell, const Point& x, double doubt) {
  Where where = Where::Inside;
  for (const skin::Wall& wall : complex.walls(cell)) {
    const double distance = wall.normal.dot(x) - wall.offset;
    if (distance > doubt) return Where::Outside;
    if (distance > -doubt) where = Where::OnWall;
  }
  return where;
}

// The circle's part in the cell, an intersection of arcs, is empty, the whole circle, or ends where
// a wall cuts the circle. So it is enough to test these points and any one more.
std::optional<Point> point_in_cell(const MixedComplex& complex, CellId cell, const Circle& circle,
                                   double doubt) {
  const geometry::TangentFrame plane(circle.axis);
  const auto at = [&](double angle) -> Point {
    return circle.centre + circle.radius * plane.direction(angle);
  };
  const auto is_in = [&](const Point& x) {
    return side(complex, cell, x, doubt) != Where::Outside;
  };
  if (is_in(at(0))) return at(0);
  for (const skin::Wall& wall : complex.walls(cell)) {
    const double x = wall.normal.dot(plane.first), y = wall.normal.dot(plane.second);
    const double extent = circle.radius * std::hypot(x, y);  // along the wall's normal
    const double distance = wall.offset - wall.normal.dot(circle.centre);
    if (!(std::abs(distance) < extent)) continue;
    const double towards = std::atan2(y, x), half_arc = std::acos(distance / extent);
    for (const double angle : {towards - half_arc, towards + half_arc}) {
      if (is_in(at(angle))) return at(angle);
    }
  }
  return std::nullopt;
}

// One dimension higher: the sphere's part in the cell is empty, the whole sphere, or bounded by
// arcs of the circles in which walls cut the sphere.
std::optional<Point> point_in_cell(const MixedComplex& complex, CellId cell, const Point& centre,
                                   double radius, double doubt) {
  const Point pole = centre + radius * Vector::UnitX();
  if (side(complex, cell, pole, doubt) != Where::Outside) return pole;
  for (const skin::Wall& wall : complex.walls(cell)) {
    const double distance = wall.offset - wall.normal.dot(centre);
    if (!(std::abs(distance) < radius)) continue;
    const Circle cut{centre + distance * wall.normal, wall.normal,
                     std::sqrt((radius - distance) * (radius + distance))};
    if (auto point = point_in_cell(complex, cell, cut, doubt)) return point;
  }
  return std::nullopt;
}

std::optional<Point> point_in_cell(const MixedComplex& complex, CellId cell, const Stretch& stretch,
                                   double doubt) {
  double from = stretch.from, to = stretch.to;
  for (const skin::Wall& wall : complex.walls(cell)) {
    const double speed = wall.normal.dot(stretch.direction);
    const double distance = wall.offset + doubt - wall.normal.dot(stretch.start);
    if (speed > 0) to = std::min(to, distance / speed);
    if (speed < 0) from = std::max(from, distance / speed);
    if (speed == 0 && distance < 0) return std::nullopt;
  }
  if (!(from <= to)) return std::nullopt;
  return stretch.start + from * stretch.direction;
}

}  // namespace morskin::morse
