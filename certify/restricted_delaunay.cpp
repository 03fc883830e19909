#include "certify/restricted_delaunay.h"

#include <algorithm>
#include <atomic>
#include <optional>
#include <vector>

#include "certify/ball_pencil.h"
#include "geometry/kd_tree.h"
#include "geometry/parallel.h"

namespace morskin::certify {

namespace {

using geometry::IndexedMesh;

/// 16 u L, Angstrom, u the unit roundoff and L the largest coordinate: squared distances of about
/// r^2, a corner's and the vertex's, are off by a few times 2 r u L.
double rounding_of(const IndexedMesh& mesh) {
  double largest = 0;
  for (const Point& p : mesh.positions) largest = std::max(largest, p.cwiseAbs().maxCoeff());
  return 16 * std::ldexp(largest, -53);
}

/// The depth of p in the ball over its squared radius; nothing within min_intrusion, with which
/// four vertices on a circle settle either way, and rounding.
std::optional<double> depth_in(const SurfaceBall& ball, const Point& p, double rounding) {
  const double intrusion = ball.intrusion(p);
  const double margin =
      min_intrusion * ball.squared_radius + rounding * std::sqrt(ball.squared_radius);
  if (!(intrusion > margin)) return std::nullopt;
  return intrusion / ball.squared_radius;
}

/// Whether a surface ball is looked for. A triangle as large as its length scale is refused by the
/// certificate (tube.h). It may have no ball, or one far away that holds much of the mesh: to find
/// that for all triangles of a mesh that has nothing to do with the surface would take for ever.
bool may_have_ball(const Corners& corners, const Circumcircle& circle) {
  return circle.radius < min_length_scale(corners);
}

class DelaunayCheck {
 public:
  DelaunayCheck(const IndexedMesh& mesh, const surface::Surface& surface,
                std::span<const SurfacePoint> points, const geometry::KdTree<VertexId>& tree)
      : mesh_(mesh),
        surface_(surface),
        points_(points),
        tree_(tree),
        rounding_(rounding_of(mesh)) {}

  /// Checks triangles [begin, end).
  RestrictedDelaunay run(std::size_t begin, std::size_t end, std::size_t listed) const {
    RestrictedDelaunay result;
    for (std::size_t t = begin; t < end; ++t) {
      const auto worst = check(static_cast<std::uint32_t>(t), result);
      if (!worst) continue;
      ++result.violations;
      result.deepest.push_back(*worst);
      if (result.deepest.size() > 2 * listed + 64) keep_deepest(result, listed);
    }
    keep_deepest(result, listed);
    return result;
  }

  static void keep_deepest(RestrictedDelaunay& result, std::size_t listed) {
    std::sort(result.deepest.begin(), result.deepest.end(), [](const auto& a, const auto& b) {
      return a.depth != b.depth ? a.depth > b.depth : a.triangle < b.triangle;
    });
    if (result.deepest.size() > listed) result.deepest.resize(listed);
    if (result.first_undecided.size() > listed) result.first_undecided.resize(listed);
  }

 private:
  std::optional<DelaunayViolation> check(std::uint32_t t, RestrictedDelaunay& result) const;
  const IndexedMesh& mesh_;
  const surface::Surface& surface_;
  std::span<const SurfacePoint> points_;
  const geometry::KdTree<VertexId>& tree_;
  double rounding_;  ///< Angstrom
};

std::optional<DelaunayViolation> DelaunayCheck::check(std::uint32_t t,
                                                      RestrictedDelaunay& result) const {
  const auto& corner = mesh_.triangles[t];
  const auto is_other = [&](VertexId v) {
    return std::ranges::find(corner, v.value) == corner.end();
  };
  const std::array at{&points_[corner[0]], &points_[corner[1]], &points_[corner[2]]};
  const Circumcircle circle = circumcircle(at);
  std::optional<SurfaceBall> ball;
  if (may_have_ball(at, circle)) {  // else counted as undecided
    // Of hostile meshes a ball may hold half the vertices: one that may be in it is enough.
    if (const std::optional<BallPencil> p = ball_pencil(surface_, at, circle)) {
      // The ball about o that contains every ball of the pencil.
      const double R = p->circle.radius, s = p->max_offset;
      const auto may_enter = [&](VertexId v) {
        return is_other(v) && p->depth(mesh_.positions[v.index()]).max > 0;
      };
      if (!tree_.nearest(p->circle.centre, s + std::sqrt(R * R + s * s), may_enter)) return {};
    }
    ball = exact_surface_ball(surface_, *at[0], at[1]->position, at[2]->position);
    ++result.exact_balls;
  }
  if (!ball || !ball->is_exact) {
    ++result.undecided;
    result.first_undecided.push_back(t);
    return std::nullopt;
  }
  // The deepest is the one nearest to the centre.
  const auto depth = [&](VertexId v) {
    return depth_in(*ball, mesh_.positions[v.index()], rounding_);
  };
  const auto deepest = tree_.nearest(ball->centre, std::sqrt(ball->squared_radius),
                                     [&](VertexId v) { return is_other(v) && depth(v); });
  if (!deepest) return std::nullopt;
  return DelaunayViolation{t, deepest->id.value, *depth(deepest->id)};
}

}  // namespace

RestrictedDelaunay restricted_delaunay(const IndexedMesh& mesh, const surface::Surface& surface,
                                       std::span<const SurfacePoint> points, std::size_t listed,
                                       const geometry::Run& run) {
  const geometry::KdTree<VertexId> tree(mesh.positions);
  const DelaunayCheck check(mesh, surface, points, tree);
  const std::size_t count = mesh.triangles.size();
  std::vector<RestrictedDelaunay> results(geometry::block_count(count));
  geometry::for_each_block(run.threads(), count, [&](auto begin, auto end, auto block) {
    results[block] = check.run(begin, end, listed);
  });
  RestrictedDelaunay& whole = results[0];
  for (std::size_t part = 1; part < results.size(); ++part) {
    const RestrictedDelaunay& other = results[part];
    whole.violations += other.violations;
    whole.undecided += other.undecided;
    whole.exact_balls += other.exact_balls;
    whole.deepest.insert(whole.deepest.end(), other.deepest.begin(), other.deepest.end());
    whole.first_undecided.insert(whole.first_undecided.end(), other.first_undecided.begin(),
                                 other.first_undecided.end());
  }
  DelaunayCheck::keep_deepest(whole, listed);
  return whole;
}

std::size_t local_delaunay_violations(const LocatedMesh& on,
                                      const geometry::GluedTriangles& connectivity,
                                      const DelaunayFilter& filter, unsigned threads) {
  const auto& triangles = on.mesh.triangles;
  const double rounding = rounding_of(on.mesh);
  const auto is_entered = [&](TriangleId t) {
    const LocatedMesh::CornerPoints corners = on.corners(triangles[t.index()]);
    const Corners at = corners;
    const Circumcircle circle = circumcircle(at);
    if (!may_have_ball(at, circle)) return false;
    const std::optional<BallPencil> bound = ball_pencil(on.surface, at, circle);
    std::optional<SurfaceBall> ball;
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(t, k);
      const Point& p = on.position(connectivity.apex(connectivity.twin(h)).value);
      if (bound && !(bound->depth(p).max > 0)) continue;
      if (!ball) ball = exact_surface_ball(on.surface, *at[0], at[1]->position, at[2]->position);
      if (ball->is_exact && depth_in(*ball, p, rounding)) return true;
    }
    return false;
  };
  std::vector<char> is_open(triangles.size(), 0);  // an edge is not proved Delaunay
  const std::size_t count = 3 * triangles.size();
  geometry::for_each_block(threads, count, [&](auto begin, auto end, auto) {
    for (std::size_t i = begin; i < end; ++i) {
      const HalfEdgeId h{i}, twin = connectivity.twin(h);
      filter.prefetch(
          connectivity.twin(HalfEdgeId{std::min(i + 3 * geometry::prefetch_ahead, count - 1)}));
      if (twin < h || filter.certainly_delaunay(h, twin)) continue;
      for (const HalfEdgeId side : {h, twin}) {
        std::atomic_ref(is_open[SurfaceMesh::triangle(side).index()])
            .store(1, std::memory_order_relaxed);
      }
    }
  });
  std::atomic<std::size_t> violations = 0;
  geometry::for_each_block(threads, triangles.size(), [&](auto begin, auto end, auto) {
    for (std::size_t t = begin; t < end; ++t) {
      if (is_open[t] != 0 && is_entered(TriangleId{t})) ++violations;
    }
  });
  return violations;
}

}  // namespace morskin::certify
