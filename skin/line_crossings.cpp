#include "skin/line_crossings.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "skin/level_set.h"

namespace morskin::skin {

namespace {

/// The parameter, from `from` to 1, at which p + t d leaves a cell. A line that runs in a wall, but
/// for rounding, leaves over it only where it gets past the tolerance. A cell may be flat if two
/// walls have the line's start on them.
template <class Skin>
double exit_of(const Skin& skin, CellId cell, const Point& p, const Vector& d, double from) {
  const double tolerance = skin.complex().wall_tolerance(), past = 2 * tolerance;
  double exit = 1;
  int on = 0;
  for (const Wall& wall : skin.complex().walls(cell)) {
    const double slope = wall.normal.dot(d);
    const double within = wall.offset - wall.normal.dot(p);
    if (within - from * slope < tolerance) ++on;
    if (!(slope > 0) || slope - within <= past) continue;
    const double at = within / slope;
    exit = std::min(exit, at < from ? (within + past) / slope : at);
  }
  exit = std::max(exit, from);
  return on < 2 ? exit : skin.last_in(cell, p, d, from, exit);
}

/// G along the segment inside one cell: a + b t + c t^2, with t from the middle of the piece, since
/// a far origin would cancel.
struct Piece {
  double middle, a, b, c;

  Piece(const Patch& patch, const Point& p, const Vector& d, double at) : middle(at) {
    const Point m = p + middle * d;
    const Vector n = patch.half_gradient(m);
    a = (m - patch.centre).dot(n) - patch.half_weight;
    b = 2 * n.dot(d);
    c = d.dot(patch.reflect(d));
  }
  bool is_outside(double share) const {
    const double t = share - middle;
    return a + t * (b + t * c) > 0;
  }
  double turning_point() const { return middle - b / (2 * c); }
  /// The zero between two shares where G has different signs and is monotone.
  double zero(double low, double high) const {
    const double root = std::sqrt(std::max(b * b - 4 * a * c, 0.0));
    const double twice = -(b + std::copysign(root, b));  // without cancellation
    double best = high, min_distance = std::numeric_limits<double>::infinity();
    for (const double t : {middle + twice / (2 * c), middle + 2 * a / twice}) {
      const double inside = std::clamp(t, low, high);
      if (!(std::abs(t - inside) < min_distance)) continue;  // also NaN
      min_distance = std::abs(t - inside);
      best = inside;
    }
    return best;
  }
};

}  // namespace

template <class Skin>
LineCrossings line_crossings(const Skin& skin, const Point& p, const Point& q, CellId hint) {
  const MixedComplex& complex = skin.complex();
  const Vector d = q - p;
  const double length = d.norm();
  LineCrossings result;
  if (!(length > 0)) return result;
  // Twice the tolerance past a wall, so that the walk leaves the cell.
  const double min_step = 2 * complex.wall_tolerance() / length;
  const std::size_t max_steps = 1000 + 8 * complex.size();
  CellId cell = skin.locate(p, hint);
  double from = 0;
  bool is_outside = false;
  for (std::size_t step = 0; from < 1; ++step) {
    if (step == max_steps) {
      result.is_complete = false;
      break;
    }
    const double to = exit_of(skin, cell, p, d, from);
    const Piece piece(skin.patch(cell), p, d, from + (to - from) / 2);
    if (step == 0) is_outside = piece.is_outside(0);
    // The sign carries over from piece to piece, so that a zero on a wall is found once.
    double low = from;
    for (const double high : {piece.turning_point(), to}) {
      if (!(high > low && high <= to)) continue;
      if (piece.is_outside(high) != is_outside) {
        is_outside = !is_outside;
        const double at = piece.zero(low, high);
        result.all.push_back({at, p + at * d, cell});
      }
      low = high;
    }
    from = std::max(to, from + min_step);
    if (from < 1) cell = skin.locate(p + from * d, cell);
  }
  return result;
}

template LineCrossings line_crossings(const SkinSurface&, const Point&, const Point&, CellId);
template LineCrossings line_crossings(const LevelSet&, const Point&, const Point&, CellId);

}  // namespace morskin::skin
