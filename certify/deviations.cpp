#include "certify/deviations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "certify/residuals.h"
#include "certify/triangle_bounds.h"

namespace morskin::certify {

namespace {

/// The few elements with the largest keys, the earliest of equal ones.
template <class Element>
class Worst {
 public:
  void offer(double key, const Element& element) {
    if (std::isnan(key)) key = std::numeric_limits<double>::infinity();
    if (count_ == max_count && !(key > kept_[max_count - 1].key)) return;
    std::size_t i = count_ < max_count ? count_++ : max_count - 1;
    for (; i > 0 && kept_[i - 1].key < key; --i) kept_[i] = kept_[i - 1];
    kept_[i] = {key, element};
  }
  std::vector<Element> list() const {
    std::vector<Element> result;
    for (std::size_t i = 0; i < count_; ++i) result.push_back(kept_[i].element);
    return result;
  }

 private:
  static constexpr std::size_t max_count = 10;
  struct Entry {
    double key;
    Element element;
  };
  std::array<Entry, max_count> kept_{};
  std::size_t count_ = 0;
};

BadVertex distance(const surface::Surface& surface, const Point& x, surface::CellId cell,
                   std::uint32_t id) {
  const double rho = surface.length_scale(x, cell);
  const double d = estimated_distance(surface.jet(x, cell).value, rho);
  return {id, d, d / rho};
}

double mean(double sum, std::size_t count) {
  return count == 0 ? 0 : sum / static_cast<double>(count);
}

void measure_vertices(const geometry::IndexedMesh& mesh, const surface::Surface& surface,
                      std::span<const SurfacePoint> points, Deviations& out) {
  Worst<BadVertex> worst;
  for (std::uint32_t v = 0; v < points.size(); ++v) {
    const BadVertex bad = distance(surface, mesh.positions[v], points[v].cell, v);
    worst.offer(bad.relative, bad);
    out.max_vertex_distance = std::max(out.max_vertex_distance, bad.distance);
    out.max_vertex_relative = std::max(out.max_vertex_relative, bad.relative);
    out.mean_vertex_relative += bad.relative;
  }
  out.mean_vertex_relative = mean(out.mean_vertex_relative, points.size());
  out.farthest_vertices = worst.list();
}

}  // namespace

Deviations measure_deviations(const geometry::IndexedMesh& mesh, const surface::Surface& surface,
                              std::span<const SurfacePoint> points, const Sizing& sizing,
                              const EdgeSides& sides) {
  Deviations out;
  measure_vertices(mesh, surface, points, out);
  Worst<BadTriangle> centroids, large, steep;
  Worst<BadEdge> edges;
  double least_cosine = 1;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& corner = mesh.triangles[t];
    const std::array p{&points[corner[0]], &points[corner[1]], &points[corner[2]]};
    const Point middle = (p[0]->position + p[1]->position + p[2]->position) / 3;
    const BadVertex off = distance(surface, middle, surface.locate(middle, p[0]->cell), t);
    centroids.offer(off.relative, {t, off.relative});
    out.max_centroid_distance = std::max(out.max_centroid_distance, off.distance);
    out.max_centroid_relative = std::max(out.max_centroid_relative, off.relative);
    out.mean_centroid_relative += off.relative;

    const TriangleBounds shape = triangle_bounds(p[0]->position, p[1]->position, p[2]->position);
    const double rho = min_length_scale(p);
    const double u = sizing.triangle_ratio(shape.circumradius, rho);
    large.offer(u, {t, u});

    double cosine = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      cosine = std::min(cosine, p[k]->normal.dot(shape.normal));
      const std::uint32_t a = corner[k], b = corner[(k + 1) % 3];
      if (!sides.is_measured(a, b)) continue;
      const double l = sizing.edge_ratio(*p[k], *p[(k + 1) % 3]);
      edges.offer(-l, {std::min(a, b), std::max(a, b), l});
    }
    cosine = std::isfinite(shape.circumradius) ? std::clamp(cosine, -1.0, 1.0) : -1;
    least_cosine = std::min(least_cosine, cosine);
    steep.offer(-cosine, {t, cosine});
  }
  out.mean_centroid_relative = mean(out.mean_centroid_relative, mesh.triangles.size());
  out.max_normal_deg = std::acos(least_cosine) * 180 / M_PI;
  out.farthest_centroids = centroids.list();
  out.largest_triangles = large.list();
  out.shortest_edges = edges.list();
  out.steepest_triangles = steep.list();
  for (BadTriangle& bad : out.steepest_triangles) bad.value = std::acos(bad.value) * 180 / M_PI;
  return out;
}

}  // namespace morskin::certify
