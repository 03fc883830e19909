#include "app/presets.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "app/output_names.h"
#include "app/report_lines.h"

namespace morskin::app {
namespace {

struct Preset {
  std::string name;
  double density;  ///< vertices per square Angstrom
  std::string voids, vertex_data, ending;
};

const std::array<Preset, 2>& presets() {
  static const std::array<Preset, 2> all{{
      {"bem", 5, "drop", "normal", ".vert"},
      {"learning", 2, "drop", "all", ".npz"},
  }};
  return all;
}

const Preset& preset_of(const std::string& name) {
  return *std::ranges::find(presets(), name, &Preset::name);
}

bool takes_density(const Typed& typed) {
  return !typed.skin.size && !typed.skin.C && !typed.density && !typed.triangles &&
         typed.method != "dynamic" && typed.method != "marching-cubes";
}

}  // namespace

std::vector<std::string> preset_names() {
  std::vector<std::string> names;
  for (const Preset& preset : presets()) names.push_back(preset.name);
  return names;
}

const std::string& preset_ending(const std::string& name) { return preset_of(name).ending; }

void apply_preset(Typed& typed, MeshArguments& mesh) {
  const Preset& preset = preset_of(*typed.purpose);
  PresetUse& use = mesh.preset.emplace();
  use.name = preset.name;
  const auto set = [&use](const std::string& option, const std::string& value) {
    use.set.emplace_back(option, value);
    return value;
  };
  if (takes_density(typed)) {
    typed.density = preset.density;
    set("density", brief(preset.density));
  }
  if (!typed.skin.voids) typed.skin.voids = set("voids", preset.voids);
  for (std::filesystem::path& output : mesh.outputs) {
    if (!is_special(output) && !output.empty() && !output.has_extension()) {
      output += preset.ending;
      set("output", output.string());
    }
  }
  const bool holds_data = std::ranges::any_of(mesh.outputs, takes_vertex_data);
  if (!typed.vertex_data && holds_data) typed.vertex_data = set("vertex-data", preset.vertex_data);
}

nlohmann::ordered_json preset_json(const PresetUse& preset) {
  nlohmann::ordered_json set = nlohmann::ordered_json::object();
  for (const auto& [option, value] : preset.set) set[option] = value;
  return {{"for", preset.name}, {"set", set}};
}

std::string preset_text(const PresetUse& preset) {
  std::string text;
  for (const auto& [option, value] : preset.set) text += " --" + option + " " + value;
  return preset.name + (text.empty() ? ": nothing is left to set" : ":" + text);
}

}  // namespace morskin::app
