#include "morskin/size_goal.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "morskin/pipeline.h"
#include "morskin/size_estimate.h"

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

/// The limit of a mesh that has about what the goal asks for; infinite if it always has more.
double estimated_limit(const PreparedSkin& skin, const SizeEstimate& estimate,
                       MeshingOptions options) {
  if (!(estimate.area() > 0)) return infinity;
  const double wanted = wanted_vertices(options.size_goal, estimate.area());
  if (!(2 * wanted <= geometry::SurfaceMesh::max_triangles)) {
    throw geometry::RefusedInput("a mesh so dense has more triangles than there are ids, " +
                                 std::to_string(geometry::SurfaceMesh::max_triangles) +
                                 "; ask for less");
  }
  return limit_of(wanted, estimate.max_length_scale(), [&](double limit) {
    options.sizing.largest_length_scale = limit;
    return estimate.vertices(options.sizing, method_of(skin, options));
  });
}

}  // namespace

MethodResult mesh_of_size(const PreparedSkin& skin, MeshingOptions& options, Observer& observer,
                          const geometry::Run& run) {
  certify::Sizing& sizing = options.sizing;
  const auto limit_to = [&](double limit) {
    sizing.largest_length_scale = std::max(limit, certify::Sizing::min_size);
    options.method = method_of(skin, options);  // the same in all further trials
  };
  // The first decides on the method; the second is by that, for the number jumps between methods.
  const SizeEstimate estimate(skin);
  for (int k = 0; k < 2; ++k) limit_to(estimated_limit(skin, estimate, options));
  for (int k = 1;; ++k) {
    observer.sized(sizing);
    MethodResult made = run_method(skin, options, observer, run);
    // Without triangles there is nothing to tell other sizes by.
    const bool is_empty = made.mesh.surface.triangle_count() == 0;
    if (made.open_edges > 0 || is_empty || k == max_trials) return made;
    const Trial trial(made.mesh, sizing.largest_length_scale);
    const double wanted = wanted_vertices(options.size_goal, trial.area());
    if (std::abs(trial.vertices() / wanted - 1) <= near_enough) return made;
    const double limit = trial.limit_for(wanted);
    if (limit == sizing.largest_length_scale) return made;  // as coarse as C allows
    limit_to(limit);
  }
}

}  // namespace morskin
