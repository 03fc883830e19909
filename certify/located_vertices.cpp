#include "certify/located_vertices.h"

#include <algorithm>
#include <utility>

namespace morskin::certify {

void VertexLocator::place(std::uint32_t v, surface::CellId start) {
  const surface::Point& x = mesh_.positions[v];
  points_[v] = surface_.at(x, surface_.locate(x, start));
  is_located_[v] = 1;
}

void VertexLocator::locate_where_said(std::span<const surface::CellId> cells, std::size_t begin,
                                      std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    const surface::Point& x = mesh_.positions[v];
    if (!surface_.is_in(x, cells[v])) continue;
    points_[v] = surface_.at(x, cells[v]);
    is_located_[v] = 1;
  }
}

void VertexLocator::locate_rest() {
  if (std::ranges::find(is_located_, 0) == is_located_.end()) return;
  // Triangles come in the order they were laid, so nearly all have a corner that is located when
  // they come, and the others' cells are near; a breadth-first order would be as short and cost a
  // queue. Those that refinement changed may come too early, and a walk from elsewhere would be
  // long: they wait, and go round again as long as that helps.
  surface::CellId last{};
  std::vector<std::uint32_t> waiting;
  const auto place_corners = [&](std::uint32_t t, bool may_wait) {
    const auto& triangle = mesh_.triangles[t];
    bool is_near = false;
    for (const std::uint32_t v : triangle) {
      if (is_located_[v] == 0) continue;
      last = points_[v].cell;
      is_near = true;
    }
    if (!is_near && may_wait) return waiting.push_back(t);
    for (const std::uint32_t v : triangle) {
      if (is_located_[v] == 0) place(v, last);
      last = points_[v].cell;
    }
  };
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) place_corners(t, t > 0);
  constexpr int most_rounds = 3;
  for (int round = 1; round <= most_rounds; ++round) {
    for (const std::uint32_t t : std::exchange(waiting, {})) place_corners(t, round < most_rounds);
  }
  for (std::uint32_t v = 0; v < points_.size(); ++v) {
    if (is_located_[v] == 0) place(v, last);
    last = points_[v].cell;
  }
}

std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface) {
  VertexLocator locator(mesh, surface);
  locator.locate_rest();
  return locator.take();
}

}  // namespace morskin::certify
