#include "front/static_method.h"

#include <utility>

#include "geometry/predicates.h"
#include "morskin/method.h"

namespace morskin {

MethodResult static_method(const PreparedSkin& skin, const MeshingOptions& options,
                           const Run& run) {
  MethodResult result;
  const skin::SkinSurface surface(skin.surface.points(), skin::MixedComplex::Keep::All, run);
  const morse::ChosenFunction chosen = run.stage("critical points", [&] {
    return morse::choose_function(surface, skin.topology.skin_euler_characteristic(),
                                  options.function);
  });
  for (int index = 0; index < 3; ++index) {
    const auto i = static_cast<std::size_t>(index);
    result.critical_points[i] = result.surviving_points[i] = chosen.critical.count(index);
  }
  result.function = chosen.function;
  run.stage("refine", [&] {
    const SizedSurface sized(surface, options.sizes);
    std::vector<morse::CriticalPoint> seeds = chosen.critical.points;
    for (morse::CriticalPoint& seed : seeds) seed.point = sized.sized(seed.point);
    front::StaticResult refined = front::static_mesh(*sized, seeds, options.sizing, run);
    result.mesh = std::move(refined.mesh);
    for (surface::SurfacePoint& p : result.mesh.points) {
      p.cell = skin.surface.complex().same(p.cell, surface.complex());
    }
    result.open_edges = refined.open_edges;
    if (result.open_edges == 0) {
      // Where C is coarse, samples that show the skin's topology stand nearer to others than [L]
      // allows. Once the mesh is a surface most of them are not needed any more; but [L] can be
      // done without, and triangles that are too big cannot.
      const SizedSurface kept(skin.surface, options.sizes);
      surface::Mesh contracted = result.mesh;
      refine::Refinement contraction(*kept, options.sizing, contracted, run);
      refined.is_done ? contraction.run_from_short_edges() : contraction.run();
      if (!contraction.leaves_big_triangles()) {
        result.mesh = std::move(contracted);
        result.refinement = contraction.counts();
      }
    } else {
      result.refinement.refused = refined.counts.refused;
    }
    result.refinement.insert += refined.counts.too_big + refined.counts.thin;
  });
  return result;
}

std::optional<surface::Mesh> refine_angles_in_space(const PreparedSkin& skin,
                                                    const surface::Mesh& mesh,
                                                    const MeshingOptions& options,
                                                    double min_angle_deg, const Run& run) {
  const skin::SkinSurface surface(skin.surface.points(), skin::MixedComplex::Keep::All, run);
  return run.stage("refine angles in space", [&]() -> std::optional<surface::Mesh> {
    std::vector<surface::SurfacePoint> seeds(mesh.points.begin(), mesh.points.end());
    for (surface::SurfacePoint& p : seeds) {
      p.position = p.position.unaryExpr(&geometry::on_exact_grid);
      p.cell = surface.complex().same(p.cell, skin.surface.complex());
    }
    const SizedSurface sized(surface, options.sizes);
    refine::DelaunayRefinement refinement(*sized, options.sizing, seeds, min_angle_deg);
    refinement.run(run);
    surface::Mesh refined = refinement.mesh();
    if (geometry::validate(refined.surface)) return std::nullopt;
    for (surface::SurfacePoint& p : refined.points) {
      p.cell = skin.surface.complex().same(p.cell, surface.complex());
    }
    return refined;
  });
}

}  // namespace morskin
