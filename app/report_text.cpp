// What `mesh` tells people.

#include <algorithm>
#include <cmath>

#include "app/function_argument.h"
#include "app/presets.h"
#include "app/report.h"

namespace morskin::app {

std::string replacement_text(const morskin::Fallback& fallback) {
  if (!fallback.replacement) return "nothing";
  if (fallback.replacement->method == morskin::Method::Static) return "static";
  const geometry::Vector& v = fallback.replacement->function.direction;
  return "sweep along (" + brief(v.x(), 3) + ", " + brief(v.y(), 3) + ", " + brief(v.z(), 3) + ")";
}

std::string critical_text(const morskin::CriticalCounts& counts) {
  return counted(counts[0], "minimum", "minima") + " - " + counted(counts[1], "saddle", "saddles") +
         " + " + counted(counts[2], "maximum", "maxima");
}

namespace {

std::string function_text(const MeshReport& report) {
  const morskin::CriticalCounts& left = report.counts.surviving_points;
  return line("function", in_words(report.counts.function)) +
         line("critical", critical_text(report.counts.critical_points) + "; " + grouped(left[0]) +
                              " - " + grouped(left[1]) + " + " + grouped(left[2]) + " survive");
}

std::string sweep_text(const front::Operations& done) {
  return line("sweep", grouped(done.creation) + " created, " + grouped(done.creep) + " crept, " +
                           grouped(done.wing) + " winged, " + grouped(done.bridge) + " bridged, " +
                           grouped(done.seal) + " sealed") +
         line("touches", grouped(done.guard_inside_protecting) + " in protecting spheres, " +
                             grouped(done.guard_outside_protecting) + " outside, of which " +
                             grouped(done.futile_inside_protecting) + " and " +
                             grouped(done.futile_outside_protecting) + " futile") +
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
                      counted(growth.inspections, "inspection", "inspections"));
}

/// What raised the angles, and how far.
std::string smoothing_text(const morskin::RunCounts& counts, double goal_deg) {
  std::string text = counted(counts.smoothing.moved, "vertex", "vertices") +
                     " moved for angles of " + brief(goal_deg) + " degrees";
  const std::size_t changed = counts.improvement.changed + counts.angles.inserted;
  if (changed > 0) text += ", " + grouped(changed) + " taken out or put in";
  if (counts.below_goal() > 0) {
    text += ", " + counted(counts.below_goal(), "triangle", "triangles") + " left below";
  }
  return text;
}

/// What the method did.
std::string method_text(const MeshReport& report) {
  if (report.grid_step) {
    return line("grid", "marching cubes, step " + brief(*report.grid_step) + " A");
  }
  if (report.growth) return growth_text(*report.growth);
  const bool is_sweep = report.method == MeshMethod::Sweep;
  const std::string why = !report.is_method_chosen ? ""
                          : report.grading         ? ", as --grading needs"
                                                   : ", as C is above 0.25";
  return (is_sweep ? "" : line("method", std::string(name_of(report.method)) + why)) +
         function_text(report) + (is_sweep ? sweep_text(report.counts.operations) : "") +
         line("refinement",
              counted(report.counts.refinement.flip, "flip", "flips") + ", " +
                  counted(report.counts.refinement.contract, "contraction", "contractions") + ", " +
                  counted(report.counts.refinement.insert, "insertion", "insertions")) +
         line("smoothing", smoothing_text(report.counts, report.angle_goal_deg));
}

/// What was replaced; first what could not be, which is why the mesh is not certified.
std::string fallback_text(const MeshReport& report) {
  constexpr std::size_t max_lines = 5;
  std::vector<morskin::Fallback> fallbacks = report.fallbacks;
  std::stable_partition(fallbacks.begin(), fallbacks.end(),
                        [](const morskin::Fallback& f) { return !f.replacement; });
  std::string text;
  for (std::size_t i = 0; i < std::min(fallbacks.size(), max_lines); ++i) {
    const morskin::Fallback& f = fallbacks[i];
    text += line("fallback", "component " + std::to_string(f.component) + ", from " +
                                 std::string(name_of(report.method)) + " to " +
                                 replacement_text(f) + ": " + f.reason);
  }
  if (fallbacks.size() <= max_lines) return text;
  return text + line("fallback", counted(fallbacks.size() - max_lines, "component", "components") +
                                     " more; --report lists them");
}

/// Of what balls the skin is, and how fine the mesh.
std::string skin_text(const MeshReport& report) {
  const MoleculeArguments& molecule = report.molecule;
  std::string text = "weights as given";
  if (molecule.model != skin::Model::Given) text = model_text(molecule);
  if (molecule.radii) text += ", radii " + *molecule.radii;
  if (molecule.selection.assembly) text += ", biological assembly " + *molecule.selection.assembly;
  text += ", patch radii " + brief(report.patch_radius_min) + " to " +
          brief(report.patch_radius_max) + " A, C " + brief(report.sizing.C) + ", Q " +
          brief(report.sizing.Q);
  if (std::isfinite(report.sizing.largest_length_scale)) {
    text += ", edges of " + brief(report.sizing.edge_length()) + " A";
  }
  return line("skin", text);
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
  text += answers_text(report);
  if (report.preset) text += line("preset", preset_text(*report.preset));
  text += line("atoms", grouped(report.atoms_used) + " used, " + grouped(skipped(report.reading)) +
                            " left out" + (words.empty() ? "" : " (" + words + ")"));
  const std::string model = model_in_words(report.reading, report.molecule.selection);
  if (!model.empty()) text += line("models", model);
  if (report.rounded_coordinates > 0) {
    text += line("rounded", counted(report.rounded_coordinates, "coordinate", "coordinates") +
                                " to multiples of 2^-120 A");
  }
  text += skin_text(report);
  if (const std::string doubts = doubts_about(report.sizing); !doubts.empty()) {
    text +=
        line("range", doubts + (report.certificate.certified ? "; certified all the same" : ""));
  }
  text += waists_text(report.parts);
  text += sizes_text(report);
  text +=
      certificate_text(report.certificate) + quality_text(report.quality, report.certificate.area);
  text += method_text(report);
  text += fallback_text(report);
  text += line("time", brief(s.total, 3) + " s: read " + brief(s.read, 2) + ", triangulate " +
                           brief(s.triangulate, 2) + ", sweep " + brief(s.sweep, 2) + ", refine " +
                           brief(s.refine, 2) + ", smooth " + brief(s.smooth, 2) + ", certify " +
                           brief(s.certify, 2) + ", write " + brief(s.write, 2) + "; " +
                           brief(report.floor_ratio(), 3) + " times the floor");
  text += line("memory", grouped(report.peak_memory_bytes / (1 << 20)) + " MiB at most");
  text += report.certificate.certified
              ? certified_text(report.certificate) + " (" + report.certified_file + " read back)\n"
              : "NOT certified: " + report.certificate.reason + "\n";
  return text;
}

}  // namespace morskin::app
