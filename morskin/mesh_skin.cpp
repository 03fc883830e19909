#include "morskin/mesh_skin.h"

#include <cmath>
#include <string>
#include <utility>

#include "geometry/parallel.h"
#include "geometry/predicates.h"
#include "geometry/stopwatch.h"
#include "morskin/safety_net.h"

namespace morskin {

namespace {

using geometry::Vector;

constexpr double largest_input = 1 << 30;  // the range of the exact predicates

void check(const MeshOptions& options) {
  const double C = options.sizing.C, Q = options.sizing.Q;
  if (!(C >= certify::Sizing::min_C && Q > 1 && 2 * C < Q && std::isfinite(C) &&
        std::isfinite(Q))) {
    throw geometry::RefusedInput("C and Q must satisfy C >= 1e-5, 2 C < Q and Q > 1");
  }
  if (!(options.sizing.largest_length_scale >= certify::Sizing::min_size)) {
    throw geometry::RefusedInput("the largest length scale must be at least 1e-6 Angstrom");
  }
  const bool has_snapshots = options.snapshots > 0 || !options.snapshot_values.empty();
  if (has_snapshots && options.method == Method::Sweep && !options.mesher &&
      (options.fronts != 1 || !options.snapshot)) {
    throw geometry::RefusedInput("snapshots are of one front, and need somebody to take them");
  }
  if (!(options.angle_goal_deg >= 0 && options.angle_goal_deg <= 60)) {
    throw geometry::RefusedInput("no triangle mesh has all its angles above 60 degrees");
  }
  if (!options.function) return;
  const morse::MorseFunction& f = *options.function;
  if (!f.direction.allFinite() || !f.origin.allFinite()) {
    throw geometry::RefusedInput("the Morse function's direction or point is not finite");
  }
  if (f.is_height() && !(f.direction.norm() > 0)) {
    throw geometry::RefusedInput("the height direction must be a vector that is not zero");
  }
}

}  // namespace

PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Progress& progress,
                          unsigned threads) {
  for (std::size_t i = 0; i < points.size(); ++i) {
    geometry::WeightedPoint& p = points[i];
    if (!p.position.allFinite() || !std::isfinite(p.weight) ||
        p.position.cwiseAbs().maxCoeff() > largest_input || std::abs(p.weight) > largest_input) {
      throw geometry::RefusedInput("weighted point " + std::to_string(i) +
                                   " has a coordinate or weight that is no number or beyond 2^30");
    }
    p.position = p.position.unaryExpr(&geometry::on_exact_grid);
    p.weight = geometry::on_exact_grid(p.weight);
  }
  skin::SkinSurface surface(std::move(points), progress, skin::MixedComplex::Keep::NearSkin,
                            threads);
  if (progress) progress("dual complex", geometry::unknown_share);
  skin::DualComplex topology = skin::dual_complex(surface, threads);
  surface.forget_facets();
  return {std::move(surface), topology};
}

MeshResult mesh_skin(const PreparedSkin& skin, const MeshOptions& options) {
  check(options);
  MethodResult made = run_method(skin, options);
  MeshResult result;
  static_cast<RunCounts&>(result) = made;
  result.seconds.triangulate = skin.surface.triangulate_seconds();
  result.seconds.mixed_complex = skin.surface.mixed_complex_seconds();
  result.expected = skin.topology;
  geometry::timed(result.seconds.refine, [&] {
    const auto list_triangles = [&] {
      result.mesh.triangles = made.mesh.surface.triangle_list();
      result.twins = made.mesh.surface.twins();
      made.mesh.surface = {};
    };
    const auto list_vertices = [&] {
      result.mesh.positions.reserve(made.mesh.points.size());
      result.cells.reserve(made.mesh.points.size());
      for (const surface::SurfacePoint& p : made.mesh.points) {
        result.mesh.positions.push_back(p.position);
        result.cells.push_back(p.cell);
      }
      std::vector<surface::SurfacePoint>().swap(made.mesh.points);
    };
    geometry::do_both(options.threads, list_triangles, list_vertices);
  });
  if (!options.certify) return result;
  if (options.progress) options.progress("certify", geometry::unknown_share);
  geometry::timed(result.seconds.certify, [&] {
    const auto certified = [&] {
      return certify::certify(result.mesh, {result.twins, result.cells}, skin.surface,
                              skin.topology, options.sizing, options.threads);
    };
    result.certificate = certified();
    if (!result.certificate.certified && mend(skin, options, result)) {
      result.certificate = certified();
    }
  });
  return result;
}

MeshResult mesh_skin(std::vector<geometry::WeightedPoint> points, const MeshOptions& options) {
  return mesh_skin(prepare_skin(std::move(points)), options);
}

double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result) {
  constexpr double share = 0.1;
  double checksum = 0;
  double seconds = 0;
  geometry::timed(seconds, [&] {
    const std::size_t count = std::min(result.cells.size(), result.mesh.positions.size());
    // [excerpt: floor]
    for (std::size_t v = 0; v < count; ++v) {
      const surface::SurfacePoint p = skin.at(result.mesh.positions[v], result.cells[v]);
      // Any tangent direction: the coordinate axis farthest from the normal, made orthogonal to it.
      Eigen::Index axis = 0;
      p.normal.cwiseAbs().minCoeff(&axis);
      const Vector tangent = (Vector::Unit(axis) - p.normal[axis] * p.normal).normalized();
      const auto moved = skin.project(p.position + share * p.length_scale * tangent, p.cell);
      if (moved) checksum += moved->length_scale;
    }
    // [/excerpt]
  });
  return checksum > 0 ? seconds : 0;  // uses the sum, so that the work is not optimised away
}

}  // namespace morskin
