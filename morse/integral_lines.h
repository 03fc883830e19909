#pragma once

/// Integral lines of a Morse function on the skin (section 3.2): curves along the gradient, from a
/// saddle or any other point down to a minimum or up to a maximum.
///
/// On sphere patches a line is an arc of a great circle through the poles, from a saddle along the
/// meridian of its hyperboloid an arc of a hyperbola; both are followed in closed form to the wall
/// where the cell ends. Elsewhere a line is followed by Runge-Kutta steps of order 8, each settled
/// on its patch and ended where a cell wall is crossed, so that every step has one smooth flow.
///
/// Where it creeps, on a way of little slope to which the flow draws all lines, the steps are
/// implicit, so that the drawing does not bound their length.
///
/// A line ends only in the capture disc of an extremum, from which the flow cannot escape.
/// Derivations: papers/3.2-morse-smale-complex.md.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "morse/critical_points.h"
#include "morse/gradient_flow.h"

namespace morskin::morse {

/// The neighbourhood of an extremum, within its cell, that a line cannot leave again: points of the
/// patch at a distance below `radius` where f differs from the extremum's by less than `level`.
struct CaptureDisc {
  Vector centre;         ///< the extremum, from the patch's centre
  double radius = 0;     ///< Angstrom; no cell wall is nearer
  double level = 0;      ///< > 0, in the units of f
  Eigen::Matrix3d form;  ///< |f(x) - f(extremum)| = d . form d for d = x - extremum, on the patch
  Vector first, second;  ///< orthogonal tangents, counter-clockwise seen from outside, each scaled
                         ///< by the root of its curvature: level curves are nearly circles in them

  double height(const Vector& u) const { return (u - centre).dot(form * (u - centre)); }
  bool contains(const Vector& u) const {
    return (u - centre).squaredNorm() < radius * radius && height(u) < level;
  }
};

/// Where a line comes in at its extremum.
struct Arrival {
  CriticalId extremum;
  double angle;   ///< radians, in the frame of the extremum's disc
  double radius;  ///< Angstrom: how far from the extremum the angle was taken
};

/// What became of a line: it has arrived at an extremum, or it has run into a saddle to within the
/// merge distance, so that nobody knows on which side it passes, or it has come to rest where f
/// does not change along the skin for all that doubles can tell, or it was lost. The last does not
/// happen but where a critical point is missing.
struct Course {
  std::optional<Arrival> arrival;
  std::optional<CriticalId> saddle;
  bool is_at_rest = false;
};

/// A line from a saddle by its nodes.
struct LineNodes {
  CriticalId saddle;
  Vector tangent;  ///< the unit vector along which the line leaves the saddle
  Way way;
  std::span<const Point> points;        ///< the first is the saddle, the last the extremum
  std::span<const skin::CellId> cells;  ///< by point, the cell in which the line goes on from it
};

class IntegralLines {
 public:
  /// Step over the length scale.
  static constexpr double usual_step = 0.18;
  /// How far a line may lie from the true one, over the length scale, with the usual step: what is
  /// left of truncation after the flow has spread it on the way. Measured against finer steps; one
  /// place in 500 has a larger error (tests/integral_lines_test.cpp).
  static constexpr double usual_accuracy = 1e-8;

  /// @param points  the critical points of f on the skin, all of them; kept by reference.
  IntegralLines(const skin::SkinSurface& skin, const MorseFunction& f,
                std::span<const CriticalPoint> points, double step = usual_step);

  /// Appends the nodes of the line that leaves a saddle along `tangent`.
  ///
  /// @param tangent  the saddle's `descending` or `ascending`, or its opposite.
  Course trace(CriticalId saddle, const Vector& tangent, Way way, std::vector<Point>& points,
               std::vector<skin::CellId>& cells) const;
  /// The same from any point of the skin that is not critical.
  Course trace(const surface::SurfacePoint& start, Way way, std::vector<Point>& points,
               std::vector<skin::CellId>& cells) const;

  /// Where a line passes a level, with the velocity (of no fixed length) there.
  struct Passage {
    Point position;
    Vector velocity, normal;
    double length_scale;
  };
  /// @return nothing when the line does not pass the level.
  std::optional<Passage> passage(const LineNodes& line, double level) const;
  /// The same at one of its nodes but the first and the last.
  Passage passage_at(const LineNodes& line, std::size_t node) const;

  /// Below this rounding, spread by the flow, outdoes truncation.
  static constexpr double best_accuracy = 1e-11;
  /// The accuracy with this object's step: the method is of order 8.
  double accuracy() const {
    return std::max(usual_accuracy * std::pow(step_ / usual_step, 8), best_accuracy);
  }
  /// Two lines of one kind nearer than this cannot be told apart, Angstrom.
  double merge_distance(double length_scale) const {
    return 10 * accuracy() * length_scale + 4 * skin_.complex().wall_tolerance();
  }

  /// Of an extremum that does not lie on a sphere patch; of other points it is empty.
  const CaptureDisc& disc(CriticalId id) const { return discs_[id.index()]; }
  /// The nearest wall of the cell that contains a critical point, Angstrom.
  double wall_distance(CriticalId id) const;
  std::span<const CriticalPoint> points() const { return points_; }
  const MorseFunction& function() const { return f_; }

 private:
  friend class Tracer;

  void build_disc(CriticalId id);
  /// The critical points in a cell.
  std::span<const CriticalId> within(skin::CellId cell) const {
    if (cell.index() + 1 >= first_.size()) return {};  // on a wall, but for rounding
    return {by_cell_.data() + first_[cell.index()],
            first_[cell.index() + 1] - first_[cell.index()]};
  }

  const skin::SkinSurface& skin_;
  MorseFunction f_;
  std::span<const CriticalPoint> points_;
  double step_;
  std::vector<std::uint32_t> first_;  ///< by cell, into by_cell_
  std::vector<CriticalId> by_cell_;
  std::vector<CaptureDisc> discs_;  ///< by critical point; of saddles empty
};

}  // namespace morskin::morse
