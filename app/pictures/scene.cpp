#include "app/pictures/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace morskin::pictures {

std::vector<Point> Scene::extent() const {
  std::vector<Point> points;
  const auto add_ball = [&](const Point& centre, double radius) {
    for (const double x : {-radius, radius}) {
      for (int axis = 0; axis < 3; ++axis) points.push_back(centre + x * Vector::Unit(axis));
    }
  };
  for (const MeshLayer& layer : meshes) {
    points.insert(points.end(), layer.mesh.positions.begin(), layer.mesh.positions.end());
  }
  for (const Ball& ball : balls) add_ball(ball.centre, ball.radius);
  for (const Stick& stick : sticks) {
    add_ball(stick.from, stick.radius);
    add_ball(stick.to, stick.radius);
  }
  for (const Line& line : lines) {
    points.insert(points.end(), line.points.begin(), line.points.end());
  }
  return points;
}

std::vector<Vector> smooth_normals(const geometry::IndexedMesh& mesh) {
  std::vector<Vector> normals(mesh.positions.size(), Vector::Zero());
  for (const auto& triangle : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Point& p = mesh.positions[triangle[k]];
      const Vector a = mesh.positions[triangle[(k + 1) % 3]] - p;
      const Vector b = mesh.positions[triangle[(k + 2) % 3]] - p;
      const Vector n = a.cross(b);
      const double length = n.norm();
      if (length > 0) normals[triangle[k]] += std::atan2(length, a.dot(b)) / length * n;
    }
  }
  for (Vector& n : normals) {
    const double length = n.norm();
    n = length > 0 ? Vector(n / length) : Vector(Vector::UnitZ());
  }
  return normals;
}

std::vector<std::array<std::uint32_t, 2>> boundary_edges(const geometry::IndexedMesh& mesh) {
  std::vector<std::array<std::uint32_t, 2>> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<std::array<std::uint32_t, 2>> single;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_twice =
        (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
    if (!is_twice) single.push_back(edges[i]);
  }
  return single;
}

}  // namespace morskin::pictures
