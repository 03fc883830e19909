#include "morskin/size_goal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "morskin/pipeline.h"

namespace morskin {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
/// Trials end when the number is as near to the one wanted, in shares, or after so many.
constexpr double near_enough = 0.05;
constexpr int max_trials = 5;

/// The limit with which a mesh has so many vertices; infinite if it always has more.
/// @param vertices_with  with a limit up to max_scale, beyond which it does not count; falling
template <class Vertices>
double limit_of(double vertices, double max_scale, const Vertices& vertices_with) {
  if (vertices_with(max_scale) >= vertices) return infinity;
  double low = max_scale, high = max_scale;
  while (vertices_with(low) < vertices) low /= 2;
  constexpr double rounding = 1e-4;
  while (high > (1 + rounding) * low) {
    const double middle = std::sqrt(low * high);
    (vertices_with(middle) > vertices ? low : high) = middle;
  }
  return high;
}

/// What a trial tells of meshes of other sizes.
class Trial {
 public:
  Trial(const surface::Mesh& mesh, double limit)
      : vertices_(static_cast<double>(mesh.surface.vertex_count())) {
    const std::size_t n = mesh.points.size();
    areas_.assign(n, 0);
    scales_.resize(n);
    for (std::size_t v = 0; v < n; ++v) {
      scales_[v] = mesh.at(geometry::VertexId{v}).length_scale;
      max_scale_ = std::max(max_scale_, scales_[v]);
    }
    for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
      const auto [a, b, c] = mesh.surface.corners(geometry::TriangleId{t});
      const geometry::Vector ab = mesh.position(b) - mesh.position(a);
      const double area = ab.cross(mesh.position(c) - mesh.position(a)).norm() / 2;
      for (const geometry::VertexId v : {a, b, c}) areas_[v.index()] += area / 3;
      area_ += area;
    }
    factor_ = vertices_ / demand(limit);
  }

  double vertices() const { return vertices_; }
  double area() const { return area_; }
  /// The limit with which a mesh has so many vertices; infinite if it always has more.
  double limit_for(double vertices) const {
    return limit_of(vertices, max_scale_, [&](double limit) { return factor_ * demand(limit); });
  }

 private:
  double demand(double limit) const {
    double sum = 0;
    for (std::size_t v = 0; v < areas_.size(); ++v) {
      const double scale = std::min(scales_[v], limit);
      sum += areas_[v] / (scale * scale);
    }
    return sum;
  }

  double vertices_, area_ = 0, max_scale_ = 0, factor_ = 1;
  std::vector<double> areas_, scales_;  ///< by vertex
};

/// A closed mesh has twice as many triangles as vertices, nearly.
double wanted_vertices(const SizeGoal& goal, double area) {
  return goal.density ? *goal.density * area : *goal.triangles / 2;
}

/// The limit of a mesh that has about what the goal asks for, by points that stand for the skin;
/// infinite if it always has more.
double estimated_limit(const skin::SkinSurface& skin, const certify::Sizing& sizing,
                       const SizeGoal& goal) {
  // Over the largest circumradius of [U], that of equilateral triangles as many as the static
  // method makes. Sweeps are coarsened to nearly as many.
  constexpr double usual_share = 0.75;
  const double radius = usual_share * sizing.C * sizing.Q;  // over the length scale
  const double vertices_per_demand = 2 / (3 * std::sqrt(3.0) * radius * radius);
  const surface::Samples samples = skin.samples();
  double area = 0, max_scale = 0;
  for (const surface::SurfacePoint& p : samples.points) {
    area += samples.each * p.length_scale * p.length_scale;
    max_scale = std::max(max_scale, p.length_scale);
  }
  const auto vertices = [&](double limit) {
    double demand = 0;
    for (const surface::SurfacePoint& p : samples.points) {
      const double ratio = std::max(1.0, p.length_scale / limit);
      demand += samples.each * ratio * ratio;
    }
    return vertices_per_demand * demand;
  };
  if (samples.points.empty()) return infinity;
  if (!(2 * wanted_vertices(goal, area) <= geometry::SurfaceMesh::max_triangles)) {
    throw geometry::RefusedInput("a mesh so dense has more triangles than there are ids, " +
                                 std::to_string(geometry::SurfaceMesh::max_triangles));
  }
  return limit_of(wanted_vertices(goal, area), max_scale, vertices);
}

}  // namespace

MethodResult mesh_of_size(const PreparedSkin& skin, MeshingOptions& options, Observer& observer,
                          const geometry::Run& run) {
  certify::Sizing& sizing = options.sizing;
  const auto limit_to = [&](double limit) {
    sizing.largest_length_scale = std::max(limit, certify::Sizing::min_size);
    options.method = method_of(skin, options);  // the same in all further trials
  };
  limit_to(estimated_limit(skin.surface, sizing, options.size_goal));
  for (int k = 1;; ++k) {
    observer.sized(sizing);
    MethodResult made = run_method(skin, options, observer, run);
    if (made.open_edges > 0 || k == max_trials) return made;
    const Trial trial(made.mesh, sizing.largest_length_scale);
    const double wanted = wanted_vertices(options.size_goal, trial.area());
    if (std::abs(trial.vertices() / wanted - 1) <= near_enough) return made;
    const double limit = trial.limit_for(wanted);
    if (limit == sizing.largest_length_scale) return made;  // as coarse as C allows
    limit_to(limit);
  }
}

double estimated_triangles(const skin::SkinSurface& skin, const certify::Sizing& sizing) {
  const surface::Samples samples = skin.samples();
  const double usual_triangle = std::sqrt(3.0) / 4 * std::pow(sizing.edge_share(), 2);
  double demand = 0;
  for (const surface::SurfacePoint& p : samples.points) {
    demand += samples.each * std::pow(p.length_scale / sizing.scale(p.length_scale), 2);
  }
  return demand / usual_triangle;
}

namespace {

/// Points of the skin over a triangle, on a grid that cuts each edge into `cuts`.
class FineGrid {
 public:
  static constexpr std::size_t cuts = 4;

  FineGrid(const skin::SkinSurface& skin, const std::array<geometry::Point, 3>& corners,
           geometry::CellId cell) {
    const auto& [a, b, c] = corners;
    for (std::size_t i = 0; i <= cuts; ++i) {
      for (std::size_t j = 0; i + j <= cuts; ++j) {
        const double to_b = static_cast<double>(i) / cuts, to_c = static_cast<double>(j) / cuts;
        const geometry::Point x = a + to_b * (b - a) + to_c * (c - a);
        points_[i][j] = skin.project(x, cell).value_or(skin.at(x, cell));
      }
    }
  }
  /// Calls visit(area, length scale) with each of the small triangles.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const {
    const auto take = [&](const SurfacePoint& p, const SurfacePoint& q, const SurfacePoint& r) {
      const geometry::Vector normal = (q.position - p.position).cross(r.position - p.position);
      visit(normal.norm() / 2, (p.length_scale + q.length_scale + r.length_scale) / 3);
    };
    for (std::size_t i = 0; i < cuts; ++i) {
      for (std::size_t j = 0; i + j < cuts; ++j) {
        take(points_[i][j], points_[i + 1][j], points_[i][j + 1]);
        if (i + j + 2 > cuts) continue;
        take(points_[i + 1][j], points_[i + 1][j + 1], points_[i][j + 1]);
      }
    }
  }

 private:
  using SurfacePoint = surface::SurfacePoint;
  std::array<std::array<SurfacePoint, cuts + 1>, cuts + 1> points_;
};

}  // namespace

BentPart bent_part(const skin::SkinSurface& skin, const MeshResult& result) {
  const double largest_area = 0.75 * std::sqrt(3) * max_provable_share * max_provable_share;
  BentPart part;
  double whole = 0, bent = 0;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& at = result.mesh.positions;
    const FineGrid grid(skin, {at[a], at[b], at[c]}, result.cells[a]);
    double area = 0, bent_here = 0;
    grid.for_each_triangle([&](double small_area, double scale) {
      area += small_area;
      if (scale >= result.sizing.largest_length_scale) return;
      bent_here += small_area;
      part.forced_triangles += small_area / (largest_area * scale * scale);
    });
    whole += area;
    bent += bent_here;
    part.triangles += bent_here / area;
  }
  part.area_share = bent / whole;
  return part;
}

}  // namespace morskin
