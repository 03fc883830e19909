#include "app/check_report.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "app/report.h"
#include "app/strict_json.h"
#include "app/surface_report.h"

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

/// By MeshDefect.
constexpr std::array defect_names{"no_triangles",
                                  "triangles_with_repeated_corners",
                                  "triangles_with_collinear_corners",
                                  "duplicate_triangles",
                                  "boundary_edges",
                                  "crowded_edges",
                                  "disagreeing_edges",
                                  "split_vertices",
                                  "unused_vertices"};

ordered_json verdicts_json(const CheckReport& report) {
  ordered_json result = ordered_json::array();
  for (const Verdict& v : report.verdicts()) {
    ordered_json entry = {{"name", v.name}, {"holds", v.holds}, {"required", v.is_required}};
    if (!v.holds) entry["reason"] = v.reason;
    result.push_back(entry);
  }
  return result;
}

constexpr std::size_t most_components = 10000;  // a triangle that repeats a corner is one by itself

ordered_json components_json(const geometry::MeshCheck& topology) {
  ordered_json result = ordered_json::array();
  const std::size_t count = std::min(most_components, topology.components.size());
  for (const geometry::MeshComponent& c : std::span(topology.components).first(count)) {
    ordered_json entry = {{"first_triangle", c.first_triangle},
                          {"triangles", c.triangles},
                          {"vertices", c.vertices},
                          {"euler_characteristic", c.euler_characteristic()},
                          {"closed_and_oriented", c.is_closed_and_oriented},
                          {"area", rounded(c.area, 12)}};
    if (c.is_closed_and_oriented) {
      entry["genus"] = c.genus();
      entry["volume"] = rounded(c.volume, 12);
    }
    result.push_back(entry);
  }
  return result;
}

template <class Bad>
ordered_json worst_json(const std::vector<Bad>& worst, const char* value) {
  ordered_json result = ordered_json::array();
  for (const Bad& bad : worst) {
    if constexpr (std::is_same_v<Bad, certify::BadEdge>) {
      result.push_back({{"edge", {bad.a, bad.b}}, {value, rounded(bad.value)}});
    } else if constexpr (std::is_same_v<Bad, certify::BadVertex>) {
      result.push_back({{"vertex", bad.vertex},
                        {"distance", rounded(bad.distance)},
                        {value, rounded(bad.relative)}});
    } else {
      result.push_back({{"triangle", bad.triangle}, {value, rounded(bad.value)}});
    }
  }
  return result;
}

void add_topology_json(ordered_json& json, const geometry::MeshCheck& topology) {
  json["closed_oriented_manifold"] = topology.is_closed_oriented_manifold();
  json["components"] = topology.components.size();
  json.erase("components_reason");
  if (topology.is_closed_oriented_manifold()) {
    long genus = 0, euler = 0;
    for (const geometry::MeshComponent& c : topology.components) {
      genus += c.genus();
      euler += c.euler_characteristic();
    }
    json["euler_characteristic"] = euler;
    json["genus"] = genus;
  }
  json["defects"] = ordered_json::object();
  for (const geometry::DefectCount& defect : topology.defects) {
    json["defects"][defect_names[static_cast<std::size_t>(defect.kind)]] = {
        {"count", defect.count}, {"first", defect.first}};
  }
  json["component_list"] = components_json(topology);
}

void add_angles_json(ordered_json& json, const CheckReport& report) {
  for (const auto& [name, angle] : {std::pair("min_angle_deg", report.shape.min_angle_deg),
                                    std::pair("max_angle_deg", report.shape.max_angle_deg)}) {
    json[name] = report.triangles > 0 ? ordered_json(angle) : nullptr;
    if (report.triangles == 0) json[std::string(name) + "_reason"] = "the mesh has no triangle";
  }
}

void add_skin_json(ordered_json& json, const AgainstSkin& against) {
  const certify::Deviations& d = against.deviations;
  json["max_centroid_distance"] = rounded(d.max_centroid_distance);
  json["max_centroid_relative_distance"] = rounded(d.max_centroid_relative);
  json["mean_relative_distance"] = rounded(d.mean_vertex_relative);
  json["mean_centroid_relative_distance"] = rounded(d.mean_centroid_relative);
  json["max_normal_deviation_deg"] = rounded(d.max_normal_deg);
  json["farthest_vertices"] = worst_json(d.farthest_vertices, "relative_distance");
  json["farthest_centroids"] = worst_json(d.farthest_centroids, "relative_distance");
  json["worst_edges"] = worst_json(d.shortest_edges, "L");
  json["worst_triangles"] = worst_json(d.largest_triangles, "U");
  json["steepest_triangles"] = worst_json(d.steepest_triangles, "normal_deviation_deg");
  json["restricted_delaunay_violations"] = against.delaunay.violations;
  json["restricted_delaunay_undecided"] = against.delaunay.undecided;
  json["restricted_delaunay_deepest"] = ordered_json::array();
  for (const certify::DelaunayViolation& v : against.delaunay.deepest) {
    json["restricted_delaunay_deepest"].push_back(
        {{"triangle", v.triangle}, {"vertex", v.vertex}, {"depth", rounded(v.depth)}});
  }
  json["skin_components"] = ordered_json::array();
  for (const CoveredComponent& component : against.covered) {
    json["skin_components"].push_back({{"name", component.name},
                                       {"dropped", component.is_dropped},
                                       {"covered_by", component.by}});
  }
}

std::string histogram_text(const CheckReport& report) {
  std::string text;
  const auto angles = static_cast<double>(3 * report.triangles);
  for (std::size_t k = 0; k < report.angles.size(); ++k) {
    if (report.angles[k] == 0) continue;
    text += (text.empty() ? "" : ", ") + std::to_string(10 * k) + "-" +
            std::to_string(10 * k + 10) + ": " +
            brief(100 * static_cast<double>(report.angles[k]) / angles, 3) + "%";
  }
  return text;
}

std::string components_text(const geometry::MeshCheck& topology) {
  constexpr std::size_t max_shown = 12;
  std::string text;
  for (std::size_t i = 0; i < std::min(max_shown, topology.components.size()); ++i) {
    const geometry::MeshComponent& c = topology.components[i];
    std::string words =
        counted(c.triangles, "triangle", "triangles") + ", area " + brief(c.area, 6) + " A^2";
    words += !c.is_closed_and_oriented
                 ? ", not closed and oriented"
                 : ", genus " + grouped(static_cast<long long>(c.genus())) + ", volume " +
                       brief(c.volume, 6) + " A^3" + (c.volume < 0 ? " (a cavity)" : "");
    text += line(i == 0 ? "components" : "", std::to_string(i) + ": " + words);
  }
  if (topology.components.size() > max_shown) {
    text += line("", "and " + grouped(topology.components.size() - max_shown) + " more");
  }
  return text;
}

// "triangle 3: 0.98, ..." for the worst few.
template <class Bad, class Words>
std::string worst_text(const std::string& label, const std::vector<Bad>& worst, Words words) {
  std::string text;
  for (const Bad& bad : worst) text += (text.empty() ? "" : ", ") + words(bad);
  return worst.empty() ? "" : line(label, text);
}

std::string skin_text(const CheckReport& report) {
  const AgainstSkin& against = *report.against;
  const certify::Deviations& d = against.deviations;
  std::string text =
      measures_text(against.certificate, report.arguments.sizing) +
      (report.arguments.surface ? certificate_text(against.certificate, critical_points_say)
                                : certificate_text(against.certificate));
  text +=
      line("centroids", "up to about " + brief(d.max_centroid_distance, 2) + " A from the skin, " +
                            brief(d.max_centroid_relative, 2) + " of the length scale");
  text += line("normals",
               "no more than " + brief_bound(d.max_normal_deg, 4) + " degrees off the skin's");
  text += line("Delaunay", counted(against.delaunay.violations, "triangle", "triangles") +
                               " with a vertex in the surface ball");
  if (report.arguments.surface) text = searched_text(against.within) + about_surface(text);
  text += "the worst ten:\n";
  const auto triangle = [](const certify::BadTriangle& bad) {
    return std::to_string(bad.triangle) + ": " + brief(bad.value);
  };
  text += worst_text("vertices", d.farthest_vertices, [](const certify::BadVertex& bad) {
    return std::to_string(bad.vertex) + ": " + brief(bad.relative, 2);
  });
  text += worst_text("centroids", d.farthest_centroids, triangle);
  text += worst_text("edges [L]", d.shortest_edges, [](const certify::BadEdge& bad) {
    return std::to_string(bad.a) + "-" + std::to_string(bad.b) + ": " + brief(bad.value);
  });
  text += worst_text("sizes [U]", d.largest_triangles, triangle);
  text += worst_text("normals", d.steepest_triangles, triangle);
  text += worst_text("Delaunay", against.delaunay.deepest, [](const certify::DelaunayViolation& v) {
    return std::to_string(v.triangle) + ": " + brief(v.depth, 2);
  });
  return text;
}

}  // namespace

std::string json_text(const CheckReport& report) {
  const CheckArguments& arguments = report.arguments;
  ordered_json json = {{"mesh", arguments.mesh.string()}};
  if (arguments.against) {
    json["input"] = arguments.against->input.string();
    add_skin(json, *arguments.against);
  }
  if (arguments.surface) json["surface"] = *arguments.surface;
  if (report.against && report.against->within) json["within"] = *report.against->within;
  if (arguments.against || arguments.surface) {
    json.update({{"C", arguments.sizing.C}, {"Q", arguments.sizing.Q}});
    add_edge_length(json, arguments.sizing);
  }
  add_origin(json, report.origin);
  const std::vector<Verdict> verdicts = report.verdicts();
  const auto broken =
      std::ranges::find_if(verdicts, [](const Verdict& v) { return !v.holds && v.is_required; });
  json["passed"] = broken == verdicts.end();
  if (report.against) json.update(certificate_json(report.against->certificate));
  if (report.against && report.curved && broken != verdicts.end()) json["certified"] = false;
  json["vertices"] = report.vertices;
  json["triangles"] = report.triangles;
  if (broken != verdicts.end() && !json.contains("reason")) json["reason"] = broken->reason;
  if (report.fitting_model) json["fitting_model"] = skin::name_of(*report.fitting_model);
  if (report.fitting_C) json["fitting_C"] = rounded(*report.fitting_C);
  json["verdicts"] = verdicts_json(report);
  add_topology_json(json, report.topology);
  add_angles_json(json, report);
  json["angle_histogram"] = report.angles;
  json["quality"] = quality_json(report.quality, report.shape.area);
  json["area"] = rounded(report.shape.area, 12);
  if (report.topology.is_closed_oriented_manifold()) {
    json["volume"] = rounded(report.shape.volume, 12);
  }
  if (report.intersections) {
    json["self_intersections"] = report.intersections->count;
    json["self_intersections_complete"] = report.intersections->is_complete;
    json["self_intersecting_pairs"] = report.intersections->pairs;
  }
  if (report.curved) json["second_order"] = curved_json(*report.curved);
  if (report.against) add_skin_json(json, *report.against);
  json["seconds"] = rounded(report.seconds);
  return strict_json(json);
}

std::string people_text(const CheckReport& report) {
  const CheckArguments& arguments = report.arguments;
  std::string text = arguments.mesh.string();
  if (arguments.against) text += " against " + arguments.against->input.string();
  if (arguments.surface) text += " against " + *arguments.surface;
  text += "\n" + origin_text(report.origin);
  if (arguments.against) text += skin_text(*arguments.against, arguments.sizing);
  const geometry::MeshCheck& topology = report.topology;
  text += line("manifold", topology.defects.empty()
                               ? "closed, oriented"
                               : "NOT closed and oriented: " + topology.defects[0].first);
  text += components_text(topology);
  if (report.against) {
    text += skin_text(report);
  } else {
    text += line("mesh", counted(report.triangles, "triangle", "triangles") + ", " +
                             counted(report.vertices, "vertex", "vertices"));
    if (report.triangles > 0) {
      text += line("angles", angles_text(report.shape.min_angle_deg, report.shape.max_angle_deg));
    }
    text += extent_text(report.shape.area, report.shape.volume, topology.defects.empty());
  }
  if (report.curved) text += curved_text(*report.curved);
  text += quality_text(report.quality, report.shape.area);
  if (report.triangles > 0) text += line("all angles", histogram_text(report));
  if (!report.intersections) text += line("crossings", "not searched");
  for (const Verdict& v : report.verdicts()) {
    text += (v.holds         ? "  yes  "
             : v.is_required ? "  NO   "
                             : "  no   ") +
            v.name + (v.holds ? "" : ": " + v.reason) + "\n";
  }
  if (report.fitting_model) {
    const std::string name(skin::name_of(*report.fitting_model));
    text += "it is homeomorphic to the skin of model " + name + "; add --model " + name + "\n";
  }
  if (report.fitting_C) {
    text += "its triangles meet [U] from C = " + brief(*report.fitting_C) +
            " on; add -C with the C that it was made with\n";
  }
  if (!report.against) {
    text += "the surface was not checked; --against INPUT runs the certificate\n";
  }
  return text;
}

}  // namespace morskin::app
