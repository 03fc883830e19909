#include "app/figures/skin_scene.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace morskin::figures {

MeshLayer skin_layer(const morskin::PreparedSkin& skin, const morskin::MeshResult& result) {
  MeshLayer layer;
  layer.mesh = result.mesh;
  for (std::size_t v = 0; v < result.cells.size(); ++v) {
    layer.normals.push_back(skin.surface.at(result.mesh.positions[v], result.cells[v]).normal);
  }
  layer.coat.colour = skin_blue;
  return layer;
}

MeshLayer skin_layer(const surface::Mesh& mesh, std::size_t triangles) {
  MeshLayer layer;
  for (const surface::SurfacePoint& p : mesh.points) {
    layer.mesh.positions.push_back(p.position);
    layer.normals.push_back(p.normal);
  }
  layer.mesh.triangles = mesh.surface.triangle_list();
  layer.mesh.triangles.resize(triangles);
  layer.coat.colour = skin_blue;
  return layer;
}

MeshLayer backdrop(const morskin::PreparedSkin& skin, const morse::MorseFunction& function,
                   double inwards) {
  constexpr double fine = 0.02;
  const morskin::MeshResult result = meshed(skin, fine, function);
  MeshLayer layer = skin_layer(skin, result);
  for (std::size_t v = 0; v < result.cells.size(); ++v) {
    const surface::SurfacePoint p = skin.surface.at(result.mesh.positions[v], result.cells[v]);
    layer.mesh.positions[v] -= inwards * p.length_scale * p.normal;
  }
  layer.coat.colour = bare_grey;
  layer.coat.gloss = 0.08;
  return layer;
}

morskin::MeshResult meshed(const morskin::PreparedSkin& skin, double C,
                           const std::optional<morse::MorseFunction>& function) {
  morskin::MeshingOptions options;
  options.sizing.C = C;
  options.function = function;
  return morskin::make_mesh(skin, options);
}

void add_critical_points(Scene& scene, std::span<const morse::CriticalPoint> points,
                         double radius) {
  for (const morse::CriticalPoint& p : points) {
    scene.balls.push_back(
        {p.point.position + 0.5 * radius * p.point.normal, radius, colour_of_index(p.index)});
  }
}

void add_level_curve(Scene& scene, const MeshLayer& layer, const morse::MorseFunction& function,
                     double value, const Colour& colour, double width, double lift) {
  std::vector<double> heights;
  for (const Point& p : layer.mesh.positions) heights.push_back(function(p) - value);
  for (const auto& t : layer.mesh.triangles) {
    std::vector<Point> ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t a = t[k], b = t[(k + 1) % 3];
      if ((heights[a] < 0) == (heights[b] < 0)) continue;
      const double share = heights[a] / (heights[a] - heights[b]);
      ends.push_back(layer.mesh.positions[a] +
                     share * (layer.mesh.positions[b] - layer.mesh.positions[a]));
    }
    if (ends.size() == 2) scene.lines.push_back({ends, colour, width, lift});
  }
}

Camera principal_camera(std::span<const Point> points, int width, int height) {
  Point mean = Point::Zero();
  for (const Point& p : points) mean += p;
  mean /= static_cast<double>(points.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Point& p : points) spread += (p - mean) * (p - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  // Eigenvectors have no sign: make each axis' largest coordinate positive.
  const auto directed = [](Vector v) {
    Eigen::Index largest = 0;
    v.cwiseAbs().maxCoeff(&largest);
    return Vector(v[largest] < 0 ? -v : v);
  };
  return pictures::camera_from(directed(axes.eigenvectors().col(0)),
                               directed(axes.eigenvectors().col(2)), width, height)
      .fitted(points);
}

}  // namespace morskin::figures
