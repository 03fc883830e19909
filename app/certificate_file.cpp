#include "app/certificate_file.h"

#include <algorithm>
#include <nlohmann/json.hpp>

namespace morskin::app {
namespace {

using nlohmann::ordered_json;

template <class Ids>
ordered_json indices(const Ids& ids) {
  ordered_json list = ordered_json::array();
  for (const auto id : ids) list.push_back(id.value);
  return list;
}

template <class Simplices>
ordered_json lists(const Simplices& simplices) {
  ordered_json list = ordered_json::array();
  for (const auto& simplex : simplices) list.push_back(indices(simplex));
  return list;
}

ordered_json top_simplices(const geometry::RegularTriangulation& triangulation) {
  switch (triangulation.dimension) {
    case 3:
      return lists(triangulation.tetrahedra);
    case 2:
      return lists(triangulation.triangles);
    case 1:
      return lists(triangulation.edges);
    default:
      return ordered_json::array({indices(triangulation.vertices)});
  }
}

}  // namespace

std::string certificate_text(const geometry::IndexedMesh& mesh,
                             std::span<const surface::SurfacePoint> points,
                             std::span<const geometry::VertexId> component_vertices,
                             const morskin::PreparedSkin& skin, const certify::Sizing& sizing) {
  const geometry::RegularTriangulation& triangulation = skin.surface.triangulation();
  ordered_json vertex_atoms = ordered_json::array();
  for (const surface::SurfacePoint& point : points) {
    vertex_atoms.push_back(indices(skin.surface.atoms(point.cell)));
  }
  const ordered_json certificate{{"format", "morskin-certificate-1"},
                                 {"balls", skin.surface.points().size()},
                                 {"vertices", mesh.positions.size()},
                                 {"triangles", mesh.triangles.size()},
                                 {"dimension", triangulation.dimension},
                                 {"C", sizing.C},
                                 {"Q", sizing.Q},
                                 {"simplices", top_simplices(triangulation)},
                                 {"dropped_voids", std::ranges::count(skin.is_dropped, 1)},
                                 {"component_vertices", indices(component_vertices)},
                                 {"vertex_atoms", std::move(vertex_atoms)}};
  return certificate.dump() + "\n";
}

}  // namespace morskin::app
