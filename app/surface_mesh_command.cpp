#include <iostream>
#include <span>
#include <string>

#include "app/commands.h"
#include "app/limits.h"
#include "app/mesh_delivery.h"
#include "app/output_names.h"
#include "app/progress.h"
#include "app/rounded_outputs.h"
#include "app/side_file.h"
#include "app/staged_outputs.h"
#include "app/surface_input.h"
#include "app/surface_report.h"
#include "geometry/error.h"
#include "geometry/stopwatch.h"

namespace morskin::app {
namespace {

using geometry::PendingFile;

morskin::MeshingOptions options_of(const MeshArguments& arguments) {
  morskin::MeshingOptions options;
  options.sizing = arguments.sizing;
  options.angle_goal_deg = arguments.angle_goal_deg;
  options.function = arguments.function;
  options.fronts = arguments.fronts;
  return options;
}

void publish(const SurfaceReport& report, const MeshArguments& arguments) {
  if (!report.certificate.certified) {
    std::cerr << "morskin: " << arguments.outputs.front().string()
              << ": not certified: " << about_surface(report.certificate.reason) << "\n";
  }
  if (arguments.quiet && !arguments.json) return;
  (takes_standard_output(arguments) ? std::cerr : std::cout)
      << (arguments.json ? json_text(report) : people_text(report));
}

}  // namespace

ExitCode mesh_surface_command(const MeshArguments& arguments) {
  const geometry::Stopwatch total;
  TimeLimit time_limit(arguments.limits, *arguments.surface);
  const SurfaceInput input = read_surface(*arguments.surface);
  std::vector<std::filesystem::path> names = arguments.outputs;
  if (arguments.report) names.push_back(*arguments.report);
  StagedOutputs outputs(names);
  std::span<PendingFile> files = outputs.files();
  SideFile report_file(arguments.report, SideFile::IfUnverified::Same, files);
  for (const PendingFile& file : files) check_unverified_name(file);

  ProgressLine line(arguments.quiet ? ShowProgress::Never : arguments.progress);
  const morskin::Run run(arguments.threads, line.callback());
  std::optional<geometry::Vector> height;
  if (arguments.function) height = arguments.function->direction;
  const implicit::PreparedSurface prepared = prepare_surface(input, height, run);
  SurfaceReport report;
  report.surface = *arguments.surface;
  report.within = searched_within(report.surface, prepared);
  report.facts = SurfaceFacts::of(prepared);
  report.prepare_seconds = total.seconds();
  MeshDelivery delivery(arguments, outputs, files, nullptr, MeshOrigin(arguments, input.sha256), {},
                        {});
  const geometry::Stopwatch meshing;
  const morskin::MeshResult result =
      morskin::make_mesh(prepared, options_of(arguments), delivery, run);
  if (result.certificate.certified) check_rounded_outputs(result.mesh, arguments);
  report.certify_seconds = run.seconds("certify");
  report.mesh_seconds = meshing.seconds() - report.certify_seconds;
  report.sizing = result.sizing;
  report.counts = result;
  report.certificate = result.certificate;
  report.provenance = delivery.provenance(result);
  report.quality = certify::measure_quality(result.mesh, run);
  line.wipe();
  const bool is_certified = report.certificate.certified;
  if (!delivery.complete(result, report.outputs)) files = {};
  report.certified_file = delivery.certified_file();
  report.total_seconds = total.seconds();
  if (report_file.is_asked()) report_file.write(json_text(report));
  time_limit.cancel();
  outputs.undisturbed([&] {
    for (PendingFile& file : files) file.commit(is_certified ? "" : unverified);
    report_file.commit(is_certified);
  });
  report_file.write_directly(is_certified);
  publish(report, arguments);
  return is_certified ? ExitCode::Success : ExitCode::NotCertified;
}

}  // namespace morskin::app
