#include <algorithm>
#include <cmath>
#include <iostream>
#include <string>

#include "app/commands.h"
#include "app/function_argument.h"
#include "app/limits.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/selection_arguments.h"
#include "app/skin_arguments.h"
#include "app/staged_outputs.h"
#include "app/stated_skin.h"
#include "app/version.h"
#include "app/view_layers.h"
#include "certify/located_vertices.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/glued_triangles.h"
#include "geometry/mesh_shape.h"
#include "morse/protecting_spheres.h"
#include "morse/validate_complex.h"
#include "skin/molecule_files.h"

namespace morskin::app {
namespace {

// What a page shows beside the mesh, if the molecule is known.
struct Context {
  MoleculeInput input;
  certify::Sizing sizing;
  morskin::PreparedSkin skin;
  morse::MorseFunction function;
  morse::MorseSmaleComplex complex;
  morse::Simplification simplified;
};

// The complex with all its points and, where rounding leaves them undecided, without its lines. Its
// spheres are those of the front then (morse/make_guide.cpp).
morse::Simplification unsimplified(morse::MorseSmaleComplex& complex, double radius_share) {
  complex.arcs.clear();
  complex.regions.clear();
  morse::Simplification result;
  result.survives.assign(complex.points.size(), true);
  result.radius = morse::disjoint_radii(complex.points, radius_share);
  return result;
}

Context context(MoleculeInput input, const MoleculeArguments& molecule,
                const ViewArguments& arguments, const morskin::Run& run) {
  morskin::PreparedSkin skin = prepare_skin(input, molecule, run);
  Context result{std::move(input), {}, std::move(skin), {}, {}, {}};
  const morse::ChosenFunction chosen = along_function(arguments.function, [&] {
    return run.stage("critical points", [&] {
      return morse::choose_function(result.skin.surface,
                                    result.skin.topology.skin_euler_characteristic(),
                                    arguments.function);
    });
  });
  result.function = chosen.function;
  result.complex = run.stage("integral lines", [&] {
    return morse::morse_smale_complex(result.skin.surface, chosen.function, chosen.critical,
                                      morse::Polylines::Keep, run);
  });
  return result;
}

// The sizing of the mesh, and the simplification by the protecting spheres that go with it.
void set_sizing(Context& context, const certify::Sizing& sizing) {
  context.sizing = sizing;
  const double share = morskin::sphere_share(context.skin.surface, sizing.laid());
  const bool is_decided = context.complex.degeneracies.empty() && !morse::validate(context.complex);
  context.simplified = is_decided ? morse::contract_short_arcs(context.complex, share)
                                  : unsimplified(context.complex, share);
}

void describe(PageData& page, const Context& context, const MoleculeArguments& molecule) {
  page.about["atoms"] = context.input.molecule.atoms.size();
  add_model(page.about, molecule);
  page.about["C"] = context.sizing.C;
  page.about["Q"] = context.sizing.Q;
  if (std::isfinite(context.sizing.largest_length_scale)) {
    page.about["largest_length_scale"] = context.sizing.largest_length_scale;
  }
  page.about["radii"] = context.input.molecule.radii;
  add_selection(page.about, molecule.selection);
  page.about["function"] = function_json(context.function);
  page.about["function"]["words"] = in_words(context.function);
  page.about["function"]["unit"] = unit_of(context.function);
}

bool is_closed(const geometry::IndexedMesh& mesh) {
  return !geometry::closed_triangles(mesh.positions.size(), mesh.triangles).defect;
}

void describe(PageData& page, const geometry::IndexedMesh& mesh) {
  const geometry::MeshShape shape = geometry::measure_shape(mesh);
  page.about["min_angle_deg"] = rounded(shape.min_angle_deg, 4);
  page.about["max_angle_deg"] = rounded(shape.max_angle_deg, 4);
  page.about["closed"] = is_closed(mesh);
}

void add_context(PageData& page, const Context& context) {
  add_molecule(page, context.input.molecule, context.skin.surface);
  add_morse(page, context.complex, context.simplified);
}

bool has_both_extrema(const std::vector<morse::CriticalPoint>& points) {
  const auto has = [&](int index) {
    return std::ranges::any_of(points, [&](const auto& p) { return p.index == index; });
  };
  return has(0) && has(2);
}

struct Viewed {
  geometry::IndexedMesh mesh;
  std::optional<certify::Certificate> certificate;
};

// A mesh whose name has no ending, as that of standard input, is taken for a molecule.
MoleculeInput read_shown(const MoleculeArguments& molecule) {
  try {
    return read_input(molecule);
  } catch (const geometry::UnreadableInput& error) {
    std::error_code ignored;
    const bool is_there =
        is_read_once(molecule.input) || std::filesystem::exists(molecule.input, ignored);
    if (!is_there || skin::molecule_format_of(molecule.input)) throw;
    throw geometry::UnreadableInput(std::string(error.what()) +
                                    "; a mesh is known by its name's ending alone");
  }
}

Viewed view_molecule(PageData& page, const ViewArguments& arguments, const morskin::Run& run) {
  MoleculeInput input = read_shown(arguments.molecule);
  if (!arguments.quiet) {
    note_rounded_coordinates(input);
    note_unused(arguments.molecule, input);
  }
  Context context = app::context(std::move(input), arguments.molecule, arguments, run);
  morskin::MeshingOptions options;
  options.sizing = arguments.sizing;
  options.size_goal = arguments.size_goal;
  options.function = context.function;
  figures::RecordedSweep recorded = figures::recorded_sweep(context.skin, options, run);
  morskin::MeshResult& result = recorded.result;
  set_sizing(context, result.sizing);

  page.about["kind"] = "molecule";
  describe(page, context, arguments.molecule);
  describe(page, result.mesh);
  const FrontCode code = add_mesh(page, "mesh", result.mesh, arguments.molecule.input);
  add_cells(page, code, context.skin.surface.complex(), result.cells);
  add_sweep(page, code, recorded);
  if (result.open_edges == 0 && has_both_extrema(context.complex.points)) {
    add_regions(page, code, flow_regions(result.mesh, context.function, context.complex, run));
  }
  add_context(page, context);
  return {std::move(result.mesh), result.certificate};
}

Viewed view_mesh(PageData& page, const ViewArguments& arguments, const morskin::Run& run) {
  geometry::MeshFile file = geometry::read_mesh_file(arguments.molecule.input);
  Viewed viewed{std::move(file.mesh), {}};
  const geometry::IndexedMesh& mesh = viewed.mesh;
  if (mesh.triangles.empty()) {
    throw geometry::RefusedInput(arguments.molecule.input.string() + ": has no triangles to show");
  }
  page.about["kind"] = "mesh";
  describe(page, mesh);
  if (!arguments.against) {
    add_mesh(page, "mesh", mesh, arguments.molecule.input);
    return viewed;
  }
  MoleculeArguments asked = arguments.molecule;
  asked.input = *arguments.against;
  StatedMolecule stated =
      read_stated(std::move(asked), arguments.sizing, arguments.typed, file.provenance);
  const MoleculeArguments& molecule = stated.molecule;
  if (!arguments.quiet) {
    note_rounded_coordinates(stated.input);
    if (is_of_molecules(arguments.typed)) note_unused(molecule, stated.input);
  }
  Context context = app::context(std::move(stated.input), molecule, arguments, run);
  set_sizing(context, stated.sizing);
  describe(page, context, molecule);
  if (!stated.taken.empty()) page.about["taken"] = stated.taken;
  if (!stated.not_taken.empty()) page.about["not_taken"] = stated.not_taken;
  page.about["against"] = molecule.input.filename().string();
  const auto points = certify::locate_vertices(mesh, context.skin.surface);
  const std::vector<geometry::CellId> cells = certify::cells_of(points);
  viewed.certificate = certify::certify(mesh, {{}, cells}, context.skin.surface,
                                        context.skin.expected(), context.sizing, run);
  const FrontCode code = add_mesh(page, "mesh", mesh, arguments.molecule.input);
  add_cells(page, code, context.skin.surface.complex(), cells);
  if (has_both_extrema(context.complex.points) && page.about["closed"]) {
    add_regions(page, code, flow_regions(mesh, context.function, context.complex, run));
  }
  add_context(page, context);
  return viewed;
}

// The files meant by --frames.
std::vector<std::filesystem::path> frame_files(const std::vector<std::filesystem::path>& asked) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& path : asked) {
    std::error_code failed;  // then read_mesh says what is wrong
    if (!std::filesystem::is_directory(path, failed)) {
      files.push_back(path);
      continue;
    }
    for (std::size_t k = 1;; ++k) {
      std::filesystem::path file = path / ("snapshot-" + std::to_string(k) + ".ply");
      if (!std::filesystem::exists(file, failed)) {
        if (k == 1) geometry::read_mesh(file);  // says what is missing
        break;
      }
      files.push_back(std::move(file));
    }
  }
  return files;
}

void add_frames(PageData& page, const std::vector<std::filesystem::path>& files) {
  nlohmann::ordered_json frames = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : files) {
    const std::string name = "growth." + std::to_string(frames.size());
    const geometry::IndexedMesh mesh = geometry::read_mesh(file);
    add_mesh(page, name, mesh, file);
    frames.push_back(
        {{"name", name}, {"label", file.stem().string()}, {"triangles", mesh.triangles.size()}});
  }
  if (!frames.empty()) page.about["growth"]["frames"] = frames;
}

std::string people_text(const ViewArguments& arguments, const Viewed& viewed, const PageData& page,
                        std::size_t bytes, const std::filesystem::path& name) {
  std::string text = arguments.molecule.input.string() + " -> " + name.string() + "\n";
  text += line("mesh", counted(viewed.mesh.triangles.size(), "triangle", "triangles") + ", " +
                           counted(viewed.mesh.positions.size(), "vertex", "vertices"));
  text += line("page", brief(static_cast<double>(bytes) / 1e6, 3) + " MB, of which the mesh's " +
                           "positions are rounded to " +
                           brief(page.about["mesh"]["grid"]["step"].get<double>(), 3) + " A");
  if (viewed.certificate) {
    text += viewed.certificate->certified ? certified_text(*viewed.certificate)
                                          : "not certified: " + viewed.certificate->reason;
    text += "\n";
  }
  return text;
}

}  // namespace

ExitCode view_command(const ViewArguments& arguments) {
  TimeLimit time_limit(arguments.limits, arguments.molecule.input);
  StagedOutputs outputs({arguments.output});
  ProgressLine progress(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::Run run(arguments.threads, progress.callback());
  PageData page;
  page.about["title"] = arguments.molecule.input.filename().string();
  page.about["version"] = version;
  const bool is_mesh = names_a_mesh(arguments.molecule.input);
  for (const geometry::PendingFile& file : outputs.files()) {
    if (!is_mesh) check_unverified_name(file);
  }
  const Viewed viewed =
      is_mesh ? view_mesh(page, arguments, run) : view_molecule(page, arguments, run);
  add_frames(page, frame_files(arguments.growth));
  if (viewed.certificate) {
    page.about["certified"] = viewed.certificate->certified;
    page.about["reason"] = viewed.certificate->reason;
  }
  const bool has_failed = !is_mesh && !viewed.certificate->certified;
  const std::string bytes = page.page();
  std::filesystem::path name = arguments.output;
  time_limit.cancel();
  for (geometry::PendingFile& file : outputs.files()) {
    file.write(bytes);
    name = file.commit(has_failed ? unverified : "");
  }
  for (const std::filesystem::path& path : outputs.direct()) {
    if (!has_failed) geometry::write_file_atomically(path, bytes);
  }
  progress.wipe();
  if (has_failed) {
    const std::string what_is_left =
        outputs.files().empty() ? "; nothing is written" : "; see " + name.string();
    std::cerr << "morskin: " << arguments.output.string()
              << ": not certified: " << viewed.certificate->reason << what_is_left << "\n";
  }
  if (!arguments.quiet) {
    print_beside(arguments.output, people_text(arguments, viewed, page, bytes.size(), name));
  }
  return has_failed ? ExitCode::NotCertified : ExitCode::Success;
}

}  // namespace morskin::app
