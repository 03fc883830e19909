#include "morskin/implicit_mesh.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <set>
#include <utility>

#include "certify/tube.h"
#include "geometry/files/text_lines.h"
#include "geometry/kd_tree.h"
#include "geometry/mesh_shape.h"
#include "geometry/orthogonal.h"
#include "morskin/pipeline_parts.h"

namespace morskin {

namespace {

using geometry::Point;
using geometry::Vector;
using surface::CellId;

constexpr CellId only_cell{0U};

/// The critical point with its first-order data and, at a saddle, the directions of steepest
/// descent and ascent: the surface's height over the tangent plane has the Hessian -H / (grad f .
/// height).
morse::CriticalPoint critical_point(const implicit::PreparedSurface& prepared,
                                    const implicit::CriticalHeight& found,
                                    const morse::MorseFunction& function) {
  const implicit::ImplicitSurface& surface = prepared.surface;
  morse::CriticalPoint result{surface.at(found.position, only_cell), found.index,
                              function(found.position)};
  if (found.index != 1) return result;
  const auto bounds = surface.function().bounds({found.position, 0});
  Eigen::Matrix3d H;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      const std::size_t k =
          implicit::symmetric_index[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)];
      H(i, j) = bounds.hessian[k].middle();
    }
  }
  const geometry::TangentFrame frame(result.point.normal);
  Eigen::Matrix<double, 3, 2> tangents;
  tangents << frame.first, frame.second;
  const double up = result.point.normal.dot(function.direction) > 0 ? 1 : -1;
  const Eigen::Matrix2d bend = -up * tangents.transpose() * H * tangents;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(bend);
  result.descending = tangents * solver.eigenvectors().col(0);
  result.ascending = tangents * solver.eigenvectors().col(1);
  return result;
}

/// The sweep's guide: all critical points, none simplified away, in spheres that do not overlap.
/// @param radius_share  of a sphere over the length scale, at most
morse::Guide guide_of(const implicit::PreparedSurface& prepared, double radius_share) {
  morse::Guide guide;
  guide.is_simplified = false;
  guide.function = morse::MorseFunction::height(prepared.critical.directions.height());
  guide.found = prepared.critical.counts();
  std::vector<morse::ProtectingSpheres::Incidence> incidences;
  for (const implicit::CriticalHeight& found : prepared.critical.points) {
    incidences.emplace_back(only_cell, morse::CriticalId{guide.points.size()});
    guide.points.push_back(critical_point(prepared, found, guide.function));
  }
  guide.spheres = {guide.points, morse::disjoint_radii(guide.points, radius_share),
                   std::move(incidences), 1};
  return guide;
}

/// By vertex, the component of the mesh, of those numbered by their first triangle; no_index for a
/// vertex of no triangle.
std::vector<std::uint32_t> components_of_triangles(const geometry::IndexedMesh& mesh) {
  const std::vector<std::uint32_t> by_first_vertex = geometry::vertex_components(mesh);
  std::vector<std::uint32_t> by_first_triangle(mesh.positions.size(), geometry::no_index);
  std::vector<std::uint32_t> result(mesh.positions.size(), geometry::no_index);
  std::uint32_t count = 0;
  for (const auto& triangle : mesh.triangles) {
    std::uint32_t& component = by_first_triangle[by_first_vertex[triangle[0]]];
    if (component == geometry::no_index) component = count++;
    for (const std::uint32_t v : triangle) result[v] = component;
  }
  return result;
}

/// Whether a vertex flows to the component of the surface that a critical point lies on.
///
/// Two points p and q of the surface with |p - q| = l <= 0.8 rho(p) lie on one component. For at a
/// distance s from p on the segment |G| <= s (l - s), and after a length t along the normal at p G
/// has changed by 2 (rho - s) t - t^2 at least, which reaches s (l - s) where s + t < rho still, as
/// l < (sqrt 8 - 2) rho. So there is one crossing, which depends continuously on s.
constexpr double max_share = 0.8;
bool leads_to_component(const Point& vertex, const implicit::CriticalHeight& minimum,
                        const surface::Surface& surface) {
  constexpr double up = 1 + 1e-9;
  const surface::Enclosure at_minimum = surface.enclose(minimum.position, only_cell);
  const double rho = at_minimum.half_gradient.norm() - at_minimum.error - minimum.doubt;
  const surface::Enclosure at_vertex = surface.enclose(vertex, only_cell);
  const double path = certify::max_flow_path(at_vertex.half_gradient.norm() - at_vertex.error,
                                             at_vertex.max_value());
  const double distance = (vertex - minimum.position).norm() + minimum.doubt + path;
  return up * distance < max_share * rho;
}

/// What the critical points and the mesh tell together.
struct Expected {
  surface::Topology topology;
  /// A minimum whose component of the surface is not shown to be covered, if there is one. How many
  /// such components there are is not known, so that no number of the mesh's is the right one.
  std::optional<Point> missed;
};

Expected expected_topology(const geometry::IndexedMesh& mesh,
                           const implicit::PreparedSurface& prepared) {
  Expected result;
  std::set<std::uint32_t> reached;
  const auto components = components_at_minima(mesh, prepared);
  std::size_t minimum = 0;
  for (const implicit::CriticalHeight& p : prepared.critical.points) {
    if (p.index != 0) continue;
    if (const auto& component = components[minimum++]) {
      reached.insert(*component);
    } else if (!result.missed) {
      result.missed = p.position;
    }
  }
  surface::Topology& topology = result.topology;
  topology.components = reached.size() + (result.missed ? 1 : 0);
  topology.euler_characteristic = prepared.critical.euler_characteristic();
  const long genus = static_cast<long>(topology.components) - topology.euler_characteristic / 2;
  topology.genus = static_cast<std::size_t>(std::max(0L, genus));
  return result;
}

/// Why the counts tell nothing; empty where they do.
std::string objection_to_counts(const implicit::PreparedSurface& prepared,
                                const Expected& expected) {
  const bool is_complete = prepared.critical.is_complete();
  if (is_complete && !expected.missed) return "";
  const Point& at = is_complete ? *expected.missed : prepared.critical.undecided.front();
  if (!is_complete) {
    return "whether the height has a critical point near " + geometry::in_words(at) +
           " could not be decided; try another --height";
  }
  return "no vertex is near enough to the minimum at " + geometry::in_words(at) +
         " to show that the mesh covers its component";
}

void require_usable_here(const MeshingOptions& options) {
  require_sound(options);
  const bool is_function_usable = !options.function || options.function->is_height();
  if (!is_function_usable) {
    throw geometry::RefusedInput("other surfaces than skins are swept along a height");
  }
  const bool is_sweep = options.method.value_or(Method::Sweep) == Method::Sweep &&
                        !options.mesher && options.guard == front::Guard::Everywhere;
  if (!is_sweep || options.grading || options.size_goal.is_set()) {
    throw geometry::RefusedInput(
        "other surfaces than skins have the sweep only, without grading, density or number of "
        "triangles");
  }
}

}  // namespace

std::vector<std::optional<std::uint32_t>> components_at_minima(
    const geometry::IndexedMesh& mesh, const implicit::PreparedSurface& prepared) {
  const std::vector<std::uint32_t> component = components_of_triangles(mesh);
  std::vector<Point> positions;  // finite ones, or the tree is in no order
  std::vector<std::uint32_t> vertex;
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    if (component[v] == geometry::no_index || !mesh.positions[v].allFinite()) continue;
    positions.push_back(mesh.positions[v]);
    vertex.push_back(v);
  }
  const geometry::KdTree<geometry::VertexId> tree(positions);
  std::vector<std::optional<std::uint32_t>> result;
  for (const implicit::CriticalHeight& p : prepared.critical.points) {
    if (p.index != 0) continue;
    result.emplace_back();
    const double rho = prepared.surface.length_scale(p.position, only_cell);
    const auto nearest = tree.nearest(p.position, max_share * rho);
    if (!nearest) continue;
    const std::uint32_t v = vertex[nearest->id.index()];
    if (leads_to_component(mesh.positions[v], p, prepared.surface)) result.back() = component[v];
  }
  return result;
}

certify::Certificate certify_implicit(const geometry::IndexedMesh& mesh, certify::Hints hints,
                                      const implicit::PreparedSurface& prepared,
                                      const certify::Sizing& sizing, const Run& run) {
  const Expected expected = expected_topology(mesh, prepared);
  certify::Certificate result =
      certify::certify(mesh, std::move(hints), prepared.surface, expected.topology, sizing, run);
  const std::string objection = objection_to_counts(prepared, expected);
  if (objection.empty() || !result.holds(certify::Claim::Manifold)) return result;
  // In place of what was found against an incomplete count.
  result.broken[static_cast<std::size_t>(certify::Claim::Counts)] = objection;
  result.reason.clear();
  result.conclude(sizing);
  return result;
}

MeshResult make_mesh(const implicit::PreparedSurface& prepared, const MeshingOptions& asked,
                     Observer& observer, const Run& run) {
  require_usable_here(asked);
  MeshingOptions options = with_claimed_angle(asked);
  options.method = Method::Sweep;
  observer.sized(options.sizing);
  const certify::Sizing laid = options.sizing.laid();
  const double rho = prepared.surface.max_length_scale();
  const morse::Guide guide =
      guide_of(prepared, laid.tangent_disk_share() * (laid.scale(rho) / rho));
  MethodResult made = sweep_along(prepared.surface, guide, options, nullptr, observer, run);
  if (made.open_edges == 0 && options.goal_deg() > 0) {
    raise_angles(prepared.surface, options, made, run);
  }
  observer.finished(made.mesh);
  Parcel parcel(std::move(made), options, run);
  const Certifying certify = [&](const geometry::IndexedMesh& mesh, certify::Hints hints) {
    return certify_implicit(mesh, std::move(hints), prepared, options.sizing, run);
  };
  deliver(parcel.result, std::move(parcel.twins), certify, observer, run);
  return std::move(parcel.result);
}

}  // namespace morskin
