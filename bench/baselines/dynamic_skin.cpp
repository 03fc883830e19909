#include "bench/baselines/dynamic_skin.h"

#include "front/stopwatch.h"

namespace morskin::baselines {

front::Mesher dynamic_mesher(const GrowthOptions& growth, GrowthCounts* counts) {
  return [growth, counts](const front::PreparedSkin& skin, const front::MeshOptions& options) {
    GrowthOptions growing = growth;
    growing.sizing = options.sizing;
    if (options.progress) {
      growing.progress = [&](double share) { options.progress("grow", share); };
    }
    front::MethodResult result;
    front::timed(result.seconds.sweep, [&] {
      Growth run(skin.surface, growing);
      run.run();
      result.mesh = run.mesh();
      if (counts != nullptr) *counts = run.counts();
    });
    front::timed(result.seconds.refine, [&] {
      if (options.progress) options.progress("refine", 0);
      refine::Refinement refinement(skin.surface, options.sizing, result.mesh, options.threads);
      refinement.run();
      result.refinement = refinement.counts();
    });
    return result;
  };
}

}  // namespace morskin::baselines
