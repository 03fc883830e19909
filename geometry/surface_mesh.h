#pragma once

/// A triangle mesh whose connectivity knows no coordinates.
///
/// Half-edge h = 3 t + k of triangle t runs from corner k to corner k + 1, the triangle on its left
/// (counter-clockwise seen from outside). Its twin is the opposite half-edge of the neighbouring
/// triangle; a half-edge without one is on the boundary. Everything lies in two flat arrays. Data
/// by vertex or triangle stand beside it and follow it (mesh_data.h).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/id.h"
#include "geometry/id_vector.h"
#include "geometry/indexed_mesh.h"
#include "geometry/mesh_follower.h"
#include "geometry/prefetch.h"

namespace morskin::geometry {

class SurfaceMesh {
 public:
  SurfaceMesh() = default;
  SurfaceMesh(const SurfaceMesh&) = default;
  SurfaceMesh(SurfaceMesh&&) = default;
  ~SurfaceMesh() = default;
  /// Its followers stay, and have as many elements as the mesh assigned.
  SurfaceMesh& operator=(SurfaceMesh other);
  /// Triangles of a list, in its order, none glued to another yet.
  /// @pre every corner is below `vertices`; at most max_triangles.
  SurfaceMesh(std::size_t vertices, std::span<const TriangleCorners> triangles);

  std::size_t vertex_count() const { return outgoing_.size(); }
  std::size_t triangle_count() const { return half_edges_.size() / 3; }
  void reserve(std::size_t vertices);

  VertexId origin(HalfEdgeId h) const { return half_edges_[h].origin; }
  VertexId target(HalfEdgeId h) const { return half_edges_[next(h)].origin; }
  VertexId apex(HalfEdgeId h) const { return half_edges_[previous(h)].origin; }
  static TriangleId triangle(HalfEdgeId h) { return TriangleId{h.value / 3}; }
  static HalfEdgeId half_edge(TriangleId t, std::uint32_t k) { return HalfEdgeId{3 * t.value + k}; }
  static HalfEdgeId next(HalfEdgeId h) {
    return HalfEdgeId{h.value % 3 == 2 ? h.value - 2 : h.value + 1};
  }
  static HalfEdgeId previous(HalfEdgeId h) {
    return HalfEdgeId{h.value % 3 == 0 ? h.value + 2 : h.value - 1};
  }
  bool is_boundary(HalfEdgeId h) const { return half_edges_[h].twin == HalfEdgeId::none(); }
  /// @pre !is_boundary(h)
  HalfEdgeId twin(HalfEdgeId h) const { return half_edges_[h].twin; }
  /// A half-edge that leaves v, or nothing for a vertex without triangles.
  std::optional<HalfEdgeId> outgoing(VertexId v) const;
  /// Prefetches what prefetch_fan() reads.
  void prefetch_outgoing(VertexId v) const { prefetch(&outgoing_[v]); }
  /// Prefetches the first half-edge of a walk round v, if v has triangles.
  void prefetch_fan(VertexId v) const {
    const HalfEdgeId first = outgoing_[v];
    if (first != HalfEdgeId::none()) prefetch(&half_edges_[first]);
  }
  std::array<VertexId, 3> corners(TriangleId t) const {
    const HalfEdge* first = &half_edges_[half_edge(t, 0)];
    return {first[0].origin, first[1].origin, first[2].origin};
  }
  /// A removed triangle keeps its id until compact(); every other one is alive.
  bool is_removed(TriangleId t) const {
    return half_edges_[half_edge(t, 0)].origin == VertexId::none();
  }

  /// The ids that a new vertex in a triangle takes: a vertex and two triangles, all as if removed.
  struct FreeSlots {
    VertexId vertex;
    TriangleId second, third;
  };

  VertexId add_vertex();
  /// A triangle with three boundary half-edges. Half-edge 0 runs from a to b.
  /// @throws LimitReached  when there are max_triangles already: half-edges have 32-bit ids, of
  ///                       which the last means "none".
  TriangleId add_triangle(VertexId a, VertexId b, VertexId c);
  /// Slots behind those there are.
  /// @throws LimitReached  as add_triangle()
  FreeSlots add_free_slots() { return slots_for(add_vertex()); }
  /// Makes two boundary half-edges each other's twin. @pre they run between the same vertices,
  /// oppositely.
  void glue(HalfEdgeId h, HalfEdgeId g);

  /// Appends all vertices and triangles of another mesh, in their order, and empties it. The k-th
  /// follower takes over the values of the other mesh's k-th, if both have one type.
  void append(SurfaceMesh&& other);

  /// Turns the edge of h inside its two triangles: a-b between c and d becomes d-c. Afterwards h
  /// runs from d to c in triangle (a, d, c), its twin from c to d in triangle (b, c, d).
  /// @pre the edge is not on the boundary.
  void flip(HalfEdgeId h);
  /// Replaces triangle t by three around a new vertex. The first keeps t's id, vertex and others
  /// take the slots, or come to the end.
  void split(TriangleId t, const FreeSlots& slots);
  void split(TriangleId t, VertexId v);
  /// Removes a vertex of degree three: its three triangles become one, with the id of the first.
  /// @return the slots that this frees
  /// @pre v has exactly three triangles around it and no boundary.
  FreeSlots unsplit(VertexId v);

  /// Calls visit(h) for each half-edge that leaves v, counter-clockwise, for a vertex with
  /// triangles and without boundary.
  template <class Visit>
  void for_each_outgoing(VertexId v, Visit visit) const {
    const HalfEdgeId first = outgoing_[v];
    HalfEdgeId h = first;
    do {
      visit(h);
      h = half_edges_[previous(h)].twin;
    } while (h != first);
  }
  /// Takes triangles out of the mesh and leaves their edges to the others as boundary. Vertices
  /// left without triangles are removed.
  /// @pre the mesh is closed, and every vertex keeps at most one fan of triangles.
  void remove(std::span<const TriangleId> triangles);

  std::size_t degree(VertexId v) const;
  /// Whether v has more neighbours than a count; takes as many steps at most.
  /// @pre v has no boundary.
  bool has_degree_above(VertexId v, std::size_t count) const {
    const HalfEdgeId first = outgoing_[v];
    HalfEdgeId h = first;
    for (std::size_t step = 0; step < count; ++step) {
      h = half_edges_[previous(h)].twin;
      if (h == first) return false;
    }
    return true;
  }
  /// Whether an edge joins a and b. @pre a has no boundary.
  bool has_edge(VertexId a, VertexId b) const;

  /// Drops removed triangles and vertices without triangles, keeping the order of the rest.
  /// @param threads  at most
  /// @return the new ids, for what is no follower
  Renaming compact(unsigned threads = 1);

  /// The triangles as a file holds them.
  TriangleList triangle_list() const;

  /// The triangles and, by half-edge, their twins, or the last id of all for none, in place of the
  /// mesh, of which nothing is left.
  /// @pre nothing has been removed since compact()
  struct Lists {
    TriangleList triangles;
    std::vector<HalfEdgeId> twins;
  };
  Lists turned_into_lists();

  static constexpr std::size_t max_triangles = no_index / 3;

 private:
  friend class MeshFollower;
  /// Those of one mesh object: a copy has none.
  struct Followers {
    std::vector<MeshFollower*> all;
    std::vector<MeshFollower*> with_triangles;  ///< those that follow every new triangle
    Followers() = default;
    Followers(const Followers&) {}
    Followers& operator=(const Followers&) = delete;
    ~Followers();
  };

  FreeSlots slots_for(VertexId v);
  Renaming renaming() const;
  void move_elements(const Renaming& renaming);
  void tell_vertex_count() const {
    for (MeshFollower* follower : followers_.all) follower->vertices_resized(vertex_count());
  }
  void tell_triangle_count() const {
    for (MeshFollower* follower : followers_.with_triangles) {
      follower->triangles_resized(triangle_count());
    }
  }
  void tell_removed(VertexId v) const {
    for (MeshFollower* follower : followers_.all) follower->vertex_removed(v);
  }
  void set_corner(HalfEdgeId h, VertexId v) {
    half_edges_[h].origin = v;
    outgoing_[v] = h;
  }
  void set_twin(HalfEdgeId h, HalfEdgeId g) {
    half_edges_[h].twin = g;
    if (g != HalfEdgeId::none()) half_edges_[g].twin = h;
  }

  struct HalfEdge {
    VertexId origin = VertexId::none();
    HalfEdgeId twin = HalfEdgeId::none();
  };
  IdVector<HalfEdgeId, HalfEdge> half_edges_;
  IdVector<VertexId, HalfEdgeId> outgoing_;
  Followers followers_;
};

/// What validate() looks for beyond the sound bookkeeping of every mesh.
enum class Expect { Any, Closed };

/// The first broken invariant in words, or nothing: triangles have three different corners, twins
/// are mutual and opposite, each vertex has one fan of triangles around it, no edge stands twice;
/// with Expect::Closed also that there is no boundary.
std::optional<std::string> validate(const SurfaceMesh& mesh, Expect expect = Expect::Closed);

/// "edge 3-7", by two vertices.
std::string edge_in_words(std::uint32_t a, std::uint32_t b);

/// For each triangle the number of its connected component, and how many there are.
struct Components {
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t count = 0;
};
Components components(const SurfaceMesh& mesh);

}  // namespace morskin::geometry
