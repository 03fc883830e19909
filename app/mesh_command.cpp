#include <sys/resource.h>

#include <array>
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
#include "app/side_file.h"
#include "app/staged_outputs.h"
#include "certify/located_vertices.h"
#include "geometry/exact_range.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"
#include "geometry/task_trace.h"
#include "morskin/bent_part.h"
#include "morskin/feature_data.h"
#include "morskin/pipeline.h"

namespace morskin::app {
namespace {

using geometry::PendingFile;
using geometry::Stopwatch;

/// The texts beside the mesh, whose files stand behind the mesh's in all_outputs().
struct SideFiles {
  SideFile trace, areas, certificate, report;

  SideFiles(const MeshArguments& arguments, std::span<PendingFile>& files)
      : trace(arguments.task_trace, SideFile::IfUnverified::Same, files),
        areas(arguments.areas, SideFile::IfUnverified::Marked, files),
        certificate(arguments.certificate, SideFile::IfUnverified::Marked, files),
        report(arguments.report, SideFile::IfUnverified::Same, files) {}

  std::array<SideFile*, 4> all() { return {&certificate, &areas, &trace, &report}; }
};

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

MeshMethod method_of(const MeshArguments& arguments, const morskin::MeshResult& result) {
  if (arguments.method != MeshMethod::Auto) return arguments.method;
  return result.method == morskin::Method::Static ? MeshMethod::Static : MeshMethod::Sweep;
}

void describe_run(MeshReport& report, const MeshArguments& arguments,
                  const morskin::PreparedSkin& skin, const morskin::MeshResult& result,
                  MeshDelivery& delivery, const morskin::Run& run) {
  report.method = method_of(arguments, result);
  report.is_method_chosen = arguments.method == MeshMethod::Auto;
  report.provenance = delivery.provenance(result);
  report.atoms_hidden = skin.surface.triangulation().hidden.size();
  report.certificate = result.certificate;
  report.sizing = result.sizing;
  report.size_goal = arguments.size_goal;
  const bool is_by_length = std::isfinite(arguments.sizing.largest_length_scale);
  const bool is_size_asked = is_by_length || arguments.size_goal.is_set();
  if (is_size_asked && makes_report(arguments))
    report.bent = run.stage("describe", [&] { return bent_part(skin.surface, result); });
  if (arguments.grading && !result.mesh.triangles.empty()) {
    report.grading = run.stage(
        "describe", [&] { return morskin::measure_grading(result.mesh, *arguments.grading); });
  }
  if (makes_report(arguments)) {
    report.quality =
        run.stage("describe", [&] { return certify::measure_quality(result.mesh, run); });
    report.parts = run.stage("describe", [&] { return skin_parts(skin, result); });
  }
  report.curved = delivery.curved();
  report.counts = result;
  report.fallbacks = result.fallbacks;
  RunSeconds& seconds = report.seconds;
  seconds.triangulate = run.seconds("triangulate");
  seconds.mixed_complex = run.seconds("mixed complex");
  seconds.dual_complex = run.seconds("dual complex");
  seconds.voids = run.seconds("voids");
  seconds.critical_points = run.seconds("critical points") + run.seconds("integral lines");
  seconds.sweep = run.seconds("sweep") + run.seconds("grow") + run.seconds("marching cubes");
  seconds.refine = run.seconds("refine") + run.seconds("thin") + run.seconds("thicken") +
                   run.seconds("refine angles") + run.seconds("refine angles in space");
  seconds.smooth = run.seconds("smooth") + run.seconds("improve angles");
  seconds.write = delivery.seconds_writing();
  seconds.certify = run.seconds("deliver") - seconds.write + run.seconds("certify");
  seconds.describe = run.seconds("describe");
}

void publish(const MeshReport& report, const MeshArguments& arguments) {
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

/// Of C and Q as they come with a size nothing is noted: nearly every skin is certified with them.
void note_doubts(const MeshArguments& arguments) {
  constexpr double usual_C = certify::Sizing::coarsest_C;
  const certify::Sizing& sizing = arguments.sizing;
  const bool is_sized = arguments.size_goal.is_set() || std::isfinite(sizing.largest_length_scale);
  if (is_sized && sizing.C == usual_C && sizing.Q == certify::Sizing::quality_for(usual_C)) return;
  const std::string doubts = doubts_about(sizing);
  if (doubts.empty() || arguments.quiet || arguments.is_brief) return;
  std::cerr << "morskin: note: " << doubts;
  if (sizing.C > usual_C) std::cerr << "; nearly every skin is certified up to -C 0.4";
  std::cerr << "\n";
}

/// @throws UsageError  a weight leaves the range of the exact predicates
void grow(std::vector<geometry::WeightedPoint>& points, double by) {
  for (auto& p : points) {
    p.weight += by;
    if (geometry::is_exact_weight(p.weight)) continue;
    throw UsageError("--grow must leave every weight within 2^30 Angstrom^2; end it nearer to 0");
  }
}

MoleculeInput read(const MeshArguments& arguments, MeshReport& report) {
  const Stopwatch reading;
  MoleculeInput input = read_input(arguments.molecule);
  if (!arguments.quiet) {
    note_rounded_coordinates(input);
    note_unused(arguments.molecule, input);
  }
  grow(input.points, arguments.grow_to);
  report.seconds.read = reading.seconds();
  describe_input(report, arguments, input);
  return input;
}

/// MeshDelivery::complete, and what it costs.
bool complete(MeshReport& report, MeshDelivery& delivery, const morskin::MeshResult& result) {
  const Stopwatch writing;
  const bool is_written = delivery.complete(result, report.outputs);
  report.certified_file = delivery.certified_file();
  report.seconds.write += writing.seconds();
  report.peak_memory_bytes = peak_memory_bytes();
  return is_written;
}

std::string certificate_of(const morskin::MeshResult& result, const morskin::PreparedSkin& skin) {
  return certificate_text(result.mesh, certify::locate_vertices(result.mesh, skin.surface),
                          result.certificate.degree_vertices, skin, result.sizing);
}

/// The texts but for the trace, each if it is asked for.
/// @param atoms  whose areas are asked for
void write_texts(SideFiles& side, const MeshReport& report, const morskin::MeshResult& result,
                 const morskin::PreparedSkin& skin, const std::vector<skin::Atom>& atoms) {
  if (side.report.is_asked()) side.report.write(json_text(report));
  if (side.certificate.is_asked()) side.certificate.write(certificate_of(result, skin));
  if (side.areas.is_asked()) {
    side.areas.write(areas_text(atoms, areas_of_atoms(skin.surface, result.mesh, result.cells)));
  }
}

}  // namespace

ExitCode mesh_command(const MeshArguments& arguments) {
  if (arguments.surface) return mesh_surface_command(arguments);
  const Stopwatch total;
  std::optional<geometry::TaskTrace> trace;
  if (arguments.task_trace) trace.emplace();
  TimeLimit time_limit(arguments.limits, arguments.molecule.input);
  note_doubts(arguments);
  MeshReport report;
  MoleculeInput input = read(arguments, report);
  auto properties = atom_properties(input.molecule, arguments.vertex_data);
  std::vector<geometry::NamedArray> arrays;
  if (arguments.vertex_data.features) arrays = atom_arrays(input.molecule);
  StagedOutputs outputs(all_outputs(arguments));
  std::span<PendingFile> files = outputs.files();
  SideFiles side(arguments, files);
  for (const PendingFile& file : files) check_unverified_name(file);

  ProgressLine line(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::Run run(arguments.threads, line.callback());
  const morskin::PreparedSkin skin = prepare_skin(input, arguments.molecule, run);
  MeshOrigin origin(arguments, input);
  std::vector<skin::Atom> atoms;
  if (side.areas.is_asked()) atoms = std::move(input.molecule.atoms);
  input = {};  // only the skin is needed from here on
  const morskin::MeshingOptions options = options_of(skin, arguments, outputs, report);
  MeshDelivery delivery(arguments, outputs, files, &skin.surface, std::move(origin),
                        std::move(properties), std::move(arrays));
  const morskin::MeshResult result = along_function(
      arguments.function, [&] { return morskin::make_mesh(skin, options, delivery, run); });
  const bool is_certified = result.certificate.certified;
  if (is_certified) check_rounded_outputs(result.mesh, arguments);
  describe_run(report, arguments, skin, result, delivery, run);
  line.wipe();

  // First what may fail or take time: then no file has its name yet.
  if (!complete(report, delivery, result)) files = {};
  report.seconds.total = total.seconds();
  if (makes_report(arguments)) report.floor_seconds = morskin::floor_seconds(skin.surface, result);
  write_texts(side, report, result, skin, atoms);
  if (trace) side.trace.write(trace->json());
  time_limit.cancel();
  outputs.undisturbed([&] {
    for (PendingFile& file : files) file.commit(is_certified ? "" : unverified);
    for (SideFile* text : side.all()) text->commit(is_certified);
  });
  for (const SideFile* text : side.all()) text->write_directly(is_certified);
  publish(report, arguments);
  return is_certified ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app
