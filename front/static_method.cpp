#include "front/static_method.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "geometry/kd_tree.h"
#include "geometry/orthogonal.h"
#include "geometry/predicates.h"

namespace morskin::front {

namespace {

using geometry::Vector;
using surface::SurfacePoint;

using SeedId = geometry::Id<struct SeedTag>;

/// Least distance of two seeds over C Q times the larger length scale. A new sample keeps
/// C Q / (1 + C Q) times its length scale from all others, so less than 1 costs nothing.
constexpr double min_spacing = 0.9;
/// Circumradius of a seed triangle over C Q rho: its edges are 0.7 sqrt(3) = 1.21 C Q rho long.
/// Nothing is inserted into its ball for [U] while C Q < 0.214, since what is inserted keeps
/// C Q / (1 + 2 C Q) rho from a seed; with a coarser C that is not proved.
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

/// Three for each critical point, itself the first.
struct Candidates {
  std::vector<SurfacePoint> points;
  std::vector<char> has_triangle;  ///< by critical point; without one the other two stay unused
};

Candidates candidates_at(const surface::Surface& skin,
                         const std::vector<morse::CriticalPoint>& critical,
                         const certify::Sizing& sizing) {
  Candidates result;
  for (const morse::CriticalPoint& c : critical) {
    SurfacePoint p = c.point;
    p.position = p.position.unaryExpr(&geometry::on_exact_grid);
    const auto triangle = seed_triangle(skin, p, sizing);
    result.has_triangle.push_back(triangle ? 1 : 0);
    for (std::size_t k = 0; k < 3; ++k) result.points.push_back(triangle ? (*triangle)[k] : p);
  }
  return result;
}

/// Some of the candidates, which keep their distance.
class Seeds {
 public:
  Seeds(std::vector<SurfacePoint> candidates, const certify::Sizing& sizing)
      : candidates_(std::move(candidates)),
        sizing_(sizing),
        share_(min_spacing * sizing.C * sizing.Q),
        tree_(positions(candidates_)),
        is_seed_(candidates_.size(), 0) {
    for (const SurfacePoint& p : candidates_) {
      largest_ = std::max(largest_, sizing.scale(p.length_scale));
    }
  }

  /// Whether a candidate is far enough from all seeds.
  bool may_take(std::size_t i) const {
    const SurfacePoint& p = candidates_[i];
    // rho is 1-Lipschitz: a point nearer than share times its own rho has no larger one than this.
    const double own = sizing_.scale(p.length_scale);
    const double radius = share_ * (share_ < 1 ? std::min(own / (1 - share_), largest_) : largest_);
    bool is_free = true;
    tree_.for_each_within(p.position, radius, [&](const auto& near) {
      const SurfacePoint& q = candidates_[near.id.index()];
      const double least = share_ * sizing_.scale(std::max(p.length_scale, q.length_scale));
      if (is_seed_[near.id.index()] != 0 && near.squared_distance <= least * least) is_free = false;
    });
    return is_free;
  }
  void take(std::size_t i) { is_seed_[i] = 1; }

  /// In the order of the candidates.
  std::vector<SurfacePoint> list() const {
    std::vector<SurfacePoint> seeds;
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      if (is_seed_[i] != 0) seeds.push_back(candidates_[i]);
    }
    return seeds;
  }

 private:
  static std::vector<geometry::Point> positions(const std::vector<SurfacePoint>& points) {
    std::vector<geometry::Point> result;
    for (const SurfacePoint& p : points) result.push_back(p.position);
    return result;
  }

  const std::vector<SurfacePoint> candidates_;
  const certify::Sizing sizing_;
  const double share_;  ///< least distance of two over the larger length scale
  const geometry::KdTree<SeedId> tree_;
  std::vector<char> is_seed_;
  double largest_ = 0;  ///< of the length scales
};

}  // namespace

std::vector<SurfacePoint> delaunay_seeds(const surface::Surface& skin,
                                         const std::vector<morse::CriticalPoint>& critical,
                                         const certify::Sizing& sizing) {
  Candidates candidates = candidates_at(skin, critical, sizing);
  Seeds seeds(std::move(candidates.points), sizing);
  // Whole triangles first, so that every component gets one, in the order of their length scales: a
  // point of a large component may stand nearer to a small one than its own length scale, beside it
  // in its tangent plane, but it has critical points elsewhere.
  std::vector<std::size_t> by_scale(critical.size());
  std::iota(by_scale.begin(), by_scale.end(), std::size_t{0});
  std::ranges::stable_sort(by_scale, {}, [&](auto i) { return critical[i].point.length_scale; });
  for (const std::size_t i : by_scale) {
    if (candidates.has_triangle[i] == 0) continue;
    if (!seeds.may_take(3 * i) || !seeds.may_take(3 * i + 1) || !seeds.may_take(3 * i + 2))
      continue;
    for (std::size_t k = 0; k < 3; ++k) seeds.take(3 * i + k);
  }
  for (std::size_t i = 0; i < critical.size(); ++i) {
    if (seeds.may_take(3 * i)) seeds.take(3 * i);
  }
  return seeds.list();
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
