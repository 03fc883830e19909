#include "app/recorded_sweep.h"

#include <algorithm>

#include "front/sweep_observer.h"

namespace morskin::app {
namespace {

// Takes down what the sweep does, and when each triangle came to be.
class Recorder : public morskin::Observer {
 public:
  explicit Recorder(RecordedMesh& recorded)
      : recorded_(recorded),
        operations_([&recorded](front::Operation operation, std::size_t triangles) {
          recorded.steps.push_back({operation, static_cast<std::uint32_t>(triangles)});
        }) {}

  bool wants_births() override { return true; }
  std::vector<front::SweepObserver*> sweep_observers() override { return {&operations_}; }
  void swept(const surface::Mesh& mesh) override {
    refined(mesh);
    // Coarsening behind the front lays triangles of its own.
    const std::uint32_t last = *std::ranges::max_element(recorded_.birth);
    recorded_.laid = std::max(recorded_.steps.back().triangles, last + 1);
  }
  void refined(const surface::Mesh& mesh) override {
    recorded_.birth.assign(mesh.births->begin(), mesh.births->end());
  }

 private:
  RecordedMesh& recorded_;
  front::OperationObserver operations_;
};

}  // namespace

RecordedMesh mesh_and_record(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run) {
  options.fronts = 1;
  options.has_safety_net = false;  // what it made would not be what the sweep laid
  RecordedMesh recorded;
  Recorder recorder(recorded);
  recorded.result = morskin::make_mesh(skin, options, recorder, run);
  return recorded;
}

}  // namespace morskin::app
