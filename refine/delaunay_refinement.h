#pragma once

/// Restricted Delaunay refinement on the skin: the static method (papers/5-static.md).
///
/// A sample of the skin is kept in a Delaunay triangulation of space. A facet of it is restricted
/// when its dual Voronoi edge, between the circumcentres of the two tetrahedra behind it, crosses
/// the skin; the crossing is the centre of an empty ball through the facet's corners, its surface
/// ball. While some restricted facet's ball is too big for [U], the centre becomes a sample point;
/// and so does that of a facet too coarse for the certificate to prove, where [L] allows it.
/// The restricted facets that are left are the mesh.
///
/// The sign of G at its circumcentre, computed once, makes a tetrahedron inside or outside. The
/// dual edge of a facet between an inside and an outside one crosses the skin an odd number of
/// times, so the mesh is the boundary of the inside tetrahedra: closed, even where rounding
/// misplaces the circumcentre of a flat one. Dual edges with an even number of crossings are found
/// by following them piece by piece (Surface::crossings).
///
/// Facets with an angle below a bound are broken as well, if one is given: the last step of any
/// method where a mesh alone does not get there (angle_refinement.h). The centre of a ball larger
/// than the facet's shortest edge is farther than that edge from all samples, whatever they are.
///
/// No point is ever deleted. Where Q^2 > 2 + 4 C Q no ball too big for [U] makes a pair too short
/// for [L], and seeds are kept apart, so short edges could come only from coarse seed triangles and
/// from samples that the topology took; `front/static_method` sees to both. For all other constants
/// the spacing of the points still has a lower bound, so the process ends. That holds for exact
/// balls; where rounding has the better of them, samples come to lie nearer to others than their
/// balls' radii. These are counted, and when they are too many the facets are left as they are.
///
/// Source: Chew 1993; Boissonnat & Oudot 2005; Cheng, Dey, Edelsbrunner & Sullivan 2001 ([L], [U]).

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geometry/run.h"
#include "geometry/triangulator.h"
#include "refine/names.h"
#include "surface/bounding_ball.h"

namespace morskin::refine {

struct DelaunayRefinementCounts {
  std::size_t seeds = 0;
  std::size_t too_big = 0;           ///< insertions into balls too big for [U] or not provable
  std::size_t thin = 0;              ///< other insertions, for angles or the topology
  std::size_t topological = 0;       ///< corners whose facets were no disk
  std::size_t hidden_crossings = 0;  ///< balls found only by following whole dual edges
  std::size_t refused = 0;           ///< balls that could not be broken
  std::size_t misplaced = 0;         ///< nearer to a sample than their ball's radius allows
  std::size_t tetrahedra = 0;        ///< made in all
};

class DelaunayRefinement {
 public:
  /// @param seeds      points of the skin; every component has a triangle of them with a surface
  ///                   ball small enough for [U]. Seeds in one plane have none, and make an empty
  ///                   mesh.
  /// @param min_angle_deg  at most 30: facets with a smaller angle are broken
  /// @throws geometry::LimitReached
  DelaunayRefinement(const surface::Surface& surface, const Sizing& sizing,
                     std::span<const SurfacePoint> seeds, double min_angle_deg = 0);

  /// Refines until every surface ball is small enough and the facets are a surface.
  /// @param run  receives the number of samples. Their share of the final number is unknown.
  void run(const geometry::Run& run = geometry::Run());

  /// The restricted facets as they are, samples that have none left out, in an order in which
  /// neighbours are near each other. Where they are no closed manifold no two are glued.
  Mesh mesh() const;

  /// Whether nothing was left too big.
  bool is_done() const { return counts_.refused == 0 && !is_endless(); }
  const DelaunayRefinementCounts& counts() const { return counts_; }
  const geometry::Triangulator& triangulation() const { return delaunay_; }
  /// Whether the tetrahedron's circumcentre lies in the body; false for ghosts.
  bool is_inside(std::uint32_t tetrahedron) const { return duals_[tetrahedron].root < 0; }
  const SurfacePoint& sample(geometry::Triangulator::Corner corner) const {
    return samples_[corner];
  }

 private:
  using Facet = geometry::Triangulator::Facet;
  using Corner = geometry::Triangulator::Corner;
  using CellId = geometry::CellId;
  using Triangle = std::array<std::uint32_t, 3>;

  /// What is kept about a tetrahedron: its dual point, the circumcentre.
  struct Dual {
    Point centre;
    double root = 0;         ///< sqrt |G| with G's sign: below zero inside the body
    CellId cell;             ///< that contains the centre, or is near it
    std::uint32_t born = 0;  ///< the insertion that made the tetrahedron
  };
  /// A restricted facet's surface ball.
  struct Ball {
    Point centre;
    CellId cell;
    double height;  ///< of the centre over the facet, along its dual edge, outwards
    double radius;
    double ratio;            ///< radius over the largest that [U] allows: below 1 is good
    double slope;            ///< of G at the centre along the dual edge, or a lower bound
    bool keeps_off = false;  ///< its centre goes in only as far from the corners as [L] wants
  };
  /// A facet to look at, seen from one of its tetrahedra.
  struct Work {
    Facet facet;
    std::uint32_t born, born_behind;  ///< of its two tetrahedra: as long as they live it stands
  };
  /// A facet to break, whatever its ball's size.
  struct Found {
    Work work;
    Ball ball;
  };

  /// A facet seen from one of its two tetrahedra.
  struct FacetGeometry {
    std::array<const SurfacePoint*, 3> corners;  ///< counter-clockwise seen from outside of it
    Circumcircle circle;
    Vector normal;   ///< unit, along the dual edge, out of the tetrahedron
    double largest;  ///< radius that [U] allows

    double height(const Point& x) const { return normal.dot(x - circle.centre); }
  };
  FacetGeometry geometry_of(Facet f) const;
  Facet behind(Facet f) const { return delaunay_.tetrahedra()[f >> 2].neighbours[f & 3]; }
  bool is_ghost(std::uint32_t t) const { return delaunay_.is_ghost(delaunay_.tetrahedra()[t]); }
  CellId near_dual(std::uint32_t t) const;
  void find_dual(std::uint32_t t, CellId start);
  void inspect_new(std::span<const std::uint32_t> tetrahedra);
  void push(Facet f);
  std::optional<Ball> ball_to_break(Facet inner) const;
  std::optional<Ball> ball_of(Facet inner, const FacetGeometry& facet, bool is_exact) const;
  bool has_small_angle(const FacetGeometry& facet) const;
  Ball ball_at(const FacetGeometry& facet, double height, CellId cell, double slope) const;
  bool insert(const Ball& ball, Facet facet);
  bool is_misplaced(const Ball& ball) const;
  bool is_endless() const;
  bool stands(const Work& work) const;
  Work work_on(Facet facet) const;
  bool break_facet(const Work& work, const Ball& ball);
  void insert_all(const geometry::Run& run);
  void break_all(const std::vector<Found>& found);
  bool follow_dual_edges();
  void follow(Facet f, std::vector<Found>& found) const;
  bool make_disks();
  std::vector<Facet> restricted_facets() const;
  Triangle triangle(Facet inner) const;

  const surface::Surface& surface_;
  const Sizing sizing_;
  const double min_squared_sine_;  ///< of a facet's angles
  const surface::BoundingBall body_;
  std::vector<SurfacePoint> samples_;  ///< by corner
  geometry::Triangulator delaunay_;
  std::vector<Dual> duals_;  ///< by tetrahedron
  /// Restricted facets to look at, by circumradius, the largest octave last.
  std::vector<std::vector<Work>> work_;
  std::uint32_t now_ = 0;       ///< insertions so far
  std::uint32_t followed_ = 0;  ///< dual edges of older tetrahedra have been followed
  DelaunayRefinementCounts counts_;
};

}  // namespace morskin::refine
