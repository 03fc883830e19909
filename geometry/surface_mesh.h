#pragma once

/// A triangle mesh whose connectivity knows no coordinates.
///
/// Half-edge h = 3 t + k of triangle t runs from corner k to corner k + 1, the triangle on its left
/// (counter-clockwise seen from outside). Its twin is the opposite half-edge of the neighbouring
/// triangle; a half-edge without one is on the boundary. Everything lies in two flat arrays.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "geometry/id.h"
#include "geometry/prefetch.h"

namespace morskin::geometry {

using HalfEdgeId = Id<struct HalfEdgeTag>;

class SurfaceMesh {
 public:
  SurfaceMesh() = default;
  /// Triangles of a list, in its order, none glued to another yet.
  /// @pre every corner is below `vertices`; at most max_triangles.
  SurfaceMesh(std::size_t vertices, std::span<const std::array<std::uint32_t, 3>> triangles);

  /// The same glued by hinted twins, which are checked: nothing unless each edge is between two
  /// triangles that agree on orientation.
  /// @param twins  by half-edge; any size, any values
  static std::optional<SurfaceMesh> glued_by_twins(
      std::size_t vertices, std::span<const std::array<std::uint32_t, 3>> triangles,
      std::span<const HalfEdgeId> twins);

  std::size_t vertex_count() const { return outgoing_.size(); }
  std::size_t triangle_count() const { return half_edges_.size() / 3; }
  void reserve(std::size_t vertices);

  VertexId origin(HalfEdgeId h) const { return half_edges_[h.index()].origin; }
  VertexId target(HalfEdgeId h) const { return half_edges_[next(h).index()].origin; }
  VertexId apex(HalfEdgeId h) const { return half_edges_[previous(h).index()].origin; }
  static TriangleId triangle(HalfEdgeId h) { return TriangleId{h.value / 3}; }
  static HalfEdgeId half_edge(TriangleId t, std::uint32_t k) { return HalfEdgeId{3 * t.value + k}; }
  static HalfEdgeId next(HalfEdgeId h) {
    return HalfEdgeId{h.value % 3 == 2 ? h.value - 2 : h.value + 1};
  }
  static HalfEdgeId previous(HalfEdgeId h) {
    return HalfEdgeId{h.value % 3 == 0 ? h.value + 2 : h.value - 1};
  }
  bool is_boundary(HalfEdgeId h) const { return half_edges_[h.index()].twin.value == kBoundary; }
  /// @pre !is_boundary(h)
  HalfEdgeId twin(HalfEdgeId h) const { return half_edges_[h.index()].twin; }
  /// A half-edge that leaves v, or nothing for a vertex without triangles.
  std::optional<HalfEdgeId> outgoing(VertexId v) const;
  /// Asks for what prefetch_fan() looks up.
  void prefetch_outgoing(VertexId v) const { prefetch(&outgoing_[v.index()]); }
  /// Asks for what a walk round v begins with, where there is something to walk round.
  void prefetch_fan(VertexId v) const {
    const HalfEdgeId first = outgoing_[v.index()];
    if (first.value != kBoundary) prefetch(&half_edges_[first.index()]);
  }
  std::array<VertexId, 3> corners(TriangleId t) const {
    const HalfEdge* first = &half_edges_[3 * t.index()];
    return {first[0].origin, first[1].origin, first[2].origin};
  }
  /// A removed triangle keeps its place until compact(); every other one is alive.
  bool is_removed(TriangleId t) const {
    return half_edges_[3 * t.index()].origin.value == kBoundary;
  }

  /// What a new vertex in a triangle takes: a vertex and two triangles, all as if removed.
  struct Room {
    VertexId vertex;
    TriangleId second, third;
  };

  VertexId add_vertex();
  /// A triangle with three boundary half-edges. Half-edge 0 runs from a to b.
  /// @throws LimitReached  when there are max_triangles already: half-edges have 32-bit ids, of
  ///                       which the last means "none".
  TriangleId add_triangle(VertexId a, VertexId b, VertexId c);
  /// Room for a vertex behind those there are.
  /// @throws LimitReached  as add_triangle()
  Room add_room() { return room_for(add_vertex()); }
  /// Makes two boundary half-edges each other's twin. @pre they run between the same vertices,
  /// oppositely.
  void glue(HalfEdgeId h, HalfEdgeId g);

  /// Adds all vertices and triangles of another mesh, in their order, behind those there are, and
  /// makes room for a little more than the whole: refinement adds one vertex to every fifteen, and
  /// growing would double the arrays.
  void append(const SurfaceMesh& other);
  static constexpr std::size_t with_room(std::size_t count) { return count + count / 12; }

  /// Turns the edge of h inside its two triangles: a-b between c and d becomes d-c. Afterwards h
  /// runs from d to c in triangle (a, d, c), its twin from c to d in triangle (b, c, d).
  /// @pre the edge is not on the boundary.
  void flip(HalfEdgeId h);
  /// Replaces triangle t by three around a new vertex. The first keeps t's place, vertex and others
  /// take the room, or come to the end.
  void split(TriangleId t, const Room& room);
  void split(TriangleId t, VertexId v);
  /// Removes a vertex of degree three: its three triangles become one, in the place of the first.
  /// @return the room that this leaves
  /// @pre v has exactly three triangles around it and no boundary.
  Room unsplit(VertexId v);

  /// Calls visit(h) for each half-edge that leaves v, counter-clockwise, for a vertex with
  /// triangles and without boundary.
  template <class Visit>
  void for_each_outgoing(VertexId v, Visit visit) const {
    const HalfEdgeId first = outgoing_[v.index()];
    HalfEdgeId h = first;
    do {
      visit(h);
      h = half_edges_[previous(h).index()].twin;
    } while (h != first);
  }
  /// Takes triangles out of the mesh and leaves their edges to the others as boundary. Vertices
  /// left without triangles are removed.
  /// @pre the mesh is closed, and every vertex keeps at most one fan of triangles.
  void remove(std::span<const TriangleId> triangles);

  std::size_t degree(VertexId v) const;
  /// Whether v has more neighbours than so many, told after one step more than that.
  /// @pre v has no boundary.
  bool has_degree_above(VertexId v, std::size_t most) const {
    const HalfEdgeId first = outgoing_[v.index()];
    HalfEdgeId h = first;
    for (std::size_t step = 0; step < most; ++step) {
      h = half_edges_[previous(h).index()].twin;
      if (h == first) return false;
    }
    return true;
  }
  /// Whether an edge joins a and b. @pre a has no boundary.
  bool has_edge(VertexId a, VertexId b) const;

  /// Drops removed triangles and vertices without triangles, keeping the order of the rest.
  /// @return for each old vertex its new id, or nothing.
  std::vector<std::optional<VertexId>> compact();
  /// The new ids that compact() gives.
  class Renaming {
   public:
    std::vector<std::optional<VertexId>> vertices;  ///< by old vertex; nothing where it goes
    /// @pre its triangle stays.
    HalfEdgeId operator()(HalfEdgeId h) const {
      if (h.value / 3 < first_) return h;
      return HalfEdgeId{3 * moved_[h.value / 3 - first_] + h.value % 3};
    }

   private:
    friend class SurfaceMesh;
    std::size_t first_ = 0;             ///< triangles before this one stay where they are
    std::size_t left_ = 0;              ///< triangles
    std::vector<std::uint32_t> moved_;  ///< by triangle from there on
  };
  /// The same in two steps. First the new ids, by which what belongs to vertices may be moved
  /// meanwhile.
  Renaming renaming() const;
  void compact(const Renaming& renamed);

  /// The triangles as a file holds them.
  std::vector<std::array<std::uint32_t, 3>> triangle_list() const;

  /// By half-edge its twin, or the last id of all for none.
  std::vector<HalfEdgeId> twins() const;

  static constexpr std::size_t max_triangles = 0xFFFFFFFFU / 3;

 private:
  static constexpr std::uint32_t kBoundary = 0xFFFFFFFFU;
  Room room_for(VertexId v);
  void set_corner(HalfEdgeId h, VertexId v) {
    half_edges_[h.index()].origin = v;
    outgoing_[v.index()] = h;
  }
  void set_twin(HalfEdgeId h, HalfEdgeId g) {
    half_edges_[h.index()].twin = g;
    if (g.value != kBoundary) half_edges_[g.index()].twin = h;
  }

  struct HalfEdge {
    VertexId origin{kBoundary};
    HalfEdgeId twin{kBoundary};
  };
  std::vector<HalfEdge> half_edges_;
  std::vector<HalfEdgeId> outgoing_;  ///< by vertex
};

/// What validate() looks for beyond the sound bookkeeping of every mesh.
enum class Expect { Any, Closed };

/// The first broken invariant in words, or nothing: triangles have three different corners, twins
/// are mutual and opposite, each vertex has one fan of triangles around it, no edge stands twice;
/// with Expect::Closed also that there is no boundary.
std::optional<std::string> validate(const SurfaceMesh& mesh, Expect expect = Expect::Closed);

/// A mesh from a triangle list, or the first reason why it is not a closed oriented 2-manifold: an
/// edge with one triangle or three, two triangles that disagree on orientation, a vertex where two
/// sheets touch. O(n).
struct MeshOrDefect {
  SurfaceMesh mesh;
  std::optional<std::string> defect;
};
MeshOrDefect closed_mesh(std::size_t vertices,
                         const std::vector<std::array<std::uint32_t, 3>>& triangles);

/// The same in two steps. First edges: each triangle glued to its neighbours, or the first edge
/// without two triangles that agree.
MeshOrDefect glued_mesh(std::size_t vertices,
                        const std::vector<std::array<std::uint32_t, 3>>& triangles);
/// Then vertices: what is wrong at the first that is not in the middle of one fan of triangles,
/// with as many neighbours.
/// @param threads  at most; the answer is the same for any number
/// @pre no boundary
std::optional<std::string> fan_defect(const SurfaceMesh& mesh, unsigned threads = 1);

/// For each triangle the number of its connected component, and how many there are.
struct Components {
  std::vector<std::uint32_t> of_triangle;
  std::uint32_t count = 0;
};
Components components(const SurfaceMesh& mesh);

}  // namespace morskin::geometry
