#include "refine/thinning.h"

#include <algorithm>
#include <utility>

#include "refine/coarsening.h"
#include "refine/refinement.h"
#include "refine/vertex_mover.h"

namespace morskin::refine {

namespace {

/// Turns end when one takes out a smaller share of the bent part's vertices.
constexpr double least_gain = 0.01;
constexpr int max_turns = 3;

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

/// One turn. @return whether the mesh is as well refined as before
bool turn(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh, geometry::Parts& parts,
          const geometry::Run& run) {
  const Subdomain bent(parts, 0);
  VertexMover mover(surface, sizing, mesh, AngleGoal(0), bent);
  for (std::size_t i = 0; i < mesh.surface.vertex_count(); ++i) mover.even_out(VertexId{i});
  constexpr double whole = 1;  // of [U]
  Coarsening(surface, sizing, mesh, whole).run(bent);
  mesh.surface.compact(run.threads());
  Refinement refinement(surface, sizing, mesh, run);
  refinement.run();
  return refinement.counts().refused == 0;
}

}  // namespace

std::size_t thin(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                 const geometry::Run& run) {
  const std::size_t at_first = mesh.surface.vertex_count();
  for (int k = 0; k < max_turns; ++k) {
    Mesh thinner = mesh;
    geometry::Parts parts = bent_vertices(mesh, sizing);
    const auto bent = static_cast<double>(std::ranges::count(parts, geometry::Part{0}));
    const bool is_refined = turn(surface, sizing, thinner, parts, run);
    const std::size_t before = mesh.surface.vertex_count(), after = thinner.surface.vertex_count();
    if (!is_refined || after >= before) break;
    mesh = std::move(thinner);
    if (static_cast<double>(before - after) < least_gain * bent) break;
  }
  return at_first - mesh.surface.vertex_count();
}

}  // namespace morskin::refine
