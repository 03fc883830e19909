// The certificate in reports.

#include <cmath>
#include <nlohmann/json.hpp>

#include "app/report.h"

namespace morskin::app {

using certify::Certificate;
using nlohmann::ordered_json;

ordered_json certificate_json(const Certificate& c) {
  const double distance = rounded_bound(c.max_distance_to_skin);
  const double relative_distance = rounded_bound(c.max_relative_distance_to_skin);
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
                       {"proved_angle_deg", c.proved_angle_deg()},
                       {"worst_L", c.worst_L},
                       {"worst_U", c.worst_U},
                       {"violations_L", c.violations_L},
                       {"violations_U", c.violations_U},
                       {"max_distance_to_skin", distance},
                       {"max_relative_distance_to_skin", relative_distance},
                       {"single_precision", c.is_single_precision},
                       {"area", rounded(c.area, 12)},
                       {"volume", rounded(c.volume, 12)},
                       {"covering_degree_ok", c.covering_degree_ok},
                       {"restricted_delaunay_violations", c.restricted_delaunay_violations},
                       {"homeomorphic", c.is_homeomorphic},
                       {"certified", c.certified}};
  if (!c.certified) json["reason"] = c.reason;
  if (!std::isfinite(c.max_distance_to_skin)) {
    for (const std::string name : {"max_distance_to_skin", "max_relative_distance_to_skin"}) {
      json[name] = nullptr;
      json[name + "_reason"] = "no bound is known of a vertex's distance from the skin";
    }
  }
  if (c.holds(certify::Claim::Manifold)) return json;
  for (const std::string name : {"components", "euler_characteristic", "genus"}) {
    json[name] = nullptr;
    json[name + "_reason"] = "not counted, for the mesh is no closed oriented 2-manifold";
  }
  json["volume"] = nullptr;
  json["volume_reason"] = "the mesh is no closed oriented 2-manifold";
  return json;
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
                   " is above 0.378, so [U] does not imply what the certificate asks of triangles");
  } else {
    add(sizing.is_sample_proved_dense(),
        "C Q = " + brief(sizing.C * sizing.Q, 3) +
            " is above 0.215, up to which sampling theory reaches; the certificate decides");
  }
  return doubts;
}

std::string extent_text(double area, double volume, bool is_closed) {
  return line("extent", "area " + brief(area, 6) + " A^2" +
                            (is_closed ? ", volume " + brief(volume, 6) + " A^3" : ""));
}

namespace {

std::string proved_text(const Certificate& c) {
  return std::string("homeomorphic to the skin, ") +
         (c.violations_L == 0 ? "[L] and [U] hold" : "[U] holds, no angle is below 30 degrees");
}

/// What a certificate asks of angles: those claimed, or what [L] and [U] imply. Where [L] is broken
/// and the angles are known all the same it goes by these.
double angle_bound_deg(const Certificate& c, const certify::Sizing& sizing) {
  if (c.claimed_angle_deg > 0) return c.claimed_angle_deg;
  const bool is_known = c.proved_angle_deg() >= certify::guaranteed_angle_deg;
  return c.violations_L > 0 && is_known ? certify::guaranteed_angle_deg : sizing.angle_bound_deg();
}

}  // namespace

std::string certified_text(const Certificate& c) { return "certified: " + proved_text(c); }

std::string measures_text(const Certificate& c, const certify::Sizing& sizing) {
  std::string text = extent_text(c.area, c.volume, c.holds(certify::Claim::Manifold)) +
                     line("mesh", counted(c.triangles, "triangle", "triangles") + ", " +
                                      counted(c.vertices, "vertex", "vertices"));
  if (c.triangles == 0) return text;
  return text + line("angles", angles_text(c.min_angle_deg, c.max_angle_deg) + " (bound " +
                                   brief(angle_bound_deg(c, sizing)) + ")");
}

namespace {

std::string counts_text(std::size_t components, long genus, long euler_characteristic) {
  return counted(components, "component", "components") + ", genus " +
         grouped(static_cast<long long>(genus)) + ", Euler characteristic " +
         grouped(static_cast<long long>(euler_characteristic));
}

}  // namespace

std::string certificate_text(const Certificate& c, std::string_view source) {
  const std::string found = counts_text(c.components, c.genus, c.euler_characteristic);
  const std::string expected =
      counts_text(c.expected_components, c.expected_genus, c.expected_euler_characteristic);
  const bool is_manifold = c.holds(certify::Claim::Manifold);
  std::string text = line("topology", !is_manifold        ? "not counted, for that takes a manifold"
                                      : found == expected ? found + ", as " + std::string(source)
                                                          : found);
  if (!is_manifold || found != expected) text += line("expected", expected);
  if (c.triangles > 0) {
    text += line("sizes", "[L] " + brief(c.worst_L, 6) + " (good above 1), [U] " +
                              brief(c.worst_U, 6) + " (good below 1), " +
                              counted(c.violations_L + c.violations_U, "violation", "violations"));
  }
  text += line("distance", !std::isfinite(c.max_distance_to_skin)
                               ? "no bound is known of a vertex's distance from the skin"
                               : "no vertex farther than " +
                                     brief_bound(c.max_distance_to_skin, 2) + " A from the skin, " +
                                     brief_bound(c.max_relative_distance_to_skin, 2) +
                                     " of the length scale");
  if (c.is_single_precision) text += line("", "(all coordinates are single precision)");
  return text;
}

std::string answers_text(const MeshReport& report) {
  const certify::Certificate& c = report.certificate;
  return surfaces_text(report.parts, c.area) + measures_text(c, report.sizing) +
         line("proved", c.certified ? proved_text(c) : "NO: " + c.reason);
}

}  // namespace morskin::app
