#include "bench/baselines/growth.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <utility>

#include "geometry/error.h"

namespace morskin::baselines {

namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A vertex this much deeper than the rim of a quick surface ball, in shares of the squared radius,
/// has the edge tried for a flip.
constexpr double suspect_intrusion = 0.01;

/// Inspections are put at ticks of a clock, 16 to 64 of them in the time in which the squared
/// length scale could grow or fall by its half; so neighbours are inspected together, and a vertex
/// is moved once for all its triangles.
double tick(double length_scale) { return std::exp2(2 * std::floor(std::log2(length_scale)) - 4); }

/// Twice as many vertices as [L] allows on a whole sphere for each metamorphosis. Growth that ended
/// well had a fifth of that at most; one that has folded its mesh inserts without end.
double max_vertices(std::size_t metamorphoses, const GrowthOptions& options) {
  const double shortest = options.slack.min_L * 2 * options.sizing.C / options.sizing.Q;
  const double on_sphere = 4 * std::numbers::pi / (std::sqrt(0.75) * shortest * shortest);
  return 2 * on_sphere * static_cast<double>(metamorphoses);
}

}  // namespace

Growth::Growth(const SkinSurface& skin, const GrowthOptions& options)
    : skin_(skin),
      options_(options),
      mesh_(skin, options.sizing),
      min_step_(tick(min_half_width(skin))),
      metamorphoses_(find_metamorphoses(skin, options.end, longest_edge(options.sizing))),
      metamorphosis_at_(skin.complex().size(), geometry::no_index),
      next_inspection_(mesh_.surface(), never),
      is_seen_(mesh_.surface(), 0) {
  for (std::uint32_t i = 0; i < metamorphoses_.size(); ++i) {
    for (const CellId cell : metamorphoses_[i].cells) metamorphosis_at_[cell] = i;
  }
}

void Growth::run(const geometry::Run& run) {
  std::uint32_t event = 0;
  std::size_t shown = 0;
  for (;;) {
    const double event_time = event < metamorphoses_.size() ? metamorphoses_[event].time : never;
    const double show_time =
        shown < options_.snapshot_times.size() ? options_.snapshot_times[shown] : never;
    const double inspection_time = queue_.next_time();
    if (std::min({event_time, show_time, inspection_time}) >= options_.end) break;
    if (event_time <= std::min(show_time, inspection_time)) {
      undergo(metamorphoses_[event], event);
      ++event;
      // The topology is wrong for good, and there may be a hole, on which nothing here can go on.
      if (counts_.failed > 0) break;
      // When most of the memory holds what is gone.
      if (2 * mesh_.dead_count() > mesh_.surface().vertex_count()) compact();
      run.report(event / static_cast<double>(metamorphoses_.size()));
    } else if (show_time <= inspection_time) {
      show(show_time);
      ++shown;
    } else {
      const InspectionQueue::Entry next = queue_.pop();
      if (next_inspection_[next.triangle] != next.time) continue;
      inspect(next.triangle, next.time);
      mend_changed(next.time);
      require_sane_size();
    }
  }
  counts_.operations = mesh_.counts;
  for (; shown < options_.snapshot_times.size(); ++shown) show(options_.end);
}

namespace {

[[noreturn]] void run_away(const std::string& where) {
  throw geometry::LimitReached("the growing mesh has run away, to " + where +
                               ": the skin passes a state that doubles do not resolve; "
                               "use --method sweep or static");
}

/// Where the skin passed a degenerate state a vertex's path may have led nowhere.
void require_finite(const surface::Mesh& mesh) {
  for (const surface::SurfacePoint& p : mesh.points) {
    if (!p.position.allFinite()) run_away("a vertex that is nowhere");
  }
}

}  // namespace

void Growth::require_sane_size() const {
  const std::size_t vertices = mesh_.surface().vertex_count() - mesh_.dead_count();
  if (static_cast<double>(vertices) <= max_vertices(metamorphoses_.size(), options_)) return;
  run_away(std::to_string(vertices) + " vertices");
}

surface::Mesh Growth::mesh() {
  mesh_.set_time(options_.end);
  surface::Mesh mesh = mesh_.snapshot();
  require_finite(mesh);
  return mesh;
}

void Growth::show(double time) {
  if (!options_.snapshot) return;
  mesh_.set_time(time);
  options_.snapshot(time, mesh_.snapshot());
}

void Growth::schedule(TriangleId t, double time) {
  next_inspection_[t] = time < options_.end ? time : never;
  if (time < options_.end) queue_.push(time, t);
}

/// Schedules the next inspection at the last tick before `time`, or at the next tick from now.
void Growth::schedule(TriangleId t, double time, double length_scale) {
  const double step = std::max(tick(length_scale), min_step_);
  schedule(t, std::max(std::floor(time / step), std::floor(mesh_.time() / step) + 1) * step);
}

/// Drops removed elements, and void entries of the queue.
void Growth::compact() {
  mesh_.compact();
  queue_.clear();
  for (std::size_t i = 0; i < next_inspection_.size(); ++i) {
    const TriangleId t{i};
    if (next_inspection_[t] < never) queue_.push(next_inspection_[t], t);
  }
}

/// Inspects what has changed until nothing changes any more.
void Growth::mend_changed(double time) {
  std::size_t left = 1000 + 30 * mesh_.changed_count();  // should it go round
  while (const auto t = mesh_.take_changed()) {
    if (mesh_.surface().is_removed(*t)) continue;
    if (left == 0) {
      const double rho = mesh_.at(mesh_.surface().corners(*t)[0]).length_scale;
      schedule(*t, time + std::max(min_wait * rho * rho, min_step_));
      continue;
    }
    --left;
    inspect(*t, time);
  }
}

/// Whether a corner lies where the mesh is to be replaced within the jump's time; then nothing is
/// done about the triangle any more.
bool Growth::is_waiting_for_metamorphosis(const std::array<VertexId, 3>& corners, double time,
                                          double& until) {
  for (const VertexId v : corners) {
    const SurfacePoint& p = mesh_.at(v);
    const std::uint32_t number = metamorphosis_at_[p.cell];
    if (number == geometry::no_index) continue;
    const Metamorphosis& m = metamorphoses_[number];
    if (m.kind == Kind::Birth || time <= m.before()) continue;
    if ((p.position - skin_.patch(m.cell).centre).norm() > hot_radius * m.half_width) continue;
    until = m.time;
    return true;
  }
  return false;
}

/// Inspects a triangle: flips its edges, contracts a short one, breaks it if it is big, or
/// schedules its next inspection.
void Growth::inspect(TriangleId t, double time) {
  SurfaceMesh& surface = mesh_.surface();
  if (surface.is_removed(t)) return;
  ++counts_.inspections;
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
  const certify::Circumcircle circle =
      certify::circumcircle(p[0].position, p[1].position, p[2].position);
  const certify::SurfaceBall ball = certify::quick_surface_ball(mesh_.level(), p[0], circle);
  for (std::uint32_t k = 0; k < 3; ++k) {
    const HalfEdgeId h = SurfaceMesh::half_edge(t, k);
    const VertexId beyond = surface.apex(surface.twin(h));
    if (ball.intrusion(mesh_.position(beyond)) > suspect_intrusion * ball.squared_radius &&
        mesh_.flip_if_better(h)) {
      return;
    }
  }
  Ratios ratios;
  for (std::uint32_t k = 0; k < 3; ++k) {
    ratios.L[k] = options_.sizing.edge_ratio(p[k], p[(k + 1) % 3]);
    if (ratios.L[k] < options_.slack.contract_below &&
        mesh_.contract(SurfaceMesh::half_edge(t, k))) {
      return;
    }
  }
  const double rho = surface::min_length_scale({&p[0], &p[1], &p[2]});
  ratios.U = options_.sizing.triangle_ratio(circle.radius, rho);
  if (ratios.U > options_.slack.insert_above && mesh_.insert(t, options_.slack.contract_below)) {
    return;
  }
  schedule(t, next_inspection(corners, ratios), rho);
}

/// When the triangle may next break the bounds of Slack (mathematics: papers/5-dynamic.md).
double Growth::next_inspection(const std::array<VertexId, 3>& corners, const Ratios& ratios) {
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
  const auto corner = [&](std::size_t k) {
    return MovingCorner{*p[k], skin_.patch(p[k]->cell).half_weight + now / 2,
                        mesh_.path(corners[k]).leaves()};
  };
  return next_inspection_time({corner(0), corner(1), corner(2)}, ratios, options_.slack, now);
}

// Metamorphoses.

void Growth::undergo(const Metamorphosis& m, std::uint32_t number) {
  if (options_.observer) options_.observer(m, mesh_.surface(), false);
  bool is_done = false;
  if (m.kind == Kind::Birth) {
    mesh_.set_time(m.after());
    const Frame frame(skin_.patch(m.cell));
    const std::size_t before = mesh_.surface().triangle_count();
    is_done =
        add_triangles(mesh_.surface(), sphere_template(mesh_, frame, m.cell, m.half_width), {});
    for (std::size_t t = before; t < mesh_.surface().triangle_count(); ++t) {
      mesh_.add_changed(TriangleId{t});
    }
  } else {
    is_done = replace(m, number);
  }
  for (const CellId cell : m.cells) metamorphosis_at_[cell] = geometry::no_index;
  ++(is_done ? counts_.metamorphoses[static_cast<std::size_t>(m.kind)] : counts_.failed);
  mend_changed(m.after());
  if (options_.observer) options_.observer(m, mesh_.surface(), true);
}

bool Growth::replace(const Metamorphosis& m, std::uint32_t number) {
  // A larger hot sphere may have simpler edges.
  for (const double share : {1.0, 1.05, 1.1, 1.15, 0.95}) {
    HotRegion region = hot_region(m, number, share * hot_radius * m.half_width);
    const std::size_t loops = m.kind == Kind::Void ? 0 : 2;
    if (region.vertices.empty() || !find_loops(region) || region.loops.size() != loops) continue;
    return refill(m, region);
  }
  return false;
}

/// The vertices within `radius` of the critical point as the jump begins, and what hangs on them.
Growth::HotRegion Growth::hot_region(const Metamorphosis& m, std::uint32_t number, double radius) {
  const SurfaceMesh& surface = mesh_.surface();
  mesh_.set_time(m.before());
  const Point& centre = skin_.patch(m.cell).centre;
  HotRegion region;
  std::vector<VertexId> seen;
  const auto visit = [&](VertexId v) {
    if (std::exchange(is_seen_[v], 1) != 0) return;
    seen.push_back(v);
    if (!surface.outgoing(v)) return;
    if ((mesh_.position(v) - centre).norm() < radius) region.vertices.push_back(v);
  };
  for (std::size_t i = 0; i < surface.vertex_count(); ++i) {
    const VertexId v{i};
    if (surface.outgoing(v) && metamorphosis_at_[mesh_.path(v).cell()] == number) visit(v);
  }
  // And neighbours that have not been moved since before they came in.
  for (std::size_t i = 0; i < region.vertices.size(); ++i) {
    surface.for_each_outgoing(region.vertices[i], [&](HalfEdgeId h) { visit(surface.target(h)); });
  }
  for (const VertexId v : seen) is_seen_[v] = 0;
  return region;
}

}  // namespace morskin::baselines
