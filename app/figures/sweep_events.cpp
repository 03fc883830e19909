#include "app/figures/sweep_events.h"

#include "morse/make_guide.h"

namespace morskin::figures {

RecordedSweep recorded_sweep(const morskin::PreparedSkin& skin, double C) {
  RecordedSweep record;
  const certify::Sizing sizing{.C = C};
  std::size_t before = 0;
  front::OperationObserver recorder([&](front::Operation operation, std::size_t triangles) {
    record.events.push_back({operation, before, triangles});
    before = triangles;
  });
  record.guide = morse::make_guide(skin.surface, skin.topology.skin_euler_characteristic(), {},
                                   sizing.tangent_disk_share());
  record.mesh =
      front::sweep_once(skin.surface, record.guide, {.sizing = sizing}, {}, {&recorder}).mesh;
  return record;
}

}  // namespace morskin::figures
