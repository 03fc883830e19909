#include "bench/ablation/refining_observer.h"

#include <utility>

namespace morskin::ablation {

using geometry::HalfEdgeId;
using geometry::Subdomain;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::VertexId;

void RefiningObserver::follow(const front::FrontChange& change) {
  resize();
  for (const front::FrontEdgeId e : change.opened) {
    const VertexId v = change.front[e].origin;
    ++front_edges_[v];
    parts_[v] = geometry::no_part;
  }
  for (const front::FrontEdgeId e : change.closed) {
    const VertexId v = change.front[e].origin;
    if (--front_edges_[v] > 0) continue;
    leaving_.push_back(v);
    parts_[v] = behind;
  }
}

void RefiningObserver::resize() {
  front_edges_.resize(mesh_.surface.vertex_count(), 0);
  parts_.resize(mesh_.surface.vertex_count(), behind);
}

void RefiningObserver::finished(front::Front&) {
  left_.work().big.insert(left_.work().big.end(), refused_.begin(), refused_.end());
  refine_behind();
  mesh_.surface.compact();
}

void RefiningObserver::refine_behind() {
  constexpr std::size_t max_insertions = 32;  // a step leaves few triangles behind
  auto slots = std::exchange(left_.free_slots(), {});
  while (slots.size() < max_insertions) slots.push_back(mesh_.surface.add_free_slots());
  resize();
  const Subdomain subdomain(parts_, behind);
  refine::LocalOperations operations(surface_, sizing_, mesh_, std::exchange(left_.work(), {}),
                                     subdomain, std::move(slots));
  inspect(operations, subdomain);
  operations.flip_where_needed();
  contract(operations, subdomain);
  operations.insert_into_big_triangles(max_insertions);
  left_.absorb(operations);
  take_back();
  defer_refused();
}

/// Takes back the vertices that the operations gave up: they lie about the flips that wait.
void RefiningObserver::take_back() {
  for (const HalfEdgeId h : left_.work().to_flip) {
    for (const HalfEdgeId side : {h, mesh_.surface.twin(h)}) {
      for (const VertexId v : mesh_.surface.corners(SurfaceMesh::triangle(side))) {
        if (front_edges_[v] == 0) parts_[v] = behind;
      }
    }
  }
}

/// Inspects the triangles whose last corner has left the front.
void RefiningObserver::inspect(refine::LocalOperations& operations, const Subdomain& subdomain) {
  for (const VertexId v : std::exchange(leaving_, {})) {
    mesh_.surface.for_each_outgoing(v, [&](HalfEdgeId h) {
      const TriangleId t = SurfaceMesh::triangle(h);
      if (!subdomain.contains(mesh_.surface, t)) return;
      operations.inspect(t, operations.work());
      for (const std::uint32_t k : {0U, 1U, 2U}) {
        operations.work().to_flip.push_back(SurfaceMesh::half_edge(t, k));
      }
    });
  }
}

/// Keeps the triangles that could not be broken, mostly because the place for the new vertex lies
/// in the star of the front, for a later step.
void RefiningObserver::defer_refused() {
  constexpr std::size_t steps_between_retries = 32;
  auto& big = left_.work().big;
  refused_.insert(refused_.end(), big.begin(), big.end());
  big.clear();
  if (++steps_ % steps_between_retries == 0) std::swap(big, refused_);
}

void RefiningObserver::contract(refine::LocalOperations& operations,
                                const Subdomain& subdomain) const {
  const auto at = [&](VertexId v) -> const surface::SurfacePoint& { return mesh_.at(v); };
  const auto remove = [&](VertexId v) {
    return subdomain.contains_star(mesh_.surface, v) && operations.remove(v);
  };
  for (const HalfEdgeId h : std::exchange(operations.work().too_short, {})) {
    const bool is_short =
        !mesh_.surface.is_removed(SurfaceMesh::triangle(h)) &&
        sizing_.is_too_short(at(mesh_.surface.origin(h)), at(mesh_.surface.target(h)));
    if (!is_short) continue;
    if (refine::contract_edge(mesh_.surface, at, h, remove)) {
      operations.flip_where_needed();
    } else {
      operations.work().too_short.push_back(h);
    }
  }
}

}  // namespace morskin::ablation
