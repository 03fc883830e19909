#include "refine/located_vertices.h"

#include <utility>

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
  // Triangles come in the order they were laid, so nearly all have a corner that is located when
  // they come, and the others' cells are near; a breadth-first order would be as short and cost a
  // queue. Those that refinement changed may come too early, and a walk from elsewhere would be
  // long: they wait, and go round again as long as that helps.
  skin::CellId last{};
  std::vector<std::uint32_t> waiting;
  const auto place_corners = [&](std::uint32_t t, bool may_wait) {
    const auto& triangle = mesh.triangles[t];
    bool is_near = false;
    for (const std::uint32_t v : triangle) {
      if (is_located[v] == 0) continue;
      last = points[v].cell;
      is_near = true;
    }
    if (!is_near && may_wait) return waiting.push_back(t);
    for (const std::uint32_t v : triangle) {
      if (is_located[v] == 0) place(v, last);
      last = points[v].cell;
    }
  };
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) place_corners(t, t > 0);
  constexpr int most_rounds = 3;
  for (int round = 1; round <= most_rounds; ++round) {
    for (const std::uint32_t t : std::exchange(waiting, {})) place_corners(t, round < most_rounds);
  }
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    if (is_located[v] == 0) place(v, last);
    last = points[v].cell;
  }
  return points;
}

}  // namespace morskin::refine
