#include "refine/thinning.h"

#include <algorithm>
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
geometry::Parts bent_vertices(const Mesh& mesh, const Sizing& sizing,
                              const std::vector<Point>& except) {
  geometry::Parts parts(mesh.surface.vertex_count(), geometry::no_part);
  const auto is_excepted = [&](const SurfacePoint& p) {
    constexpr double reach = 5;  // length scales, some four edges
    return std::ranges::any_of(
        except, [&](const Point& x) { return (x - p.position).norm() < reach * p.length_scale; });
  };
  for (std::size_t i = 0; i < mesh.surface.vertex_count(); ++i) {
    const VertexId v{i};
    if (!(mesh.at(v).length_scale < sizing.largest_length_scale)) continue;
    const auto mark = [&](VertexId u) {
      if (!is_excepted(mesh.at(u))) parts[u] = 0;
    };
    mark(v);
    mesh.surface.for_each_outgoing(v, [&](HalfEdgeId h) { mark(mesh.surface.target(h)); });
  }
  return parts;
}

/// Makes the edges at these vertices Delaunay, as far as no triangle becomes too big.
void flip(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
          const geometry::Parts& bent) {
  Work work;
  for (std::size_t i = 0; i < 3 * mesh.surface.triangle_count(); ++i) {
    if (bent[mesh.surface.origin(HalfEdgeId{i})] == 0) work.to_flip.push_back(HalfEdgeId{i});
  }
  LocalOperations operations(surface, sizing, mesh, std::move(work));
  operations.keep_sizes();
  operations.flip_where_needed();
}

}  // namespace

std::size_t thin(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                 const std::vector<Point>& except, const geometry::Run& run) {
  const std::size_t at_first = mesh.surface.vertex_count();
  for (int k = 0; k < max_turns; ++k) {
    geometry::Parts bent = bent_vertices(mesh, sizing, except);
    const auto count = static_cast<double>(std::ranges::count(bent, geometry::Part{0}));
    const Subdomain subdomain(bent, 0);
    VertexMover mover(surface, sizing, mesh, AngleGoal(0), subdomain);
    for (std::size_t i = 0; i < mesh.surface.vertex_count(); ++i) mover.even_out(VertexId{i});
    flip(surface, sizing, mesh, bent);
    constexpr double whole = 1;  // of [U]
    const std::size_t removed = Coarsening(surface, sizing, mesh, whole).run(subdomain);
    mesh.surface.compact(run.threads());
    flip(surface, sizing, mesh, bent_vertices(mesh, sizing, except));
    if (static_cast<double>(removed) < least_gain * count) break;
  }
  return at_first - mesh.surface.vertex_count();
}

}  // namespace morskin::refine
