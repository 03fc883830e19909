// One row's run of the ablation (bench/ablation.py): Algorithm 1 with some of the changes to
// what the paper prints undone, certified, with no safety net.
//
//   morskin_ablation INPUT MODEL [SWITCH ...]     prints what came of it as JSON
//   morskin_ablation --switches                   prints the names of all switches

#include <cstdio>
#include <cstring>
#include <ctime>
#include <nlohmann/json.hpp>
#include <span>

#include "bench/ablation/as_printed.h"
#include "bench/ablation/breaches.h"
#include "geometry/error.h"
#include "morskin/pipeline.h"
#include "skin/model.h"
#include "skin/molecule_files.h"
#include "skin/singular_skin.h"

using namespace morskin;

namespace {

double cpu_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

/// Counts breaches of a mesh as it was swept, and the processor time until it is delivered.
class Recorder : public Observer {
 public:
  explicit Recorder(const certify::Sizing& sizing) : sizing_(sizing), start_(cpu_seconds()) {}

  void swept(const surface::Mesh& mesh) override {
    const double before = cpu_seconds();
    breaches = ablation::count_breaches(sizing_, mesh);
    start_ += cpu_seconds() - before;
  }
  Delivery deliver(geometry::IndexedMesh mesh, std::span<const geometry::CellId>) override {
    seconds = cpu_seconds() - start_;
    return {std::move(mesh), {}};
  }

  ablation::Breaches breaches;
  double seconds = 0;

 private:
  const certify::Sizing sizing_;
  double start_;
};

ablation::AsPrinted parse(std::span<char*> names) {
  ablation::AsPrinted printed;
  for (const std::string_view name : names) {
    bool is_known = false;
    for (const auto& [word, member] : ablation::switches) {
      if (word != name) continue;
      printed.*member = true;
      is_known = true;
    }
    if (!is_known) throw geometry::RefusedInput("there is no switch " + std::string(name));
  }
  return printed;
}

nlohmann::json run(const char* file, skin::Model model, const ablation::AsPrinted& printed) {
  constexpr double probe = 1.4;
  const PreparedSkin skin =
      prepare_skin(skin::weighted_points(skin::read_molecule(file), model, probe));
  const MeshingOptions options{
      .sizing = {}, .mesher = ablation::mesher(printed), .fronts = 1, .has_safety_net = false};
  Recorder recorder(options.sizing);
  const MeshResult result = make_mesh(skin, options, recorder);
  return {{"certified", result.certificate.certified},
          {"reason", result.certificate.reason},
          {"open_edges", result.open_edges},
          {"triangles", result.mesh.triangles.size()},
          {"min_angle_deg", result.certificate.min_angle_deg},
          {"max_angle_deg", result.certificate.max_angle_deg},
          {"angles_below_25", ablation::angles_below(25, result.mesh)},
          {"angles_below_30", ablation::angles_below(30, result.mesh)},
          {"laid_short_edges", recorder.breaches.short_edges},
          {"laid_big_triangles", recorder.breaches.big_triangles},
          {"cpu_seconds", recorder.seconds}};
}

}  // namespace

int main(int count, char** words) {
  if (count == 2 && std::strcmp(words[1], "--switches") == 0) {
    for (const auto& [name, member] : ablation::switches) std::puts(std::string(name).c_str());
    return EXIT_SUCCESS;
  }
  const auto model = count >= 3 ? skin::parse_model(words[2]) : std::nullopt;
  if (!model) {
    std::fputs("usage: morskin_ablation INPUT MODEL [SWITCH ...] | --switches\n", stderr);
    return 2;
  }
  try {
    const auto names = std::span(words, static_cast<std::size_t>(count)).subspan(3);
    std::puts(run(words[1], *model, parse(names)).dump().c_str());
    return EXIT_SUCCESS;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "morskin_ablation: %s\n", error.what());
    return EXIT_FAILURE;
  }
}
