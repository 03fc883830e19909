#include "geometry/surface_mesh.h"

#include <cassert>
#include <utility>

#include "geometry/error.h"
#include "geometry/last_visit.h"

namespace morskin::geometry {

SurfaceMesh::SurfaceMesh(std::size_t vertices, std::span<const TriangleCorners> triangles)
    : half_edges_(3 * triangles.size()), outgoing_(vertices, HalfEdgeId::none()) {
  if (triangles.size() > max_triangles) fail_for_lack_of_ids(max_triangles, "triangles");
  HalfEdgeId h;
  for (const auto& triangle : triangles) {
    for (const std::uint32_t v : triangle) {
      set_corner(h, VertexId{v});
      ++h.value;
    }
  }
}

SurfaceMesh& SurfaceMesh::operator=(SurfaceMesh other) {
  std::swap(half_edges_, other.half_edges_);
  std::swap(outgoing_, other.outgoing_);
  tell_vertex_count();
  tell_triangle_count();
  return *this;
}

void SurfaceMesh::reserve(std::size_t vertices) {
  outgoing_.reserve(vertices);
  half_edges_.reserve(6 * vertices);
  for (MeshFollower* follower : followers_.all) follower->reserved(vertices);
}

std::optional<HalfEdgeId> SurfaceMesh::outgoing(VertexId v) const {
  const HalfEdgeId h = outgoing_[v];
  return h == HalfEdgeId::none() ? std::nullopt : std::optional(h);
}

VertexId SurfaceMesh::add_vertex() {
  outgoing_.push_back(HalfEdgeId::none());
  tell_vertex_count();
  return VertexId{outgoing_.size() - 1};
}

TriangleId SurfaceMesh::add_triangle(VertexId a, VertexId b, VertexId c) {
  assert(a != b && b != c && c != a);
  require_capacity(half_edges_.size() / 3, max_triangles, "triangles");
  for (const VertexId v : {a, b, c}) {
    outgoing_[v] = HalfEdgeId{half_edges_.size()};
    half_edges_.push_back({v, HalfEdgeId::none()});
  }
  tell_triangle_count();
  return TriangleId{triangle_count() - 1};
}

SurfaceMesh::FreeSlots SurfaceMesh::slots_for(VertexId v) {
  const TriangleId second{triangle_count()}, third{triangle_count() + 1};
  require_capacity(third.index(), max_triangles, "triangles");
  half_edges_.resize(half_edges_.size() + 6);
  tell_triangle_count();
  return {v, second, third};
}

void SurfaceMesh::glue(HalfEdgeId h, HalfEdgeId g) {
  assert(is_boundary(h) && is_boundary(g));
  assert(origin(h) == target(g) && origin(g) == target(h));
  set_twin(h, g);
}

void SurfaceMesh::append(SurfaceMesh&& other) {
  const std::size_t vertices = vertex_count(), all_vertices = vertices + other.vertex_count();
  const std::size_t half_edges = half_edges_.size();
  const std::size_t all_triangles = triangle_count() + other.triangle_count();
  if (all_triangles > max_triangles) fail_for_lack_of_ids(max_triangles, "triangles");
  const auto moved = [](auto id, std::size_t by) {
    return id == decltype(id)::none() ? id : decltype(id){id.index() + by};
  };
  visit_last(other.half_edges_, [&](auto block) {
    for (const HalfEdge& h : block) {
      half_edges_.push_back({moved(h.origin, vertices), moved(h.twin, half_edges)});
    }
  });
  other.half_edges_ = {};
  for (const HalfEdgeId h : other.outgoing_) outgoing_.push_back(moved(h, half_edges));
  other.outgoing_ = {};
  for (std::size_t k = 0; k < followers_.all.size(); ++k) {
    const std::vector<MeshFollower*>& others = other.followers_.all;
    followers_.all[k]->appended(k < others.size() ? others[k] : nullptr, all_vertices,
                                all_triangles);
  }
  other.tell_vertex_count();
  other.tell_triangle_count();
}

void SurfaceMesh::flip(HalfEdgeId h) {
  assert(!is_boundary(h));
  const HalfEdgeId g = twin(h);
  const VertexId a = origin(h), b = origin(g), c = apex(h), d = apex(g);
  const HalfEdgeId beyond_bc = half_edges_[next(h)].twin, beyond_ca = half_edges_[previous(h)].twin;
  const HalfEdgeId beyond_ad = half_edges_[next(g)].twin, beyond_db = half_edges_[previous(g)].twin;
  set_corner(previous(h), a);
  set_corner(previous(g), b);
  set_corner(next(h), c);
  set_corner(g, c);
  set_corner(next(g), d);
  set_corner(h, d);
  set_twin(next(h), beyond_ca);
  set_twin(previous(h), beyond_ad);
  set_twin(next(g), beyond_db);
  set_twin(previous(g), beyond_bc);
}

void SurfaceMesh::split(TriangleId t, VertexId v) { split(t, slots_for(v)); }

void SurfaceMesh::split(TriangleId t, const FreeSlots& slots) {
  const auto [v, second, third] = slots;
  assert(is_removed(second) && is_removed(third));
  const auto [a, b, c] = corners(t);
  const HalfEdgeId ab = half_edge(t, 0);
  const HalfEdgeId beyond_bc = half_edges_[next(ab)].twin,
                   beyond_ca = half_edges_[previous(ab)].twin;
  const HalfEdgeId bc = half_edge(second, 0), ca = half_edge(third, 0);
  set_corner(bc, b);
  set_corner(next(bc), c);
  set_corner(previous(bc), v);
  set_corner(ca, c);
  set_corner(next(ca), a);
  set_corner(previous(ca), v);
  set_corner(previous(ab), v);
  set_corner(ab, a);
  set_corner(next(ab), b);
  set_twin(bc, beyond_bc);
  set_twin(ca, beyond_ca);
  set_twin(next(ab), previous(bc));
  set_twin(next(bc), previous(ca));
  set_twin(next(ca), previous(ab));
  for (MeshFollower* follower : followers_.all) follower->triangle_split(t, second, third);
}

SurfaceMesh::FreeSlots SurfaceMesh::unsplit(VertexId v) {
  assert(degree(v) == 3);
  const HalfEdgeId va = outgoing_[v];
  const HalfEdgeId vb = twin(previous(va));
  const HalfEdgeId vc = twin(previous(vb));
  const HalfEdgeId beyond_bc = half_edges_[next(vb)].twin, beyond_ca = half_edges_[next(vc)].twin;
  const VertexId a = target(va), b = target(vb), c = target(vc);
  // The kept triangle's half-edges va, next(va), previous(va) become c-a, a-b, b-c.
  set_corner(va, c);
  set_corner(next(va), a);
  set_corner(previous(va), b);
  set_twin(va, beyond_ca);
  set_twin(previous(va), beyond_bc);
  for (const HalfEdgeId h : {vb, vc}) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      half_edges_[half_edge(triangle(h), k)] = {};
    }
  }
  outgoing_[v] = HalfEdgeId::none();
  tell_removed(v);
  return {v, triangle(vb), triangle(vc)};
}

void SurfaceMesh::remove(std::span<const TriangleId> triangles) {
  std::vector<VertexId> corners_gone;
  for (const TriangleId t : triangles) {
    for (const VertexId v : corners(t)) {
      if (outgoing_[v] != HalfEdgeId::none()) corners_gone.push_back(v);
      outgoing_[v] = HalfEdgeId::none();
    }
  }
  for (const TriangleId t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) half_edges_[half_edge(t, k)].origin = VertexId::none();
  }
  // A fan that is left begins at the half-edge whose twin is gone.
  for (const TriangleId t : triangles) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      HalfEdgeId& twin = half_edges_[half_edge(t, k)].twin;
      if (twin != HalfEdgeId::none() && half_edges_[twin].origin != VertexId::none()) {
        half_edges_[twin].twin = HalfEdgeId::none();
        outgoing_[half_edges_[twin].origin] = twin;
      }
      twin = HalfEdgeId::none();
    }
  }
  for (const VertexId v : corners_gone) {
    if (outgoing_[v] == HalfEdgeId::none()) tell_removed(v);
  }
}

std::size_t SurfaceMesh::degree(VertexId v) const {
  std::size_t count = 0;
  for_each_outgoing(v, [&](HalfEdgeId) { ++count; });
  return count;
}

bool SurfaceMesh::has_edge(VertexId a, VertexId b) const {
  const HalfEdgeId first = outgoing_[a];
  HalfEdgeId h = first;
  do {
    const HalfEdgeId before = previous(h);
    if (half_edges_[before].origin == b) return true;
    h = half_edges_[before].twin;
  } while (h != first);
  return false;
}

TriangleList SurfaceMesh::triangle_list() const {
  TriangleList list;
  list.reserve(triangle_count());
  for (std::size_t t = 0; t < triangle_count(); ++t) {
    if (is_removed(TriangleId{t})) continue;
    const auto [a, b, c] = corners(TriangleId{t});
    list.push_back({a.value, b.value, c.value});
  }
  return list;
}

SurfaceMesh::Lists SurfaceMesh::turned_into_lists() {
  Lists lists;
  lists.triangles.reserve(triangle_count());
  lists.twins.reserve(half_edges_.size());
  outgoing_ = {};
  std::uint32_t k = 0;
  TriangleCorners corners;
  visit_last(half_edges_, [&](auto block) {
    for (const HalfEdge& h : block) {
      corners[k++] = h.origin.value;
      lists.twins.push_back(h.twin);
      if (k < 3) continue;
      lists.triangles.push_back(corners);
      k = 0;
    }
  });
  *this = SurfaceMesh();
  return lists;
}

}  // namespace morskin::geometry
