#include "app/features_options.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <iterator>

#include "app/output_names.h"
#include "app/shared_options.h"
#include "morskin/feature_data.h"
#include "skin/molecule_files.h"

namespace morskin::app {

void add_features(CLI::App& app, FeaturesArguments& features, Typed& typed) {
  CLI::App& command = *app.add_subcommand(
      "features", "Write a mesh with all that learning on surfaces takes, as arrays");
  MeshArguments& mesh = features.mesh;
  mesh.limits.advice = "ask for a smaller --density";
  command.add_option("INPUT", mesh.molecule.input, "The molecule")->required();
  command
      .add_option("-o,--output", mesh.outputs,
                  ".npz, all of it; .ply, the mesh with what is by vertex; repeat for both")
      ->required()
      ->allow_extra_args(false);
  add_meshing_options(command, mesh, typed);
  for (const char* name : features_lack) command.remove_option(command.get_option(name));
  command.get_option("--model")->default_str("ses-like");
  command.get_option("--voids")->default_str("drop");
  command.get_option("--density")->default_str("2");
  for (const char* name : {"--size", "--triangles"}) {
    command.get_option(name)->default_str("as --density makes");
  }
  command.get_option("-C")->default_str("0.4, which --density makes finer");
  command
      .add_option("--report", mesh.report, "Also write the report of mesh to this file, as JSON")
      ->default_str("none");
  command.add_flag("-q,--quiet", mesh.quiet, "Print nothing but errors");
  add_threads_option(command, mesh.threads);
  add_limit_options(command, mesh.limits, typed);
  add_progress_option(command, typed);
  command.footer(
      "The mesh is certified as that of mesh is. Normals, curvatures and nearest atoms are the\n"
      "skin's, in closed form. hphob is the residue's value on the scale of Kyte and Doolittle, 0\n"
      "where it is no amino acid. Not there: MaSIF's charge, a potential that a Poisson-Boltzmann\n"
      "solver makes, and its hbond. papers/features.md lists every array.");
}

void set_feature_defaults(Typed& typed, const FeaturesArguments& features) {
  constexpr double density = 2;
  if (typed.method == "dynamic" || typed.method == "marching-cubes") {
    throw UsageError("features are of the methods sweep and static, not " + typed.method);
  }
  const bool gives_weights =
      skin::molecule_format_of(features.mesh.molecule.input) == skin::MoleculeFormat::Xyzw;
  if (!typed.skin.model && !gives_weights) typed.skin.model = "ses-like";
  if (!typed.skin.voids) typed.skin.voids = "drop";
  if (!typed.density && !typed.triangles && !typed.skin.size) typed.density = density;
}

void finish_features(FeaturesArguments& features) {
  MeshArguments& mesh = features.mesh;
  for (const std::filesystem::path& path : mesh.outputs) {
    const std::string ending = lower_extension(path);
    if (!path.empty() && !is_special(path) && ending != ".npz" && ending != ".ply") {
      throw UsageError(path.string() + ": the ending must be .npz or .ply");
    }
  }
  mesh.is_brief = true;
  mesh.vertex_data.data.assign(std::begin(morskin::feature_data), std::end(morskin::feature_data));
  mesh.vertex_data.charges = true;
  mesh.vertex_data.is_all = true;
  mesh.vertex_data.features = true;
}

}  // namespace morskin::app
