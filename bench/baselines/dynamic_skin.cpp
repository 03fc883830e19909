#include "bench/baselines/dynamic_skin.h"

#include <chrono>

namespace morskin::baselines {

namespace {

template <class Work>
double seconds_of(Work work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

front::PreparedSkin grown_skin(const front::PreparedSkin& skin, double end) {
  std::vector<geometry::WeightedPoint> points = skin.surface.points();
  for (geometry::WeightedPoint& p : points) p.weight += end;
  return front::prepare_skin(std::move(points));
}

DynamicResult mesh_dynamically(const front::PreparedSkin& skin, const front::PreparedSkin& last,
                               const DynamicOptions& options) {
  DynamicResult result;
  skin::SkinMesh mesh;
  result.growth_seconds = seconds_of([&] {
    Growth growth(skin.surface, options.growth);
    growth.run();
    mesh = growth.mesh();
    result.growth = growth.counts();
  });
  result.refine_seconds = seconds_of([&] {
    refine::Refinement refinement(last.surface, options.growth.sizing, mesh, options.threads);
    refinement.run();
    result.refinement = refinement.counts();
  });
  result.mesh.triangles = mesh.surface.triangle_list();
  for (const SurfacePoint& p : mesh.points) {
    result.mesh.positions.push_back(p.position);
    result.cells.push_back(p.cell);
  }
  if (options.certify) {
    result.certify_seconds = seconds_of([&] {
      result.certificate = refine::certify(result.mesh, last.surface, last.topology,
                                           options.growth.sizing, options.threads);
    });
  }
  return result;
}

}  // namespace morskin::baselines
