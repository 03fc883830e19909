#pragma once

/// Integral lines of a Morse function on the skin (section 3.2): curves along the gradient, from a
/// saddle or any other point down to a minimum or up to a maximum.
///
/// On sphere patches a line is an arc of a great circle through the poles, and from a saddle along
/// the meridian of its hyperboloid an arc of a hyperbola: both have a closed form up to the cell's
/// wall. Elsewhere the tracer takes Runge-Kutta steps of order 8, projects each onto its patch and
/// ends it at a cell wall, so that the flow is smooth along every step.
///
/// Where a line creeps, along a curve of little slope to which the flow draws its neighbours, steps
/// are implicit (radau_step).
///
/// A line ends only in the capture disc of an extremum, from which the flow cannot escape.
/// Derivations: papers/3.2-morse-smale-complex.md.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "geometry/grouped.h"
#include "morse/critical_points.h"
#include "morse/gradient_flow.h"

namespace morskin::morse {

/// The neighbourhood of an extremum, within its cell, that no line leaves: points of the patch
/// nearer than `radius` whose values differ from the extremum's by less than `level`.
struct CaptureDisc {
  Vector centre;         ///< the extremum, from the patch's centre
  double radius = 0;     ///< Angstrom; no cell wall is nearer
  double level = 0;      ///< > 0, in the units of f
  Eigen::Matrix3d form;  ///< |f(x) - f(extremum)| = d . form d for d = x - extremum, on the patch
  Vector first, second;  ///< orthogonal tangents, counter-clockwise seen from outside, scaled by
                         ///< the roots of their curvatures, which makes level curves nearly circles

  double height(const Vector& u) const { return (u - centre).dot(form * (u - centre)); }
  bool contains(const Vector& u) const {
    return (u - centre).squaredNorm() < radius * radius && height(u) < level;
  }
};

/// The end of a line at its extremum.
struct Arrival {
  CriticalId extremum;
  double angle;   ///< radians, in the frame of the extremum's disc
  double radius;  ///< Angstrom: the distance from the extremum at which the angle was measured
};

/// The outcome of a trace: the line arrives at an extremum; or passes a saddle within the merge
/// distance, so that its side is unknown; or comes to rest where f is constant along the skin
/// within rounding; or is lost, which happens only if a critical point is missing.
struct Course {
  std::optional<Arrival> arrival;
  std::optional<CriticalId> saddle;
  bool is_at_rest = false;
};

/// A line from a saddle by its nodes.
struct LineNodes {
  CriticalId saddle;
  Vector tangent;  ///< unit, of the line at the saddle
  Direction direction;
  std::span<const Point> points;        ///< from the saddle to the extremum
  std::span<const skin::CellId> cells;  ///< by point, the cell of the line's next piece
};

class IntegralLines {
 public:
  /// Step over the length scale.
  static constexpr double usual_step = 0.18;
  /// Error of a line with the usual step over the length scale: truncation, amplified by the flow.
  /// Measured against finer steps; one point in 500 has a larger error
  /// (tests/integral_lines_test.cpp).
  static constexpr double usual_accuracy = 1e-8;

  /// @param points  all critical points of f on the skin; kept by reference
  /// @param step    over the length scale
  IntegralLines(const skin::SkinSurface& skin, const MorseFunction& f,
                std::span<const CriticalPoint> points, double step = usual_step);

  /// Appends the nodes of the line that leaves a saddle along `tangent`.
  ///
  /// @param tangent  the saddle's `descending` or `ascending`, or its opposite.
  Course trace(CriticalId saddle, const Vector& tangent, Direction direction,
               std::vector<Point>& points, std::vector<skin::CellId>& cells) const;
  /// The same from any regular point of the skin.
  Course trace(const surface::SurfacePoint& start, Direction direction, std::vector<Point>& points,
               std::vector<skin::CellId>& cells) const;

  /// The point where a line passes a level.
  struct Passage {
    Point position;
    Vector velocity;  ///< of any length
    Vector normal;
    double length_scale;
  };
  /// @return nothing where the line does not pass the level.
  std::optional<Passage> passage(const LineNodes& line, double level) const;
  /// The same at a node other than the first and the last.
  Passage passage_at(const LineNodes& line, std::size_t node) const;

  /// Below this, rounding amplified by the flow exceeds truncation.
  static constexpr double best_accuracy = 1e-11;
  /// The accuracy with this object's step: the method is of order 8.
  double accuracy() const {
    return std::max(usual_accuracy * std::pow(step_ / usual_step, 8), best_accuracy);
  }
  /// Two lines of one kind nearer than this are indistinguishable, Angstrom.
  double merge_distance(double length_scale) const {
    return 10 * accuracy() * length_scale + 4 * skin_.complex().wall_tolerance();
  }

  /// Empty for saddles and extrema on sphere patches.
  const CaptureDisc& disc(CriticalId id) const { return discs_[id.index()]; }
  /// Distance of a critical point to the nearest wall of its cell, Angstrom.
  double wall_distance(CriticalId id) const;
  std::span<const CriticalPoint> points() const { return points_; }
  const MorseFunction& function() const { return f_; }

 private:
  friend class Tracer;

  void build_disc(CriticalId id);
  /// The critical points in a cell.
  std::span<const CriticalId> within(skin::CellId cell) const {
    if (cell.index() >= by_cell_.group_count()) return {};  // on a wall, up to rounding
    return by_cell_.of(cell.index());
  }

  const skin::SkinSurface& skin_;
  MorseFunction f_;
  std::span<const CriticalPoint> points_;
  double step_;
  geometry::Grouped<CriticalId> by_cell_;
  std::vector<CaptureDisc> discs_;  ///< by critical point; of saddles empty
};

}  // namespace morskin::morse
