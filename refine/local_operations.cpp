#include "refine/local_operations.h"

#include <algorithm>
#include <utility>

#include "geometry/sort_unique.h"

namespace morskin::refine {

namespace {

/// Of two balls the deeper entered.
Depth deeper(const Depth& a, const Depth& b) {
  return {std::max(a.min, b.min), std::max(a.max, b.max)};
}

}  // namespace

void Work::append(const Work& other) {
  to_flip.insert(to_flip.end(), other.to_flip.begin(), other.to_flip.end());
  too_short.insert(too_short.end(), other.too_short.begin(), other.too_short.end());
  big.insert(big.end(), other.big.begin(), other.big.end());
}

LocalOperations::LocalOperations(const surface::Surface& surface, const Sizing& sizing, Mesh& mesh,
                                 Work work, const Subdomain& subdomain,
                                 std::vector<SurfaceMesh::FreeSlots> slots)
    : surface_(surface),
      sizing_(sizing),
      mesh_(mesh),
      work_(std::move(work)),
      subdomain_(subdomain),
      free_slots_(std::move(slots)) {}

void LocalOperations::absorb(const LocalOperations& other) {
  work_.append(other.work_);
  work_.append(other.deferred_);
  counts_.flip += other.counts_.flip;
  counts_.contract += other.counts_.contract;
  counts_.insert += other.counts_.insert;
  steps_ += other.steps_;
  free_slots_.insert(free_slots_.end(), other.free_slots_.begin(), other.free_slots_.end());
}

double LocalOperations::max_residual(const surface::Corners& p) const {
  return surface_.residual_bound(max_length_scale(p));
}

LazySurfaceBall LocalOperations::ball(VertexId a, VertexId b, VertexId c) const {
  return {surface_,
          {&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)},
          circumcircle(mesh_.position(a), mesh_.position(b), mesh_.position(c))};
}

/// Whether a triangle breaks [U], or is so coarse that the certificate could not prove it.
bool LocalOperations::is_big(const surface::Corners& p) const {
  return sizing_.triangle_ratio(circumcircle(p).radius, min_length_scale(p)) >= 1 ||
         !expects_tube(surface_, sizing_, p);
}

bool LocalOperations::is_big(VertexId a, VertexId b, VertexId c) const {
  return is_big({&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)});
}

/// Finds whether a triangle breaks [L] or [U].
void LocalOperations::inspect(TriangleId t, Work& found) const {
  const auto [a, b, c] = mesh_.surface.corners(t);
  const std::array p{&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
  if (is_big(p)) found.big.push_back(t);
  for (std::uint32_t k = 0; k < 3; ++k) {
    if (sizing_.is_too_short(*p[k], *p[k == 2 ? 0 : k + 1])) {
      found.too_short.push_back(SurfaceMesh::half_edge(t, k));
    }
  }
}

/// Inspects a triangle that changed, and those of its edges not known to be Delaunay.
void LocalOperations::inspect_again(TriangleId t, std::initializer_list<HalfEdgeId> edges) {
  inspect(t, work_);
  work_.to_flip.insert(work_.to_flip.end(), edges);
}

/// Counts a flip and inspects both triangles.
void LocalOperations::note_flip(HalfEdgeId h) {
  ++counts_.flip;
  if (journal_ != nullptr) journal_->note_flip(h);
  for (const HalfEdgeId side : {h, mesh_.surface.twin(h)}) {
    inspect_again(SurfaceMesh::triangle(side),
                  {SurfaceMesh::next(side), SurfaceMesh::previous(side)});
  }
}

// [excerpt: flip]
/// Flips the edge if a far corner lies in the surface ball beyond it, and the two balls after the
/// flip are less deeply entered. Two angles mostly tell that none lies there; else bounds decide
/// where they can. Where they cannot the balls are found to rounding, so that all answers together
/// describe one restricted Voronoi diagram: where they contradict each other flips go in circles.
/// That they end otherwise is not proved; flip_where_needed() counts them.
bool LocalOperations::flip_if_better(HalfEdgeId h) {
  const SurfaceMesh& connectivity = mesh_.surface;
  const HalfEdgeId g = connectivity.twin(h);
  const VertexId a = connectivity.origin(h), b = connectivity.origin(g);
  const VertexId c = connectivity.apex(h), d = connectivity.apex(g);
  const std::array here{&mesh_.at(a), &mesh_.at(b), &mesh_.at(c)};
  const SurfacePoint& beyond = mesh_.at(d);
  const double residual =
      std::max(max_residual(here), surface_.residual_bound(beyond.length_scale));
  if (is_certainly_delaunay(here, beyond, residual)) return false;
  const Point &at_a = mesh_.position(a), &at_b = mesh_.position(b);
  const Point &at_c = mesh_.position(c), &at_d = mesh_.position(d);
  LazySurfaceBall left = ball(a, b, c), right = ball(b, a, d);
  const Depth now = deeper(left.intrusion(at_d), right.intrusion(at_c));
  if (now.max <= 0) return false;
  if (!subdomain_.contains(connectivity, SurfaceMesh::triangle(h)) ||
      !subdomain_.contains(connectivity, SurfaceMesh::triangle(g))) {
    defer(h);
    return false;
  }
  if (!can_flip(connectivity, points(), h)) return false;
  LazySurfaceBall upper = ball(a, d, c), lower = ball(b, c, d);
  const Depth then = deeper(upper.depth(at_b), lower.depth(at_a));
  if (then.min >= now.max) return false;
  if (then.max >= now.min) {
    const Depth exactly_now = deeper(left.exact_depth(at_d), right.exact_depth(at_c));
    const Depth exactly_then = deeper(upper.exact_depth(at_b), lower.exact_depth(at_a));
    if (exactly_then.min >= exactly_now.min) return false;
  }
  if (keeps_sizes_ && (is_big(a, d, c) || is_big(b, c, d))) return false;
  mesh_.surface.flip(h);
  note_flip(h);
  return true;
}
// [/excerpt]

/// Defers a flip to the subdomain that contains both triangles, and gives up their corners, so that
/// no insertion precedes it there.
void LocalOperations::defer(HalfEdgeId h) {
  deferred_.to_flip.push_back(h);
  for (const HalfEdgeId side : {h, mesh_.surface.twin(h)}) {
    for (const VertexId v : mesh_.surface.corners(SurfaceMesh::triangle(side))) {
      subdomain_.give_up(v);
    }
  }
}

void LocalOperations::flip_where_needed() {
  while (!work_.to_flip.empty() && counts_.flip < 1000 + 50 * mesh_.surface.triangle_count()) {
    const HalfEdgeId h = work_.to_flip.back();
    work_.to_flip.pop_back();
    if (mesh_.surface.is_removed(SurfaceMesh::triangle(h))) continue;
    flip_if_better(h);
  }
  work_.to_flip.clear();
}

bool LocalOperations::is_short(HalfEdgeId h) const {
  return sizing_.is_too_short(mesh_.at(mesh_.surface.origin(h)), mesh_.at(mesh_.surface.target(h)));
}

void LocalOperations::contract_short_edges() {
  for (std::size_t done = counts_.contract + 1; counts_.contract != done;) {
    done = counts_.contract;
    std::vector<HalfEdgeId> batch = std::exchange(work_.too_short, {});
    geometry::sort_unique(batch);
    for (const HalfEdgeId h : batch) {
      if (mesh_.surface.is_removed(SurfaceMesh::triangle(h)) || !is_short(h)) continue;
      if (!contract(h)) work_.too_short.push_back(h);
    }
  }
}

bool LocalOperations::contract(HalfEdgeId h) {
  const bool is_removed =
      contract_edge(mesh_.surface, points(), h, [&](VertexId v) { return remove(v); });
  flip_where_needed();
  counts_.contract += is_removed;
  return is_removed;
}

bool LocalOperations::remove(VertexId v) {
  const SurfacePoint point = mesh_.at(v);
  const auto slots =
      removal_.remove(mesh_.surface, points(), v, [&](HalfEdgeId h) { note_flip(h); });
  if (!slots) return false;
  free_slots_.push_back(*slots);
  const TriangleId left = removal_.triangle_left();
  if (journal_ != nullptr) journal_->note_removal(v, point, left);
  inspect_again(left, {SurfaceMesh::half_edge(left, 0), SurfaceMesh::half_edge(left, 1),
                       SurfaceMesh::half_edge(left, 2)});
  return true;
}

void LocalOperations::report_progress(std::size_t left) {
  constexpr std::size_t steps_between_reports = 4096;
  if (!run_ || ++steps_ % steps_between_reports != 0) return;
  run_->report(static_cast<double>(steps_) / static_cast<double>(steps_ + left));
}

void LocalOperations::insert_into_big_triangles(std::size_t max_insertions) {
  std::vector<TriangleId> refused;
  while (!work_.big.empty() && counts_.insert < max_insertions) {
    const TriangleId t = work_.big.back();
    work_.big.pop_back();
    report_progress(work_.big.size());
    if (!mesh_.surface.is_removed(t) && !insert(t)) refused.push_back(t);
  }
  geometry::sort_unique(refused);
  work_.big.insert(work_.big.end(), refused.begin(), refused.end());
}

/// Breaks a triangle that is too big with the centre of its surface ball; true when the triangle is
/// small enough, or a vertex went in.
bool LocalOperations::insert(TriangleId t) {
  const SurfaceMesh& connectivity = mesh_.surface;
  const auto [a, b, c] = connectivity.corners(t);
  if (!is_big(a, b, c)) return true;
  if (!subdomain_.is_whole() && free_slots_.empty()) return false;
  const auto is_far_enough = [&](const Insertion& where) {
    const auto corners = connectivity.corners(where.under);
    return std::ranges::none_of(
        corners, [&](VertexId v) { return sizing_.is_too_short(mesh_.at(v), where.point); });
  };
  if (!insert_ball_centre(t, is_far_enough)) return false;
  ++counts_.insert;
  flip_where_needed();
  return true;
}

void LocalOperations::insert(const Insertion& where) {
  if (free_slots_.empty()) free_slots_.push_back(mesh_.surface.add_free_slots());
  const SurfaceMesh::FreeSlots slots = free_slots_.back();
  free_slots_.pop_back();
  mesh_.points[slots.vertex] = where.point;
  mesh_.surface.split(where.under, slots);
  if (journal_ != nullptr) journal_->note_insertion(slots.vertex);
  for (const TriangleId changed : {where.under, slots.second, slots.third}) {
    inspect_again(changed, {SurfaceMesh::half_edge(changed, 0)});
  }
}

}  // namespace morskin::refine
