#include "bench/baselines/kept_delaunay.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <utility>

#include "geometry/predicates.h"
#include "geometry/stopwatch.h"

namespace morskin::baselines {

using geometry::Point;
using geometry::timed;
using geometry::Triangulator;
using geometry::WeightedPoint;

namespace {

Point on_grid(const Point& p) { return p.unaryExpr(&geometry::on_exact_grid); }

}  // namespace

void KeptDelaunay::add(VertexId v, const Point& p) {
  timed(counts_.seconds, [&] {
    if (samples_.size() <= v.index()) samples_.resize(v.index() + 1);
    assert(!samples_[v.index()].is_in);
    samples_[v.index()] = {on_grid(p), nobody, true};
    ++counts_.insertions;
    insert(v);
  });
}

void KeptDelaunay::move(VertexId v, const Point& p) {
  timed(counts_.seconds, [&] {
    if (v.index() >= samples_.size()) return;
    Sample& sample = samples_[v.index()];
    const Point to = on_grid(p);
    if (!sample.is_in || sample.position == to) return;
    sample.position = to;
    if (sample.corner == nobody) {
      ++counts_.moved_by_both;
      try_waiting();
      return;
    }
    if (delaunay_->move(sample.corner, {to, 0}, star_[sample.corner])) {
      ++counts_.moved_in_place;
      near_ = star_[sample.corner];
    } else {
      ++counts_.moved_by_both;
      take_out(v);
      insert(v);
    }
    if (!waiting_.empty()) try_waiting();  // for the place that is free now
  });
}

void KeptDelaunay::remove(VertexId v) {
  timed(counts_.seconds, [&] {
    if (v.index() >= samples_.size() || !samples_[v.index()].is_in) return;
    ++counts_.removals;
    take_out(v);
    samples_[v.index()].is_in = false;
    if (!waiting_.empty()) try_waiting();
  });
}

/// Puts a sample into the triangulation, or lets it wait.
void KeptDelaunay::insert(VertexId v) {
  Sample& sample = samples_[v.index()];
  const auto corner =
      delaunay_ ? delaunay_->add({sample.position, 0}, {near_, near_}) : std::optional<Corner>();
  if (!corner) {
    waiting_.push_back(v);
    if (!delaunay_) start();
    return;
  }
  sample.corner = *corner;
  if (vertex_of_.size() <= *corner) vertex_of_.resize(*corner + 1, nobody);
  vertex_of_[*corner] = v.value;
  note(delaunay_->added());
}

/// Takes a sample out of the triangulation, or out of those that wait.
void KeptDelaunay::take_out(VertexId v) {
  const Corner corner = std::exchange(samples_[v.index()].corner, nobody);
  if (corner == nobody) {
    std::erase(waiting_, v);
    return;
  }
  vertex_of_[corner] = nobody;
  if (delaunay_->remove(corner, star_[corner])) {
    note(delaunay_->added());
  } else {
    stop();
  }
}

/// Tries to put in what waits.
void KeptDelaunay::try_waiting() {
  for (const VertexId v : std::exchange(waiting_, {})) insert(v);
}

/// Triangulates what waits, if that spans space.
void KeptDelaunay::start() {
  if (waiting_.size() < 4) return;
  std::vector<WeightedPoint> points;
  for (const VertexId v : waiting_) points.push_back({samples_[v.index()].position, 0});
  Triangulator triangulator(points);
  if (triangulator.dimension() < 3) return;
  delaunay_ = std::move(triangulator);
  vertex_of_.assign(points.size(), nobody);
  star_.assign(points.size(), nobody);
  std::vector<std::uint32_t> live;
  for (std::uint32_t t = 0; t < delaunay_->tetrahedra().size(); ++t) {
    if (delaunay_->is_live(t)) live.push_back(t);
  }
  note(live);
  const std::vector<VertexId> started = std::exchange(waiting_, {});
  for (Corner corner = 0; corner < points.size(); ++corner) {
    const VertexId v = started[delaunay_->atom(corner)->index()];
    if (star_[corner] == nobody) {
      waiting_.push_back(v);
      continue;
    }
    samples_[v.index()].corner = corner;
    vertex_of_[corner] = v.value;
  }
}

/// Lets all wait that are in the triangulation, because they do not span space any more.
void KeptDelaunay::stop() {
  for (const std::uint32_t v : vertex_of_) {
    if (v == nobody) continue;
    samples_[v].corner = nobody;
    waiting_.push_back(VertexId{v});
  }
  vertex_of_.clear();
  star_.clear();
  delaunay_.reset();
}

void KeptDelaunay::note(std::span<const std::uint32_t> tetrahedra) {
  counts_.made += tetrahedra.size();
  for (const std::uint32_t t : tetrahedra) {
    for (const Corner c : delaunay_->tetrahedra()[t].corners) {
      if (star_.size() <= c && c < nobody) star_.resize(c + 1, nobody);
      if (c < star_.size()) star_[c] = t;
    }
  }
  near_ = tetrahedra.back();
}

void KeptDelaunay::rename(std::span<const std::optional<VertexId>> names) {
  std::vector<Sample> renamed;
  for (std::size_t v = 0; v < std::min(names.size(), samples_.size()); ++v) {
    assert(names[v] || !samples_[v].is_in);
    if (!names[v]) continue;
    if (renamed.size() <= names[v]->index()) renamed.resize(names[v]->index() + 1);
    renamed[names[v]->index()] = samples_[v];
    const Corner corner = samples_[v].corner;
    if (corner != nobody) vertex_of_[corner] = names[v]->value;
  }
  samples_ = std::move(renamed);
  for (VertexId& v : waiting_) v = *names[v.index()];
}

void KeptDelaunay::become(std::span<const surface::SurfacePoint> points) {
  struct Place {
    Point position;
    VertexId v;
    bool is_new;
    auto key() const {
      return std::tuple(position.x(), position.y(), position.z(), is_new, v.value);
    }
  };
  std::vector<Place> places;
  for (std::size_t v = 0; v < samples_.size(); ++v) {
    if (samples_[v].is_in) places.push_back({samples_[v].position, VertexId{v}, false});
  }
  for (std::size_t v = 0; v < points.size(); ++v) {
    places.push_back({on_grid(points[v].position), VertexId{v}, true});
  }
  std::ranges::sort(places, {}, &Place::key);
  std::vector<std::optional<VertexId>> names(samples_.size());
  std::vector<Place> coming;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const bool is_kept = i + 1 < places.size() && !places[i].is_new && places[i + 1].is_new &&
                         places[i].position == places[i + 1].position;
    if (is_kept) {
      names[places[i].v.index()] = places[i + 1].v;
      ++i;
    } else if (places[i].is_new) {
      coming.push_back(places[i]);
    } else {
      remove(places[i].v);
    }
  }
  rename(names);
  for (const Place& place : coming) add(place.v, place.position);
}

KeptDelaunayCounts KeptDelaunay::counts() const {
  KeptDelaunayCounts counts = counts_;
  counts.samples = static_cast<std::size_t>(std::ranges::count(samples_, true, &Sample::is_in));
  if (!delaunay_) return counts;
  for (std::size_t t = 0; t < delaunay_->tetrahedra().size(); ++t) {
    counts.tetrahedra += delaunay_->is_live(t) && !delaunay_->is_ghost(delaunay_->tetrahedra()[t]);
  }
  return counts;
}

}  // namespace morskin::baselines
