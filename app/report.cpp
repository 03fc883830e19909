#include "app/report.h"

#include <nlohmann/json.hpp>

#include "app/function_argument.h"
#include "app/presets.h"
#include "app/selection_arguments.h"
#include "app/strict_json.h"
#include "geometry/files/provenance_json.h"
#include "morskin/boundary.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

ordered_json operations_json(const MeshReport& report) {
  const front::Operations& done = report.counts.operations;
  return {{"creation", done.creation},
          {"creep", done.creep},
          {"wing", done.wing},
          {"bridge", done.bridge},
          {"seal", done.seal},
          {"guard_inside_protecting", done.guard_inside_protecting},
          {"guard_outside_protecting", done.guard_outside_protecting},
          {"vain_inside_protecting", done.futile_inside_protecting},
          {"vain_outside_protecting", done.futile_outside_protecting},
          {"coarsen", done.coarsen},
          {"flip", report.counts.refinement.flip},
          {"contract", report.counts.refinement.contract},
          {"insert", report.counts.refinement.insert},
          {"refused", report.counts.refinement.refused}};
}

ordered_json growth_json(const baselines::GrowthCounts& growth) {
  return {{"births", growth.metamorphoses[0]},
          {"necks", growth.metamorphoses[1]},
          {"tunnels_closed", growth.metamorphoses[2]},
          {"voids_gone", growth.metamorphoses[3]},
          {"failed", growth.failed},
          {"flip", growth.operations.flip},
          {"contract", growth.operations.contract},
          {"insert", growth.operations.insert},
          {"looks", growth.inspections}};
}

ordered_json seconds_json(const RunSeconds& seconds) {
  return {{"read", rounded(seconds.read)},
          {"triangulate", rounded(seconds.triangulate)},
          {"mixed_complex", rounded(seconds.mixed_complex)},
          {"dual_complex", rounded(seconds.dual_complex)},
          {"voids", rounded(seconds.voids)},
          {"critical_points", rounded(seconds.critical_points)},
          {"sweep", rounded(seconds.sweep)},
          {"refine", rounded(seconds.refine)},
          {"smooth", rounded(seconds.smooth)},
          {"certify", rounded(seconds.certify)},
          {"describe", rounded(seconds.describe)},
          {"write", rounded(seconds.write)},
          {"total", rounded(seconds.total)}};
}

ordered_json skipped_json(const skin::ReadingCounts& counts) {
  ordered_json json;
  for (const auto& [reason, count] : morskin::left_out(counts)) json[reason] = count;
  return json;
}

ordered_json fallbacks_json(const MeshReport& report) {
  ordered_json json = ordered_json::array();
  for (const morskin::Fallback& f : report.fallbacks) {
    json.push_back({{"component", f.component},
                    {"from", name_of(report.method)},
                    {"to", replacement_text(f)},
                    {"why", f.reason}});
  }
  return json;
}

/// What was asked for, and the atoms that it came to.
ordered_json input_json(const MeshReport& report) {
  ordered_json json = {{"input", report.molecule.input.string()}};
  add_model(json, report.molecule);
  json.update({{"radii", report.radii},
               {"atoms_used", report.atoms_used},
               {"atoms_skipped", skipped(report.reading)},
               {"atoms_skipped_by_reason", skipped_json(report.reading)},
               {"models_skipped", report.reading.other_models},
               {"atoms_duplicate", report.reading.duplicates},
               {"atoms_hidden", report.atoms_hidden},
               {"coordinates_rounded", report.rounded_coordinates},
               {"patch_radius_min", rounded(report.patch_radius_min)},
               {"patch_radius_max", rounded(report.patch_radius_max)},
               {"method", name_of(report.method)},
               {"C", report.sizing.C},
               {"Q", report.sizing.Q},
               {"C_Q_in_proved_range", doubts_about(report.sizing).empty()}});
  add_selection(json, report.molecule.selection);
  if (report.preset) json["preset"] = preset_json(*report.preset);
  add_edge_length(json, report.sizing);
  return json;
}

/// How the mesh was made.
void add_run_json(ordered_json& json, const MeshReport& report) {
  const morskin::RunCounts& counts = report.counts;
  json["function"] = function_json(counts.function);
  if (counts.function.is_height()) {
    const geometry::Vector& v = counts.function.direction;
    json["height"] = {rounded(v.x()), rounded(v.y()), rounded(v.z())};
  }
  json.update(critical_json(counts.critical_points));
  json["open_edges"] = counts.open_edges;
  json["surviving"] = critical_json(counts.surviving_points);
  json["subdomains"] = counts.subdomains;
  json["triangles_laid"] = counts.triangles_laid;
  json["seam_triangles"] = counts.seam_triangles;
  json["fallbacks"] = fallbacks_json(report);
  json["operations"] = operations_json(report);
  json["smoothing"] = {
      {"goal_deg", report.angle_goal_deg},  {"below", counts.smoothing.below},
      {"moved", counts.smoothing.moved},    {"reconnected", counts.improvement.changed},
      {"inserted", counts.angles.inserted}, {"left", counts.below_goal()}};
}

}  // namespace

ordered_json critical_json(const morskin::CriticalCounts& counts) {
  return {{"minima", counts[0]}, {"saddles", counts[1]}, {"maxima", counts[2]}};
}

std::string json_text(const MeshReport& report) {
  ordered_json json = input_json(report);
  add_sizes(json, report);
  add_skin_parts(json, report.parts);
  if (report.grid_step) json["grid_step"] = rounded(*report.grid_step);
  json.update(certificate_json(report.certificate));
  json["quality"] = quality_json(report.quality, report.certificate.area);
  json["certified_file"] = report.certified_file;
  json["outputs"] = ordered_json::array();
  for (const std::filesystem::path& output : report.outputs)
    json["outputs"].push_back(output.string());
  json["provenance"] = geometry::provenance_json(report.provenance);
  add_run_json(json, report);
  if (report.growth) json["growth"] = growth_json(*report.growth);
  json["seconds"] = seconds_json(report.seconds);
  json["floor_ratio"] = rounded(report.floor_ratio());
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  return strict_json(json);
}

}  // namespace morskin::app
