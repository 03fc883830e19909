#include "skin/skin_surface.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "geometry/error.h"
#include "skin/enclosure.h"
#include "skin/line_crossings.h"
#include "skin/slide.h"

namespace morskin::skin {

namespace {

const std::vector<WeightedPoint>& checked(const std::vector<WeightedPoint>& points) {
  const bool any = std::any_of(points.begin(), points.end(),
                               [](const WeightedPoint& p) { return p.weight > 0; });
  if (!any) {
    throw geometry::RefusedInput(
        "no ball has a positive weight, so there is no surface; give larger radii or weights");
  }
  return points;
}

}  // namespace

SkinSurface::SkinSurface(std::vector<WeightedPoint> points, MixedComplex::Keep keep,
                         const geometry::Run& run)
    : complex_([&] {
        auto triangulation = run.stage(
            "triangulate", [&] { return geometry::regular_triangulation(checked(points), run); });
        return run.stage("mixed complex", [&] {
          return MixedComplex(std::move(points), std::move(triangulation), keep, run);
        });
      }()),
      powers_(complex_.points(), complex_.triangulation().edges) {}

CellAtoms SkinSurface::atoms(CellId cell) const {
  const std::size_t index = complex_.simplex_index(cell);
  const geometry::RegularTriangulation& t = complex_.triangulation();
  switch (complex_.dimension(cell)) {
    case 0:
      return CellAtoms(std::array{t.vertices[index]});
    case 1:
      return CellAtoms(t.edges[index]);
    case 2:
      return CellAtoms(t.triangles[index]);
    default:
      return CellAtoms(t.tetrahedra[index]);
  }
}

AtomId SkinSurface::nearest_atom(const Point& x, CellId cell) const {
  return powers_.nearest(x, *atoms(cell).begin());
}

/// One step of the walk to x: over the wall of a cell that x is farthest beyond, if there is one.
template <class Walls>
SkinSurface::Step SkinSurface::step_over(const Point& x, CellId cell, const Walls& walls) const {
  const double tolerance = complex_.wall_tolerance();
  double farthest = -tolerance;
  CellId beyond = cell;
  for (const Wall& wall : walls) {
    const double distance = wall.normal.dot(x) - wall.offset;
    if (distance > farthest) {
      farthest = distance;
      beyond = wall.beyond;
    }
  }
  return farthest > tolerance ? Step{beyond, false} : Step{cell, beyond != cell};
}

CellId SkinSurface::locate(const Point& x, CellId hint) const {
  CellId current = hint;
  // Detects a cycle by a mark on the path, moved on as the path grows (Brent 1980).
  CellId passed = hint;
  std::size_t steps = 0, next_mark = 8;
  bool is_anew = false;
  for (;;) {
    const Step step = complex_.is_kept(current)
                          ? step_over(x, current, complex_.kept_walls(current))
                          : step_over(x, current, complex_.walls(current));
    if (step.next == current) {
      if (!step.is_on_wall || is_by_definition_in(x, current)) return current;
      // Within the walls of a flat cell that does not contain it: from there no wall leads on.
      if (std::exchange(is_anew, true)) return search(x, current);
      current = complex_.cell(nearest_atom(x, current));
      continue;
    }
    current = step.next;
    if (current == passed) return search(x, current);
    if (++steps == next_mark) {
      passed = current;
      next_mark *= 2;
    }
  }
}

/// The plane of equal power to the simplex and the atom of the least power at q: in the dual no
/// atom has less than the simplex.
SkinSurface::DualEnd SkinSurface::end_of_dual(const Point& q, CellId cell) const {
  const AtomId own = *atoms(cell).begin();
  const AtomId other = powers_.nearest(q, own);
  if (other == own) return {Vector::Zero(), 0};
  const WeightedPoint &a = points()[own.index()], &b = points()[other.index()];
  const Vector h = b.position - a.position;
  // Powers differ by 2 h d where q is d beyond the plane on which they are equal. Their difference
  // is taken without squares of large distances.
  const double difference = h.dot(2 * q - a.position - b.position) + b.weight - a.weight;
  return {h.normalized(), difference / (2 * h.norm())};
}

/// Whether a cell contains x, which is within its walls and on one: half a point of the simplex and
/// half one of its dual. A cell without volume, of a tie, has two walls on each other, and may have
/// none along their plane. The two points are x - N and x + N.
bool SkinSurface::is_by_definition_in(const Point& x, CellId cell) const {
  const auto is_on = [&](const Wall& wall) {
    return wall.normal.dot(x) - wall.offset > -complex_.wall_tolerance();
  };
  const Walls walls = complex_.walls(cell);
  if (std::count_if(walls.begin(), walls.end(), is_on) < 2) return true;
  return end_of_dual(x + jet(x, cell).half_gradient, cell).distance <= dual_tolerance();
}

/// At x = p + t d the dual's point is x + N, which moves on a line, too. Where it is past an end,
/// the segment is cut back to where it got there, until it is past none.
double SkinSurface::last_in(CellId cell, const Point& p, const Vector& d, double from,
                            double to) const {
  const Patch patch = complex_.patch(cell);
  const Vector direction = d + patch.reflect(d);
  for (;;) {
    const Point x = p + to * d;
    const DualEnd end = end_of_dual(x + patch.half_gradient(x), cell);
    // Twice the tolerance past an end, so that a walk leaves the cell.
    const double past = end.distance - 2 * dual_tolerance();
    const double slope = end.normal.dot(direction);
    const double there = slope > 0 ? std::max(to - past / slope, from) : from;
    if (!(past > 0 && there < to)) return to;
    to = there;
  }
}

bool SkinSurface::is_in(const Point& x, CellId cell) const {
  if (!complex_.is_kept(cell)) return false;
  const Step step = step_over(x, cell, complex_.kept_walls(cell));
  return step.next == cell && (!step.is_on_wall || is_by_definition_in(x, cell));
}

/// Searches all cells that can be reached over walls with x beyond or on them for one that contains
/// x, or, should there be none, the one with x the least beyond its walls. Only walls that x is on
/// may lead out of a flat cell with x in its plane.
CellId SkinSurface::search(const Point& x, CellId start) const {
  std::vector<CellId> waiting{start}, seen{start};  // seen: ascending
  CellId best = start;
  double min_beyond = std::numeric_limits<double>::infinity();
  while (!waiting.empty()) {
    const CellId cell = waiting.back();
    waiting.pop_back();
    double farthest = 0;
    for (const Wall& wall : complex_.walls(cell)) {
      const double distance = wall.normal.dot(x) - wall.offset;
      farthest = std::max(farthest, distance);
      if (distance <= -complex_.wall_tolerance()) continue;
      const auto at = std::ranges::lower_bound(seen, wall.beyond);
      if (at != seen.end() && *at == wall.beyond) continue;
      seen.insert(at, wall.beyond);
      waiting.push_back(wall.beyond);
    }
    if (farthest <= complex_.wall_tolerance()) {
      if (is_by_definition_in(x, cell)) return cell;
    } else if (farthest < min_beyond) {
      min_beyond = farthest;
      best = cell;
    }
  }
  return best;
}

surface::Enclosure SkinSurface::enclose(const Point& x, CellId cell) const {
  const CellAtoms atoms = this->atoms(cell);
  return skin::enclose(points(), powers_, x, {atoms.begin(), atoms.size()});
}

std::optional<SurfacePoint> SkinSurface::project(const Point& x, CellId hint) const {
  return slide_onto(*this, x, hint);
}

LineCrossings SkinSurface::crossings(const Point& p, const Point& q, CellId hint) const {
  return line_crossings(*this, p, q, hint);
}

BoundingBall SkinSurface::bounding_ball() const {
  constexpr double margin = 1.01;
  Point low = Point::Constant(std::numeric_limits<double>::infinity());
  Point high = -low;
  double max_weight = 0;
  for (const WeightedPoint& p : points()) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
    max_weight = std::max(max_weight, p.weight);
  }
  return {(low + high) / 2, margin * ((high - low).norm() / 2 + std::sqrt(max_weight))};
}

double SkinSurface::max_length_scale() const {
  double max_weight = 0;
  for (const WeightedPoint& p : points()) max_weight = std::max(max_weight, p.weight);
  return std::sqrt(max_weight / 2);
}

double waist_radius(const Patch& patch, double max_length_scale) {
  return std::max(std::sqrt(std::abs(patch.half_weight)), 0x1p-100 * max_length_scale);
}

/// On a hyperboloid of one sheet, at s along the axis from the middle, rho^2 = k + 2 s^2 with k the
/// square of the waist's radius, and the integral of 2 pi / rho ds over both sides is that of
/// rho^-2. With two sheets, k the square of half their distance, it is less.
PatchExtent extent_of(const Patch& patch, double max_length_scale) {
  if (patch.axis.isZero(0)) return {4 * M_PI, std::sqrt(std::abs(patch.half_weight))};
  const double waist = waist_radius(patch, max_length_scale);
  const double area = 2 * std::sqrt(2.0) * M_PI * std::asinh(max_length_scale / waist);
  return {area, max_length_scale};
}

PatchExtent SkinSurface::extent(CellId cell, double max_length_scale) const {
  return extent_of(complex_.kept_patch(cell), max_length_scale);
}

}  // namespace morskin::skin
