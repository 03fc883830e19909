#include "app/figures/recorded_sweep.h"

#include <algorithm>

namespace morskin::figures {
namespace {

class Recorder : public morskin::Observer {
 public:
  explicit Recorder(RecordedSweep& record)
      : record_(record), operations_([&record](front::Operation operation, std::size_t triangles) {
          const std::size_t before = record.events.empty() ? 0 : record.events.back().after;
          record.events.push_back({operation, before, triangles});
        }) {}

  // A size goal sweeps again: what is recorded is the last sweep.
  void sized(const certify::Sizing&) override {
    record_.events.clear();
    seams_.clear();
  }
  bool wants_births() override { return true; }
  void guided(const morse::Guide& guide) override { record_.guide = guide; }
  std::vector<front::SweepObserver*> sweep_observers() override { return {&operations_, &seams_}; }
  void swept(const surface::Mesh& mesh) override {
    record_.mesh = mesh;
    record_.is_on_seam = seams_.by_birth();
    // Coarsening behind the front lays triangles of its own.
    const std::uint32_t last = *std::ranges::max_element(*mesh.births);
    record_.laid = std::max(static_cast<std::uint32_t>(record_.events.back().after), last + 1);
  }
  // Angles are raised by operations that change the triangles, after all refinement.
  void finished(const surface::Mesh& mesh) override {
    const std::uint32_t last = record_.laid - 1;
    record_.birth.assign(mesh.surface.triangle_count(), last);
    if (!mesh.births) return;
    std::ranges::transform(*mesh.births, record_.birth.begin(),
                           [&](std::uint32_t birth) { return std::min(birth, last); });
  }

 private:
  RecordedSweep& record_;
  front::OperationObserver operations_;
  SeamObserver seams_;
};

}  // namespace

RecordedSweep recorded_sweep(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run) {
  options.fronts = 1;
  options.has_safety_net = false;
  RecordedSweep record;
  Recorder recorder(record);
  record.result = morskin::make_mesh(skin, options, recorder, run);
  return record;
}

}  // namespace morskin::figures
