// How good the triangles of a mesh are, in reports.

#include <nlohmann/json.hpp>

#include "app/report.h"

namespace morskin::app {

using certify::MeshQuality;
using nlohmann::ordered_json;

namespace {

std::string share(std::size_t part, std::size_t whole) {
  return brief(100 * static_cast<double>(part) / static_cast<double>(whole), 3) + "%";
}

double per_area(std::size_t count, double area) { return static_cast<double>(count) / area; }

}  // namespace

ordered_json quality_json(const MeshQuality& quality, double area) {
  ordered_json below, above;
  for (const int deg : {30, 35, 40}) below[std::to_string(deg)] = quality.triangles_below(deg);
  for (const int deg : {90, 105, 120}) above[std::to_string(deg)] = quality.triangles_above(deg);
  return {{"triangles_below_deg", below},
          {"triangles_above_deg", above},
          {"histogram_bin_deg", MeshQuality::bin_deg},
          {"smallest_angle_histogram", quality.smallest_angles},
          {"largest_angle_histogram", quality.largest_angles},
          {"min_valence", quality.min_valence},
          {"max_valence", quality.max_valence},
          {"vertices_by_valence", quality.valences},
          {"min_radius_ratio", rounded_lower_bound(quality.min_radius_ratio)},
          {"mean_radius_ratio", rounded(quality.mean_radius_ratio)},
          {"edge_length_quantiles",
           {{"5", rounded(quality.edges.short_end)},
            {"50", rounded(quality.edges.median)},
            {"95", rounded(quality.edges.long_end)}}},
          {"vertices_per_square_angstrom", rounded(per_area(quality.vertices, area))},
          {"triangles_per_square_angstrom", rounded(per_area(quality.triangles, area))}};
}

std::string quality_text(const MeshQuality& quality, double area) {
  if (quality.triangles == 0) return "";
  const std::size_t usual = quality.valences[5] + quality.valences[6] + quality.valences[7];
  const auto below = [&](int deg) {
    return share(quality.triangles_below(deg), quality.triangles);
  };
  const auto above = [&](int deg) {
    return share(quality.triangles_above(deg), quality.triangles);
  };
  return line("density", brief(per_area(quality.vertices, area), 3) + " vertices, " +
                             brief(per_area(quality.triangles, area), 3) +
                             " triangles per A^2; edges of " + brief(quality.edges.median, 3) +
                             " A in the median, 90% from " + brief(quality.edges.short_end, 3) +
                             " to " + brief(quality.edges.long_end, 3)) +
         line("valences", std::to_string(quality.min_valence) + " to " +
                              std::to_string(quality.max_valence) + ", 5 to 7 at " +
                              share(usual, quality.vertices) + " of vertices; radius ratio " +
                              brief_lower_bound(quality.min_radius_ratio, 3) + " at least, " +
                              brief(quality.mean_radius_ratio, 3) + " on average") +
         line("shares", below(30) + " of triangles below 30 degrees, " + below(35) + " below 35, " +
                            below(40) + " below 40; " + above(90) + " above 90, " + above(105) +
                            " above 105, " + above(120) + " above 120");
}

}  // namespace morskin::app
