#include "morse/saddle_lines.h"

#include <Eigen/Geometry>
#include <utility>

#include "geometry/parallel.h"

namespace morskin::morse {

SaddleLines::SaddleLines(const skin::SkinSurface& skin, const MorseFunction& f,
                         std::span<const CriticalPoint> points, unsigned threads)
    : tracers_{{{skin, f, points, IntegralLines::usual_step},
                {skin, f, points, IntegralLines::usual_step / 4}}} {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CriticalPoint& p = points[i];
    if (p.index != 1) continue;
    const bool turns = p.point.normal.cross(p.descending).dot(p.ascending) > 0;
    const Vector up = turns ? p.ascending : Vector(-p.ascending);
    for (const Vector& tangent : {p.descending, up, Vector(-p.descending), Vector(-up)}) {
      lines_.push_back({CriticalId{i}, tangent, {}, 0, 0, 0});
    }
  }
  trace_all(threads);
}

/// Traces every line. Each thread takes consecutive lines and keeps their nodes apart; then they
/// are put one behind the other.
void SaddleLines::trace_all(unsigned threads) {
  constexpr std::size_t least = 64;        // lines that are worth a thread
  constexpr std::size_t usual_nodes = 90;  // of a line, on average
  std::vector<Nodes> parts(geometry::chunk_count(threads, lines_.size(), least));
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    Nodes& part = parts[chunk];
    part.points.reserve(usual_nodes * (end - begin));
    part.cells.reserve(usual_nodes * (end - begin));
    for (std::size_t i = begin; i < end; ++i) {
      Line& line = lines_[i];
      const Way way = this->way(static_cast<std::uint32_t>(i));
      for (trace(line, way, part); line.course.saddle && line.fineness < finest;) {
        ++line.fineness;
        trace(line, way, part);
      }
    }
  };
  geometry::for_each_chunk(threads, lines_.size(), work, least);
  nodes_ = std::move(parts.front());
  for (std::size_t chunk = 1; chunk < parts.size(); ++chunk) {
    const std::size_t offset = nodes_.points.size();
    for (std::size_t i = chunk * lines_.size() / parts.size();
         i < (chunk + 1) * lines_.size() / parts.size(); ++i) {
      lines_[i].first += offset;
      lines_[i].end += offset;
    }
    nodes_.points.insert(nodes_.points.end(), parts[chunk].points.begin(),
                         parts[chunk].points.end());
    nodes_.cells.insert(nodes_.cells.end(), parts[chunk].cells.begin(), parts[chunk].cells.end());
    parts[chunk] = {};
  }
}

void SaddleLines::trace(Line& line, Way way, Nodes& nodes) const {
  line.first = nodes.points.size();
  line.course =
      tracer(line.fineness).trace(line.saddle, line.tangent, way, nodes.points, nodes.cells);
  line.end = nodes.points.size();
}

bool SaddleLines::refine(std::uint32_t line) {
  if (lines_[line].fineness == finest) return false;
  ++lines_[line].fineness;
  trace(lines_[line], way(line), nodes_);
  return true;
}

LineNodes SaddleLines::nodes(std::uint32_t line) const {
  const Line& l = lines_[line];
  return {l.saddle,
          l.tangent,
          way(line),
          {nodes_.points.data() + l.first, l.end - l.first},
          {nodes_.cells.data() + l.first, l.end - l.first}};
}

}  // namespace morskin::morse
