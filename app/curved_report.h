#pragma once

/// What `mesh` and `check` tell of curved triangles.

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

#include "certify/curved_mesh.h"

namespace morskin::app {

struct CurvedReport {
  std::size_t nodes = 0;  ///< vertices and nodes in edges
  certify::CurvedMeasures measures;
  std::string objection;  ///< to the nodes in edges, or empty
};

CurvedReport curved_report(const geometry::SecondOrderMesh& mesh);

nlohmann::ordered_json curved_json(const CurvedReport& report);
std::string curved_text(const CurvedReport& report);

}  // namespace morskin::app
