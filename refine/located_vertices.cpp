#include "refine/located_vertices.h"

namespace morskin::refine {

std::vector<skin::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                const skin::SkinSurface& skin) {
  std::vector<skin::SurfacePoint> points(mesh.positions.size());
  std::vector<char> is_located(points.size(), 0);
  const auto place = [&](std::uint32_t v, skin::CellId start) {
    const skin::Point& x = mesh.positions[v];
    points[v] = skin.at(x, skin.locate(x, start));
    is_located[v] = 1;
  };
  // Triangles come in the order they were laid, so a corner's cell is near the last triangle's; a
  // breadth-first order would be as short and cost a queue.
  skin::CellId last{};
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t v : triangle) {
      if (is_located[v] != 0) last = points[v].cell;
    }
    for (const std::uint32_t v : triangle) {
      if (is_located[v] == 0) place(v, last);
      last = points[v].cell;
    }
  }
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (is_located[v] == 0) place(v, last);
    last = points[v].cell;
  }
  return points;
}

}  // namespace morskin::refine
