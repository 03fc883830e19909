#include "app/report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "app/function_argument.h"
#include "app/strict_json.h"

namespace morskin::app {
namespace {

using certify::Certificate;
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

ordered_json critical_json(const morskin::CriticalCounts& counts) {
  return {{"minima", counts[0]}, {"saddles", counts[1]}, {"maxima", counts[2]}};
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
          {"looks", growth.looks}};
}

ordered_json seconds_json(const RunSeconds& seconds) {
  return {{"read", rounded(seconds.read)},
          {"triangulate", rounded(seconds.triangulate)},
          {"mixed_complex", rounded(seconds.mixed_complex)},
          {"dual_complex", rounded(seconds.dual_complex)},
          {"critical_points", rounded(seconds.critical_points)},
          {"sweep", rounded(seconds.sweep)},
          {"refine", rounded(seconds.refine)},
          {"smooth", rounded(seconds.smooth)},
          {"certify", rounded(seconds.certify)},
          {"write", rounded(seconds.write)},
          {"total", rounded(seconds.total)}};
}

ordered_json skipped_json(const skin::ReadingCounts& counts) {
  return {{"waters", counts.waters},
          {"alternates", counts.alternates},
          {"zero_radii", counts.zero_radii},
          {"unknown_elements", counts.unknown}};
}

/// What took a component's place, in words.
std::string replacement_text(const morskin::Fallback& fallback) {
  if (!fallback.replacement) return "nothing";
  if (fallback.replacement->method == morskin::Method::Static) return "static";
  const geometry::Vector& v = fallback.replacement->function.direction;
  return "sweep along (" + brief(v.x(), 3) + ", " + brief(v.y(), 3) + ", " + brief(v.z(), 3) + ")";
}

ordered_json fallbacks_json(const std::vector<morskin::Fallback>& fallbacks) {
  ordered_json json = ordered_json::array();
  for (const morskin::Fallback& f : fallbacks) {
    json.push_back({{"component", f.component},
                    {"from", "sweep"},
                    {"to", replacement_text(f)},
                    {"why", f.reason}});
  }
  return json;
}

double floor_ratio(const MeshReport& report) {
  return report.floor_seconds > 0 ? report.seconds.total / report.floor_seconds : 0;
}

}  // namespace

ordered_json certificate_json(const Certificate& c) {
  ordered_json json = {{"vertices", c.vertices},
                       {"triangles", c.triangles},
                       {"components", c.components},
                       {"euler_characteristic", c.euler_characteristic},
                       {"genus", c.genus},
                       {"expected_euler_characteristic", c.expected_euler_characteristic},
                       {"expected_components", c.expected_components},
                       {"expected_genus", c.expected_genus},
                       {"min_angle_deg", c.min_angle_deg},
                       {"max_angle_deg", c.max_angle_deg},
                       {"worst_L", c.worst_L},
                       {"worst_U", c.worst_U},
                       {"violations_L", c.violations_L},
                       {"violations_U", c.violations_U},
                       {"max_distance_to_skin", rounded(c.max_distance_to_skin)},
                       {"max_relative_distance_to_skin", rounded(c.max_relative_distance_to_skin)},
                       {"single_precision", c.is_single_precision},
                       {"area", rounded(c.area, 12)},
                       {"volume", rounded(c.volume, 12)},
                       {"covering_degree_ok", c.covering_degree_ok},
                       {"restricted_delaunay_violations", c.restricted_delaunay_violations},
                       {"homeomorphic", c.is_homeomorphic},
                       {"certified", c.certified}};
  if (!c.certified) json["reason"] = c.reason;
  return json;
}

std::string json_text(const MeshReport& report) {
  ordered_json json = {{"input", report.molecule.input.string()},
                       {"model", skin::name_of(report.molecule.model)},
                       {"probe", report.molecule.probe},
                       {"atoms_used", report.atoms_used},
                       {"atoms_skipped", skipped(report.reading)},
                       {"atoms_skipped_by_reason", skipped_json(report.reading)},
                       {"atoms_duplicate", report.reading.duplicates},
                       {"atoms_hidden", report.atoms_hidden},
                       {"coordinates_rounded", report.rounded_coordinates},
                       {"patch_radius_min", rounded(report.patch_radius_min)},
                       {"patch_radius_max", rounded(report.patch_radius_max)},
                       {"method", name_of(report.method)},
                       {"C", report.sizing.C},
                       {"Q", report.sizing.Q},
                       {"C_Q_in_proved_range", doubts_about(report.sizing).empty()}};
  if (std::isfinite(report.sizing.largest_length_scale)) {
    json["edge_length"] = rounded(report.sizing.edge_length());
  }
  if (report.grid_step) json["grid_step"] = rounded(*report.grid_step);
  json.update(certificate_json(report.certificate));
  json["certified_file"] = report.certified_file;
  json["outputs"] = ordered_json::array();
  for (const std::filesystem::path& output : report.outputs)
    json["outputs"].push_back(output.string());
  json["function"] = function_json(report.counts.function);
  if (report.counts.function.is_height()) {
    const geometry::Vector& v = report.counts.function.direction;
    json["height"] = {rounded(v.x()), rounded(v.y()), rounded(v.z())};
  }
  json.update(critical_json(report.counts.critical_points));
  json["open_edges"] = report.counts.open_edges;
  json["surviving"] = critical_json(report.counts.surviving_points);
  json["fronts"] = report.fronts;
  json["fallbacks"] = fallbacks_json(report.fallbacks);
  json["operations"] = operations_json(report);
  json["smoothing"] = {{"goal_deg", report.angle_goal_deg},
                       {"below", report.counts.smoothing.below},
                       {"moved", report.counts.smoothing.moved},
                       {"left", report.counts.smoothing.left}};
  if (report.growth) json["growth"] = growth_json(*report.growth);
  json["seconds"] = seconds_json(report.seconds);
  json["floor_ratio"] = rounded(floor_ratio(report));
  json["peak_memory_bytes"] = report.peak_memory_bytes;
  return strict_json(json);
}

std::string doubts_about(const certify::Sizing& sizing) {
  std::string doubts;
  const auto add = [&](bool is_proved, const std::string& text) {
    if (!is_proved) doubts += (doubts.empty() ? "" : ", and ") + text;
  };
  add(sizing.is_refinement_proved_to_end(),
      "Q^2 is not above 2 + 4 C Q, so [L] and [U] may be in each other's way");
  if (!sizing.is_tube_proved()) {
    add(false, "C Q = " + brief(sizing.C * sizing.Q, 3) +
                   " is above 0.377, so [U] does not imply what the certificate asks of triangles");
  } else {
    add(sizing.is_sample_proved_dense(),
        "C Q = " + brief(sizing.C * sizing.Q, 3) +
            " is above 0.215, up to which sampling theory reaches; the certificate decides");
  }
  return doubts;
}

std::string certificate_text(const Certificate& c, const certify::Sizing& sizing) {
  const bool counts_agree = c.components == c.expected_components && c.genus == c.expected_genus &&
                            c.euler_characteristic == c.expected_euler_characteristic;
  std::string text;
  text += line("mesh", counted(c.triangles, "triangle", "triangles") + ", " +
                           counted(c.vertices, "vertex", "vertices"));
  text +=
      line("topology", counted(c.components, "component", "components") + ", genus " +
                           grouped(static_cast<long long>(c.genus)) + ", Euler characteristic " +
                           grouped(static_cast<long long>(c.euler_characteristic)) +
                           (counts_agree ? ", as the dual complex says" : ""));
  if (!counts_agree) {
    text += line("expected", counted(c.expected_components, "component", "components") +
                                 ", genus " + grouped(static_cast<long long>(c.expected_genus)) +
                                 ", Euler characteristic " +
                                 grouped(static_cast<long long>(c.expected_euler_characteristic)));
  }
  if (c.triangles > 0) {
    text += line("angles", brief(c.min_angle_deg) + " to " + brief(c.max_angle_deg) +
                               " degrees (bound " + brief(sizing.angle_bound_deg()) + ")");
    text += line("sizes", "[L] " + brief(c.worst_L, 6) + " (good above 1), [U] " +
                              brief(c.worst_U, 6) + " (good below 1), " +
                              counted(c.violations_L + c.violations_U, "violation", "violations"));
  }
  text += line("distance", "no vertex farther than " + brief(c.max_distance_to_skin, 2) +
                               " A from the skin, " + brief(c.max_relative_distance_to_skin, 2) +
                               " of the length scale");
  if (c.is_single_precision) text += line("", "(all coordinates are single precision)");
  text +=
      line("extent", "area " + brief(c.area, 6) + " A^2, volume " + brief(c.volume, 6) + " A^3");
  return text;
}

namespace {

std::string critical_text(const MeshReport& report) {
  const auto& [minima, saddles, maxima] = report.counts.critical_points;
  const morskin::CriticalCounts& left = report.counts.surviving_points;
  return line("function", in_words(report.counts.function)) +
         line("critical", counted(minima, "minimum", "minima") + " - " +
                              counted(saddles, "saddle", "saddles") + " + " +
                              counted(maxima, "maximum", "maxima") + "; " + grouped(left[0]) +
                              " - " + grouped(left[1]) + " + " + grouped(left[2]) + " survive");
}

std::string sweep_text(const front::Operations& done) {
  return line("sweep", grouped(done.creation) + " created, " + grouped(done.creep) + " crept, " +
                           grouped(done.wing) + " winged, " + grouped(done.bridge) + " bridged, " +
                           grouped(done.seal) + " sealed") +
         line("touches", grouped(done.guard_inside_protecting) + " in protecting spheres, " +
                             grouped(done.guard_outside_protecting) + " outside, of which " +
                             grouped(done.futile_inside_protecting) + " and " +
                             grouped(done.futile_outside_protecting) + " in vain") +
         (done.coarsen == 0
              ? ""
              : line("coarsening", counted(done.coarsen, "vertex", "vertices") + " taken out"));
}

/// What the growth did.
std::string growth_text(const baselines::GrowthCounts& growth) {
  const auto& [births, necks, tunnels, voids] = growth.metamorphoses;
  return line("growth", grouped(births) + " born, " + counted(necks, "neck", "necks") + ", " +
                            counted(tunnels, "tunnel", "tunnels") + " closed, " +
                            counted(voids, "void", "voids") + " gone, " + grouped(growth.failed) +
                            " failed") +
         line("", counted(growth.operations.flip, "flip", "flips") + ", " +
                      counted(growth.operations.contract, "contraction", "contractions") + ", " +
                      counted(growth.operations.insert, "insertion", "insertions") + " in " +
                      counted(growth.looks, "look", "looks"));
}

/// What the method did.
std::string method_text(const MeshReport& report) {
  if (report.grid_step) {
    return line("grid", "marching cubes, step " + brief(*report.grid_step) + " A");
  }
  if (report.growth) return growth_text(*report.growth);
  const bool is_sweep = report.method == MeshMethod::Sweep;
  return (is_sweep ? "" : line("method", std::string(name_of(report.method)))) +
         critical_text(report) + (is_sweep ? sweep_text(report.counts.operations) : "") +
         line("refinement",
              counted(report.counts.refinement.flip, "flip", "flips") + ", " +
                  counted(report.counts.refinement.contract, "contraction", "contractions") + ", " +
                  counted(report.counts.refinement.insert, "insertion", "insertions")) +
         line("smoothing", counted(report.counts.smoothing.moved, "vertex", "vertices") +
                               " moved for angles of " + brief(report.angle_goal_deg) + " degrees");
}

/// What was replaced; first what could not be, which is why the mesh is not certified.
std::string fallback_text(std::vector<morskin::Fallback> fallbacks) {
  constexpr std::size_t most_lines = 5;
  std::stable_partition(fallbacks.begin(), fallbacks.end(),
                        [](const morskin::Fallback& f) { return !f.replacement; });
  std::string text;
  for (std::size_t i = 0; i < std::min(fallbacks.size(), most_lines); ++i) {
    const morskin::Fallback& f = fallbacks[i];
    text += line("fallback", "component " + std::to_string(f.component) + ", from sweep to " +
                                 replacement_text(f) + ": " + f.reason);
  }
  if (fallbacks.size() <= most_lines) return text;
  return text + line("fallback", grouped(fallbacks.size() - most_lines) +
                                     " components more; --report lists them");
}

}  // namespace

std::string people_text(const MeshReport& report) {
  std::string outputs;
  for (const std::filesystem::path& output : report.outputs)
    outputs += (outputs.empty() ? "" : ", ") + output.string();
  const std::string words = skipped_in_words(report.reading);
  const RunSeconds& s = report.seconds;
  std::string text =
      report.molecule.input.string() + " -> " + (outputs.empty() ? "-" : outputs) + "\n";
  text += line("atoms", grouped(report.atoms_used) + " used, " + grouped(skipped(report.reading)) +
                            " left out" + (words.empty() ? "" : " (" + words + ")"));
  const bool is_given = report.molecule.model == skin::Model::Given;
  if (report.rounded_coordinates > 0) {
    text += line("rounded", counted(report.rounded_coordinates, "coordinate", "coordinates") +
                                " to multiples of 2^-120 A");
  }
  text += line("skin", (is_given ? "weights as given"
                                 : "model " + std::string(skin::name_of(report.molecule.model)) +
                                       ", probe " + brief(report.molecule.probe) + " A") +
                           ", patch radii " + brief(report.patch_radius_min) + " to " +
                           brief(report.patch_radius_max) + " A, C " + brief(report.sizing.C) +
                           ", Q " + brief(report.sizing.Q) +
                           (std::isfinite(report.sizing.largest_length_scale)
                                ? ", edges of " + brief(report.sizing.edge_length()) + " A"
                                : ""));
  if (const std::string doubts = doubts_about(report.sizing); !doubts.empty()) {
    text +=
        line("range", doubts + (report.certificate.certified ? "; certified all the same" : ""));
  }
  text += certificate_text(report.certificate, report.sizing);
  text += method_text(report);
  text += fallback_text(report.fallbacks);
  text += line("time", brief(s.total, 3) + " s: read " + brief(s.read, 2) + ", triangulate " +
                           brief(s.triangulate, 2) + ", sweep " + brief(s.sweep, 2) + ", refine " +
                           brief(s.refine, 2) + ", smooth " + brief(s.smooth, 2) + ", certify " +
                           brief(s.certify, 2) + ", write " + brief(s.write, 2) + "; " +
                           brief(floor_ratio(report), 3) + " times the floor");
  text += line("memory", grouped(report.peak_memory_bytes / (1 << 20)) + " MiB at most");
  text += report.certificate.certified ? "certified: homeomorphic to the skin, [L] and [U] hold (" +
                                             report.certified_file + " read back)\n"
                                       : "NOT certified: " + report.certificate.reason + "\n";
  return text;
}

}  // namespace morskin::app
