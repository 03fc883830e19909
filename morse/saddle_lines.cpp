#include "morse/saddle_lines.h"

#include <Eigen/Geometry>

namespace morskin::morse {

SaddleLines::SaddleLines(const skin::SkinSurface& skin, const MorseFunction& f,
                         std::span<const CriticalPoint> points)
    : tracers_{{{skin, f, points, IntegralLines::usual_step},
                {skin, f, points, IntegralLines::usual_step / 4}}} {
  std::size_t saddles = 0;
  for (const CriticalPoint& p : points) saddles += p.index == 1;
  constexpr std::size_t usual_nodes = 90;  // of a line, on average
  lines_.reserve(4 * saddles);
  points_.reserve(usual_nodes * 4 * saddles);
  cells_.reserve(usual_nodes * 4 * saddles);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CriticalPoint& p = points[i];
    if (p.index != 1) continue;
    const bool turns = p.point.normal.cross(p.descending).dot(p.ascending) > 0;
    const Vector up = turns ? p.ascending : Vector(-p.ascending);
    for (const Vector& tangent : {p.descending, up, Vector(-p.descending), Vector(-up)}) {
      const auto line = static_cast<std::uint32_t>(lines_.size());
      lines_.push_back({CriticalId{i}, tangent, {}, 0, 0, 0});
      trace(lines_.back(), way(line));
      while (course(line).saddle && refine(line)) {
      }
    }
  }
}

void SaddleLines::trace(Line& line, Way way) {
  line.first = points_.size();
  line.course = tracer(line.fineness).trace(line.saddle, line.tangent, way, points_, cells_);
  line.end = points_.size();
}

bool SaddleLines::refine(std::uint32_t line) {
  if (lines_[line].fineness == finest) return false;
  ++lines_[line].fineness;
  trace(lines_[line], way(line));
  return true;
}

LineNodes SaddleLines::nodes(std::uint32_t line) const {
  const Line& l = lines_[line];
  return {l.saddle,
          l.tangent,
          way(line),
          {points_.data() + l.first, l.end - l.first},
          {cells_.data() + l.first, l.end - l.first}};
}

}  // namespace morskin::morse
