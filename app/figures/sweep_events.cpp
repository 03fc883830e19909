#include "app/figures/sweep_events.h"

namespace morskin::figures {
namespace {

class Recorder : public morskin::Observer {
 public:
  explicit Recorder(RecordedSweep& record)
      : record_(record), operations_([&record](front::Operation operation, std::size_t triangles) {
          const std::size_t before = record.events.empty() ? 0 : record.events.back().after;
          record.events.push_back({operation, before, triangles});
        }) {}

  void guided(const morse::Guide& guide) override { record_.guide = guide; }
  std::vector<front::SweepObserver*> sweep_observers() override { return {&operations_}; }
  void swept(const surface::Mesh& mesh) override { record_.mesh = mesh; }

 private:
  RecordedSweep& record_;
  front::OperationObserver operations_;
};

}  // namespace

RecordedSweep recorded_sweep(const morskin::PreparedSkin& skin, double C) {
  RecordedSweep record;
  Recorder recorder(record);
  morskin::make_mesh(skin, {.sizing = {.C = C}, .fronts = 1}, recorder);
  return record;
}

}  // namespace morskin::figures
