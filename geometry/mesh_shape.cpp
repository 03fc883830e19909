#include "geometry/mesh_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/prefetch.h"

namespace morskin::geometry {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// The cosines of the angles at p, q and r; not a number where a side has no length.
std::array<double, 3> cosines(const Vector& pq, const Vector& qr, const Vector& rp) {
  const double x = pq.norm(), y = qr.norm(), z = rp.norm();
  return {-pq.dot(rp) / (x * z), -pq.dot(qr) / (x * y), -qr.dot(rp) / (y * z)};
}

}  // namespace

TriangleShape triangle_shape(const Point& p, const Point& q, const Point& r, const Point& apex) {
  const Vector pq = q - p, qr = r - q, rp = p - r;
  TriangleShape shape{-1, 1, 0, 0};
  for (const double cosine : cosines(pq, qr, rp)) {
    shape.largest_cosine = std::max(shape.largest_cosine, std::isnan(cosine) ? 1.0 : cosine);
    shape.smallest_cosine = std::min(shape.smallest_cosine, std::isnan(cosine) ? -1.0 : cosine);
  }
  const Vector doubled = rp.cross(pq);
  shape.area = doubled.norm() / 2;
  shape.volume = (p - apex).dot(doubled) / 6;
  return shape;
}

MeshShape measure_shape(const IndexedMesh& mesh) {
  // The extreme angles have the extreme cosines; one arc cosine each at the end.
  MeshShape shape;
  double largest_cosine = -1, smallest_cosine = 1;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& [a, b, c] = mesh.triangles[i];
    const std::size_t later = std::min(i + prefetch_ahead, mesh.triangles.size() - 1);
    for (const std::uint32_t v : mesh.triangles[later]) prefetch(&mesh.positions[v]);
    const TriangleShape t =
        triangle_shape(mesh.positions[a], mesh.positions[b], mesh.positions[c], mesh.positions[0]);
    largest_cosine = std::max(largest_cosine, t.largest_cosine);
    smallest_cosine = std::min(smallest_cosine, t.smallest_cosine);
    shape.area += t.area;
    shape.volume += t.volume;
  }
  shape.min_angle_deg = std::acos(std::clamp(largest_cosine, -1.0, 1.0)) * degrees;
  shape.max_angle_deg = std::acos(std::clamp(smallest_cosine, -1.0, 1.0)) * degrees;
  return shape;
}

AngleHistogram angle_histogram(const IndexedMesh& mesh) {
  AngleHistogram counts{};
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    double no_angle = 0;  // at the ends of a side of length zero: 0, then 180
    for (const double cosine : cosines(q - p, r - q, p - r)) {
      double angle = std::acos(std::clamp(cosine, -1.0, 1.0)) * degrees;
      if (std::isnan(angle)) angle = std::exchange(no_angle, 180 - no_angle);
      const double bin = angle / 10;
      ++counts[std::min(static_cast<std::size_t>(bin), counts.size() - 1)];
    }
  }
  return counts;
}

}  // namespace morskin::geometry
