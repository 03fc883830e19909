#include "refine/journal.h"

#include <algorithm>

#include "geometry/sort_unique.h"
#include "refine/mesh_operations.h"

namespace morskin::refine {

void Journal::note_flip(HalfEdgeId h) {
  const SurfaceMesh& connectivity = mesh_.surface;
  const VertexId from = connectivity.origin(h);
  changes_.push_back({Kind::Flip,
                      {from, connectivity.target(h), connectivity.apex(h),
                       connectivity.apex(connectivity.twin(h))},
                      mesh_.at(from)});
}

void Journal::note_insertion(VertexId v) {
  Change change{Kind::Insertion, {v, v, v, v}, mesh_.at(v)};
  std::size_t corner = 0;
  mesh_.surface.for_each_outgoing(
      v, [&](HalfEdgeId h) { change.vertices[++corner] = mesh_.surface.target(h); });
  changes_.push_back(change);
}

void Journal::note_removal(VertexId v, const SurfacePoint& point, TriangleId left) {
  const auto [a, b, c] = mesh_.surface.corners(left);
  changes_.push_back({Kind::Removal, {v, a, b, c}, point});
}

void Journal::note_move(VertexId v, const SurfacePoint& from) {
  changes_.push_back({Kind::Move, {v, v, v, v}, from});
}

std::size_t Journal::exchanged() const {
  return static_cast<std::size_t>(std::ranges::count_if(changes_, [](const Change& c) {
    return c.kind == Kind::Insertion || c.kind == Kind::Removal;
  }));
}

void Journal::undo(std::size_t first, std::vector<SurfaceMesh::FreeSlots>& free_slots) {
  while (changes_.size() > first) {
    const auto& [kind, vertices, point] = changes_.back();
    const auto [v, a, b, c] = vertices;
    switch (kind) {
      case Kind::Flip:
        mesh_.surface.flip(half_edge_between(mesh_.surface, v, a));
        break;
      case Kind::Insertion:
        free_slots.push_back(mesh_.surface.unsplit(v));
        break;
      case Kind::Removal: {
        const HalfEdgeId h = half_edge_between(mesh_.surface, a, b);
        mesh_.surface.split(SurfaceMesh::triangle(h), free_slots.back());
        free_slots.pop_back();
        mesh_.points[v] = point;
        break;
      }
      case Kind::Move:
        mesh_.points[v] = point;
        break;
    }
    changes_.pop_back();
  }
}

std::vector<VertexId> Journal::touched(std::size_t first) const {
  std::vector<VertexId> found;
  for (std::size_t i = first; i < changes_.size(); ++i) {
    found.insert(found.end(), changes_[i].vertices.begin(), changes_[i].vertices.end());
  }
  geometry::sort_unique(found);
  std::erase_if(found, [this](VertexId v) { return !mesh_.surface.outgoing(v); });
  return found;
}

}  // namespace morskin::refine
