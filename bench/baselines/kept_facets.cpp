// The part of KeptDelaunay that compares it with a mesh.

#include <algorithm>
#include <cmath>
#include <limits>

#include "bench/baselines/kept_delaunay.h"
#include "certify/triangle_geometry.h"
#include "refine/circumcentre.h"
#include "skin/line_crossings.h"
#include "surface/bounding_ball.h"

namespace morskin::baselines {

using geometry::Point;
using geometry::Triangulator;
using geometry::Vector;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// How far a facet's dual edge, between the circumcentres on its two sides, ends from the skin,
/// over the facet's circumradius: 0 if it crosses; infinity if it does not within a radius of its
/// ends.
double miss(const Triangulator& delaunay, Triangulator::Facet f, const skin::SkinSurface& skin,
            const surface::BoundingBall& body, geometry::CellId near) {
  constexpr std::array<std::array<std::size_t, 3>, 4> outward{
      {{1, 3, 2}, {0, 2, 3}, {0, 3, 1}, {0, 1, 2}}};
  const auto tetrahedra = delaunay.tetrahedra();
  if (delaunay.is_ghost(tetrahedra[Triangulator::tetrahedron_of(f)])) {
    f = tetrahedra[Triangulator::tetrahedron_of(f)].neighbours[Triangulator::index_of(f)];
  }
  const Triangulator::Tetrahedron& inner = tetrahedra[Triangulator::tetrahedron_of(f)];
  const Triangulator::Tetrahedron& outer =
      tetrahedra[Triangulator::tetrahedron_of(inner.neighbours[Triangulator::index_of(f)])];
  const auto corner = [&](const Triangulator::Tetrahedron& t, std::size_t k) -> const Point& {
    return delaunay.point(t.corners[k]).position;
  };
  const auto& places = outward[Triangulator::index_of(f)];
  const certify::Circumcircle circle = certify::circumcircle(
      corner(inner, places[0]), corner(inner, places[1]), corner(inner, places[2]));
  const Vector normal = circle.doubled_area.normalized();
  const auto height = [&](const Triangulator::Tetrahedron& t) {
    const Point centre =
        refine::circumcentre({&corner(t, 0), &corner(t, 1), &corner(t, 2), &corner(t, 3)});
    return normal.dot(centre - circle.centre);
  };
  // Cut off where the edge leaves the ball that contains the body.
  const auto chord = body.chord(circle.centre, normal);
  if (!chord) return infinity;
  const double low = std::max(chord->low, height(inner));
  const double high = delaunay.is_ghost(outer) ? chord->high : std::min(chord->high, height(outer));
  // Ends on two sides tell it, also where the way through the cells is lost between tied ones.
  const auto is_outside = [&](double at) {
    return skin.value(circle.centre + at * normal, near) > 0;
  };
  if (low < high && is_outside(low) != is_outside(high)) return 0;
  const Point p = circle.centre + (low - circle.radius) * normal;
  const double length = high - low + 2 * circle.radius;
  if (!(length > 0)) return infinity;
  double least = infinity;
  for (const surface::LineCrossing& crossing :
       skin::line_crossings(skin, p, p + length * normal, near).all) {
    const double at = low - circle.radius + crossing.at * length;
    least = std::min(least, std::max({low - at, at - high, 0.0}) / circle.radius);
  }
  return least;
}

}  // namespace

/// A facet with three corners, found among the tetrahedra at the first.
std::optional<Triangulator::Facet> KeptDelaunay::facet(const std::array<Corner, 3>& corners) {
  const auto tetrahedra = delaunay_->tetrahedra();
  seen_.assign(1, star_[corners[0]]);
  for (std::size_t next = 0; next < seen_.size(); ++next) {
    const Triangulator::Tetrahedron& t = tetrahedra[seen_[next]];
    const auto place = [&](Corner c) {
      return static_cast<std::uint32_t>(std::ranges::find(t.corners, c) - t.corners.begin());
    };
    const std::uint32_t a = place(corners[0]), b = place(corners[1]), c = place(corners[2]);
    if (b < 4 && c < 4) return seen_[next] << 2 | (6 - a - b - c);  // the places' sum is 6
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t there = Triangulator::tetrahedron_of(t.neighbours[k]);
      if (k != a && std::ranges::find(seen_, there) == seen_.end()) seen_.push_back(there);
    }
  }
  return std::nullopt;
}

void KeptDelaunay::compare(const surface::Mesh& mesh, const skin::SkinSurface& skin) {
  const surface::BoundingBall body = skin.bounding_ball();
  for (const std::array<std::uint32_t, 3>& triangle : mesh.surface.triangle_list()) {
    ++counts_.facets;
    std::array<Corner, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      corners[k] = triangle[k] < samples_.size() ? samples_[triangle[k]].corner : nobody;
    }
    std::optional<Triangulator::Facet> found;
    if (delaunay_ && std::ranges::find(corners, nobody) == corners.end()) found = facet(corners);
    if (!found) {
      ++counts_.facets_missing;
    } else {
      const double missed = miss(*delaunay_, *found, skin, body, mesh.points[triangle[0]].cell);
      counts_.facets_not_crossed += missed > 0;
      counts_.worst_miss = std::max(counts_.worst_miss, missed);
    }
  }
}

}  // namespace morskin::baselines
