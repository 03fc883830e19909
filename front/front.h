#pragma once

/// The front: the boundary of the partial triangulation, as cycles of front edges (section 4.1).
///
/// A front edge runs along a boundary half-edge of the mesh, the mesh on its left and bare surface
/// on its right. The corner of a front edge is the one at its origin, between the edge before and
/// the edge itself; a vertex where the front touches itself has several. An edge keeps its id, and
/// so its corner, from the day the corner comes to be until it closes: ids are reused afterwards,
/// told apart by a generation.

#include <limits>
#include <vector>

#include "front/front_grid.h"
#include "surface/mesh.h"

namespace morskin::front {

using geometry::HalfEdgeId;
using geometry::VertexId;
using surface::Mesh;
using surface::Point;
using surface::SurfacePoint;
using surface::Vector;

/// On one cache line: the fronts of a big molecule do not fit the near caches, and vertices are
/// taken up all over them.
struct alignas(64) FrontEdge {
  Point position;  ///< of the origin
  VertexId origin;
  FrontEdgeId next, previous;
  HalfEdgeId half_edge;
  std::uint32_t generation = 0;
  std::uint32_t loop = 0;     ///< the watched loop it belongs to; 0 for none
  FrontGrid::Places filed{};  ///< where its corner is in the grid
  bool is_open = false;
};
static_assert(sizeof(FrontEdge) == 64);

/// A polygon that a touch split off, watched until it closes.
struct Loop {
  bool is_predicted = false;  ///< the touch was inside a protecting sphere
  bool met_another = false;   ///< it touched the front again
  bool has_maximum = false;   ///< it came into the protecting sphere of a maximum
  bool is_closed = false;

  /// Nothing came of it: a spot left out that was filled later.
  bool is_vain() const { return is_closed && !met_another && !has_maximum; }
};

class Front {
 public:
  /// @param reach  how far the grid of corners can be asked, in units of the length scale
  /// @param largest_length_scale  a larger one counts as this, Angstrom
  explicit Front(Mesh& mesh, double reach = 0.4,
                 double largest_length_scale = std::numeric_limits<double>::infinity())
      : mesh_(mesh), grid_(reach, largest_length_scale) {}

  const FrontEdge& operator[](FrontEdgeId e) const { return edges_[e.index()]; }
  const FrontEdge& next(FrontEdgeId e) const { return edges_[edges_[e.index()].next.index()]; }
  const FrontEdge& previous(FrontEdgeId e) const {
    return edges_[edges_[e.index()].previous.index()];
  }
  VertexId target(FrontEdgeId e) const { return next(e).origin; }
  const FrontGrid& grid() const { return grid_; }
  std::size_t capacity() const { return edges_.size(); }
  std::size_t open_edges() const { return open_; }

  /// Opens a cycle of front edges along boundary half-edges, each ending where the next begins.
  /// @return the edges, in the same order.
  std::vector<FrontEdgeId> open_polygon(std::span<const HalfEdgeId> half_edges);

  /// Takes over the edges of the front of a mesh that was appended to this one's.
  /// @param vertices, half_edges  how many this mesh had before
  /// @return  what to add to an edge's id
  std::uint32_t append(const Front& other, std::uint32_t vertices, std::uint32_t half_edges);

  /// By vertex of the mesh, whether the front runs through it.
  std::vector<char> marked_vertices() const;
  /// Follows the mesh when it is compacted.
  /// @pre it has lost nothing that the front runs along.
  void rename(const geometry::SurfaceMesh::Renaming& renaming);

  /// Adds the triangle of edge e and a new vertex x. Edge e then runs from its origin to x.
  /// @return the new edge, from x to e's old target.
  FrontEdgeId attach(FrontEdgeId e, const SurfacePoint& x);

  /// Adds the triangle in a corner, between the edge before it and its own: the corner closes, and
  /// the edge before runs on to where the corner's edge ran. A front of three edges closes whole.
  void close_corner(FrontEdgeId corner);

  /// Adds the triangle of edge e and the vertex of a corner elsewhere on the front: the polygon
  /// splits in two, or two polygons join. Edge e then runs from its origin to the corner's vertex.
  /// @pre  the corner is no neighbour of e: its vertex is not next to e's ends.
  /// @return the new edge, from the corner's vertex to e's old target.
  FrontEdgeId attach(FrontEdgeId e, FrontEdgeId corner);

  /// Tells what attach(e, corner) did: when it split a polygon, the smaller part is watched from
  /// now on. Takes as long as that part has edges.
  /// @param added  what attach() returned
  void watch_touch(FrontEdgeId e, FrontEdgeId added, bool is_predicted);
  /// Notes that an edge's polygon has come to a maximum.
  void note_maximum(FrontEdgeId e) { loops_[edges_[e.index()].loop].has_maximum = true; }
  /// How many of the touches with this prediction split off a loop of which nothing came.
  std::size_t vain_loops(bool is_predicted) const;

 private:
  geometry::TriangleId add_triangle(FrontEdgeId e, VertexId apex);
  FrontEdgeId open_edge(VertexId origin, HalfEdgeId half_edge);
  void close_edge(FrontEdgeId e);
  void link(FrontEdgeId e, FrontEdgeId f) {
    edges_[e.index()].next = f;
    edges_[f.index()].previous = e;
  }
  void zip(FrontEdgeId e);

  Mesh& mesh_;
  std::vector<FrontEdge> edges_;
  std::vector<FrontEdgeId> free_;
  FrontGrid grid_;
  std::vector<Loop> loops_{Loop{}};  ///< the first stands for all that are not watched
  std::size_t open_ = 0;
};

}  // namespace morskin::front
