#include <sys/resource.h>

#include <cmath>
#include <fstream>
#include <iostream>
#include <span>
#include <string>

#include "app/atom_tables.h"
#include "app/certificate_file.h"
#include "app/commands.h"
#include "app/function_argument.h"
#include "app/limits.h"
#include "app/mesh_delivery.h"
#include "app/meshing_options.h"
#include "app/molecule_input.h"
#include "app/output_names.h"
#include "app/progress.h"
#include "app/report.h"
#include "app/rounded_outputs.h"
#include "app/staged_outputs.h"
#include "certify/located_vertices.h"
#include "geometry/error.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"
#include "geometry/task_trace.h"
#include "morskin/feature_data.h"
#include "morskin/pipeline.h"

namespace morskin::app {
namespace {

using geometry::PendingFile;
using geometry::Stopwatch;

// Feeds what is no regular file, which gets certified meshes only.
std::vector<std::filesystem::path> feed(const MeshArguments& arguments, MeshDelivery& delivery,
                                        const morskin::MeshResult& result) {
  std::vector<std::filesystem::path> names;
  const bool is_certified = result.certificate.certified;
  for (const std::filesystem::path& path : arguments.outputs) {
    if (!is_certified || !geometry::is_written_directly(path)) continue;
    geometry::write_file_atomically(path, delivery.bytes_for(path, result));
    names.push_back(path);
  }
  return names;
}

// The last of the files if it is the one named, no longer among them then.
PendingFile* take_last(std::span<PendingFile>& files,
                       const std::optional<std::filesystem::path>& name) {
  if (!name || geometry::is_written_directly(*name)) return nullptr;
  PendingFile* const last = &files.back();
  files = files.first(files.size() - 1);
  return last;
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
  report.preset = arguments.preset;
  report.sizing = arguments.sizing;
  report.angle_goal_deg =
      arguments.angle_goal_deg.value_or(refine::AngleGoal::usual_deg(arguments.sizing));
  report.radii = input.molecule.radii;
  report.atoms_used = input.molecule.atoms.size();
  report.reading = input.molecule.counts;
  report.rounded_coordinates = input.rounded_coordinates;
  const RadiusRange radii = patch_radii(input.points);
  report.patch_radius_min = radii.smallest;
  report.patch_radius_max = radii.largest;
}

bool prints_report(const MeshArguments& arguments) {
  return !arguments.is_brief && (!arguments.quiet || arguments.json);
}
bool makes_report(const MeshArguments& arguments) {
  return prints_report(arguments) || arguments.report.has_value();
}

void describe_run(MeshReport& report, const MeshArguments& arguments,
                  const morskin::PreparedSkin& skin, const morskin::MeshResult& result,
                  const MeshDelivery& delivery, const morskin::Run& run) {
  report.certificate = result.certificate;
  report.sizing = result.sizing;
  report.size_goal = arguments.size_goal;
  const bool is_by_length = std::isfinite(arguments.sizing.largest_length_scale);
  const bool is_size_asked = is_by_length || arguments.size_goal.is_set();
  if (is_size_asked && makes_report(arguments))
    report.bent = run.stage("describe", [&] { return bent_part(skin.surface, result); });
  if (arguments.grading) {
    report.grading = run.stage(
        "describe", [&] { return morskin::measure_grading(result.mesh, *arguments.grading); });
  }
  if (makes_report(arguments)) {
    report.quality =
        run.stage("describe", [&] { return certify::measure_quality(result.mesh, run); });
    report.parts = run.stage("describe", [&] { return skin_parts(skin, result); });
  }
  report.curved = delivery.curved();
  report.certified_file = delivery.certified_file();
  report.counts = result;
  report.fallbacks = result.fallbacks;
  RunSeconds& seconds = report.seconds;
  seconds.triangulate = run.seconds("triangulate");
  seconds.mixed_complex = run.seconds("mixed complex");
  seconds.dual_complex = run.seconds("dual complex");
  seconds.voids = run.seconds("voids");
  seconds.critical_points = run.seconds("critical points") + run.seconds("integral lines");
  seconds.sweep = run.seconds("sweep") + run.seconds("grow") + run.seconds("marching cubes");
  seconds.refine = run.seconds("refine") + run.seconds("thin") + run.seconds("refine angles") +
                   run.seconds("refine angles in space");
  seconds.smooth = run.seconds("smooth") + run.seconds("improve angles");
  seconds.write = delivery.seconds_writing();
  seconds.certify = run.seconds("deliver") - seconds.write + run.seconds("certify");
  seconds.describe = run.seconds("describe");
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
  std::ostream& free_stream = takes_standard_output(arguments) ? std::cerr : std::cout;
  if (arguments.is_brief && !arguments.quiet) free_stream << brief_text(report);
  if (!prints_report(arguments)) return;
  free_stream << (arguments.json ? json_text(report) : people_text(report));
}

}  // namespace

ExitCode mesh_command(const MeshArguments& arguments) {
  if (arguments.surface) return mesh_surface_command(arguments);
  const Stopwatch total;
  std::optional<geometry::TaskTrace> trace;
  if (arguments.task_trace) trace.emplace();
  TimeLimit time_limit(arguments.limits, arguments.molecule.input);
  MeshReport report;
  const std::string doubts = doubts_about(arguments.sizing);
  const bool is_talkative = !arguments.quiet && !arguments.is_brief;
  if (!doubts.empty() && is_talkative) std::cerr << "morskin: note: " << doubts << "\n";

  const Stopwatch reading;
  MoleculeInput input = read_input(arguments.molecule);
  for (auto& p : input.points) p.weight += arguments.grow_to;
  report.seconds.read = reading.seconds();
  describe_input(report, arguments, input);
  std::vector<morskin::AtomProperty> properties =
      atom_properties(input.molecule, arguments.vertex_data);
  std::vector<geometry::NamedArray> arrays;
  if (arguments.vertex_data.features) arrays = atom_arrays(input.molecule);

  StagedOutputs outputs(all_outputs(arguments));
  std::span<PendingFile> files = outputs.files();
  PendingFile* const trace_file = take_last(files, arguments.task_trace);
  PendingFile* const areas_file = take_last(files, arguments.areas);
  PendingFile* const certificate_file = take_last(files, arguments.certificate);
  PendingFile* const report_file = take_last(files, arguments.report);
  for (const PendingFile& file : files) check_unverified_name(file);
  for (const PendingFile* file : {certificate_file, areas_file}) {
    if (file != nullptr) check_unverified_name(*file);
  }

  ProgressLine line(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::Run run(arguments.threads, line.callback());
  const morskin::PreparedSkin skin = prepare_skin(input, arguments.molecule, run);
  const std::vector<skin::Atom> atoms =
      arguments.areas ? std::move(input.molecule.atoms) : std::vector<skin::Atom>();
  MeshOrigin origin(arguments, input);
  input = {};  // only the skin is needed from here on
  report.atoms_hidden = skin.surface.triangulation().hidden.size();
  const morskin::MeshingOptions options = options_of(skin, arguments, outputs, report);
  MeshDelivery delivery(arguments, outputs, files, &skin.surface, std::move(origin),
                        std::move(properties), std::move(arrays));
  const morskin::MeshResult result = along_function(
      arguments.function, [&] { return morskin::make_mesh(skin, options, delivery, run); });
  if (result.certificate.certified) check_rounded_outputs(result.mesh, arguments);
  const bool is_static = result.method == morskin::Method::Static;
  report.is_method_chosen = arguments.method == MeshMethod::Auto;
  report.method = !report.is_method_chosen ? arguments.method
                  : is_static              ? MeshMethod::Static
                                           : MeshMethod::Sweep;
  report.provenance = delivery.provenance(result);
  describe_run(report, arguments, skin, result, delivery, run);
  line.wipe();
  // First what may fail or take time: then no file has its name yet.
  const Stopwatch delivering;
  if (!result.certificate.certified && !delivery.mark_not_certified(result)) files = {};
  const std::vector<std::filesystem::path> fed = feed(arguments, delivery, result);
  report.seconds.write += delivering.seconds();
  report.seconds.total = total.seconds();
  const std::string_view suffix = report.certificate.certified ? "" : unverified;
  for (const PendingFile& file : files) report.outputs.push_back(file.final_name(suffix));
  report.outputs.insert(report.outputs.end(), fed.begin(), fed.end());
  report.peak_memory_bytes = peak_memory_bytes();
  if (makes_report(arguments)) report.floor_seconds = morskin::floor_seconds(skin.surface, result);
  if (report_file != nullptr) report_file->write(json_text(report));
  std::string certificate;
  if (arguments.certificate) {
    certificate = certificate_text(result.mesh, certify::locate_vertices(result.mesh, skin.surface),
                                   report.certificate.degree_vertices, skin, result.sizing);
    if (certificate_file != nullptr) certificate_file->write(certificate);
  }
  std::string areas;
  if (arguments.areas) {
    areas = areas_text(atoms, areas_of_atoms(skin.surface, result.mesh, result.cells));
    if (areas_file != nullptr) areas_file->write(areas);
  }
  if (trace_file != nullptr) trace_file->write(trace->json());
  time_limit.cancel();
  outputs.undisturbed([&] {
    for (PendingFile& file : files) file.commit(suffix);
    if (report_file != nullptr) report_file->commit();
    if (certificate_file != nullptr) certificate_file->commit(suffix);
    if (areas_file != nullptr) areas_file->commit(suffix);
    if (trace_file != nullptr) trace_file->commit();
  });
  const bool is_certified = report.certificate.certified;
  if (is_certified && arguments.certificate && certificate_file == nullptr) {
    geometry::write_file_atomically(*arguments.certificate, certificate);
  }
  if (is_certified && arguments.areas && areas_file == nullptr) {
    geometry::write_file_atomically(*arguments.areas, areas);
  }
  if (trace && trace_file == nullptr) {
    geometry::write_file_atomically(*arguments.task_trace, trace->json());
  }
  publish(report, arguments);
  return is_certified ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app
