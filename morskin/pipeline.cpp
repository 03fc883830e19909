#include "morskin/pipeline.h"

#include <bit>
#include <cmath>
#include <utility>

#include "front/subdomains.h"
#include "geometry/orthogonal.h"
#include "geometry/parallel.h"
#include "geometry/stopwatch.h"
#include "morskin/pipeline_parts.h"
#include "morskin/safety_net.h"
#include "morskin/traced_complex.h"

namespace morskin {

namespace {

using geometry::Vector;

void check(const certify::Sizing& sizing) {
  const double C = sizing.C, Q = sizing.Q;
  if (!(C >= certify::Sizing::min_C && Q > 1 && 2 * C < Q && std::isfinite(C) &&
        std::isfinite(Q))) {
    throw geometry::RefusedInput("C and Q must satisfy C >= 1e-5, 2 C < Q and Q > 1");
  }
  if (!(sizing.largest_length_scale >= certify::Sizing::min_size)) {
    throw geometry::RefusedInput("the largest length scale must be at least 1e-6 Angstrom");
  }
}

void check(const SizeGoal& goal) {
  constexpr double max_triangles = geometry::SurfaceMesh::max_triangles;
  if (goal.density && goal.triangles) {
    throw geometry::RefusedInput("a mesh has a density or a number of triangles, not both");
  }
  if (!(goal.density.value_or(1) > 0 && std::isfinite(goal.density.value_or(1)))) {
    throw geometry::RefusedInput("the density must be above 0 and finite");
  }
  if (!(goal.triangles.value_or(4) >= 4 && goal.triangles.value_or(4) <= max_triangles)) {
    throw geometry::RefusedInput("a mesh has at least 4 triangles, and at most " +
                                 std::to_string(geometry::SurfaceMesh::max_triangles));
  }
}

/// Sets the method, and the sizing where a size goal wants it.
MethodResult mesh_by(const PreparedSkin& skin, MeshingOptions& options, Observer& observer,
                     const Run& run) {
  if (options.size_goal.is_set()) return mesh_of_size(skin, options, observer, run);
  options.method = method_of(skin, options);
  observer.sized(options.sizing);
  return run_method(skin, options, observer, run);
}

}  // namespace

void require_sound(const MeshingOptions& options) {
  check(options.sizing);
  check(options.size_goal);
  if (options.function) require_usable(*options.function);
  if (options.fronts && !(*options.fronts >= 1 && *options.fronts <= front::max_subdomains)) {
    throw geometry::RefusedInput("there may be 1 to " + std::to_string(front::max_subdomains) +
                                 " fronts");
  }
  if (options.fronts && !std::has_single_bit(*options.fronts)) {
    throw geometry::RefusedInput(
        "the number of fronts must be a power of two, as boxes are halved");
  }
  if (options.fronts && options.method == Method::Static) {
    throw geometry::RefusedInput("fronts are of the sweep, and the static method has none");
  }
  if (!(options.goal_deg() >= 0 && options.goal_deg() <= 60)) {
    throw geometry::RefusedInput("the goal for angles must be from 0 to 60 degrees");
  }
  if (!options.grading) return;
  if (!(*options.grading >= min_grading && std::isfinite(*options.grading))) {
    throw geometry::RefusedInput("the grading must be at least 0.01 and finite");
  }
  const bool is_other_method =
      options.mesher || options.fronts || options.method.value_or(Method::Static) != Method::Static;
  if (is_other_method || options.goal_deg() < certify::guaranteed_angle_deg) {
    throw geometry::RefusedInput(
        "grading is for the static method, with a goal of 30 degrees or more");
  }
}

MeshingOptions with_claimed_angle(MeshingOptions options) {
  if (!options.mesher && options.goal_deg() >= certify::guaranteed_angle_deg) {
    options.sizing.claimed_angle_deg = certify::guaranteed_angle_deg;
  }
  return options;
}

Parcel::Parcel(MethodResult made, const MeshingOptions& options, const Run& run)
    : result{{}, *options.method, options.sizing, {}, {}, {}, {}} {
  surface::Mesh& from = made.mesh;
  const auto list_triangles = [&] {
    geometry::SurfaceMesh::Lists lists =
        geometry::SurfaceMesh(std::move(from.surface)).turned_into_lists();
    result.mesh.triangles = std::move(lists.triangles);
    twins = std::move(lists.twins);
  };
  const auto list_vertices = [&] {
    result.mesh.positions.reserve(from.points.size());
    result.cells.reserve(from.points.size());
    geometry::visit_last(from.points, [&](auto block) {
      for (const surface::SurfacePoint& p : block) {
        result.mesh.positions.push_back(p.position);
        result.cells.push_back(p.cell);
      }
    });
    from.points = {};
  };
  geometry::do_both(run.threads(), list_triangles, list_vertices);
  static_cast<RunCounts&>(result) = std::move(made);
}

void deliver(MeshResult& result, std::vector<geometry::HalfEdgeId> twins, const Certifying& certify,
             Observer& observer, const Run& run) {
  Observer::Delivery arrived = run.stage(
      "deliver", [&] { return observer.deliver(std::exchange(result.mesh, {}), result.cells); });
  result.mesh = std::move(arrived.mesh);
  result.certificate = run.stage("certify", [&] {
    return certify(result.mesh, {std::move(twins), result.cells});
  });
  if (arrived.defect.empty()) return;
  result.certificate.certified = false;
  result.certificate.reason = std::move(arrived.defect);
}

MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& asked, Observer& observer,
                     const Run& run) {
  require_sound(asked);
  MeshingOptions options = with_claimed_angle(asked);
  if (options.grading) {
    options.sizes = size_field(skin, options, run);
    if (options.sizes) options.method = Method::Static;
  }
  MethodResult made = mesh_by(skin, options, observer, run);
  observer.finished(made.mesh);
  Parcel parcel(std::move(made), options, run);
  const Certifying certify = [&](const geometry::IndexedMesh& mesh, certify::Hints hints) {
    return certify::certify(mesh, std::move(hints), skin.surface, skin.expected(), options.sizing,
                            run);
  };
  MeshResult& result = parcel.result;
  deliver(result, std::move(parcel.twins), certify, observer, run);
  const bool is_method_free = !asked.method && !options.sizes;
  if (!result.certificate.certified && mend(skin, options, is_method_free, result, run))
    deliver(result, {}, certify, observer, run);
  return std::move(result);
}

MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& options, const Run& run) {
  Observer unobserved;
  return make_mesh(skin, options, unobserved, run);
}

double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result) {
  constexpr double share = 0.1;
  constexpr std::size_t run = 256, every = 8;  // vertices one after the other, of so many runs one
  double checksum = 0;
  double seconds = 0;
  std::size_t done = 0;
  const std::size_t count = std::min(result.cells.size(), result.mesh.positions.size());
  geometry::timed(seconds, [&] {
    for (std::size_t first = 0; first < count; first += every * run) {
      const std::size_t end = std::min(first + run, count);
      // [excerpt: floor]
      for (std::size_t v = first; v < end; ++v) {
        const surface::SurfacePoint p = skin.at(result.mesh.positions[v], result.cells[v]);
        const Vector tangent = geometry::TangentFrame(p.normal).first;
        const auto moved = skin.project(p.position + share * p.length_scale * tangent, p.cell);
        if (moved) checksum += moved->length_scale;
      }
      // [/excerpt]
      done += end - first;
    }
  });
  if (!(checksum > 0)) return 0;  // uses the sum, so that the work is not optimised away
  return seconds * static_cast<double>(count) / static_cast<double>(done);
}

}  // namespace morskin
