#pragma once

/// Traces one integral line from cell wall to cell wall. Internal to integral_lines.cpp, tracer.cpp
/// and tracer_steps.cpp.

#include <utility>

#include "morse/integral_lines.h"

namespace morskin::morse {

class Tracer {
 public:
  /// A cell that a line would leave again within so many wall tolerances counts as one without
  /// width; the largest error seen in walls of flat simplices is 17 of them.
  static constexpr double no_width = 64;

  /// @param points, cells  receive the nodes; both or neither may be null
  Tracer(const IntegralLines& lines, Direction direction, std::vector<Point>* points,
         std::vector<skin::CellId>* cells);

  /// Starts at a point of the skin.
  void start(const Point& x, skin::CellId cell);
  /// Starts on the line that leaves a saddle along a tangent.
  /// @param share  of the distance from the saddle to the first node, in (0, 1]
  void start(CriticalId saddle, const Vector& tangent, double share);
  /// Follows the meridian of a saddle's hyperboloid to the wall, if the line runs along it.
  void follow_meridian(CriticalId saddle, const Vector& tangent);

  /// Traces the line to an extremum, to the level of stop_at(), or until it cannot continue.
  void run();

  void stop_at(double level) { stop_ = level; }
  bool is_at_level() const { return at_level_; }
  const Course& course() const { return course_; }
  IntegralLines::Passage passage() const;

 private:
  struct LocalWall {
    Vector normal;  ///< in the flow's coordinates
    double offset;
    skin::CellId beyond;
    double distance, slope;  ///< of the current point, and its derivative along the velocity
  };

  /// @param u  in space, from the centre of the cell's patch
  void enter(skin::CellId cell, const Vector& u);
  void leave_through(LocalWall wall);
  void note();
  double level_here(const Vector& u) const { return centre_value_ + flow_.value(u); }
  std::optional<std::size_t> wall_passed() const;
  bool follow_great_circle();
  /// Where such a line leaves the cell, as it falls from a half tangent to 0.
  struct ArcExit {
    double half_tangent = 0;          ///< of t
    const LocalWall* wall = nullptr;  ///< nothing if the line ends at its pole
  };
  ArcExit exit_of_arc(const Vector& pole, const Vector& side, double from) const;
  void add_arc_nodes(const Vector& pole, const Vector& side, double from, double to);
  bool step();
  double step_time();
  std::pair<double, double> rates() const;
  Vector step_end(double time) const;
  template <class Function>
  double first_zero(double time, double tolerance, Function function);
  bool end_at_wall(double& time, std::optional<std::size_t>& exit);
  bool rises_above(const LocalWall& wall, double& time, double slope_at_end) const;
  bool capture(double time);
  void arrive(CriticalId id, const Vector& from);
  bool stops_within(double time);
  bool is_at_saddle();
  bool comes_too_near(const CriticalPoint& saddle) const;

  const IntegralLines& lines_;
  Direction direction_;
  std::vector<Point>* points_;
  std::vector<skin::CellId>* cells_;
  double tolerance_;
  skin::CellId cell_;
  Point centre_;
  GradientFlow flow_;
  double centre_value_ = 0;
  Vector u_, velocity_;  ///< the current point, in the flow's coordinates
  Vector end_;           ///< of the step
  std::vector<LocalWall> walls_;
  std::optional<double> stop_;
  bool at_level_ = false;
  double decay_ = 0;       ///< while it creeps: e-folds by which it has come nearer the slow curve
  double creep_time_ = 0;  ///< of the last step while it creeps
  bool is_implicit_ = false;          ///< the kind of step
  std::optional<CriticalId> origin_;  ///< the saddle that the line leaves
  Course course_;
};

}  // namespace morskin::morse
