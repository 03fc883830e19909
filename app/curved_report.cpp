#include "app/curved_report.h"

#include "app/report.h"

namespace morskin::app {

CurvedReport curved_report(const geometry::SecondOrderMesh& mesh) {
  return {mesh.nodes.size(), certify::measure_curved(mesh), certify::objection_to_nodes(mesh)};
}

nlohmann::ordered_json curved_json(const CurvedReport& report) {
  nlohmann::ordered_json json = {{"nodes", report.nodes},
                                 {"area", rounded(report.measures.area, 12)}};
  if (const auto unproved = report.measures.first_unproved) {
    json["least_jacobian"] = nullptr;
    json["least_jacobian_reason"] = "triangle " + std::to_string(*unproved) + " has none proved";
  } else {
    json["least_jacobian"] = rounded_lower_bound(report.measures.least_jacobian);
  }
  return json;
}

std::string curved_text(const CurvedReport& report) {
  return line("curved",
              grouped(report.nodes) + " nodes, area " + brief(report.measures.area, 6) +
                  " A^2, Jacobians " +
                  (report.measures.first_unproved
                       ? "not proved positive"
                       : "at least " + brief_lower_bound(report.measures.least_jacobian, 4) +
                             " of the flat triangles'"));
}

}  // namespace morskin::app
