#include "bench/baselines/dynamic_skin.h"

#include "geometry/stopwatch.h"

namespace morskin::baselines {

morskin::Mesher dynamic_mesher(const GrowthOptions& growth, GrowthCounts* counts) {
  return [growth, counts](const morskin::PreparedSkin& skin, const morskin::MeshOptions& options) {
    GrowthOptions growing = growth;
    growing.sizing = options.sizing;
    if (options.progress) {
      growing.progress = [&](double share) { options.progress("grow", share); };
    }
    morskin::MethodResult result;
    bool has_failed = false;
    geometry::timed(result.seconds.sweep, [&] {
      // The skins of all times pass through all cells.
      const skin::SkinSurface surface(skin.surface.points(), {}, skin::MixedComplex::Keep::All);
      Growth run(surface, growing);
      run.run();
      result.mesh = run.mesh();
      for (surface::SurfacePoint& p : result.mesh.points) {
        p.cell = skin.surface.complex().same(p.cell, surface.complex());
      }
      if (counts != nullptr) *counts = run.counts();
      has_failed = run.counts().failed > 0;
    });
    if (has_failed) return result;  // not certified, and not to be refined: there may be a hole
    geometry::timed(result.seconds.refine, [&] {
      if (options.progress) options.progress("refine", 0);
      refine::Refinement refinement(skin.surface, options.sizing, result.mesh, options.threads);
      refinement.run();
      result.refinement = refinement.counts();
    });
    return result;
  };
}

}  // namespace morskin::baselines
