#include "morskin/pipeline.h"

#include <cmath>
#include <utility>

#include "front/subdomains.h"
#include "geometry/orthogonal.h"
#include "geometry/parallel.h"
#include "geometry/stopwatch.h"
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
    throw geometry::RefusedInput("the density must be above 0");
  }
  if (!(goal.triangles.value_or(4) >= 4 && goal.triangles.value_or(4) <= max_triangles)) {
    throw geometry::RefusedInput("a mesh has at least 4 triangles, and at most " +
                                 std::to_string(geometry::SurfaceMesh::max_triangles));
  }
}

void check(const MeshingOptions& options) {
  check(options.sizing);
  check(options.size_goal);
  if (options.function) require_usable(*options.function);
  if (options.fronts && !(*options.fronts >= 1 && *options.fronts <= front::max_subdomains)) {
    throw geometry::RefusedInput("there may be 1 to " + std::to_string(front::max_subdomains) +
                                 " fronts, not " + std::to_string(*options.fronts));
  }
  if (!(options.goal_deg() >= 0 && options.goal_deg() <= 60)) {
    throw geometry::RefusedInput("no triangle mesh has all its angles above 60 degrees");
  }
  if (!options.grading) return;
  if (!(*options.grading >= min_grading && std::isfinite(*options.grading))) {
    throw geometry::RefusedInput("the grading must be at least 0.01");
  }
  const bool is_other_method = options.mesher || options.fronts == 1 ||
                               options.method.value_or(Method::Static) != Method::Static;
  if (is_other_method || options.goal_deg() < certify::guaranteed_angle_deg) {
    throw geometry::RefusedInput(
        "grading is for the static method, with a goal of 30 degrees or more");
  }
}

/// A mesh on its way from the mesher to the certificate, with what is known of it.
struct Parcel {
  geometry::IndexedMesh mesh;
  std::vector<geometry::CellId> cells;      ///< by vertex
  std::vector<geometry::HalfEdgeId> twins;  ///< by half-edge; none when the safety net made it

  /// Empties the mesh that it is made from, so that little is there twice.
  Parcel(surface::Mesh& from, const Run& run) {
    const auto list_triangles = [&] {
      const geometry::SurfaceMesh connectivity = std::move(from.surface);  // freed here
      mesh.triangles = connectivity.triangle_list();
      twins = connectivity.twins();
    };
    const auto list_vertices = [&] {
      mesh.positions.reserve(from.points.size());
      cells.reserve(from.points.size());
      for (const surface::SurfacePoint& p : from.points) {
        mesh.positions.push_back(p.position);
        cells.push_back(p.cell);
      }
      from.points = {};
    };
    geometry::do_both(run.threads(), list_triangles, list_vertices);
  }
};

/// Delivers a mesh and certifies what has arrived.
class Delivering {
 public:
  Delivering(const PreparedSkin& skin, const certify::Sizing& sizing, Observer& observer,
             const Run& run)
      : skin_(skin), sizing_(sizing), observer_(observer), run_(run) {}

  void operator()(MeshResult& result, std::span<const geometry::HalfEdgeId> twins) const {
    Observer::Delivery arrived = run_.stage(
        "deliver", [&] { return observer_.deliver(std::exchange(result.mesh, {}), result.cells); });
    result.mesh = std::move(arrived.mesh);
    result.certificate = run_.stage("certify", [&] {
      return certify::certify(result.mesh, {twins, result.cells}, skin_.surface, skin_.expected(),
                              sizing_, run_);
    });
    if (arrived.defect.empty()) return;
    result.certificate.certified = false;
    result.certificate.reason = std::move(arrived.defect);
  }

 private:
  const PreparedSkin& skin_;
  const certify::Sizing& sizing_;
  Observer& observer_;
  const Run& run_;
};

}  // namespace

MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& asked, Observer& observer,
                     const Run& run) {
  check(asked);
  MeshingOptions options = asked;
  if (!options.mesher && options.goal_deg() >= certify::guaranteed_angle_deg) {
    options.sizing.claimed_angle_deg = certify::guaranteed_angle_deg;
  }
  if (options.grading) {
    options.sizes = size_field(skin, options, run);
    if (options.sizes) options.method = Method::Static;
  }
  if (options.size_goal.is_set()) settle_size(skin, options, run);
  observer.sized(options.sizing);
  const Method method = method_of(skin, options);
  options.method = method;
  MethodResult made = run_method(skin, options, observer, run);
  Parcel parcel(made.mesh, run);
  MeshResult result{std::move(made),
                    method,
                    options.sizing,
                    std::move(parcel.mesh),
                    std::move(parcel.cells),
                    {},
                    {}};
  const Delivering deliver(skin, options.sizing, observer, run);
  deliver(result, parcel.twins);
  const bool is_method_free = !asked.method && !options.sizes;
  if (!result.certificate.certified && mend(skin, options, is_method_free, result, run))
    deliver(result, {});
  return result;
}

MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& options, const Run& run) {
  Observer unobserved;
  return make_mesh(skin, options, unobserved, run);
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
      const Vector tangent = geometry::TangentFrame(p.normal).first;
      const auto moved = skin.project(p.position + share * p.length_scale * tangent, p.cell);
      if (moved) checksum += moved->length_scale;
    }
    // [/excerpt]
  });
  return checksum > 0 ? seconds : 0;  // uses the sum, so that the work is not optimised away
}

}  // namespace morskin
