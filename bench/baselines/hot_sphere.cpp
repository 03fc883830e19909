#include <algorithm>
#include <map>

#include "bench/baselines/growth.h"
#include "geometry/sort_unique.h"

namespace morskin::baselines {

/// Takes out what has a corner in the region, and orders the edges that this opens into loops.
/// @return whether there is nothing else but simple loops
bool Growth::find_loops(HotRegion& region) {
  const SurfaceMesh& surface = mesh_.surface();
  std::vector<VertexId>& hot = region.vertices;
  std::map<VertexId, VertexId> next;
  for (bool is_pinched = true; is_pinched;) {
    region.triangles.clear();
    for (const VertexId v : hot) {
      surface.for_each_outgoing(
          v, [&](HalfEdgeId h) { region.triangles.push_back(SurfaceMesh::triangle(h)); });
    }
    geometry::sort_unique(region.triangles);
    region.open.clear();
    next.clear();
    is_pinched = false;
    for (const TriangleId t : region.triangles) {
      for (std::uint32_t k = 0; k < 3; ++k) {
        const HalfEdgeId h = SurfaceMesh::half_edge(t, k), g = surface.twin(h);
        if (std::binary_search(region.triangles.begin(), region.triangles.end(),
                               SurfaceMesh::triangle(g))) {
          continue;
        }
        region.open.push_back(g);
        if (next.emplace(surface.origin(h), surface.target(h)).second) continue;
        // Two parts of the edge touch here: take the vertex out as well.
        hot.push_back(surface.origin(h));
        is_pinched = true;
      }
    }
  }
  region.loops.clear();
  while (!next.empty()) {
    Ring loop;
    for (auto step = next.begin(); step != next.end(); step = next.find(loop.back())) {
      if (loop.empty()) loop.push_back(step->first);
      loop.push_back(step->second);
      next.erase(step);
    }
    if (loop.back() != loop.front()) return false;
    loop.pop_back();
    region.loops.push_back(std::move(loop));
  }
  return true;
}

/// Replaces the region by what is there after the jump.
bool Growth::refill(const Metamorphosis& m, HotRegion& region) {
  mesh_.set_time(m.after());
  const Patch& patch = skin_.patch(m.cell);
  const Frame frame(patch);
  std::array<const Ring*, 2> loops{};  // below and above along the axis
  for (const Ring& loop : region.loops) {
    std::size_t above = 0;
    for (const VertexId v : loop) above += frame.axial(mesh_.position(v)) > 0;
    if (above != 0 && above != loop.size()) return false;
    loops[above != 0] = &loop;
  }
  if (m.kind != Kind::Void && (loops[0] == nullptr || loops[1] == nullptr)) return false;

  const std::size_t before = mesh_.surface().triangle_count();
  mesh_.remove(region.triangles);
  std::vector<Corners> triangles;
  if (m.kind == Kind::Neck) {
    triangles = tube_template(mesh_, frame, m.cell, m.half_width, *loops[0], *loops[1]);
  } else if (m.kind == Kind::Tunnel) {
    for (const std::size_t side : {0U, 1U}) {
      const Frame outward(patch, side == 0 ? -1 : 1);
      const auto cap = cap_template(mesh_, outward, m.cell, m.half_width, *loops[side]);
      triangles.insert(triangles.end(), cap.begin(), cap.end());
    }
  }
  const bool is_sound = add_triangles(mesh_.surface(), triangles, region.open);
  for (std::size_t t = before; t < mesh_.surface().triangle_count(); ++t) {
    mesh_.add_changed(TriangleId{t});
  }
  return is_sound;
}

}  // namespace morskin::baselines
