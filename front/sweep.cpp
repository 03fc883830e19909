#include "front/sweep.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

namespace morskin::front {

namespace {

/// Nearer than the length scale all skin is one sheet, a graph over the tangent plane: normals
/// differ by less than a right angle. This near they differ by less than asin(0.85) = 58 degrees.
constexpr double largest_view = 0.85;

/// Vertices a patch takes where each has the area that it has when they stand 0.85 disk radii
/// apart, which is denser than any sweep lays them, and twice as many: with more, the front has
/// passed itself unseen.
/// @param area   of the patch, in units of the length scale's square
/// @param share  radius of the disk over the length scale
double most_vertices(double area, double share) {
  const double spacing = 0.85 * share;
  return 2 * area / (std::sqrt(3.0) / 2 * spacing * spacing) + 100;
}

constexpr double sphere_area = 4 * M_PI;

}  // namespace

Operations& Operations::operator+=(const Operations& other) {
  creation += other.creation;
  creep += other.creep;
  wing += other.wing;
  bridge += other.bridge;
  seal += other.seal;
  coarsen += other.coarsen;
  guard_inside_protecting += other.guard_inside_protecting;
  guard_outside_protecting += other.guard_outside_protecting;
  return *this;
}

Sweep::Sweep(const surface::Surface& skin, const morse::Guide& guide, const SweepOptions& options,
             Mesh& mesh, double last)
    : skin_(skin),
      guide_(guide),
      options_(options),
      wing_cosine_(std::cos(spacing_.wing_angle_deg * M_PI / 180)),
      disk_share_(spacing_.disk_share * options.sizing.tangent_disk_share()),
      mesh_(mesh),
      front_(mesh, std::min(spacing_.view * disk_share_, largest_view),
             options.sizing.largest_length_scale),
      near_(mesh, front_),
      marked_(guide.points.size()),
      last_(last),
      laid_(skin.cell_count(), 0),
      most_on_sphere_(most_vertices(sphere_area, disk_share_)) {
  if (options_.coarser) {
    coarsening_.emplace(skin, *options_.coarser, mesh);
    coarsen_at_ = options_.coarsen_after;
  }
}

void Sweep::run() {
  if (guide_.points.empty()) return;
  const auto [lowest, highest] =
      std::minmax_element(guide_.points.begin(), guide_.points.end(),
                          [](const auto& p, const auto& q) { return p.value < q.value; });
  lowest_ = lowest->value;
  highest_ = std::min(highest->value, last_);
  for (std::size_t k = 1; k <= options_.snapshots; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(options_.snapshots);
    options_.snapshot_values.push_back(lowest_ + share * (highest_ - lowest_));
  }
  std::sort(options_.snapshot_values.begin(), options_.snapshot_values.end());
  std::vector<std::uint32_t> minima;
  for (std::uint32_t i = 0; i < guide_.points.size(); ++i) {
    if (guide_.points[i].index == 0 && guide_.points[i].value <= last_) minima.push_back(i);
  }
  std::sort(minima.begin(), minima.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::pair(guide_.points[a].value, a) < std::pair(guide_.points[b].value, b);
  });
  for (const std::uint32_t i : minima) create(guide_.points[i]);
  finish();
  show_up_to(std::numeric_limits<double>::infinity());
}

void Sweep::finish() {
  creep_triangles();
  release_red_marks();
  creep_triangles();
  for (std::size_t c = 0; c < guide_.points.size(); ++c) seal(CriticalId{c});
  creep_triangles();
  // What was refused while the front stood differently may go now.
  for (std::size_t before = 0; !stuck_.empty() && before != triangles_laid();) {
    before = triangles_laid();
    push_current(stuck_);
    creep_triangles();
  }
  if (coarsening_) coarsen();
}

/// Takes out what it can behind the front. So the whole of a fine mesh is never there at once.
void Sweep::coarsen() {
  operations_.coarsen += coarsening_->run(front_.marked_vertices());
  const geometry::SurfaceMesh::Renaming renaming = mesh_.compact();
  front_.rename(renaming);
  coarsening_->rename(renaming);
  const std::size_t count = mesh_.surface.triangle_count();
  coarsen_at_ = count + std::max(options_.coarsen_after, count / 4);
}

void Sweep::join(Sweep& above, unsigned threads) {
  const auto vertices = static_cast<std::uint32_t>(mesh_.surface.vertex_count());
  const auto half_edges = static_cast<std::uint32_t>(3 * mesh_.surface.triangle_count());
  mesh_.append(std::move(above.mesh_), threads);
  const std::uint32_t edges = front_.append(above.front_, vertices, half_edges);
  if (coarsening_) coarsening_->take_over(*above.coarsening_, vertices);
  push_current(beyond_);
  for (const auto* departures : {&above.beyond_, &above.stuck_}) {
    for (const Departure& d : *departures) {
      if (above.is_current(d)) push(FrontEdgeId{d.corner.value + edges});
    }
  }
  for (std::size_t c = 0; c < marked_.size(); ++c) {
    if (guide_.points[c].index == 1) marked_[c].is_done |= above.marked_[c].is_done;
    if (guide_.points[c].index == 2) marked_[c].is_done = false;
  }
  for (std::size_t cell = 0; cell < laid_.size(); ++cell) laid_[cell] += above.laid_[cell];
  largest_laid_ = std::max(largest_laid_, above.largest_laid_);
  is_overlapping_ |= above.is_overlapping_;
  operations_ += above.operations_;
  last_ = std::numeric_limits<double>::infinity();
  finish();
}

// [excerpt: algorithm-1]
// Algorithm 1, with its line numbers.
void Sweep::creep_triangles() {
  while (!queue_.empty() && !is_overlapping_) {  // 1
    const Departure departure = queue_.top();    // 2
    queue_.pop();
    if (mesh_.surface.triangle_count() >= coarsen_at_) coarsen();
    if (!is_current(departure)) continue;
    report(departure);
    if (!may_depart(departure)) {
      beyond_.push_back(departure);
      continue;
    }
    const VertexId t = front_[departure.corner].origin;
    const auto c = guide_.spheres.containing(mesh_.at(t));
    const int index = c && !marked_[c->index()].is_done ? guide_.points[c->index()].index : 0;
    if (index == 1) {  // 3: t falls in the protecting sphere of a saddle point c
      mark_red(*c, departure);
      const auto& sides = marked_[c->index()].sides;
      if (!sides[0].empty() && !sides[1].empty()) bridge(*c);  // 4, 5
    } else if (index == 2) {                                   // 9: ... of a maximum point c
      marked_[c->index()].sides[0].push_back(departure);       // 10: mark with green
      front_.note_maximum(departure.corner);
    } else if (!creep(departure.corner)) {  // 12
      stuck_.push_back(departure);
    }
  }  // 15
}
// [/excerpt]

/// Tells of progress, and of the values that the front has come to.
void Sweep::report(const Departure& departure) {
  constexpr std::size_t steps_between_reports = 4096;
  if (options_.progress && ++steps_ % steps_between_reports == 0) {
    options_.progress(departure.value);
  }
  show_up_to(departure.value);
}

void Sweep::note(Operation operation) const {
  if (options_.operation) options_.operation(operation, mesh_.surface.triangle_count());
}

void Sweep::show_up_to(double value) {
  for (; snapshots_ < options_.snapshot_values.size() &&
         options_.snapshot_values[snapshots_] <= value;
       ++snapshots_) {
    options_.snapshot({guide_.function, options_.snapshot_values[snapshots_], mesh_, front_});
  }
}

/// Gathers what the guard is to see round a departure vertex.
void Sweep::look_round(FrontEdgeId corner) {
  const SurfacePoint& centre = mesh_.at(front_[corner].origin);
  if (options_.guard == Guard::Everywhere || options_.enlarged->containing(centre)) {
    near_.gather(centre);
  } else {
    near_.gather_along(centre, corner, options_.guard == Guard::Adjacent);
  }
}

/// Whether the patch of a new vertex has more of them than fit. No patch is allowed fewer than a
/// sphere with triangles of full size, and few have as many: most are not looked at closely.
bool Sweep::is_covered_twice(const SurfacePoint& x) {
  largest_laid_ = std::max(largest_laid_, x.length_scale);
  if (x.cell.index() >= laid_.size() || ++laid_[x.cell.index()] <= most_on_sphere_) return false;
  const surface::PatchExtent patch = skin_.extent(x.cell, largest_laid_);
  const double largest = patch.max_length_scale;
  const double share = disk_share_ * options_.sizing.scale(largest) / largest;
  return laid_[x.cell.index()] > most_vertices(patch.area, share);
}

Operations Sweep::operations() const {
  Operations operations = operations_;
  operations.vain_inside_protecting = front_.vain_loops(true);
  operations.vain_outside_protecting = front_.vain_loops(false);
  return operations;
}

bool Sweep::is_current(const Departure& d) const {
  return front_[d.corner].is_open && front_[d.corner].generation == d.generation;
}

/// Whether all that a fan or a closed corner at the departure vertex could add stays below the last
/// value, with a disk's radius to spare.
bool Sweep::may_depart(const Departure& d) const {
  const SurfacePoint& t = mesh_.at(front_[d.corner].origin);
  const double reach = 2 * disk_share_ * options_.sizing.scale(t.length_scale);
  return d.value + guide_.function.most_change(t.position, reach) <= last_;
}

/// Puts those departures back into the queue whose corners are still there.
void Sweep::push_current(std::vector<Departure>& departures) {
  for (const Departure& d : std::exchange(departures, {})) {
    if (is_current(d)) queue_.push(d);
  }
}

void Sweep::push(FrontEdgeId corner) {
  queue_.push(
      {guide_.function(mesh_.position(front_[corner].origin)), corner, front_[corner].generation});
}

void Sweep::mark_red(CriticalId saddle, const Departure& departure) {
  const int side = side_of_saddle(saddle, front_[departure.corner].origin);
  marked_[saddle.index()].sides[static_cast<std::size_t>(side)].push_back(departure);
}

void Sweep::release_red_marks() {
  for (std::size_t c = 0; c < marked_.size(); ++c) {
    if (guide_.points[c].index != 1) continue;
    marked_[c].is_done = true;
    for (auto& side : marked_[c].sides) push_current(side);
  }
}

}  // namespace morskin::front
