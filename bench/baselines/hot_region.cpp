#include "bench/baselines/hot_region.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>

namespace morskin::baselines {

namespace {

/// Rings stay this share of the spacing from the loop that they meet: nearly a whole one, as the
/// loop's vertices lie up to one spacing farther out.
constexpr double gap_to_loop = 0.7;

/// How many steps of about one spacing a length, over the length scale, is cut into.
int steps_along(double length, double spacing) {
  return std::max(1, static_cast<int>(std::lround(length / spacing)));
}

/// A vertex at the point of the skin that x projects to.
VertexId add_vertex(MovingMesh& mesh, const Point& x, CellId cell) {
  const auto p = mesh.level().project(x, cell);
  return mesh.add_vertex(p ? *p : mesh.level().at(x, cell));
}

}  // namespace

Frame::Frame(const Patch& patch, double direction)
    : centre(patch.centre),
      axis(direction * (patch.axis.squaredNorm() > 0.5 ? patch.axis : Vector(Vector::UnitZ()))),
      across(axis) {}

Ring add_ring(MovingMesh& mesh, const Frame& frame, CellId cell, double radial, double axial,
              double turn) {
  const double around = 2 * std::numbers::pi * radial / std::hypot(radial, axial);
  const int count = std::max(5, static_cast<int>(std::lround(around / mesh.spacing())));
  Ring ring;
  for (int i = 0; i < count; ++i) {
    const double azimuth = turn + 2 * std::numbers::pi * i / count;
    ring.push_back(add_vertex(mesh, frame.point(radial, azimuth, axial), cell));
  }
  return ring;
}

void join(MovingMesh& mesh, const Ring& outer, const Ring& inner, std::vector<Corners>& triangles) {
  const std::size_t n = outer.size(), m = inner.size();
  std::vector<Point> out, in;
  for (const VertexId v : outer) out.push_back(mesh.position(v));
  for (const VertexId v : inner) in.push_back(mesh.position(v));
  std::size_t start = 0;
  for (std::size_t j = 1; j < m; ++j) {
    if ((out[0] - in[j]).squaredNorm() < (out[0] - in[start]).squaredNorm()) start = j;
  }
  std::rotate(in.begin(), in.begin() + static_cast<std::ptrdiff_t>(start), in.end());
  // cost[i][j]: the least of all paths from the rung (0, 0) to (i, j). A path past (n, 0) or (0, m)
  // would put the rung (0, 0) into the strip twice.
  constexpr double barred = std::numeric_limits<double>::infinity();
  std::vector<double> cost((n + 1) * (m + 1), barred);
  const auto at = [&](std::size_t i, std::size_t j) -> double& { return cost[i * (m + 1) + j]; };
  at(0, 0) = 0;
  for (std::size_t i = 0; i <= n; ++i) {
    for (std::size_t j = 0; j <= m; ++j) {
      if (i + j == 0 || (i == n && j == 0) || (i == 0 && j == m)) continue;
      const double before = std::min(i > 0 ? at(i - 1, j) : barred, j > 0 ? at(i, j - 1) : barred);
      at(i, j) = before + (out[i % n] - in[j % m]).squaredNorm();
    }
  }
  for (std::size_t i = n, j = m; i + j > 0;) {
    const VertexId a = outer[i % n], b = inner[(start + j) % m];
    if (j == 0 || (i > 0 && at(i - 1, j) < at(i, j - 1))) {
      triangles.push_back({outer[--i], a, b});
    } else {
      triangles.push_back({a, b, inner[(start + --j) % m]});
    }
  }
}

void close(const Ring& ring, VertexId centre, std::vector<Corners>& triangles) {
  for (std::size_t i = 0; i < ring.size(); ++i) {
    triangles.push_back({ring[i], ring[(i + 1) % ring.size()], centre});
  }
}

bool add_triangles(SurfaceMesh& surface, const std::vector<Corners>& triangles,
                   const std::vector<HalfEdgeId>& open) {
  std::map<std::pair<VertexId, VertexId>, HalfEdgeId> waiting;
  for (const HalfEdgeId h : open) waiting[{surface.origin(h), surface.target(h)}] = h;
  bool is_sound = true;
  for (const auto& [a, b, c] : triangles) {
    const TriangleId t = surface.add_triangle(a, b, c);
    for (std::uint32_t k = 0; k < 3; ++k) {
      const HalfEdgeId h = SurfaceMesh::half_edge(t, k);
      const auto twin = waiting.find({surface.target(h), surface.origin(h)});
      if (twin != waiting.end()) {
        surface.glue(h, twin->second);
        waiting.erase(twin);
      } else {
        is_sound =
            waiting.emplace(std::pair{surface.origin(h), surface.target(h)}, h).second && is_sound;
      }
    }
  }
  return is_sound && waiting.empty();
}

std::vector<Corners> sphere_template(MovingMesh& mesh, const Frame& frame, CellId cell,
                                     double radius) {
  const int steps = steps_along(std::numbers::pi, mesh.spacing());
  const auto pole = [&](double side) {
    return add_vertex(mesh, frame.point(0, 0, side * radius), cell);
  };
  std::vector<Corners> triangles;
  const VertexId south = pole(-1), north = pole(+1);
  Ring last;
  for (int k = 1; k < steps; ++k) {
    const double latitude = std::numbers::pi * k / steps;
    const Ring ring = add_ring(mesh, frame, cell, radius * std::sin(latitude),
                               -radius * std::cos(latitude), 0.5 * k * mesh.spacing());
    if (k == 1) {
      close(Ring(ring.rbegin(), ring.rend()), south, triangles);
    } else {
      join(mesh, last, ring, triangles);
    }
    last = ring;
  }
  close(last, north, triangles);
  // Spheres that are voids are seen from inside.
  if (mesh.skin().patch(cell).sign < 0) {
    for (Corners& t : triangles) std::swap(t[0], t[1]);
  }
  return triangles;
}

std::vector<Corners> cap_template(MovingMesh& mesh, const Frame& frame, CellId cell, double h,
                                  const Ring& loop) {
  double radius = std::numeric_limits<double>::infinity();
  for (const VertexId v : loop) radius = std::min(radius, frame.radial(mesh.position(v)));
  // With radial = h sinh(a), axial = h cosh(a), a is the length along a meridian over the length
  // scale.
  const double first =
      std::max(std::asinh(radius / h) - gap_to_loop * mesh.spacing(), mesh.spacing());
  const int steps = steps_along(first, mesh.spacing());
  std::vector<Corners> triangles;
  Ring last = loop;
  for (int k = steps; k >= 1; --k) {
    const double a = first * k / steps;
    const Ring ring =
        add_ring(mesh, frame, cell, h * std::sinh(a), h * std::cosh(a), 0.5 * k * mesh.spacing());
    join(mesh, last, ring, triangles);
    last = ring;
  }
  close(last, add_vertex(mesh, frame.point(0, 0, h), cell), triangles);
  return triangles;
}

std::vector<Corners> tube_template(MovingMesh& mesh, const Frame& frame, CellId cell, double h,
                                   const Ring& lower, const Ring& upper) {
  double low = -std::numeric_limits<double>::infinity(), high = -low;
  for (const VertexId v : lower) low = std::max(low, frame.axial(mesh.position(v)));
  for (const VertexId v : upper) high = std::min(high, frame.axial(mesh.position(v)));
  // With axial = h sinh(a), radial = h cosh(a), a is the length along a meridian over the length
  // scale.
  const double gap = gap_to_loop * mesh.spacing();
  const double first = std::asinh(low / h) + gap, end = std::asinh(high / h) - gap;
  const int steps = steps_along(end - first, mesh.spacing());
  std::vector<Corners> triangles;
  Ring last = lower;
  for (int k = 0; k <= steps; ++k) {
    const double a = first + (end - first) * k / steps;
    const Ring ring =
        add_ring(mesh, frame, cell, h * std::cosh(a), h * std::sinh(a), 0.5 * k * mesh.spacing());
    join(mesh, last, ring, triangles);
    last = ring;
  }
  join(mesh, last, Ring(upper.rbegin(), upper.rend()), triangles);
  return triangles;
}

}  // namespace morskin::baselines
