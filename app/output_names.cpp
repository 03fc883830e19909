#include "app/output_names.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <system_error>
#include <vector>

#include "geometry/mesh_files.h"

namespace morskin::app {
namespace {

// The one name of a file, whatever way its path is written.
std::filesystem::path one_name(const std::filesystem::path& path) {
  std::error_code failed;
  std::filesystem::path name = std::filesystem::weakly_canonical(path, failed);
  return failed ? std::filesystem::absolute(path).lexically_normal() : name;
}

}  // namespace

std::string lower_extension(const std::filesystem::path& path) {
  std::string ending = path.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdout";
}

bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  return is_standard_output(path) || (std::filesystem::exists(path, ignored) &&
                                      !std::filesystem::is_regular_file(path, ignored));
}

void check_not_input(const std::filesystem::path& output, const MoleculeArguments& molecule) {
  if (output.empty()) throw UsageError("an output's name is empty");
  if (!is_special(output) && one_name(output) == one_name(molecule.input)) {
    throw UsageError(output.string() + " would replace the input; choose another name");
  }
}

void check_outputs(const MeshArguments& mesh) {
  std::vector<std::filesystem::path> names = mesh.outputs;
  if (mesh.report) names.push_back(*mesh.report);
  std::size_t standard_outputs = mesh.json ? 1 : 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    check_not_input(names[i], mesh.molecule);
    if (is_standard_output(names[i])) ++standard_outputs;
    if (is_special(names[i])) continue;
    for (std::size_t j = 0; j < i; ++j) {
      if (one_name(names[i]) == one_name(names[j])) {
        throw UsageError(names[i].string() + " is named twice");
      }
    }
  }
  if (standard_outputs > 1) throw UsageError("only one thing can go to standard output");
  for (const std::filesystem::path& output : mesh.outputs) {
    if (!is_special(output) && !geometry::mesh_format_of(output)) {
      throw UsageError(output.string() +
                       ": the ending stands for no mesh format; use .ply, .off, .obj, .stl or "
                       ".vtu");
    }
  }
}

bool names_a_mesh(const std::filesystem::path& path) {
  std::string ending = lower_extension(path);
  if (ending == ".gz") ending = lower_extension(path.stem());
  constexpr std::array<std::string_view, 6> endings{".ply", ".off",  ".obj",
                                                    ".stl", ".vert", ".face"};
  return std::ranges::find(endings, ending) != endings.end();
}

}  // namespace morskin::app
