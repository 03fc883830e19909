#include "front/coverage.h"

#include <algorithm>
#include <cmath>

namespace morskin::front {

namespace {

/// Vertices a patch takes where each has the area that it has when they stand 0.85 disk radii
/// apart, which is denser than any sweep lays them, and twice as many, with an allowance for those
/// at the patch's border.
/// @param area   of the patch, in units of the length scale's square
/// @param share  radius of the disk over the length scale
double max_vertices(double area, double share) {
  constexpr double min_spacing = 0.85, border = 100;
  const double spacing = min_spacing * share;
  return 2 * area / (std::sqrt(3.0) / 2 * spacing * spacing) + border;
}

constexpr double sphere_area = 4 * M_PI;

}  // namespace

void PatchCounts::add(const PatchCounts& other) {
  for (std::size_t p = 0; p < pages_.size(); ++p) {
    const std::vector<std::uint32_t>& page = other.pages_[p];
    if (pages_[p].empty()) {
      pages_[p] = page;
      continue;
    }
    for (std::size_t i = 0; i < page.size(); ++i) pages_[p][i] += page[i];
  }
}

Coverage::Coverage(const surface::Surface& surface, const TangentDisk& disk)
    : surface_(surface),
      disk_(disk),
      max_on_sphere_(max_vertices(sphere_area, disk.share())),
      vertices_(surface.cell_count()) {}

void Coverage::follow(const FrontChange& change) {
  if (change.kind != FrontChange::Kind::NewVertex) return;
  const VertexId added = change.front[change.opened.front()].origin;
  is_overlapping_ |= is_covered_twice(change.front.mesh().at(added));
}

/// Whether the patch of a new vertex has more of them than fit. No patch is allowed fewer than a
/// sphere with triangles of full size, and few have as many: most need no closer inspection.
bool Coverage::is_covered_twice(const SurfacePoint& x) {
  largest_length_scale_ = std::max(largest_length_scale_, x.length_scale);
  if (x.cell.index() >= surface_.cell_count() || ++vertices_[x.cell] <= max_on_sphere_) {
    return false;
  }
  const auto [area, largest] = surface_.extent(x.cell, largest_length_scale_);
  return vertices_[x.cell] > max_vertices(area, disk_.radius(largest) / largest);
}

void Coverage::absorb(const Coverage& other) {
  vertices_.add(other.vertices_);
  largest_length_scale_ = std::max(largest_length_scale_, other.largest_length_scale_);
  is_overlapping_ |= other.is_overlapping_;
}

}  // namespace morskin::front
