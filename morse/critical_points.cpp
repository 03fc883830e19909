#include "morse/critical_points.h"

#include "geometry/files/text_lines.h"
#include "geometry/kd_tree.h"
#include "morse/cell_contact.h"
#include "morse/critical_points_internal.h"

namespace morskin::morse {

namespace {

/// Each point may be off by its wall doubt; two nearer than both doubts may coincide.
void report_coincidences(const skin::SkinSurface& surface, CriticalPoints& result) {
  std::vector<Point> positions;
  positions.reserve(result.points.size());
  for (const CriticalPoint& p : result.points) positions.push_back(p.point.position);
  const geometry::KdTree<CriticalId> tree(positions);
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const double doubt = wall_doubt * result.points[i].point.length_scale;
    const double radius = 2 * (doubt + surface.complex().wall_tolerance());
    const auto twin =
        tree.nearest(positions[i], radius, [&](CriticalId j) { return j.index() > i; });
    if (twin) {
      result.degeneracies.push_back("two critical points coincide within rounding " +
                                    position_text(positions[i]));
    }
  }
}

}  // namespace

std::size_t CriticalPoints::count(int index) const {
  std::size_t n = 0;
  for (const CriticalPoint& p : points) n += p.index == index;
  return n;
}

long CriticalPoints::euler_characteristic() const {
  return static_cast<long>(count(0) + count(2)) - static_cast<long>(count(1));
}

std::string position_text(const Point& x) { return "at " + geometry::in_words(x); }

bool take(const skin::SkinSurface& surface, const CriticalPoint& critical, double doubt,
          CriticalPoints& result) {
  const Where where = side(surface.complex(), critical.point.cell, critical.point.position, doubt);
  if (where == Where::Outside) return false;
  if (where == Where::OnWall) {
    result.degeneracies.push_back("a critical point lies on a cell wall " +
                                  position_text(critical.point.position));
  }
  result.points.push_back(critical);
  return true;
}

CriticalPoints critical_points(const skin::SkinSurface& surface, const MorseFunction& function) {
  CriticalPoints result;
  const std::size_t cells = surface.complex().kept_size();  // no others meet the skin
  if (function.is_height()) {
    for (std::size_t i = 0; i < cells; ++i) {
      add_height_critical_points(surface, skin::CellId{i}, function, result);
    }
  } else {
    // direction . x + c |x - o|^2 = c |x - (o - direction / 2c)|^2 + a constant
    const Point origin = function.origin - function.direction / (2 * function.curvature);
    for (std::size_t i = 0; i < cells; ++i) {
      add_distance_critical_points(surface, skin::CellId{i}, function, origin, result);
    }
  }
  report_coincidences(surface, result);
  return result;
}

}  // namespace morskin::morse
