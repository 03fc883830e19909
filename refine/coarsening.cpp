#include "refine/coarsening.h"

#include <algorithm>
#include <array>
#include <cstdint>

namespace morskin::refine {

namespace {

/// Shares of [U] up to which triangles may grow when a vertex too near another is removed. The
/// cheapest removals come first: each decides which of its close neighbours may stay.
constexpr std::array crowded_limits{0.6, 0.8, 1.0};

/// A polygon with more corners has hardly ever good ears only.
constexpr std::size_t max_neighbours = 12;

}  // namespace

Coarsening::Coarsening(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                       double limit)
    : surface_(surface), sizing_(sizing), limit_(limit), mesh_(mesh), is_tried_(mesh.surface, 0) {}

std::size_t Coarsening::run(const Subdomain& subdomain) {
  const std::size_t before = removed_;
  const std::vector<VertexId> all = candidates(subdomain);
  std::vector<VertexId> crowded = all;
  for (const double limit : crowded_limits) {
    std::size_t left = 0;
    for (std::size_t i = 0; i < crowded.size(); ++i) {
      prefetch_next(crowded, i);
      if (is_crowded_after(crowded[i], limit, subdomain)) crowded[left++] = crowded[i];
    }
    crowded.resize(left);
  }
  for (std::size_t i = 0; i < all.size(); ++i) {
    prefetch_next(all, i);
    if (!is_removed(all[i])) remove(all[i], limit_);
  }
  return removed_ - before;
}

/// Asks for vertices that a pass will come to, step by step.
void Coarsening::prefetch_next(const std::vector<VertexId>& pass, std::size_t i) const {
  const std::size_t last = pass.size() - 1;
  const VertexId far = pass[std::min(i + 16, last)], near = pass[std::min(i + 8, last)];
  mesh_.surface.prefetch_outgoing(far);
  geometry::prefetch(&mesh_.at(far));
  mesh_.surface.prefetch_fan(near);
}

/// The new and the waiting vertices that the subdomain contains with their neighbours, sorted by
/// patch: a front visits a large molecule in an order that scatters neighbours in memory.
std::vector<VertexId> Coarsening::candidates(const Subdomain& subdomain) {
  std::vector<std::uint64_t> free;  // cells and vertices, to be sorted by both
  for (std::size_t i = 0; i < mesh_.surface.vertex_count(); ++i) {
    const VertexId v{i};
    if (is_tried_[v] || is_removed(v) || !subdomain.contains_star(mesh_.surface, v)) continue;
    is_tried_[v] = 1;
    free.push_back(std::uint64_t{mesh_.at(v).cell.value} << 32 | v.value);
  }
  std::ranges::sort(free);
  std::vector<VertexId> result;
  result.reserve(free.size());
  for (const std::uint64_t both : free) result.emplace_back(static_cast<std::uint32_t>(both));
  return result;
}

/// Takes out a vertex that has a neighbour nearer than [L] allows, or else such a neighbour.
/// @return whether it stays and may still have one
bool Coarsening::is_crowded_after(VertexId v, double limit, const Subdomain& subdomain) {
  if (is_removed(v)) return false;
  crowd_.clear();
  mesh_.surface.for_each_outgoing(v, [&](HalfEdgeId h) {
    const VertexId x = mesh_.surface.target(h);
    if (sizing_.is_too_short(mesh_.at(v), mesh_.at(x))) crowd_.push_back(x);
  });
  if (crowd_.empty() || remove(v, limit)) return false;
  for (const VertexId x : crowd_) {
    if (subdomain.contains_star(mesh_.surface, x) && remove(x, limit)) break;
  }
  return true;
}

/// Takes a vertex out if its neighbours can be joined by good triangles.
/// @pre the subdomain contains v and its neighbours.
bool Coarsening::remove(VertexId v, double limit) {
  SurfaceMesh& connectivity = mesh_.surface;
  const auto size = [&](VertexId a, VertexId b, VertexId c) { return ear(a, b, c, limit); };
  const auto is_provable = [&](VertexId a, VertexId b, VertexId c) {
    return can_be_proved(a, b, c);
  };
  if (connectivity.has_degree_above(v, max_neighbours) ||
      !removal_.plan(connectivity, v, size, is_provable)) {
    return false;
  }
  removal_.carry_out(connectivity, [](HalfEdgeId) {});
  ++removed_;
  return true;
}

/// The circumradius over the length scale of a triangle that could cut off the middle corner, if it
/// is a good one.
double Coarsening::ear(VertexId a, VertexId b, VertexId c, double limit) const {
  const SurfacePoint &p = mesh_.at(a), &q = mesh_.at(b), &r = mesh_.at(c);
  const Circumcircle circle = circumcircle(p.position, q.position, r.position);
  const double rho = surface::min_length_scale({&p, &q, &r});
  const bool is_good = sizing_.triangle_ratio(circle.radius, rho) < limit &&
                       is_upright(circle.doubled_area, p, q, r);
  return is_good ? circle.radius / rho : VertexRemoval::never;
}

bool Coarsening::can_be_proved(VertexId a, VertexId b, VertexId c) const {
  return expects_tube(surface_, sizing_, {&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)});
}

}  // namespace morskin::refine
