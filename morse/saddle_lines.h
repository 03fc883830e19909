#pragma once

/// The four integral lines of every saddle, each traced as finely as it needs.

#include <array>
#include <vector>

#include "geometry/parallel.h"
#include "geometry/run.h"
#include "morse/integral_lines.h"

namespace morskin::morse {

class SaddleLines {
 public:
  /// All nodes, or every other one between a line's ends: enough to continue from, and nodes are
  /// most of a large molecule's memory before it has triangles.
  enum class Kept { All, EveryOther };
  /// Traces all lines: four consecutive ones for each saddle, counter-clockwise about it seen from
  /// outside, the first along `descending`. A line that runs into a saddle is traced again, finer.
  /// @param run  receives the share traced, from the first thread
  SaddleLines(const skin::SkinSurface& skin, const MorseFunction& f,
              std::span<const CriticalPoint> points, const geometry::Run& run = geometry::Run(),
              Kept kept = Kept::All);

  std::size_t size() const { return lines_.size(); }
  CriticalId saddle(std::uint32_t line) const { return lines_[line].saddle; }
  Direction direction(std::uint32_t line) const {
    return line % 2 == 0 ? Direction::Down : Direction::Up;
  }
  /// With the finest step tried.
  const Course& course(std::uint32_t line) const { return lines_[line].course; }
  LineNodes nodes(std::uint32_t line) const;
  std::size_t node_count() const;

  /// 0 with the usual step, `finest` with a quarter of it, where rounding exceeds truncation and
  /// finer steps gain nothing.
  int fineness(std::uint32_t line) const { return lines_[line].fineness; }
  static constexpr int finest = 1;
  /// The tracer of a fineness.
  const IntegralLines& tracer(int fineness) const {
    return tracers_[static_cast<std::size_t>(fineness)];
  }
  /// Traces a line again with the finer step. @return false if that was done already.
  bool refine(std::uint32_t line);

 private:
  struct Line {
    CriticalId saddle;
    Vector tangent;
    Course course;
    std::size_t first = 0, end = 0;  ///< of its nodes
    std::uint32_t part = 0;          ///< in which they are
    int fineness = 0;
  };

  struct Nodes {
    std::vector<Point> points;
    std::vector<skin::CellId> cells;
  };

  void trace_all(const geometry::Run& run);
  void trace(Line& line, Direction direction, Nodes& nodes) const;
  static void drop_every_other(Line& line, Nodes& nodes);

  std::array<IntegralLines, finest + 1> tracers_;
  std::vector<Line> lines_;
  std::vector<geometry::Apart<Nodes>> parts_;  ///< by block of lines
  Kept kept_;
};

}  // namespace morskin::morse
