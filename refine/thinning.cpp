#include "refine/thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "refine/coarsening.h"
#include "refine/local_operations.h"
#include "refine/vertex_mover.h"

namespace morskin::refine {

namespace {

/// Turns end when one takes out a smaller share of the bent part's vertices.
constexpr double least_gain = 0.005;
constexpr int max_turns = 5;

/// By vertex, 0 where the length scale decides the size of the triangles and not a length, and at
/// the neighbours: else nothing could be done at the border, and most bent parts are small.
geometry::Parts bent_vertices(const Mesh& mesh, const Sizing& sizing) {
  geometry::Parts parts(mesh.surface.vertex_count(), geometry::no_part);
  for (std::size_t i = 0; i < mesh.surface.vertex_count(); ++i) {
    const VertexId v{i};
    if (!(mesh.at(v).length_scale < sizing.largest_length_scale)) continue;
    parts[v] = 0;
    mesh.surface.for_each_outgoing(v, [&](HalfEdgeId h) { parts[mesh.surface.target(h)] = 0; });
  }
  return parts;
}

/// Whether a triangle meets [L] and [U], faces outward and could be proved.
bool is_good(const surface::Surface& surface, const Sizing& sizing, const Mesh& mesh,
             TriangleId t) {
  const auto [a, b, c] = mesh.surface.corners(t);
  const std::array p{&mesh.at(a), &mesh.at(b), &mesh.at(c)};
  for (std::size_t k = 0; k < 3; ++k) {
    if (sizing.is_too_short(*p[k], *p[(k + 1) % 3])) return false;
  }
  const Circumcircle circle = circumcircle(p);
  return sizing.triangle_ratio(circle.radius, surface::min_length_scale(p)) < 1 &&
         is_upright(circle.doubled_area, *p[0], *p[1], *p[2]) && expects_tube(surface, sizing, p);
}

/// Moves the bent vertices to the means of their neighbours. Then the corners of a triangle that is
/// no longer good go back, until there is none: proofs are dear, and so each triangle has about
/// one, in place of one for each corner that moves.
void even_out(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
              const Subdomain& bent) {
  const std::vector<SurfacePoint> before(mesh.points.begin(), mesh.points.end());
  VertexMover mover(surface, sizing, mesh, AngleGoal(0), bent);
  std::vector<char> has_moved(before.size(), 0);
  for (std::size_t i = 0; i < before.size(); ++i) has_moved[i] = mover.even_out(VertexId{i});
  std::vector<TriangleId> waiting;
  const auto may_be_bad = [&](TriangleId t) {
    return std::ranges::any_of(mesh.surface.corners(t),
                               [&](VertexId v) { return has_moved[v.index()] != 0; });
  };
  for (std::size_t t = 0; t < mesh.surface.triangle_count(); ++t) {
    if (may_be_bad(TriangleId{t})) waiting.push_back(TriangleId{t});
  }
  while (!waiting.empty()) {
    const TriangleId t = waiting.back();
    waiting.pop_back();
    if (!may_be_bad(t) || is_good(surface, sizing, mesh, t)) continue;
    for (const VertexId v : mesh.surface.corners(t)) {
      if (std::exchange(has_moved[v.index()], 0) == 0) continue;
      mesh.points[v] = before[v.index()];
      mesh.surface.for_each_outgoing(
          v, [&](HalfEdgeId h) { waiting.push_back(SurfaceMesh::triangle(h)); });
    }
  }
}

/// Makes the edges at these vertices Delaunay, as far as no triangle becomes too big.
void flip(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
          const geometry::Parts& bent) {
  Work work;
  for (std::size_t i = 0; i < 3 * mesh.surface.triangle_count(); ++i) {
    const HalfEdgeId h{i}, twin = mesh.surface.twin(h);
    const bool is_bent = bent[mesh.surface.origin(h)] == 0 || bent[mesh.surface.origin(twin)] == 0;
    if (h < twin && is_bent) work.to_flip.push_back(h);
  }
  LocalOperations operations(surface, sizing, mesh, std::move(work));
  operations.keep_sizes();
  operations.flip_where_needed();
}

}  // namespace

std::size_t thin(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                 const geometry::Run& run) {
  const std::size_t at_first = mesh.surface.vertex_count();
  for (int k = 0; k < max_turns; ++k) {
    geometry::Parts bent = bent_vertices(mesh, sizing);
    const auto count = static_cast<double>(std::ranges::count(bent, geometry::Part{0}));
    const Subdomain subdomain(bent, 0);
    even_out(surface, sizing, mesh, subdomain);
    flip(surface, sizing, mesh, bent);
    constexpr double whole = 1;  // of [U]
    const std::size_t removed = Coarsening(surface, sizing, mesh, whole).run(subdomain);
    mesh.surface.compact(run.threads());
    if (static_cast<double>(removed) < least_gain * count) break;
  }
  flip(surface, sizing, mesh, bent_vertices(mesh, sizing));
  return at_first - mesh.surface.vertex_count();
}

std::size_t thicken(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                    const std::vector<Point>& places, double radius, const geometry::Run& run) {
  const auto is_near_place = [&](VertexId v) {
    const SurfacePoint& p = mesh.at(v);
    return std::ranges::any_of(
        places, [&](const Point& x) { return (x - p.position).norm() < radius * p.length_scale; });
  };
  Work work;
  for (std::size_t i = 0; i < mesh.surface.triangle_count(); ++i) {
    const TriangleId t{i};
    if (std::ranges::none_of(mesh.surface.corners(t), is_near_place)) continue;
    work.big.push_back(t);
    for (std::uint32_t k = 0; k < 3; ++k) work.to_flip.push_back(SurfaceMesh::half_edge(t, k));
  }
  const std::size_t triangles = work.big.size();
  Sizing finer = sizing;  // with the same [L]
  finer.C *= std::sqrt(Sizing::spare_limit);
  finer.Q *= std::sqrt(Sizing::spare_limit);
  LocalOperations operations(surface, finer, mesh, std::move(work));
  operations.flip_where_needed();
  operations.insert_into_big_triangles(triangles);
  operations.contract_short_edges();
  mesh.surface.compact(run.threads());
  return operations.counts().insert;
}

}  // namespace morskin::refine
