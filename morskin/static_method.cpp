#include "front/static_method.h"

#include <string>
#include <utility>

#include "geometry/stopwatch.h"
#include "morskin/method.h"
#include "refine/refinement.h"

namespace morskin {

MethodResult static_method(const PreparedSkin& skin, const MeshOptions& options) {
  MethodResult result;
  const auto progress = [&](std::string_view stage) {
    if (options.progress) options.progress(stage, geometry::unknown_share);
  };
  const skin::SkinSurface surface(skin.surface.points(), {}, skin::MixedComplex::Keep::All);
  progress("critical points");
  morse::ChosenFunction chosen;
  geometry::timed(result.seconds.critical_points, [&] {
    chosen = morse::choose_function(surface, skin.topology.skin_euler_characteristic(),
                                    options.function);
  });
  result.minima = result.surviving_minima = chosen.critical.count(0);
  result.saddles = result.surviving_saddles = chosen.critical.count(1);
  result.maxima = result.surviving_maxima = chosen.critical.count(2);
  result.function = chosen.function;
  progress("refine");
  geometry::timed(result.seconds.refine, [&] {
    front::StaticResult refined = front::static_mesh(
        surface, chosen.critical.points, options.sizing,
        [&](std::size_t samples) { progress("refine, " + std::to_string(samples) + " samples"); });
    result.mesh = std::move(refined.mesh);
    for (surface::SurfacePoint& p : result.mesh.points) {
      p.cell = skin.surface.complex().same(p.cell, surface.complex());
    }
    result.refinement.insert = refined.counts.too_big + refined.counts.topological;
    result.refinement.refused = refined.counts.refused;
    result.open_edges = refined.open_edges;
  });
  if (result.open_edges > 0) return result;
  // Where C is coarse, samples that show the skin's topology stand nearer to others than [L]
  // allows. Once the mesh is a surface most of them are not needed any more.
  geometry::timed(result.seconds.refine, [&] {
    refine::Refinement contraction(skin.surface, options.sizing, result.mesh, options.threads);
    contraction.run();
    const std::size_t inserted = result.refinement.insert;
    result.refinement = contraction.counts();
    result.refinement.insert += inserted;
  });
  return result;
}

}  // namespace morskin
