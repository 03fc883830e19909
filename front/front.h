#pragma once

/// The front: the boundary of the partial triangulation, as cycles of front edges (section 4.1).
///
/// A front edge runs along a boundary half-edge of the mesh, the mesh on its left and bare surface
/// on its right. The corner of a front edge is the one at its origin, between the edge before and
/// the edge itself; a vertex where the front touches itself has several. An edge keeps its id, and
/// so its corner, until the corner closes: ids are reused afterwards, with another generation.
///
/// Only the front adds triangles to the mesh. It reports every change to its mirrors, once, and
/// follows the mesh when that is compacted.

#include <limits>
#include <span>
#include <vector>

#include "front/front_grid.h"
#include "geometry/subdomain.h"
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
  FrontGrid::Keys grid_keys{};  ///< of its corner
  bool is_open = false;
};
static_assert(sizeof(FrontEdge) == 64);

class Front;

/// What one step changed of the front. Valid only while its mirrors receive it.
struct FrontChange {
  enum class Kind {
    OpenedPolygon,  ///< round a bowl
    NewVertex,      ///< a triangle over an edge, its apex new
    Touch,          ///< a triangle over an edge, its apex elsewhere on the front
    ClosedCorner,   ///< a triangle over two neighbouring edges
    ClosedPolygon,  ///< the same over the last three
  };
  Kind kind;
  const Front& front;                   ///< as it is afterwards
  std::span<const FrontEdgeId> opened;  ///< new edges
  std::span<const FrontEdgeId> closed;  ///< edges that are gone: a corner's, or it and the last two
  std::span<const FrontEdgeId> moved;   ///< edges with another target
  /// Corners whose bare angle is new or has changed. Of a triangle whose apex is new or elsewhere
  /// on the front only those at the apex: the two at the ends of its edge are left out.
  std::span<const FrontEdgeId> corners;
};

/// Keeps something that follows from the front.
class FrontMirror {
 public:
  virtual ~FrontMirror() = default;
  virtual void follow(const FrontChange& change) = 0;
};

/// By how much the ids of an absorbed front and its mesh move up.
struct IdOffsets {
  std::uint32_t vertices, half_edges, edges;
};

class Front : private geometry::MeshFollower {
 public:
  /// @param radius  largest radius of a query to the grid of corners, in units of the length scale
  /// @param largest_length_scale  a larger one counts as this, Angstrom
  explicit Front(Mesh& mesh, double radius = 0.4,
                 double largest_length_scale = std::numeric_limits<double>::infinity())
      : MeshFollower(mesh.surface), mesh_(mesh), grid_(radius, largest_length_scale) {}

  /// Reports every change from now on to a mirror. It must live as long as the front changes.
  void add_mirror(FrontMirror& mirror) { mirrors_.push_back(&mirror); }

  const FrontEdge& operator[](FrontEdgeId e) const { return edges_[e]; }
  const FrontEdge& next(FrontEdgeId e) const { return edges_[edges_[e].next]; }
  const FrontEdge& previous(FrontEdgeId e) const { return edges_[edges_[e].previous]; }
  VertexId target(FrontEdgeId e) const { return next(e).origin; }
  /// Whether the polygon of an edge has three edges.
  bool is_triangle(FrontEdgeId e) const { return previous(e).previous == edges_[e].next; }
  const FrontGrid& grid() const { return grid_; }
  const Mesh& mesh() const { return mesh_; }
  std::size_t capacity() const { return edges_.size(); }
  std::size_t open_edges() const { return open_; }
  /// Triangles added in all, those counted that coarsening has taken out again.
  std::size_t triangles_added() const { return triangles_added_; }

  /// Adds a closed fan of triangles about a new vertex, and opens its rim.
  /// @param rim  counter-clockwise seen from outside
  void open_fan(const SurfacePoint& centre, std::span<const SurfacePoint> rim);

  /// Opens a cycle of front edges along boundary half-edges, each ending where the next begins.
  /// @return the edges, in the same order.
  std::vector<FrontEdgeId> open_polygon(std::span<const HalfEdgeId> half_edges);

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

  /// Adds the triangle of edge e and an existing corner's vertex, wherever that is: closes a corner
  /// where it is next to e, and else attaches it.
  void finish_edge(FrontEdgeId e, FrontEdgeId corner);

  /// Takes over the edges of a front whose mesh was appended to this one's. Mirrors receive
  /// nothing: they absorb their counterparts.
  void absorb(const Front& other, const IdOffsets& offsets);

  /// The vertices behind the front as one part; those on it belong to none.
  geometry::Parts parts_behind() const;

 private:
  /// @pre the mesh has lost nothing that the front runs along.
  void compacted(const geometry::Renaming& renaming) override;
  geometry::TriangleId add_triangle(FrontEdgeId e, VertexId apex);
  FrontEdgeId open_edge(VertexId origin, HalfEdgeId half_edge);
  void close_edge(FrontEdgeId e);
  void link(FrontEdgeId e, FrontEdgeId f) {
    edges_[e].next = f;
    edges_[f].previous = e;
  }
  void report(const FrontChange& change) const {
    for (FrontMirror* mirror : mirrors_) mirror->follow(change);
  }

  Mesh& mesh_;
  std::vector<FrontMirror*> mirrors_;
  geometry::IdVector<FrontEdgeId, FrontEdge> edges_;
  std::vector<FrontEdgeId> free_;
  FrontGrid grid_;
  std::size_t open_ = 0;
  std::size_t triangles_added_ = 0;
};

}  // namespace morskin::front
