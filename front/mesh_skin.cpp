#include "front/mesh_skin.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "front/two_fronts.h"
#include "geometry/predicates.h"

namespace morskin::front {

namespace {

using geometry::Vector;

constexpr double largest_input = 1 << 30;  // the range of the exact predicates

void check(const MeshOptions& options) {
  const auto [C, Q] = options.sizing;
  if (!(C > 0 && Q > 1 && 2 * C < Q && std::isfinite(C) && std::isfinite(Q))) {
    throw geometry::RefusedInput("C and Q must satisfy 0 < 2 C < Q and Q > 1");
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

/// Runs a piece of work and adds its time to a stage.
template <class Work>
void timed(double& seconds, Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points, const Progress& progress) {
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
  skin::SkinSurface surface(std::move(points), progress);
  if (progress) progress("dual complex", geometry::unknown_share);
  skin::DualComplex topology = skin::dual_complex(surface);
  return {std::move(surface), topology};
}

MeshResult mesh_skin(const PreparedSkin& skin, const MeshOptions& options) {
  check(options);
  MeshResult result;
  const auto progress = [&](std::string_view stage, double share) {
    if (options.progress) options.progress(stage, share);
  };
  result.seconds.triangulate = skin.surface.triangulate_seconds();
  result.seconds.mixed_complex = skin.surface.mixed_complex_seconds();
  result.expected = skin.topology;

  morse::Guide guide;
  timed(result.seconds.critical_points, [&] {
    guide =
        morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), options.function,
                          options.sizing.tangent_disk_share(), options.threads, progress);
  });
  result.minima = guide.found[0];
  result.saddles = guide.found[1];
  result.maxima = guide.found[2];
  result.surviving_minima = guide.count(0);
  result.surviving_saddles = guide.count(1);
  result.surviving_maxima = guide.count(2);
  result.function = guide.function;

  skin::SkinMesh mesh;
  timed(result.seconds.sweep, [&] {
    SweepOptions sweeping{.sizing = options.sizing,
                          .guard = options.guard,
                          .progress = [&](double share) { progress("sweep", share); },
                          .snapshot_values = options.snapshot_values,
                          .snapshots = options.snapshots,
                          .snapshot = options.snapshot};
    SweepResult swept = options.fronts == 1
                            ? sweep_once(skin.surface, guide, sweeping)
                            : sweep_from_both_ends(skin.surface, guide, sweeping, options.threads);
    mesh = std::move(swept.mesh);
    result.operations = swept.operations;
    result.open_edges = swept.open_edges;
  });
  timed(result.seconds.refine, [&] {
    if (result.open_edges == 0) {
      refine::Refinement refinement(skin.surface, options.sizing, mesh, options.threads);
      refinement.run([&](double share) { progress("refine", share); });
      result.refinement = refinement.counts();
    }
    result.mesh.triangles = mesh.surface.triangle_list();
    mesh.surface = {};
    result.mesh.positions.reserve(mesh.points.size());
    result.cells.reserve(mesh.points.size());
    for (const SurfacePoint& p : mesh.points) {
      result.mesh.positions.push_back(p.position);
      result.cells.push_back(p.cell);
    }
    mesh.points = {};
  });
  if (options.certify) {
    progress("certify", geometry::unknown_share);
    timed(result.seconds.certify, [&] {
      result.certificate = refine::certify(result.mesh, skin.surface, skin.topology, options.sizing,
                                           options.threads);
    });
  }
  return result;
}

MeshResult mesh_skin(std::vector<geometry::WeightedPoint> points, const MeshOptions& options) {
  return mesh_skin(prepare_skin(std::move(points)), options);
}

double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result) {
  constexpr double share = 0.1;
  double checksum = 0;
  double seconds = 0;
  timed(seconds, [&] {
    const std::size_t count = std::min(result.cells.size(), result.mesh.positions.size());
    for (std::size_t v = 0; v < count; ++v) {
      const SurfacePoint p = skin.at(result.mesh.positions[v], result.cells[v]);
      // Any tangent direction: the coordinate axis farthest from the normal, made orthogonal to it.
      Eigen::Index axis = 0;
      p.normal.cwiseAbs().minCoeff(&axis);
      const Vector tangent = (Vector::Unit(axis) - p.normal[axis] * p.normal).normalized();
      const auto moved = skin.project(p.position + share * p.length_scale * tangent, p.cell);
      if (moved) checksum += moved->length_scale;
    }
  });
  return checksum > 0 ? seconds : 0;  // uses the sum, so that the work is not optimised away
}

}  // namespace morskin::front
