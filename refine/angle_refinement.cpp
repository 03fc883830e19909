#include "refine/angle_refinement.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "geometry/kd_tree.h"
#include "refine/angle_goal.h"
#include "refine/local_operations.h"

namespace morskin::refine {

namespace {

/// All vertices, for questions how near one is.
class NearVertices {
 public:
  explicit NearVertices(const Mesh& mesh) {
    positions_.reserve(mesh.points.size());
    for (const SurfacePoint& p : mesh.points) positions_.push_back(p.position);
    tree_.emplace(positions_);
  }

  bool is_any_within(const Point& x, double distance) const {
    bool is_any = false;
    tree_->for_each_within(x, distance, [&](const auto&) { is_any = true; });
    return is_any || std::any_of(positions_.begin() + in_tree(), positions_.end(),
                                 [&](const Point& p) { return (p - x).norm() <= distance; });
  }

  void add(const Point& x) {
    constexpr std::size_t max_outside = 256;
    positions_.push_back(x);
    if (++outside_ <= max_outside) return;
    tree_.emplace(positions_);
    outside_ = 0;
  }

 private:
  std::ptrdiff_t in_tree() const {
    return static_cast<std::ptrdiff_t>(positions_.size() - outside_);
  }

  std::vector<Point> positions_;
  std::size_t outside_ = 0;  ///< the last positions, not in the tree yet
  std::optional<geometry::KdTree<VertexId>> tree_;
};

/// How far from all others the vertex that breaks a triangle has to be: as far as the triangle's
/// shortest edge is long. One too big for [U], its angles good, may have longer edges than its
/// ball's radius; then that is enough.
double min_distance(const Mesh& mesh, TriangleId t) {
  const auto [a, b, c] = mesh.surface.corners(t);
  const Point &p = mesh.position(a), &q = mesh.position(b), &r = mesh.position(c);
  return std::min(TriangleSides(p, q, r).shortest(), circumcircle(p, q, r).radius);
}

}  // namespace

AngleRefinementCounts refine_angles(const surface::Surface& surface, const Sizing& sizing,
                                    Mesh& mesh, double bound_deg, const geometry::Run& run) {
  const AngleGoal bound(bound_deg);
  std::vector<TriangleId> waiting;
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    if (mesh.surface.is_removed(TriangleId{t})) continue;
    if (!bound.is_met(mesh, TriangleId{t})) waiting.push_back(TriangleId{t});
  }
  // The bound may be a little above 30 degrees, and the ball's centre is known to rounding.
  constexpr double rounding = 1e-9;
  AngleRefinementCounts counts;
  if (waiting.empty()) return counts;
  NearVertices near(mesh);
  LocalOperations operations(surface, sizing, mesh);
  Journal journal(mesh);
  operations.record_in(journal);
  // A new vertex may have a smaller length scale than those around, so that [U] asks for more.
  Work broken;
  const auto must_break = [&](TriangleId t) {
    broken.big.clear();
    broken.too_short.clear();
    operations.inspect(t, broken);
    return !broken.big.empty() || !bound.is_met(mesh, t);
  };
  while (!waiting.empty()) {
    const TriangleId t = waiting.back();
    waiting.pop_back();
    if (mesh.surface.is_removed(t) || !must_break(t)) continue;
    run.report(geometry::unknown_share, std::to_string(counts.inserted) + " insertions");
    const double least = min_distance(mesh, t);
    Point at;
    const bool is_in = operations.insert_ball_centre(t, [&](const Insertion& where) {
      at = where.point.position;
      return !near.is_any_within(at, (1 - rounding) * least);
    });
    if (!is_in) {
      counts.left.push_back(mesh.position(mesh.surface.corners(t)[0]));
      continue;
    }
    ++counts.inserted;
    near.add(at);
    operations.flip_where_needed();
    operations.work() = {};
    for (const VertexId v : journal.touched()) {
      mesh.surface.for_each_outgoing(
          v, [&](HalfEdgeId h) { waiting.push_back(SurfaceMesh::triangle(h)); });
    }
    journal.clear();
  }
  mesh.surface.compact(run.threads());
  return counts;
}

}  // namespace morskin::refine
