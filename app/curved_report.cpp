#include "app/curved_report.h"

#include "app/report.h"

namespace morskin::app {

CurvedReport curved_report(const geometry::SecondOrderMesh& mesh) {
  return {mesh.nodes.size(), certify::measure_curved(mesh), certify::objection_to_nodes(mesh)};
}

nlohmann::ordered_json curved_json(const CurvedReport& report) {
  return {{"nodes", report.nodes},
          {"area", rounded(report.measures.area, 12)},
          {"least_jacobian", rounded(report.measures.least_jacobian)}};
}

std::string curved_text(const CurvedReport& report) {
  return line("curved", grouped(report.nodes) + " nodes, area " + brief(report.measures.area, 6) +
                            " A^2, Jacobians at least " + brief(report.measures.least_jacobian) +
                            " of the flat triangles'");
}

}  // namespace morskin::app
