#include "app/output_names.h"

#include <algorithm>
#include <array>
#include <iostream>
#include <system_error>
#include <utility>
#include <vector>

#include "geometry/files/atomic_file.h"
#include "geometry/files/mesh_files.h"
#include "geometry/files/text_lines.h"

namespace morskin::app {

using geometry::MeshFormat;

namespace {

// The canonical path of a file, of one that links lead to and that is yet to be made as well.
std::filesystem::path one_name(const std::filesystem::path& path) {
  std::error_code failed;
  const std::filesystem::path absolute = std::filesystem::absolute(path, failed);
  // An empty name, or one in a working folder that is gone: whoever opens the file will say so.
  if (failed) return path.lexically_normal();
  const std::filesystem::path target = geometry::link_target(absolute, failed);
  if (failed) return absolute.lexically_normal();
  std::filesystem::path name = std::filesystem::weakly_canonical(target, failed);
  return failed ? absolute.lexically_normal() : name;
}

// Where an output goes if the mesh is not certified: beside the file that a link leads to.
std::filesystem::path unverified_name(const std::filesystem::path& output) {
  std::error_code ignored;
  return geometry::link_target(output, ignored).concat(unverified);
}

// What gets the ending .unverified if the mesh is not certified.
std::vector<std::filesystem::path> renamed_outputs(const MeshArguments& mesh) {
  std::vector<std::filesystem::path> renamed = mesh.outputs;
  for (const auto& path : {mesh.certificate, mesh.areas}) {
    if (path) renamed.push_back(*path);
  }
  return renamed;
}

// Names that the run chooses itself: of what belongs to uncertified meshes, and snapshots.
void check_not_given_otherwise(const std::filesystem::path& name, const MeshArguments& mesh) {
  for (const std::filesystem::path& output : renamed_outputs(mesh)) {
    if (is_same_file(name, unverified_name(output))) {
      throw UsageError(name.string() + " is where " + output.string() +
                       " goes when it is not certified; choose another name");
    }
  }
  const std::filesystem::path path = one_name(name);
  if (mesh.has_snapshots() &&
      path.parent_path() == one_name(mesh.snapshot_folder / "x").parent_path() &&
      path.filename().string().starts_with("snapshot-")) {
    throw UsageError(name.string() + " may become a snapshot's name; choose another");
  }
}

// The command that a file of no mesh format may be meant for.
std::string maker_of(const std::filesystem::path& output) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 4> makers{
      {{".html", "view"}, {".png", "render"}, {".xyzr", "balls"}, {".xyzw", "balls"}}};
  for (const auto& [ending, command] : makers) {
    if (lower_extension(output) != ending) continue;
    return "; for " + std::string(ending) + " there is morskin " + std::string(command);
  }
  return "";
}

}  // namespace

bool is_same_file(const std::filesystem::path& a, const std::filesystem::path& b) {
  return one_name(a) == one_name(b);
}

std::string lower_extension(const std::filesystem::path& path) {
  return geometry::lower_case(path.extension().string());
}

bool is_standard_output(const std::filesystem::path& path) {
  return path == "-" || path == "/dev/stdout";
}

std::vector<std::filesystem::path> all_outputs(const MeshArguments& mesh) {
  std::vector<std::filesystem::path> names = mesh.outputs;
  for (const auto& path : {mesh.report, mesh.certificate, mesh.areas, mesh.task_trace}) {
    if (path) names.push_back(*path);
  }
  return names;
}

bool takes_standard_output(const MeshArguments& mesh) {
  return std::ranges::any_of(all_outputs(mesh), is_standard_output);
}

void print_beside(const std::filesystem::path& output, const std::string& report) {
  (is_standard_output(output) ? std::cerr : std::cout) << report;
}

bool is_special(const std::filesystem::path& path) {
  std::error_code ignored;
  return geometry::is_written_directly(path) || std::filesystem::is_directory(path, ignored);
}

void check_not_input(const std::filesystem::path& output, const MoleculeArguments& molecule) {
  if (output.empty()) throw UsageError("an output's name is empty");
  if (molecule.input.empty() || is_special(output)) return;  // no input: another surface
  if (is_same_file(output, molecule.input)) {
    throw UsageError(output.string() + " would replace the input; choose another name");
  }
  if (molecule.radii && is_same_file(output, *molecule.radii)) {
    throw UsageError(output.string() + " would replace the radii; choose another name");
  }
}

void check_outputs(const MeshArguments& mesh) {
  const std::vector<std::filesystem::path> names = all_outputs(mesh);
  std::size_t standard_outputs = mesh.json ? 1 : 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    check_not_input(names[i], mesh.molecule);
    if (is_standard_output(names[i])) ++standard_outputs;
    if (is_special(names[i])) continue;
    check_not_given_otherwise(names[i], mesh);
    for (std::size_t j = 0; j < i; ++j) {
      if (is_same_file(names[i], names[j])) {
        throw UsageError(names[i].string() + " is named twice");
      }
    }
  }
  for (const std::filesystem::path& output : renamed_outputs(mesh)) {
    check_not_input(unverified_name(output), mesh.molecule);
  }
  if (standard_outputs > 1) throw UsageError("only one thing can go to standard output");
  for (const std::filesystem::path& output : mesh.outputs) {
    if (!is_special(output) && !geometry::mesh_format_of(output)) {
      throw UsageError(output.string() +
                       ": the ending stands for no mesh format; use .ply, .off, .obj, .stl, "
                       ".vtu, .glb, .npz, .msh or .vert" +
                       maker_of(output));
    }
  }
}

geometry::MeshFormat format_of(const std::filesystem::path& path) {
  return geometry::mesh_format_of(path).value_or(geometry::MeshFormat::PlyBinary);
}

bool takes_vertex_data(const std::filesystem::path& path) {
  return geometry::has_vertex_data(format_of(path));
}

bool takes_second_order(const std::filesystem::path& path) {
  return geometry::has_second_order(format_of(path));
}

bool is_msms(MeshFormat format) {
  return format == MeshFormat::MsmsVertices || format == MeshFormat::MsmsFaces;
}

bool is_msms(const std::filesystem::path& path) { return is_msms(format_of(path)); }

std::filesystem::path msms_partner(std::filesystem::path path) {
  const bool is_of_vertices = geometry::mesh_format_of(path) == geometry::MeshFormat::MsmsVertices;
  return path.replace_extension(is_of_vertices ? ".face" : ".vert");
}

void add_msms_partners(std::vector<std::filesystem::path>& outputs) {
  const std::vector<std::filesystem::path> named = outputs;
  for (const std::filesystem::path& path : named) {
    const std::filesystem::path partner = msms_partner(path);
    const bool is_named = std::ranges::any_of(
        outputs, [&](const auto& other) { return is_same_file(other, partner); });
    if (is_msms(path) && !is_named) outputs.push_back(partner);
  }
}

bool names_a_mesh(const std::filesystem::path& path) {
  return geometry::mesh_format_of(geometry::plain_name(path)).has_value();
}

}  // namespace morskin::app
