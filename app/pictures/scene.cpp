#include "app/pictures/scene.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

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

namespace {

using Edge = std::array<std::uint32_t, 2>;

/// By vertex the first one at its position.
std::vector<std::uint32_t> first_at_position(const geometry::IndexedMesh& mesh) {
  std::vector<std::tuple<double, double, double, std::uint32_t>> order;
  order.reserve(mesh.positions.size());
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const Point& p = mesh.positions[v];
    order.emplace_back(p.x(), p.y(), p.z(), v);
  }
  std::ranges::sort(order);
  std::vector<std::uint32_t> first(mesh.positions.size());
  std::uint32_t last = 0;
  for (const auto& [x, y, z, v] : order) {
    if (Point(x, y, z) != mesh.positions[last]) last = v;
    first[v] = last;
  }
  return first;
}

void drop_copies(std::vector<Edge>& edges, const geometry::IndexedMesh& mesh) {
  if (edges.empty()) return;
  const std::vector<std::uint32_t> first = first_at_position(mesh);
  std::vector<std::pair<Edge, Edge>> order;
  for (const auto& [a, b] : edges) {
    order.push_back({{std::min(first[a], first[b]), std::max(first[a], first[b])}, {a, b}});
  }
  std::ranges::sort(order);
  const auto same = [](const auto& p, const auto& q) { return p.first == q.first; };
  order.erase(std::unique(order.begin(), order.end(), same), order.end());
  edges.clear();
  for (const auto& [unused, edge] : order) edges.push_back(edge);
  std::ranges::sort(edges);
}

}  // namespace

std::vector<Edge> boundary_edges(const geometry::IndexedMesh& mesh) {
  std::vector<Edge> edges;
  edges.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])});
    }
  }
  std::sort(edges.begin(), edges.end());
  std::vector<Edge> single;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const bool is_twice =
        (i > 0 && edges[i] == edges[i - 1]) || (i + 1 < edges.size() && edges[i] == edges[i + 1]);
    if (!is_twice) single.push_back(edges[i]);
  }
  drop_copies(single, mesh);
  return single;
}

void drop_copies(geometry::IndexedMesh& mesh) {
  const std::vector<std::uint32_t> first = first_at_position(mesh);
  std::vector<std::array<std::uint32_t, 4>> order;  // corners, the least in front, and the number
  order.reserve(mesh.triangles.size());
  for (const auto& [a, b, c] : mesh.triangles) {
    geometry::TriangleCorners t{first[a], first[b], first[c]};
    std::rotate(t.begin(), std::ranges::min_element(t), t.end());
    order.push_back({t[0], t[1], t[2], static_cast<std::uint32_t>(order.size())});
  }
  std::ranges::sort(order);
  std::vector<bool> is_copy(mesh.triangles.size());
  for (std::size_t i = 1; i < order.size(); ++i) {
    is_copy[order[i][3]] = std::equal(order[i].begin(), order[i].begin() + 3, order[i - 1].begin());
  }
  std::size_t kept = 0;
  for (std::size_t t = 0; t < is_copy.size(); ++t) {
    if (!is_copy[t]) mesh.triangles[kept++] = mesh.triangles[t];
  }
  mesh.triangles.resize(kept);
}

}  // namespace morskin::pictures
