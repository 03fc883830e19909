#include "geometry/mesh_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/id.h"
#include "geometry/prefetch.h"
#include "geometry/union_find.h"

namespace morskin::geometry {

namespace {

constexpr double degrees = 180 / std::numbers::pi;

/// The extreme angles of a mesh with needles: of an angle within some 10^-6 degrees of 0 or 180 the
/// cosine tells nothing.
void measure_needles(const IndexedMesh& mesh, MeshShape& shape) {
  shape.min_angle_deg = 180;
  shape.max_angle_deg = 0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const Point &p = mesh.positions[a], &q = mesh.positions[b], &r = mesh.positions[c];
    const std::array<Vector, 3> sides{q - p, r - q, p - r};
    for (std::size_t k = 0; k < 3; ++k) {
      const Vector to = sides[k].stableNormalized(), from = sides[(k + 2) % 3].stableNormalized();
      const bool is_none = to.isZero(0) || from.isZero(0);
      const double angle = std::atan2(to.cross(from).norm(), -to.dot(from)) * degrees;
      shape.min_angle_deg = std::min(shape.min_angle_deg, is_none ? 0 : angle);
      shape.max_angle_deg = std::max(shape.max_angle_deg, is_none ? 180 : angle);
    }
  }
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

/// Whether a triangle certainly has no cosine beyond those known, without a root; true for nearly
/// all.
bool ShapeMeasure::certainly_holds(const Vector& pq, const Vector& qr, const Vector& rp) const {
  if (!(largest_cosine_ > 0 && smallest_cosine_ < 0)) return false;
  constexpr double margin = 1 - 1e-12;  // far above rounding
  const double above = margin * largest_cosine_ * largest_cosine_;
  const double below = margin * smallest_cosine_ * smallest_cosine_;
  const double x = pq.squaredNorm(), y = qr.squaredNorm(), z = rp.squaredNorm();
  const auto is_within = [&](double dot, double squares) {
    return dot * dot < (dot < 0 ? above : below) * squares;
  };
  return is_within(pq.dot(rp), x * z) && is_within(pq.dot(qr), x * y) &&
         is_within(qr.dot(rp), y * z);
}

void ShapeMeasure::add(const TriangleCorners& triangle) {
  const Point &p = mesh_->positions[triangle[0]], &q = mesh_->positions[triangle[1]],
              &r = mesh_->positions[triangle[2]], &apex = mesh_->positions[0];
  const Vector pq = q - p, rp = p - r, doubled = rp.cross(pq);
  area_ += doubled.norm() / 2;
  volume_ += (p - apex).dot(doubled) / 6;
  if (certainly_holds(pq, r - q, rp)) return;
  const TriangleShape exact = triangle_shape(p, q, r, apex);
  largest_cosine_ = std::max(largest_cosine_, exact.largest_cosine);
  smallest_cosine_ = std::min(smallest_cosine_, exact.smallest_cosine);
}

void ShapeMeasure::add(const ShapeMeasure& other) {
  area_ += other.area_;
  volume_ += other.volume_;
  largest_cosine_ = std::max(largest_cosine_, other.largest_cosine_);
  smallest_cosine_ = std::min(smallest_cosine_, other.smallest_cosine_);
}

MeshShape ShapeMeasure::shape() const {
  MeshShape shape{.area = area_, .volume = volume_};
  shape.min_angle_deg = std::acos(std::clamp(largest_cosine_, -1.0, 1.0)) * degrees;
  shape.max_angle_deg = std::acos(std::clamp(smallest_cosine_, -1.0, 1.0)) * degrees;
  constexpr double of_needles = 1 - 1e-8;  // within 0.01 degrees
  if (std::max(largest_cosine_, -smallest_cosine_) > of_needles) measure_needles(*mesh_, shape);
  return shape;
}

MeshShape measure_shape(const IndexedMesh& mesh) {
  ShapeMeasure measure(mesh);
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const std::size_t later = std::min(i + prefetch_ahead, mesh.triangles.size() - 1);
    for (const std::uint32_t v : mesh.triangles[later]) prefetch(&mesh.positions[v]);
    measure.add(mesh.triangles[i]);
  }
  return measure.shape();
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

std::vector<std::uint32_t> vertex_components(const IndexedMesh& mesh) {
  // A triangle's corners take a label that one of them has, or a new one; labels that meet are one.
  std::vector<std::uint32_t> component(mesh.positions.size(), no_index);
  UnionFind labels(0);
  for (const auto& corners : mesh.triangles) {
    std::uint32_t label = no_index;
    for (const std::uint32_t v : corners) {
      const std::uint32_t other = component[v];
      if (other == no_index || other == label) continue;
      if (label != no_index) labels.join(label, other);
      label = other;
    }
    if (label == no_index) label = labels.add();
    for (const std::uint32_t v : corners) component[v] = label;
  }
  std::vector<std::uint32_t> number(labels.size(), no_index);
  std::uint32_t count = 0;
  for (std::uint32_t& label : component) {
    if (label == no_index) label = labels.add();
    number.resize(labels.size(), no_index);
    std::uint32_t& n = number[labels.root(label)];
    if (n == no_index) n = count++;
    label = n;
  }
  return component;
}

}  // namespace morskin::geometry
