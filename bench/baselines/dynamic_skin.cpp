#include "bench/baselines/dynamic_skin.h"

#include "geometry/error.h"

namespace morskin::baselines {

morskin::Mesher dynamic_mesher(const GrowthOptions& growth, GrowthCounts* counts) {
  return [growth, counts](const morskin::PreparedSkin& skin, const morskin::MeshingOptions& options,
                          morskin::Observer&, const morskin::Run& run) {
    GrowthOptions growing = growth;
    growing.sizing = options.sizing;
    morskin::MethodResult result;
    bool has_failed = false;
    run.stage("grow", [&] {
      // The skins of all times pass through all cells.
      const skin::SkinSurface surface(skin.surface.points(), skin::MixedComplex::Keep::All);
      Growth grown(surface, growing);
      grown.run(run);
      result.mesh = grown.mesh();
      for (surface::SurfacePoint& p : result.mesh.points) {
        p.cell = skin.surface.complex().same(p.cell, surface.complex());
      }
      if (counts != nullptr) *counts = grown.counts();
      has_failed = grown.counts().failed > 0;
    });
    if (result.mesh.surface.triangle_count() == 0) {
      throw geometry::LimitReached(
          "growth finds no mesh: the balls begin nearer to each other than doubles resolve; use "
          "--method sweep or static");
    }
    if (has_failed) return result;  // not certified, and not to be refined: there may be a hole
    run.stage("refine", [&] {
      refine::Refinement refinement(skin.surface, options.sizing, result.mesh, run);
      refinement.run();
      result.refinement = refinement.counts();
    });
    return result;
  };
}

}  // namespace morskin::baselines
