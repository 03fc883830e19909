#include "morse/saddle_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <thread>

#include "geometry/parallel.h"

namespace morskin::morse {

SaddleLines::SaddleLines(const skin::SkinSurface& skin, const MorseFunction& f,
                         std::span<const CriticalPoint> points, const geometry::Run& run, Kept kept)
    : tracers_{{{skin, f, points, IntegralLines::usual_step},
                {skin, f, points, IntegralLines::usual_step / 4}}},
      kept_(kept) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    const CriticalPoint& p = points[i];
    if (p.index != 1) continue;
    const bool turns = p.point.normal.cross(p.descending).dot(p.ascending) > 0;
    const Vector up = turns ? p.ascending : Vector(-p.ascending);
    for (const Vector& tangent : {p.descending, up, Vector(-p.descending), Vector(-up)}) {
      lines_.push_back({CriticalId{i}, tangent, {}});
    }
  }
  trace_all(run);
}

/// Traces every line; each block has its own nodes.
void SaddleLines::trace_all(const geometry::Run& run) {
  if (lines_.empty()) return;
  // About a millisecond or more a block. Few large blocks of nodes return to the system when freed;
  // many small ones would not.
  constexpr std::size_t min_size = 32, max_blocks = 64;
  const std::size_t block_size = std::max(min_size, lines_.size() / max_blocks);
  parts_.resize(geometry::block_count(lines_.size(), block_size));
  const auto teller = std::this_thread::get_id();
  const auto work = [&](std::size_t begin, std::size_t end, std::size_t block) {
    if (std::this_thread::get_id() == teller) {
      run.report(static_cast<double>(begin) / static_cast<double>(lines_.size()));
    }
    for (std::size_t i = begin; i < end; ++i) {
      Line& line = lines_[i];
      line.part = static_cast<std::uint32_t>(block);
      const Direction direction = this->direction(static_cast<std::uint32_t>(i));
      for (trace(line, direction, parts_[block]); line.course.saddle && line.fineness < finest;) {
        ++line.fineness;
        trace(line, direction, parts_[block]);
      }
    }
  };
  geometry::for_each_block(run.threads(), lines_.size(), work, block_size);
}

std::size_t SaddleLines::node_count() const {
  std::size_t count = 0;
  for (const Nodes& part : parts_) count += part.points.size();
  return count;
}

void SaddleLines::trace(Line& line, Direction direction, Nodes& nodes) const {
  line.first = nodes.points.size();
  line.course =
      tracer(line.fineness).trace(line.saddle, line.tangent, direction, nodes.points, nodes.cells);
  line.end = nodes.points.size();
  if (kept_ == Kept::EveryOther) drop_every_other(line, nodes);
}

/// Except in the first piece, at the saddle, and in the last, in the capture disc.
void SaddleLines::drop_every_other(Line& line, Nodes& nodes) {
  constexpr std::size_t at_each_end = 2;
  std::size_t kept = std::min(line.first + at_each_end, line.end);
  for (std::size_t i = kept; i < line.end; ++i) {
    if ((i - line.first) % 2 == 0 && i + at_each_end < line.end) continue;
    nodes.points[kept] = nodes.points[i];
    nodes.cells[kept++] = nodes.cells[i];
  }
  line.end = kept;
  nodes.points.resize(kept);
  nodes.cells.resize(kept);
}

bool SaddleLines::refine(std::uint32_t line) {
  if (lines_[line].fineness == finest) return false;
  ++lines_[line].fineness;
  trace(lines_[line], direction(line), parts_[lines_[line].part]);
  return true;
}

LineNodes SaddleLines::nodes(std::uint32_t line) const {
  const Line& l = lines_[line];
  return {l.saddle,
          l.tangent,
          direction(line),
          {parts_[l.part].points.data() + l.first, l.end - l.first},
          {parts_[l.part].cells.data() + l.first, l.end - l.first}};
}

}  // namespace morskin::morse
