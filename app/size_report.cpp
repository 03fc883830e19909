// What the report of a mesh tells of the sizes that were asked for.

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/report.h"
#include "app/report_lines.h"

namespace morskin::app {

namespace {

/// What was asked for and not reached, within a tenth; empty if nothing.
std::string missed_size(const MeshReport& report) {
  constexpr double tenth = 0.1;
  const auto is_missed = [&](double is, double wanted) {
    return !(std::abs(is - wanted) <= tenth * wanted);
  };
  const std::optional<double>& density = report.size_goal.density;
  const std::optional<double>& count = report.size_goal.triangles;
  const certify::Certificate& made = report.certificate;
  std::string wanted;
  if (density && is_missed(static_cast<double>(made.vertices) / made.area, *density)) {
    wanted = brief(*density) + " vertices per A^2";
  }
  if (count && is_missed(static_cast<double>(made.triangles), *count)) {
    wanted = grouped(static_cast<std::size_t>(*count)) + " triangles";
  }
  if (wanted.empty()) return "";
  return "not " + wanted + ", as asked: where the skin bends strongly, in necks, voids and " +
         "crevices, -C forces more triangles, 0.4 the fewest" +
         (report.grading ? "; about these so does --grading" : "");
}

std::string bent_text(const morskin::BentPart& bent) {
  const auto lying_there = static_cast<std::size_t>(std::llround(bent.triangles));
  return line("bent", brief(100 * bent.area_share, 3) +
                          "% of the area bends too much for edges so long: " +
                          counted(lying_there, "triangle", "triangles") + ", " +
                          brief(bent.triangles / bent.forced_triangles) + " times the " +
                          grouped(std::llround(bent.forced_triangles)) +
                          " that R <= 0.68 length scales forces");
}

std::string grading_text(const morskin::Grading& grading) {
  return line("grading", "edges " + brief(grading.median, 3) + " times as long as growth by " +
                             brief(grading.allowed) + " from shorter ones allows (median), " +
                             brief(grading.most, 3) + " at most but for 1%, " +
                             brief(grading.largest, 3) + " at most");
}

}  // namespace

void add_edge_length(nlohmann::ordered_json& json, const certify::Sizing& sizing) {
  if (std::isfinite(sizing.largest_length_scale))
    json["edge_length"] = rounded(sizing.edge_length());
}

void add_sizes(nlohmann::ordered_json& json, const MeshReport& report) {
  if (const std::string missed = missed_size(report); !missed.empty()) json["missed_size"] = missed;
  if (report.bent) {
    json["bent"] = {{"area_share", rounded(report.bent->area_share)},
                    {"triangles", std::round(report.bent->triangles)},
                    {"forced_triangles", std::round(report.bent->forced_triangles)}};
  }
  if (report.curved) {
    json["second_order"] = curved_json(*report.curved);
  }
  if (report.grading) {
    json["grading"] = {{"allowed", rounded(report.grading->allowed)},
                       {"median", rounded(report.grading->median)},
                       {"quantile_99", rounded(report.grading->most)},
                       {"largest", rounded(report.grading->largest)}};
  }
}

std::string sizes_text(const MeshReport& report) {
  std::string text;
  if (const std::string missed = missed_size(report); !missed.empty()) {
    text += line("missed", missed);
  }
  if (report.bent && std::llround(report.bent->forced_triangles) > 0) {
    text += bent_text(*report.bent);
  }
  if (report.grading) text += grading_text(*report.grading);
  if (report.curved) text += curved_text(*report.curved);
  return text;
}

std::string brief_text(const MeshReport& report) {
  const certify::Certificate& made = report.certificate;
  const double density = static_cast<double>(made.vertices) / made.area;
  const std::string name = report.outputs.empty() ? "no file" : report.outputs.front().string();
  return name + ": " + grouped(made.vertices) + " vertices, " + grouped(made.triangles) +
         " triangles, " + brief(density, 3) + " vertices per A^2, " +
         (made.certified ? "certified" : "not certified") + "\n";
}

}  // namespace morskin::app
