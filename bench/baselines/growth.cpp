#include "bench/baselines/growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace morskin::baselines {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A vertex this much deeper than the rim of a quick surface ball, in shares of the squared radius,
/// has the edge tried for a flip.
constexpr double suspect_intrusion = 0.01;

/// What could not be mended is looked at again after this share of the squared length scale. The
/// safe times of triangles that keep [L] and [U] are longer (papers/5-dynamic.md).
constexpr double least_wait = 0.02;

}  // namespace

Growth::Growth(const SkinSurface& skin, const GrowthOptions& options)
    : skin_(skin),
      options_(options),
      mesh_(skin, options.sizing),
      metamorphoses_(find_metamorphoses(skin, options.end)),
      is_over_(metamorphoses_.size(), 0) {
  for (const Metamorphosis& m : metamorphoses_) mesh_.watch(m.cells);
}

void Growth::run() {
  std::size_t event = 0, shown = 0;
  for (;;) {
    const double event_time = event < metamorphoses_.size() ? metamorphoses_[event].time : never;
    const double show_time =
        shown < options_.snapshot_times.size() ? options_.snapshot_times[shown] : never;
    const double look_time = queue_.empty() ? never : queue_.top().time;
    if (std::min({event_time, show_time, look_time}) >= options_.end) break;
    if (event_time <= std::min(show_time, look_time)) {
      const auto watch = static_cast<std::uint32_t>(event);
      undergo(metamorphoses_[event++], watch);
      if (options_.progress) {
        options_.progress(static_cast<double>(event) / static_cast<double>(metamorphoses_.size()));
      }
    } else if (show_time <= look_time) {
      show(show_time);
      ++shown;
    } else {
      const Look next = queue_.top();
      queue_.pop();
      if (next_look_[next.triangle.index()] != next.time) continue;
      look(next.triangle, next.time);
      mend_changed(next.time);
    }
  }
  counts_.operations = mesh_.counts;
  for (; shown < options_.snapshot_times.size(); ++shown) show(options_.end);
}

skin::SkinMesh Growth::mesh() {
  mesh_.set_time(options_.end);
  skin::SkinMesh result;
  result.surface = mesh_.surface();
  const auto renamed = result.surface.compact();
  result.points.reserve(result.surface.vertex_count());
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v]) result.points.push_back(mesh_.at(VertexId{v}));
  }
  return result;
}

void Growth::show(double time) {
  if (!options_.snapshot) return;
  mesh_.set_time(time);
  skin::SkinMesh copy;
  copy.surface = mesh_.surface();
  const auto renamed = copy.surface.compact();
  for (std::size_t v = 0; v < renamed.size(); ++v) {
    if (renamed[v]) copy.points.push_back(mesh_.at(VertexId{v}));
  }
  options_.snapshot(time, copy);
}

void Growth::schedule(TriangleId t, double time) {
  if (next_look_.size() <= t.index()) next_look_.resize(mesh_.surface().triangle_count(), never);
  next_look_[t.index()] = time < options_.end ? time : never;
  if (time < options_.end) queue_.push({time, t});
}

/// Looks at what has changed until nothing changes any more.
void Growth::mend_changed(double time) {
  std::size_t left = 1000 + 30 * mesh_.changed.size();  // should it go round
  while (!mesh_.changed.empty()) {
    const TriangleId t = mesh_.changed.back();
    mesh_.changed.pop_back();
    if (mesh_.surface().is_removed(t)) continue;
    if (left == 0) {
      const double rho = mesh_.at(mesh_.surface().corners(t)[0]).length_scale;
      schedule(t, time + least_wait * rho * rho);
      continue;
    }
    --left;
    look(t, time);
  }
}

/// Whether a corner lies where the mesh is to be replaced within the jump's time; then nothing is
/// done about the triangle any more.
bool Growth::is_waiting_for_metamorphosis(const std::array<VertexId, 3>& corners, double time,
                                          double& until) {
  for (const VertexId v : corners) {
    const SurfacePoint& p = mesh_.at(v);
    const auto watch = mesh_.watch_of(p.cell);
    if (!watch || is_over_[*watch] != 0) continue;
    const Metamorphosis& m = metamorphoses_[*watch];
    if (m.kind == Kind::Birth || time <= m.before()) continue;
    if ((p.position - skin_.patch(m.cell).centre).norm() > hot_radius * m.half_width) continue;
    until = m.time;
    return true;
  }
  return false;
}

/// Looks at a triangle: flips its edges, contracts a short one, breaks it if it is big, or says
/// when to look again.
void Growth::look(TriangleId t, double time) {
  SurfaceMesh& surface = mesh_.surface();
  if (surface.is_removed(t)) return;
  ++counts_.looks;
  const std::array<VertexId, 3> corners = surface.corners(t);
  for (const VertexId v : corners) time = std::max(time, mesh_.path(v).begins());
  mesh_.set_time(time);
  double until = never;
  if (is_waiting_for_metamorphosis(corners, time, until)) {
    schedule(t, until);
    return;
  }
  const std::array<SurfacePoint, 3> p{mesh_.at(corners[0]), mesh_.at(corners[1]),
                                      mesh_.at(corners[2])};
  const refine::Circumcircle circle =
      refine::circumcircle(p[0].position, p[1].position, p[2].position);
  const refine::SurfaceBall ball = refine::quick_surface_ball(mesh_.level(), p[0], circle);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdgeId h = SurfaceMesh::half_edge(t, k);
    const VertexId beyond = surface.apex(surface.twin(h));
    if (ball.intrusion(mesh_.position(beyond)) > suspect_intrusion * ball.squared_radius &&
        mesh_.flip_if_better(h)) {
      return;
    }
  }
  double ratio_L = never;
  for (std::uint32_t k = 0; k < 3; ++k) {
    const double ratio = options_.sizing.edge_ratio(p[k], p[(k + 1) % 3]);
    ratio_L = std::min(ratio_L, ratio);
    if (ratio < options_.slack.contract_below && mesh_.contract(SurfaceMesh::half_edge(t, k))) {
      return;
    }
  }
  const double rho = std::min({p[0].length_scale, p[1].length_scale, p[2].length_scale});
  const double ratio_U = options_.sizing.triangle_ratio(circle.radius, rho);
  if (ratio_U > options_.slack.insert_above && mesh_.insert(t, options_.slack.contract_below)) {
    return;
  }
  schedule(t, next_look(corners, ratio_L, ratio_U));
}

/// When the triangle may next break the bounds of Slack (mathematics: papers/5-dynamic.md).
double Growth::next_look(const std::array<VertexId, 3>& corners, double ratio_L, double ratio_U) {
  const std::array<const SurfacePoint*, 3> p{&mesh_.at(corners[0]), &mesh_.at(corners[1]),
                                             &mesh_.at(corners[2])};
  const double now = mesh_.time();
  if (p[0]->cell == p[1]->cell && p[0]->cell == p[2]->cell) {
    const int dimension = skin_.complex().dimension(p[0]->cell);
    if (dimension == 0 || dimension == 3) {
      // All three move along rays of one sphere: nothing changes but the size.
      return std::min({mesh_.path(corners[0]).leaves(), mesh_.path(corners[1]).leaves(),
                       mesh_.path(corners[2]).leaves()});
    }
  }
  const double rho = std::min({p[0]->length_scale, p[1]->length_scale, p[2]->length_scale});
  std::array<Vector, 3> side;  // opposite corner k
  for (std::size_t k = 0; k < 3; ++k) {
    side[k] = p[(k + 2) % 3]->position - p[(k + 1) % 3]->position;
  }
  const double area2 = side[0].cross(side[1]).norm();
  // |d ln R / dt| <= S / (4 rho^2), S the sum of |cot A cot B|: 1 unless an angle is obtuse.
  double S = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector &a = side[k], &b = side[(k + 1) % 3], &c = side[(k + 2) % 3];
    S += std::abs(a.dot(b) * a.dot(c));
  }
  S /= area2 * area2;
  const double room_U = std::max(options_.slack.most_U / ratio_U, 1.05);
  const double room_L = std::max(ratio_L / options_.slack.least_L, 1.05);
  const double until_U = 2 * rho * rho * std::log(room_U) / (S + 1);
  const double until_L = 2 * rho * rho * (1 - 1 / room_L);
  // A triangle that is flat, or could not be mended, would be looked at for ever.
  return now + std::max(std::min(until_U, until_L), least_wait * rho * rho);
}

// Metamorphoses.

void Growth::undergo(const Metamorphosis& m, std::uint32_t watch) {
  if (options_.observer) options_.observer(m, mesh_.surface(), false);
  bool is_done = false;
  if (m.kind == Kind::Birth) {
    mesh_.set_time(m.after());
    const Frame frame(skin_.patch(m.cell));
    const std::size_t before = mesh_.surface().triangle_count();
    is_done =
        add_triangles(mesh_.surface(), sphere_template(mesh_, frame, m.cell, m.half_width), {});
    for (std::size_t t = before; t < mesh_.surface().triangle_count(); ++t) {
      mesh_.changed.emplace_back(t);
    }
  } else {
    is_done = replace(m, watch);
  }
  is_over_[watch] = 1;
  ++(is_done ? counts_.metamorphoses[static_cast<std::size_t>(m.kind)] : counts_.failed);
  mend_changed(m.after());
  if (options_.observer) options_.observer(m, mesh_.surface(), true);
}

bool Growth::replace(const Metamorphosis& m, std::uint32_t watch) {
  // A larger hot sphere may have simpler edges.
  for (const double share : {1.0, 1.05, 1.1, 1.15, 0.95}) {
    HotRegion region = hot_region(m, watch, share * hot_radius * m.half_width);
    const std::size_t loops = m.kind == Kind::Void ? 0 : 2;
    if (region.vertices.empty() || !find_loops(region) || region.loops.size() != loops) continue;
    return refill(m, region);
  }
  return false;
}

/// The vertices within `radius` of the critical point as the jump begins, and what hangs on them.
Growth::HotRegion Growth::hot_region(const Metamorphosis& m, std::uint32_t watch, double radius) {
  const SurfaceMesh& surface = mesh_.surface();
  mesh_.set_time(m.before());
  const Point& centre = skin_.patch(m.cell).centre;
  HotRegion region;
  is_seen_.resize(surface.vertex_count(), 0);
  std::vector<VertexId> seen;
  const auto visit = [&](VertexId v) {
    if (std::exchange(is_seen_[v.index()], 1) != 0) return;
    seen.push_back(v);
    if (!surface.outgoing(v)) return;
    if ((mesh_.position(v) - centre).norm() < radius) region.vertices.push_back(v);
  };
  for (const VertexId v : mesh_.visitors(watch)) visit(v);
  // And neighbours that nobody has asked for since before they came in.
  for (std::size_t i = 0; i < region.vertices.size(); ++i) {
    surface.for_each_outgoing(region.vertices[i], [&](HalfEdgeId h) { visit(surface.target(h)); });
  }
  for (const VertexId v : seen) is_seen_[v.index()] = 0;
  return region;
}

}  // namespace morskin::baselines
