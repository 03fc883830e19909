#include <sys/resource.h>

#include <chrono>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <span>
#include <string>
#include <utility>

#include "app/commands.h"
#include "app/limits.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/snapshots.h"
#include "app/staged_outputs.h"
#include "bench/baselines/dynamic_skin.h"
#include "bench/baselines/marching_cubes.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/predicates.h"
#include "morskin/safety_net.h"

namespace morskin::app {
namespace {

using geometry::MeshFormat;
using geometry::PendingFile;

class Stopwatch {
 public:
  double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

// Devices and pipes have no ending; they take PLY.
MeshFormat format_of(const std::filesystem::path& path) {
  return geometry::mesh_format_of(path).value_or(MeshFormat::PlyBinary);
}

bool can_be_certified(MeshFormat format) {
  return format != MeshFormat::Stl && format != MeshFormat::Vtu;
}

// The dynamic method. The balls have been grown to --grow's end already, so it ends at time 0.
morskin::Mesher dynamic_mesher(const morskin::PreparedSkin& skin, const MeshArguments& arguments,
                               StagedOutputs& outputs, MeshReport& report) {
  baselines::GrowthOptions growth;
  double largest = 0;
  for (const auto& p : skin.surface.points()) largest = std::max(largest, p.weight);
  const double from =
      arguments.growth_shown_from ? *arguments.growth_shown_from - arguments.grow_to : -largest;
  for (std::size_t k = 1; k <= arguments.snapshots; ++k) {
    const double left = static_cast<double>(arguments.snapshots - k);
    growth.snapshot_times.push_back(from * left / static_cast<double>(arguments.snapshots));
  }
  for (const double t : arguments.snapshot_values) {
    growth.snapshot_times.push_back(t - arguments.grow_to);
  }
  std::ranges::sort(growth.snapshot_times);
  growth.snapshot = [&arguments, &outputs, number = std::size_t{0}](
                        double, const surface::Mesh& mesh) mutable {
    outputs.undisturbed([&] { write_snapshot(arguments.snapshot_folder, ++number, mesh); });
  };
  if (arguments.keep_delaunay) growth.kept = &report.kept_delaunay.emplace();
  return baselines::dynamic_mesher(growth, &report.growth.emplace());
}

morskin::MeshOptions options_of(const morskin::PreparedSkin& skin, const MeshArguments& arguments,
                                StagedOutputs& outputs, MeshReport& report) {
  morskin::MeshOptions options;
  options.sizing = arguments.sizing;
  options.angle_goal_deg = arguments.angle_goal_deg;
  options.method = arguments.method;
  if (report.grid_step) options.mesher = baselines::marching_cubes_mesher(*report.grid_step);
  if (arguments.method == morskin::Method::Dynamic) {
    options.mesher = dynamic_mesher(skin, arguments, outputs, report);
  }
  options.function = arguments.function;
  options.fronts = arguments.fronts;
  options.threads = arguments.threads;
  options.guard = arguments.guard;
  options.snapshots = arguments.snapshots;
  options.snapshot_values = arguments.snapshot_values;
  options.certify = false;
  return options;
}

morskin::MeshResult mesh(const morskin::PreparedSkin& skin, const MeshArguments& arguments,
                         morskin::MeshOptions options, StagedOutputs& outputs,
                         const morskin::Progress& progress) {
  std::size_t number = 0;
  options.snapshot = [&](const front::Snapshot& snapshot) {
    outputs.undisturbed([&] { write_snapshot(arguments.snapshot_folder, ++number, snapshot); });
  };
  options.progress = progress;
  try {
    return morskin::mesh_skin(skin, options);
  } catch (const morse::DegenerateFunction& error) {
    // Which exit code depends on whose choice the function was.
    if (arguments.function) throw UsageError(error.what());
    throw;
  }
}

void write(std::span<PendingFile> files, const geometry::IndexedMesh& mesh) {
  for (PendingFile& file : files) file.write(geometry::serialized(mesh, format_of(file.path())));
}

bool is_same(const geometry::IndexedMesh& a, const geometry::IndexedMesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

geometry::IndexedMesh read_back(const PendingFile& file) {
  return geometry::parse_mesh(geometry::read_file(file.temporary_name()).view(),
                              file.path().string());
}

// The certificate of the first file whose format keeps every coordinate, from its bytes; if there
// is none, of the bytes that a PLY file would have. Other such files must hold the same mesh.
// `result.mesh` becomes what was read, so that it is held once.
certify::Certificate certify(std::span<const PendingFile> files, morskin::MeshResult& result,
                             const morskin::PreparedSkin& skin, const MeshArguments& arguments,
                             std::string& certified_file) {
  certified_file.clear();
  geometry::IndexedMesh& mesh = result.mesh;
  geometry::IndexedMesh copy;
  std::string defect;
  try {
    for (const PendingFile& file : files) {
      if (!can_be_certified(format_of(file.path()))) continue;
      if (certified_file.empty()) {
        certified_file = file.path().string();
        mesh = {};
        copy = read_back(file);
      } else if (!is_same(copy, read_back(file))) {
        defect = file.path().string() + " does not hold the mesh of " + certified_file;
      }
    }
    if (certified_file.empty()) {
      certified_file = "the same mesh as binary PLY, in memory";
      const std::string bytes = geometry::serialized(mesh, MeshFormat::PlyBinary);
      mesh = {};
      copy = geometry::parse_mesh(bytes, certified_file);
    }
  } catch (const geometry::UnreadableInput& error) {
    defect = error.what();
  }
  mesh = std::move(copy);
  certify::Certificate certificate =
      certify::certify(mesh, {result.twins, result.cells}, skin.surface, skin.topology,
                       arguments.sizing, arguments.threads);
  if (!defect.empty()) {
    certificate.certified = false;
    certificate.reason = defect;
  }
  return certificate;
}

// Feeds what is no regular file, which gets certified meshes only.
std::vector<std::filesystem::path> feed(const MeshArguments& arguments,
                                        const geometry::IndexedMesh& mesh, bool is_certified) {
  std::vector<std::filesystem::path> names;
  for (const std::filesystem::path& path : arguments.outputs) {
    if (!is_certified || !geometry::is_written_directly(path)) continue;
    geometry::write_file_atomically(path, geometry::serialized(mesh, format_of(path)));
    names.push_back(path);
  }
  return names;
}

constexpr std::string_view unverified = ".unverified";

// Found out before the long work, as PendingFile does for the name itself.
void check_unverified_names(std::span<const PendingFile> files) {
  for (const PendingFile& file : files) {
    const std::filesystem::path name = file.final_name(unverified);
    std::error_code ignored;
    if (std::filesystem::is_directory(name, ignored)) {
      throw geometry::UnwritableOutput(name.string() + ": is a folder, in the place of a mesh " +
                                       "that is not certified; remove it or choose another name");
    }
  }
}

// The high-water mark of this program alone; that of getrusage starts with what its parent held.
long long peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    long long kibibytes = 0;
    if (std::sscanf(line.c_str(), "VmHWM: %lld kB", &kibibytes) == 1) return kibibytes * 1024;
  }
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss * 1024LL;
}

void describe_input(MeshReport& report, const MeshArguments& arguments,
                    const MoleculeInput& input) {
  report.molecule = arguments.molecule;
  report.sizing = arguments.sizing;
  report.angle_goal_deg = arguments.angle_goal_deg;
  report.atoms_used = input.molecule.atoms.size();
  report.reading = input.molecule.counts;
  const RadiusRange radii = patch_radii(input.points);
  report.patch_radius_min = radii.smallest;
  report.patch_radius_max = radii.largest;
}

void describe_run(MeshReport& report, const morskin::MeshResult& result) {
  report.surviving_minima = result.surviving_minima;
  report.surviving_saddles = result.surviving_saddles;
  report.surviving_maxima = result.surviving_maxima;
  report.minima = result.minima;
  report.saddles = result.saddles;
  report.maxima = result.maxima;
  report.function = result.function;
  report.operations = result.operations;
  report.refinement = result.refinement;
  report.smoothing = result.smoothing;
  report.open_edges = result.open_edges;
  report.fallbacks = result.fallbacks;
  report.seconds.stages = result.seconds;
}

void publish(const MeshReport& report, const MeshArguments& arguments) {
  if (arguments.report && geometry::is_written_directly(*arguments.report)) {
    geometry::write_file_atomically(*arguments.report, json_text(report));
  }
  if (!report.certificate.certified) {
    std::cerr << "morskin: " << arguments.outputs.front().string()
              << ": not certified: " << report.certificate.reason << "; see "
              << (report.outputs.empty() ? "the report" : report.outputs.front().string()) << "\n";
  }
  if (arguments.quiet && !arguments.json) return;
  // A mesh, or the report as JSON, on standard output sends the report for people elsewhere.
  const bool is_taken = std::ranges::any_of(arguments.outputs, is_standard_output) ||
                        (arguments.report && is_standard_output(*arguments.report));
  (is_taken ? std::cerr : std::cout) << (arguments.json ? json_text(report) : people_text(report));
}

}  // namespace

ExitCode mesh_command(const MeshArguments& arguments) {
  const Stopwatch total;
  TimeLimit time_limit(arguments.timeout, arguments.molecule.input,
                       "make a coarser mesh with a larger -C");
  MeshReport report;
  const std::string doubts = doubts_about(arguments.sizing);
  if (!doubts.empty() && !arguments.quiet) std::cerr << "morskin: note: " << doubts << "\n";

  const Stopwatch reading;
  MoleculeInput input = read_input(arguments.molecule);
  for (auto& p : input.points) p.weight = geometry::on_exact_grid(p.weight + arguments.grow_to);
  report.seconds.read = reading.seconds();
  describe_input(report, arguments, input);

  std::vector<std::filesystem::path> names = arguments.outputs;
  if (arguments.report) names.push_back(*arguments.report);
  StagedOutputs outputs(names);
  const bool is_report_staged =
      arguments.report && !geometry::is_written_directly(*arguments.report);
  std::span<PendingFile> files = outputs.files();
  PendingFile* const report_file = is_report_staged ? &files.back() : nullptr;
  if (is_report_staged) files = files.first(files.size() - 1);
  check_unverified_names(files);

  const Stopwatch preparing;
  ProgressLine line(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const auto progress = [&](std::string_view stage, double share) { line.show(stage, share); };
  const morskin::PreparedSkin skin = prepare_skin(input, progress, arguments.threads);
  input = {};  // only the skin is needed from here on
  report.seconds.dual_complex = preparing.seconds() - skin.surface.triangulate_seconds() -
                                skin.surface.mixed_complex_seconds();
  report.atoms_hidden = skin.surface.triangulation().hidden.size();
  if (arguments.method == morskin::Method::MarchingCubes) {
    report.grid_step = arguments.grid_step
                           ? *arguments.grid_step
                           : baselines::step_like_sweep(skin.surface, report.sizing);
  }
  const morskin::MeshOptions options = options_of(skin, arguments, outputs, report);
  morskin::MeshResult result = mesh(skin, arguments, options, outputs, progress);
  report.method = arguments.method;
  report.fronts = arguments.fronts;

  const Stopwatch writing;
  progress("write", geometry::unknown_share);
  write(files, result.mesh);
  report.seconds.write = writing.seconds();
  const Stopwatch certifying;
  progress("certify", geometry::unknown_share);
  report.certificate = certify(files, result, skin, arguments, report.certified_file);
  if (!report.certificate.certified && morskin::mend(skin, options, result)) {
    write(files, result.mesh);
    report.certificate = certify(files, result, skin, arguments, report.certified_file);
  }
  describe_run(report, result);
  report.seconds.certify = certifying.seconds();
  line.wipe();
  // First what may fail or take time: then no file has its name yet.
  const Stopwatch delivering;
  const std::vector<std::filesystem::path> fed =
      feed(arguments, result.mesh, report.certificate.certified);
  report.seconds.write += delivering.seconds();
  report.seconds.total = total.seconds();
  const std::string_view suffix = report.certificate.certified ? "" : unverified;
  for (const PendingFile& file : files) report.outputs.push_back(file.final_name(suffix));
  report.outputs.insert(report.outputs.end(), fed.begin(), fed.end());
  report.peak_memory_bytes = peak_memory_bytes();
  report.floor_seconds = morskin::floor_seconds(skin.surface, result);
  if (report_file != nullptr) report_file->write(json_text(report));
  time_limit.cancel();
  outputs.undisturbed([&] {
    for (PendingFile& file : files) file.commit(suffix);
    if (report_file != nullptr) report_file->commit();
  });
  publish(report, arguments);
  return report.certificate.certified ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app
