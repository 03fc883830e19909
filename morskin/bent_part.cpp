#include "morskin/bent_part.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "morskin/pipeline.h"

namespace morskin {

namespace {

/// Points of the skin over a triangle, on a grid that cuts each edge into `cuts`.
class FineGrid {
 public:
  static constexpr std::size_t cuts = 4;

  FineGrid(const skin::SkinSurface& skin, const std::array<geometry::Point, 3>& corners,
           geometry::CellId cell) {
    const auto& [a, b, c] = corners;
    for (std::size_t i = 0; i <= cuts; ++i) {
      for (std::size_t j = 0; i + j <= cuts; ++j) {
        const double to_b = static_cast<double>(i) / cuts, to_c = static_cast<double>(j) / cuts;
        const geometry::Point x = a + to_b * (b - a) + to_c * (c - a);
        points_[i][j] = skin.project(x, cell).value_or(skin.at(x, cell));
      }
    }
  }
  /// Calls visit(area, length scale) with each of the small triangles.
  template <class Visit>
  void for_each_triangle(const Visit& visit) const {
    const auto take = [&](const SurfacePoint& p, const SurfacePoint& q, const SurfacePoint& r) {
      const geometry::Vector normal = (q.position - p.position).cross(r.position - p.position);
      visit(normal.norm() / 2, (p.length_scale + q.length_scale + r.length_scale) / 3);
    };
    for (std::size_t i = 0; i < cuts; ++i) {
      for (std::size_t j = 0; i + j < cuts; ++j) {
        take(points_[i][j], points_[i + 1][j], points_[i][j + 1]);
        if (i + j + 2 > cuts) continue;
        take(points_[i + 1][j], points_[i + 1][j + 1], points_[i][j + 1]);
      }
    }
  }

 private:
  using SurfacePoint = surface::SurfacePoint;
  std::array<std::array<SurfacePoint, cuts + 1>, cuts + 1> points_;
};

/// Whether all length scales over a triangle are at least so large. The length scale is
/// 1-Lipschitz. A point over the triangle is nearer to a corner than 3/4 of its longest side: in
/// its plane than 1 / sqrt 3 of it, and with R up to 0.9 of the radius of a ball that it lies on
/// than 0.68.
bool is_surely_above(const skin::SkinSurface& skin, const std::array<geometry::Point, 3>& corners,
                     const std::array<geometry::CellId, 3>& cells, double limit) {
  double least = std::numeric_limits<double>::infinity(), longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    least = std::min(least, skin.length_scale(corners[k], cells[k]));
    longest = std::max(longest, (corners[(k + 1) % 3] - corners[k]).norm());
  }
  return least - 0.75 * longest >= limit;
}

}  // namespace

BentPart bent_part(const skin::SkinSurface& skin, const MeshResult& result) {
  const double limit = result.sizing.largest_length_scale;
  const double largest_area = 0.75 * std::sqrt(3) * max_provable_share * max_provable_share;
  BentPart part;
  double whole = 0, bent = 0;
  for (const auto& [a, b, c] : result.mesh.triangles) {
    const auto& at = result.mesh.positions;
    const std::array corners{at[a], at[b], at[c]};
    const double flat = (corners[1] - corners[0]).cross(corners[2] - corners[0]).norm() / 2;
    whole += flat;
    const std::array cells{result.cells[a], result.cells[b], result.cells[c]};
    if (is_surely_above(skin, corners, cells, limit)) continue;
    double area = 0, bent_here = 0;
    FineGrid(skin, corners, cells[0]).for_each_triangle([&](double small_area, double scale) {
      area += small_area;
      if (scale >= limit) return;
      bent_here += small_area;
      part.forced_triangles += small_area / (largest_area * scale * scale);
    });
    bent += flat * bent_here / area;
    part.triangles += bent_here / area;
  }
  part.area_share = bent / whole;
  return part;
}

}  // namespace morskin
