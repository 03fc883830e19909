#pragma once

/// The follower of one integral line: where it stands, and how it goes on to the next cell wall.
/// An inner part of integral_lines.cpp.

#include <utility>

#include "morse/integral_lines.h"

namespace morskin::morse {

class Tracer {
 public:
  /// @param points, cells  the nodes, appended to as the line goes on; both or neither.
  Tracer(const IntegralLines& lines, Way way, std::vector<Point>* points,
         std::vector<skin::CellId>* cells);

  /// Stands at a point of the skin.
  void start(const Point& x, skin::CellId cell);
  /// Stands on the line that leaves a saddle along a tangent, a share (0, 1] of the way of the
  /// first node from it.
  void start(CriticalId saddle, const Vector& tangent, double share);
  /// Follows the meridian of a saddle's hyperboloid to the wall, if the line runs along it.
  void follow_meridian(CriticalId saddle, const Vector& tangent);

  /// Goes on to an extremum, or to the level at which it stops, as far as it gets.
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
    double distance, slope;  ///< of the point stood at, and along the velocity
  };

  /// @param u  in space, from the centre of the cell's patch
  void enter(skin::CellId cell, const Vector& u);
  void leave_through(LocalWall wall);
  void note();
  double level_here(const Vector& u) const { return centre_value_ + flow_.value(u); }
  std::optional<std::size_t> wall_passed() const;
  bool follow_great_circle();
  void lay_circle(const Vector& pole, const Vector& side, double from, double to);
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
  bool look_for_stop(double time);
  bool is_at_saddle();
  bool comes_too_near(const CriticalPoint& saddle) const;

  const IntegralLines& lines_;
  Way way_;
  std::vector<Point>* points_;
  std::vector<skin::CellId>* cells_;
  double tolerance_;
  skin::CellId cell_;
  Point centre_;
  GradientFlow flow_;
  double centre_value_ = 0;
  Vector u_, velocity_;  ///< where the line stands, in the flow's coordinates
  Vector end_;           ///< where the step ends
  std::vector<LocalWall> walls_;
  std::optional<double> stop_;
  bool at_level_ = false;
  double decay_ = 0;       ///< since it creeps: how much of what was off the slow way has died out
  double creep_time_ = 0;  ///< of the last step while it creeps
  bool is_implicit_ = false;          ///< how steps are taken
  std::optional<CriticalId> origin_;  ///< the saddle that the line has left
  Course course_;
};

}  // namespace morskin::morse
