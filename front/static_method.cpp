#include "front/static_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/kd_tree.h"
#include "geometry/orthogonal.h"
#include "geometry/predicates.h"

namespace morskin::front {

namespace {

using geometry::Vector;
using surface::SurfacePoint;

using SeedId = geometry::Id<struct SeedTag>;

/// Least distance of two seeds over C Q times the larger length scale. A new sample keeps a
/// distance of C Q / (1 + C Q) from all others, so less than 1 costs nothing.
constexpr double min_spacing = 0.9;
/// Circumradius of a seed triangle over C Q rho: its edges are 0.7 sqrt(3) = 1.21 C Q rho long.
/// Nothing is inserted into its ball, since what is inserted keeps farther away than the radius.
constexpr double seed_radius = 0.7;

/// Where refinement gave up the triangles make no closed surface, and none is glued to another.
std::size_t open_edges(const geometry::SurfaceMesh& surface) {
  std::size_t count = 0;
  for (std::size_t h = 0; h < 3 * surface.triangle_count(); ++h) {
    count += surface.is_boundary(geometry::HalfEdgeId{h});
  }
  return count;
}

/// A critical point and two more, 60 degrees apart seen from it.
std::optional<std::array<SurfacePoint, 3>> seed_triangle(const surface::Surface& skin,
                                                         const SurfacePoint& p,
                                                         const certify::Sizing& sizing) {
  const geometry::TangentFrame tangent(p.normal);
  const double edge =
      std::sqrt(3.0) * seed_radius * sizing.C * sizing.Q * sizing.scale(p.length_scale);
  std::array<SurfacePoint, 3> triangle{p, p, p};
  for (std::size_t k = 1; k < 3; ++k) {
    const double angle = static_cast<double>(k) * M_PI / 3;
    const auto q = skin.project(p.position + edge * tangent.direction(angle), p.cell);
    if (!q) return std::nullopt;
    triangle[k] = *q;
    triangle[k].position = q->position.unaryExpr(&geometry::on_exact_grid);
  }
  return triangle;
}

}  // namespace

std::vector<SurfacePoint> delaunay_seeds(const surface::Surface& skin,
                                         const std::vector<morse::CriticalPoint>& critical,
                                         const certify::Sizing& sizing) {
  // Three positions for each critical point; those of a triangle that could not be laid stay
  // unused.
  std::vector<SurfacePoint> candidates;
  std::vector<geometry::Point> positions;
  std::vector<char> has_triangle;
  for (const morse::CriticalPoint& c : critical) {
    SurfacePoint p = c.point;
    p.position = p.position.unaryExpr(&geometry::on_exact_grid);
    const auto triangle = seed_triangle(skin, p, sizing);
    has_triangle.push_back(triangle ? 1 : 0);
    for (std::size_t k = 0; k < 3; ++k) {
      candidates.push_back(triangle ? (*triangle)[k] : p);
      positions.push_back(candidates.back().position);
    }
  }
  const geometry::KdTree<SeedId> tree(positions);
  std::vector<char> is_seed(candidates.size(), 0);
  const double share = min_spacing * sizing.C * sizing.Q;
  double largest = 0;
  for (const SurfacePoint& p : candidates) {
    largest = std::max(largest, sizing.scale(p.length_scale));
  }
  const auto is_free = [&](std::size_t i) {
    const SurfacePoint& p = candidates[i];
    // rho is 1-Lipschitz: a point nearer than share times its own rho has no larger one than this.
    const double own = sizing.scale(p.length_scale);
    const double radius = share * (share < 1 ? std::min(own / (1 - share), largest) : largest);
    bool free = true;
    tree.for_each_within(p.position, radius, [&](const auto& near) {
      const SurfacePoint& q = candidates[near.id.index()];
      const double least = share * sizing.scale(std::max(p.length_scale, q.length_scale));
      if (is_seed[near.id.index()] != 0 && near.squared_distance <= least * least) free = false;
    });
    return free;
  };
  // Whole triangles first, so that every component gets one, in the order of their length scales: a
  // point of a large component may stand nearer to a small one than its own length scale, beside it
  // in its tangent plane, but it has critical points elsewhere.
  std::vector<std::size_t> by_scale(critical.size());
  std::iota(by_scale.begin(), by_scale.end(), std::size_t{0});
  std::ranges::stable_sort(by_scale, {}, [&](auto i) { return critical[i].point.length_scale; });
  for (const std::size_t i : by_scale) {
    if (has_triangle[i] == 0) continue;
    if (!is_free(3 * i) || !is_free(3 * i + 1) || !is_free(3 * i + 2)) continue;
    for (std::size_t k = 0; k < 3; ++k) is_seed[3 * i + k] = 1;
  }
  for (std::size_t i = 0; i < critical.size(); ++i) {
    if (is_free(3 * i)) is_seed[3 * i] = 1;
  }
  std::vector<SurfacePoint> seeds;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    if (is_seed[i] != 0) seeds.push_back(candidates[i]);
  }
  return seeds;
}

StaticResult static_mesh(const surface::Surface& surface,
                         const std::vector<morse::CriticalPoint>& critical,
                         const certify::Sizing& sizing, const geometry::Run& run) {
  refine::DelaunayRefinement refinement(surface, sizing, delaunay_seeds(surface, critical, sizing));
  refinement.run(run);
  StaticResult result{refinement.mesh(), refinement.counts(), 0, refinement.is_done()};
  result.open_edges = open_edges(result.mesh.surface);
  return result;
}

}  // namespace morskin::front
