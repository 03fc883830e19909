#include "app/mesh_arguments.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <string>
#include <tuple>

#include "app/function_argument.h"
#include "app/output_names.h"
#include "app/surface_input.h"
#include "app/typed_values.h"
#include "front/subdomains.h"
#include "morskin/grading.h"

namespace morskin::app {

namespace {

/// Each of several models needs files of its own.
void check_several(const MeshArguments& mesh) {
  const auto refuse = [](const std::string& what) {
    throw UsageError("several models cannot " + what + "; choose one with --model-number");
  };
  const auto& radii = mesh.molecule.radii;
  if (is_read_once(mesh.molecule.input) || (radii && is_read_once(*radii))) {
    refuse("come from standard input or a pipe");
  }
  if (takes_standard_output(mesh)) refuse("go to standard output");
  if (mesh.has_snapshots()) refuse("all have snapshots");
}

bool is_smoothed(MeshMethod method) {
  return method != MeshMethod::Dynamic && method != MeshMethod::MarchingCubes;
}

/// The method, and the options of one method or another.
void finish_method(MeshArguments& mesh, const Typed& typed) {
  mesh.method = *parse_method(typed.method);
  const bool is_of_a_sweep = typed.fronts || typed.guard != "everywhere" || mesh.has_snapshots();
  if (mesh.method == MeshMethod::Auto && is_of_a_sweep) mesh.method = MeshMethod::Sweep;
  if (typed.angle_goal && !is_smoothed(mesh.method)) {
    throw UsageError("--angle-goal is for the methods sweep and static");
  }
  mesh.angle_goal_deg = is_smoothed(mesh.method) ? typed.angle_goal : 0;
  if (mesh.angle_goal_deg && !(*mesh.angle_goal_deg >= 0 && *mesh.angle_goal_deg <= 60)) {
    throw UsageError("--angle-goal must be from 0 to 60");
  }
  if (mesh.grid_step && mesh.method != MeshMethod::MarchingCubes) {
    throw UsageError("--grid is for --method marching-cubes");
  }
  if (mesh.grid_step && !(*mesh.grid_step > 0 && std::isfinite(*mesh.grid_step))) {
    throw UsageError("--grid must be above 0 and finite");
  }
  if (!typed.grow) return;
  if (mesh.method != MeshMethod::Dynamic) throw UsageError("--grow is for --method dynamic");
  std::tie(mesh.growth_shown_from, mesh.grow_to) = parsed_growth(*typed.grow);
  if (mesh.certificate && mesh.grow_to != 0) {
    throw UsageError("--certificate is of the balls that `balls` writes, so --grow must end at 0");
  }
}

/// How a sweep goes, and pictures on its way.
void finish_sweep(MeshArguments& mesh, const Typed& typed) {
  const bool is_sweep = mesh.method == MeshMethod::Sweep;
  if ((typed.fronts || typed.guard != "everywhere") && !is_sweep) {
    throw UsageError("--fronts and --guard are for --method sweep");
  }
  if (typed.guard == "adjacent") mesh.guard = front::Guard::Adjacent;
  if (typed.guard == "spheres") mesh.guard = front::Guard::Spheres;
  if (typed.fronts && !(*typed.fronts >= 1 && *typed.fronts <= front::max_subdomains)) {
    throw UsageError("--fronts must be 1 to " + std::to_string(front::max_subdomains));
  }
  if (typed.fronts && !std::has_single_bit(*typed.fronts)) {
    throw UsageError("--fronts must be a power of two, as boxes are halved");
  }
  mesh.fronts = typed.fronts;
  if (!mesh.has_snapshots()) {
    if (mesh.snapshot_folder == ".") return;
    throw UsageError("--snapshot-dir is for snapshots, and none are asked for; add --snapshots");
  }
  if (!is_sweep && mesh.method != MeshMethod::Dynamic) {
    throw UsageError("snapshots are for the methods sweep and dynamic");
  }
  if (is_sweep && mesh.fronts.value_or(1) != 1) {
    throw UsageError("snapshots are of one front from below: leave out --fronts");
  }
  if (is_sweep) mesh.fronts = 1;
}

void finish_sizes(MeshArguments& mesh, const Typed& typed) {
  finish(mesh.size_goal, typed);
  if ((typed.skin.size || mesh.size_goal.is_set()) && !is_smoothed(mesh.method)) {
    throw UsageError("--size, --density and --triangles are for the methods sweep and static");
  }
  mesh.grading = typed.grading;
  if (!mesh.grading) return;
  if (!(*mesh.grading >= morskin::min_grading && std::isfinite(*mesh.grading))) {
    throw UsageError("--grading must be at least 0.01 and finite");
  }
  if (mesh.method != MeshMethod::Auto && mesh.method != MeshMethod::Static) {
    throw UsageError("--grading is for --method static");
  }
  if (mesh.angle_goal_deg.value_or(certify::guaranteed_angle_deg) < certify::guaranteed_angle_deg) {
    throw UsageError("--grading needs an --angle-goal of 30 or more");
  }
}

void finish_files(MeshArguments& mesh, const Typed& typed) {
  if (typed.vertex_data) mesh.vertex_data = parsed_vertex_data(*typed.vertex_data);
  add_msms_partners(mesh.outputs);
  check_outputs(mesh);
  if (typed.vertex_data && std::ranges::none_of(mesh.outputs, takes_vertex_data)) {
    throw UsageError("--vertex-data goes into .ply, .vtu, .glb, .npz and .msh; none is written");
  }
  if (mesh.order == 2 && std::ranges::none_of(mesh.outputs, takes_second_order)) {
    throw UsageError("--order 2 is of .vtu and .msh files, and none is written");
  }
  if (mesh.decimals &&
      std::ranges::none_of(mesh.outputs, [](const auto& path) { return is_msms(path); })) {
    throw UsageError("--decimals is of .vert and .face files, and none is written");
  }
}

/// What only a molecule's skin has, with the option that asks for it.
void check_surface(const MeshArguments& mesh, const Typed& typed) {
  if (!mesh.molecule.input.empty()) {
    throw UsageError("a molecule and --surface are two surfaces; give one of them");
  }
  const bool is_of_skins = is_of_molecules(typed.skin) || mesh.models || typed.vertex_data ||
                           mesh.preset || mesh.areas || mesh.certificate || mesh.task_trace ||
                           mesh.order == 2;
  if (is_of_skins) {
    throw UsageError(
        "--surface goes without the options of molecules, --for, --vertex-data, --areas, "
        "--order 2, --certificate and --trace-tasks");
  }
  const bool is_sweep = mesh.method == MeshMethod::Auto || mesh.method == MeshMethod::Sweep;
  if (!is_sweep || mesh.guard != front::Guard::Everywhere || mesh.size_goal.is_set() ||
      mesh.grading || (mesh.function && !mesh.function->is_height())) {
    throw UsageError("--surface goes with --method sweep, along a height, and with --size only");
  }
  if (std::ranges::any_of(mesh.outputs, [](const auto& path) { return is_msms(path); })) {
    throw UsageError("MSMS's files are of molecules; write --surface to another format");
  }
  const auto molecule = molecule_of_surface(*mesh.surface);
  if (!molecule) return;
  for (const std::filesystem::path& name : all_outputs(mesh)) {
    check_not_input(name, {.input = *molecule});
  }
}

}  // namespace

std::optional<morse::MorseFunction> parsed(const Typed& typed) {
  if (typed.height && typed.function) {
    throw UsageError("--height x,y,z is short for --function height:x,y,z; give one of them");
  }
  if (typed.height) return parsed_height(*typed.height);
  if (typed.function) return parsed_function(*typed.function);
  return std::nullopt;
}

void finish(morskin::SizeGoal& goal, const Typed& typed) {
  if (typed.skin.size.has_value() + typed.density.has_value() + typed.triangles.has_value() > 1) {
    throw UsageError("--size, --density and --triangles are three ways to say one thing");
  }
  if (typed.density && !(*typed.density > 0 && std::isfinite(*typed.density))) {
    throw UsageError("--density must be above 0 and finite");
  }
  constexpr double max_triangles = geometry::SurfaceMesh::max_triangles;
  if (typed.triangles && !(*typed.triangles >= 4 && *typed.triangles <= max_triangles &&
                           std::trunc(*typed.triangles) == *typed.triangles)) {
    throw UsageError("--triangles must be a whole number from 4 to " +
                     std::to_string(geometry::SurfaceMesh::max_triangles));
  }
  goal.density = typed.density;
  goal.triangles = typed.triangles;
}

void finish(MeshArguments& mesh, const Typed& typed) {
  if (mesh.molecule.input.empty() && !mesh.surface) {
    throw UsageError("INPUT is missing: a molecule, or --surface");
  }
  mesh.typed = typed.skin;
  mesh.snapshot_values = parsed_snapshots_at(typed.snapshots_at);
  if (mesh.models) check_several(mesh);
  if (mesh.fail_fast && !mesh.models) {
    throw UsageError("--fail-fast is for several models, as in --model-number all");
  }
  mesh.function = parsed(typed);
  finish_method(mesh, typed);
  finish_sweep(mesh, typed);
  finish_sizes(mesh, typed);
  finish_files(mesh, typed);
  if (mesh.surface) check_surface(mesh, typed);
}

}  // namespace morskin::app
