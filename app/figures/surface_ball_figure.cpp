// A facet of a Delaunay triangulation, its dual Voronoi edge and its surface ball (section 2.2; the
// page of the static method): on a mesh of a neck, cut open.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "app/figures/figures.h"
#include "app/figures/skin_scene.h"
#include "certify/triangle_geometry.h"
#include "geometry/predicates.h"
#include "geometry/regular_triangulation.h"
#include "refine/circumcentre.h"

namespace morskin::figures {
namespace {

using DualEdge = std::array<Point, 2>;

constexpr Colour inner_side = Colour::of(0xe3d3b4), dual_violet = Colour::of(0x8a3fc2);

// By facet, corners ascending, the circumcentres of the two tetrahedra behind it: the ends of its
// dual Voronoi edge. Facets of the hull are left out.
std::map<geometry::TriangleCorners, DualEdge> dual_edges(std::span<const Point> positions) {
  std::vector<geometry::WeightedPoint> points;
  for (const Point& p : positions) points.push_back({p.unaryExpr(&geometry::on_exact_grid), 0});
  const geometry::RegularTriangulation delaunay = geometry::regular_triangulation(points);
  std::vector<std::vector<Point>> ends(delaunay.triangles.size());
  for (std::size_t t = 0; t < delaunay.tetrahedra.size(); ++t) {
    std::array<const Point*, 4> at{};
    std::ranges::transform(delaunay.tetrahedra[t], at.begin(),
                           [&](geometry::AtomId id) { return &points[id.index()].position; });
    for (const std::uint32_t facet : delaunay.tetrahedron_triangles[t]) {
      ends[facet].push_back(refine::circumcentre(at));
    }
  }
  std::map<geometry::TriangleCorners, DualEdge> edges;
  for (std::size_t f = 0; f < ends.size(); ++f) {
    const auto& [u, v, w] = delaunay.triangles[f];
    if (ends[f].size() == 2) edges[{u.value, v.value, w.value}] = {ends[f][0], ends[f][1]};
  }
  return edges;
}

Point centroid(const geometry::IndexedMesh& mesh, const geometry::TriangleCorners& t) {
  return (mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]]) / 3;
}

struct Facet {
  geometry::TriangleCorners triangle;
  std::array<Point, 3> corners;
  DualEdge dual;
  certify::SurfaceBall ball;

  double radius() const { return std::sqrt(ball.squared_radius); }
  Vector normal() const {
    return (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
  }
};

// Of all triangles, the one with the shortest dual edge that leaves its surface ball on both sides.
Facet shortest_dual(const morskin::PreparedSkin& skin, const morskin::MeshResult& result) {
  const geometry::IndexedMesh& mesh = result.mesh;
  const auto edges = dual_edges(mesh.positions);
  const auto ball_of = [&](const geometry::TriangleCorners& t) {
    const surface::SurfacePoint a = skin.surface.at(mesh.positions[t[0]], result.cells[t[0]]);
    return certify::exact_surface_ball(skin.surface, a, mesh.positions[t[1]], mesh.positions[t[2]]);
  };
  const auto dual_of = [&](geometry::TriangleCorners t) {
    std::ranges::sort(t);
    const auto found = edges.find(t);
    return found == edges.end() ? nullptr : &found->second;
  };
  const auto length = [&](const geometry::TriangleCorners& t) {
    const DualEdge* dual = dual_of(t);
    const certify::SurfaceBall ball = ball_of(t);
    if (!dual || ball.intrusion((*dual)[0]) > 0 || ball.intrusion((*dual)[1]) > 0) {
      return std::numeric_limits<double>::infinity();
    }
    return ((*dual)[0] - (*dual)[1]).norm();
  };
  const geometry::TriangleCorners t = *std::ranges::min_element(mesh.triangles, {}, length);
  return {t,
          {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]},
          *dual_of(t),
          ball_of(t)};
}

// The mesh without what stands before the facet, seen from `across`.
MeshLayer cut_layer(const morskin::PreparedSkin& skin, const morskin::MeshResult& result,
                    const Facet& facet, const Vector& across) {
  MeshLayer layer = skin_layer(skin, result);
  layer.normals.clear();
  layer.coat.edge_width = 1.6;
  layer.coat.back = inner_side;
  const double depth = across.dot(centroid(result.mesh, facet.triangle));
  std::erase_if(layer.mesh.triangles, [&](const geometry::TriangleCorners& t) {
    return t != facet.triangle &&
           across.dot(centroid(result.mesh, t)) > depth + 0.3 * facet.radius();
  });
  for (const geometry::TriangleCorners& t : layer.mesh.triangles) {
    layer.triangle_colours.push_back(t == facet.triangle ? fresh_orange : skin_blue);
  }
  return layer;
}

// The facet's dual edge and its surface ball, whose rim is the circle that the camera sees.
void add_ball(Scene& scene, const Facet& facet, const Camera& camera) {
  const Point& centre = facet.ball.centre;
  const double radius = facet.radius();
  for (const Point& end : facet.dual) {
    scene.lines.push_back({{centre, end}, dual_violet, 3, 0, 0, true});
    scene.balls.push_back({end, 0.05 * radius, dual_violet});
  }
  for (const Point& corner : facet.corners) {
    scene.lines.push_back({{centre, corner}, pictures::ink, 1.5, 0, 4, true});
  }
  pictures::Line rim{{}, front_red, 2, 0, 0, true};
  constexpr int sides = 180;
  for (int i = 0; i <= sides; ++i) {
    const double angle = 2 * M_PI * i / sides;
    rim.points.push_back(centre +
                         radius * (std::cos(angle) * camera.right + std::sin(angle) * camera.up));
  }
  scene.lines.push_back(std::move(rim));
  scene.balls.push_back({centre, 0.07 * radius, front_red});
  for (std::size_t k = 0; k < 3; ++k) {
    const Point& corner = facet.corners[k];
    scene.balls.push_back({corner, 0.05 * radius, pictures::ink});
    const Vector seen = camera.seen(corner) - camera.seen(centre);
    const Vector2 out = 20 * seen.head<2>().normalized() + Vector2(0, 6);
    scene.labels.push_back({corner, std::string(1, "abc"[k]), out, 15});
  }
}

}  // namespace

Image surface_ball(double scale) {
  std::vector<geometry::WeightedPoint> balls{{{-1.62, 0, 0}, 2 * 1.15 * 1.15},
                                             {{1.5, 0, 0}, 2 * 1.3 * 1.3}};
  const morskin::PreparedSkin skin = morskin::prepare_skin(std::move(balls));
  // Coarse, so that the centre on the skin stands well off the facet.
  constexpr double C = 0.3;
  morskin::MeshingOptions options;
  options.sizing = {.C = C, .Q = certify::Sizing::quality_for(C)};
  options.method = morskin::Method::Static;
  const morskin::MeshResult result = morskin::make_mesh(skin, options);
  const Facet facet = shortest_dual(skin, result);
  const Vector across = Vector::UnitX().cross(facet.normal()).normalized();
  Camera camera = pictures::camera_from(across + 0.3 * facet.normal(), facet.normal(), 700, 520);
  Scene scene;
  scene.meshes.push_back(cut_layer(skin, result, facet, across));
  add_ball(scene, facet, camera);
  camera.target = facet.ball.centre;
  camera.scale = camera.width / (7 * facet.radius());
  return with_legend(panel(scene, camera, scale),
                     {{},
                      {{Mark::Patch, fresh_orange, "Delaunay facet abc"},
                       {Mark::Line, dual_violet, "its dual Voronoi edge"},
                       {Mark::Line, front_red, "surface ball, its centre on the skin"},
                       {Mark::Dashes, pictures::ink, "radius"},
                       {Mark::Patch, skin_blue, "mesh"},
                       {Mark::Patch, inner_side, "its inner side"}}},
                     scale);
}

}  // namespace morskin::figures
