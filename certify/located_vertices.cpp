#include "certify/located_vertices.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

namespace morskin::certify {

namespace {

float rounded_up(double x) {
  const auto nearest = static_cast<float>(x);
  if (static_cast<double>(nearest) >= x || std::isnan(x)) return nearest;
  return std::nextafter(nearest, std::numeric_limits<float>::infinity());
}

}  // namespace

EdgeSides::EdgeSides(std::span<const geometry::TriangleCorners> triangles) : is_open_(true) {
  for (const geometry::TriangleCorners& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::pair side(t[k], t[(k + 1) % 3]);
      if (side.first < side.second) upwards_.push_back(side);
    }
  }
  std::ranges::sort(upwards_);
}

void VertexLocator::locate(std::uint32_t v, surface::CellId start) {
  set(v, surface_.locate(mesh_.positions[v], start));
}

void VertexLocator::set(std::size_t v, surface::CellId cell) {
  const surface::Point& x = mesh_.positions[v];
  const surface::Enclosure found = surface_.enclose(x, cell);
  const Vector& N = found.half_gradient;
  const double rho = N.norm();
  const double error = found.error + 0x1p-50 * rho;  // length scale times normal is rounded
  std::construct_at(&vertices_[v], LocatedVertex{N, -rounded_up(-found.low), rounded_up(found.high),
                                                 rounded_up(error), cell});
  is_located_[v] = 1;
}

void VertexLocator::locate_hinted(std::span<const surface::CellId> hints, std::size_t begin,
                                  std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    if (surface_.is_in(mesh_.positions[v], hints[v])) set(v, hints[v]);
  }
}

void VertexLocator::locate_rest(const geometry::Run& run) {
  if (std::ranges::find(is_located_, 0) == is_located_.end()) return;
  // Triangles come in the order they were laid, so nearly all have a located corner, with the other
  // cells near; a breadth-first order would be as short and cost a queue. Those that refinement
  // changed may come too early: they wait for another round, to avoid long walks.
  surface::CellId last{};
  std::vector<std::uint32_t> waiting;
  const auto locate_corners = [&](std::uint32_t t, bool may_wait) {
    const auto& triangle = mesh_.triangles[t];
    bool is_near = false;
    for (const std::uint32_t v : triangle) {
      if (is_located_[v] == 0) continue;
      last = vertices_[v].cell;
      is_near = true;
    }
    if (!is_near && may_wait) return waiting.push_back(t);
    for (const std::uint32_t v : triangle) {
      if (is_located_[v] == 0) locate(v, last);
      last = vertices_[v].cell;
    }
  };
  constexpr std::uint32_t report_every = 1U << 16U;  // triangles: some 60 milliseconds
  for (std::uint32_t t = 0; t < mesh_.triangles.size(); ++t) {
    if ((t + 1) % report_every == 0) run.report(geometry::unknown_share);
    locate_corners(t, t > 0);
  }
  constexpr int max_rounds = 3;
  for (int round = 1; round <= max_rounds; ++round) {
    for (const std::uint32_t t : std::exchange(waiting, {})) locate_corners(t, round < max_rounds);
  }
  for (std::uint32_t v = 0; v < vertices_.size(); ++v) {
    if (is_located_[v] == 0) locate(v, last);
    last = vertices_[v].cell;
  }
}

LocatedVertices locate_with_bounds(const geometry::IndexedMesh& mesh,
                                   const surface::Surface& surface, const geometry::Run& run) {
  VertexLocator locator(mesh, surface);
  locator.locate_rest(run);
  return locator.take_vertices();
}

std::vector<surface::SurfacePoint> locate_vertices(const geometry::IndexedMesh& mesh,
                                                   const surface::Surface& surface,
                                                   const geometry::Run& run) {
  const LocatedVertices located = locate_with_bounds(mesh, surface, run);
  std::vector<SurfacePoint> points;
  points.reserve(located.size());
  for (std::size_t v = 0; v < located.size(); ++v) {
    points.push_back(located[v].at(mesh.positions[v]));
  }
  return points;
}

std::vector<surface::CellId> cells_of(std::span<const surface::SurfacePoint> points) {
  std::vector<surface::CellId> cells;
  cells.reserve(points.size());
  for (const surface::SurfacePoint& p : points) cells.push_back(p.cell);
  return cells;
}

}  // namespace morskin::certify
