// Section 4.1, front/sweep.h: one creep.
//
// The sweep of a single ball is stopped after its bowl and after its first creep. The bowl's corner
// has 240 degrees of bare surface in front of it, so the fan has 240 / 60 = 4 triangles.

#include <vector>

#include "front/mesh_skin.h"
#include "front/two_fronts.h"
#include "papers/steps/step.h"

int main() {
  using namespace morskin;
  const front::PreparedSkin skin = front::prepare_skin({{{0, 0, 0}, 2.0}});
  const morse::Guide guide =
      morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), {},
                        refine::Sizing{}.tangent_disk_share());
  struct Done {
    front::Operation operation;
    std::size_t triangles;
  };
  std::vector<Done> done;
  front::SweepOptions options;
  options.operation = [&](front::Operation operation, std::size_t triangles) {
    done.push_back({operation, triangles});
  };
  const front::SweepResult swept = front::sweep_once(skin.surface, guide, options);
  const std::size_t bowl = done.at(0).triangles, fan = done.at(1).triangles - bowl;
  std::printf("the bowl: %zu triangles; the first creep: %zu more\n", bowl, fan);
  std::printf("in all %zu triangles, %zu creeps, %zu wings, %zu front edges left open\n",
              swept.mesh.surface.triangle_count(), swept.operations.creep, swept.operations.wing,
              swept.open_edges);
  return step::claim("a fan has as many triangles as its angle has 60 degrees",
                     bowl == 6 && done[1].operation == front::Operation::Creep && fan == 4 &&
                         swept.open_edges == 0);
}
