// What the report of a mesh tells of the sizes that were asked for.

#include <cmath>
#include <nlohmann/json.hpp>
#include <string>

#include "app/report.h"
#include "app/report_lines.h"

namespace morskin::app {

namespace {

std::string bent_text(const morskin::BentPart& bent) {
  return line("bent", brief(100 * bent.area_share, 3) +
                          "% of the area bends too much for edges so long: " +
                          grouped(std::llround(bent.triangles)) + " triangles, " +
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

void add_sizes(nlohmann::ordered_json& json, const MeshReport& report) {
  if (!report.missed_size.empty()) json["missed_size"] = report.missed_size;
  if (report.bent) {
    json["bent"] = {{"area_share", rounded(report.bent->area_share)},
                    {"triangles", std::round(report.bent->triangles)},
                    {"forced_triangles", std::round(report.bent->forced_triangles)}};
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
  if (!report.missed_size.empty()) text += line("missed", report.missed_size);
  if (report.bent && report.bent->forced_triangles > 0) text += bent_text(*report.bent);
  if (report.grading) text += grading_text(*report.grading);
  return text;
}

}  // namespace morskin::app
