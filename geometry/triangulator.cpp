#include "geometry/triangulator.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/error.h"
#include "geometry/predicates_internal.h"

namespace morskin::geometry {
namespace {

constexpr Triangulator::Facet facet_of(std::uint32_t tetrahedron, std::size_t index) {
  return tetrahedron << 2 | static_cast<std::uint32_t>(index);
}

/// By corner, the corners of the opposite facet, all in the same sense.
constexpr std::array<std::array<std::size_t, 3>, 4> indices_around{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

}  // namespace

/// The common case: a finite tetrahedron, and the filter can tell.
inline bool Triangulator::is_in_conflict(std::uint32_t tetrahedron, Corner p) const {
  const Tetrahedron& t = tetrahedra_[tetrahedron];
  if (!is_ghost(t)) {
    const auto& [a, b, c, d] = t.corners;
    const auto sign =
        internal::filtered_orthosphere(points_[a], points_[b], points_[c], points_[d], points_[p]);
    if (sign) return *sign == Sign::Positive;
  }
  return is_in_conflict_exactly(t, p);
}

/// A ghost's orthosphere is the half-space beyond its facet; for a point in the facet's plane it
/// cuts the plane as the orthosphere of the tetrahedron behind the facet does, under the same ties,
/// because the cofactor of the fourth corner's height is zero.
bool Triangulator::is_in_conflict_exactly(const Tetrahedron& t, Corner p) const {
  const auto& [a, b, c, d] = t.corners;
  if (is_ghost(t)) {
    const Sign side = internal::fast_orientation(points_[a].position, points_[b].position,
                                                 points_[c].position, points_[p].position);
    if (side != Sign::Zero) return side == Sign::Positive;
    return is_in_conflict_exactly(tetrahedra_[tetrahedron_of(t.neighbours[3])], p);
  }
  return orthosphere_side(points_[a], points_[b], points_[c], points_[d], points_[p],
                          {ids_[a], ids_[b], ids_[c], ids_[d], ids_[p]}) == Side::Inside;
}

/// Inserts a point or, if it is redundant, leaves everything as it is. A point that is in the
/// closed tetrahedron where the walk ends, and not in conflict with it, lies above the lower hull.
///
/// @return false: nothing was done, since the region or its slots do not suffice
bool Triangulator::insert(Corner p, Worker& worker) {
  return worker.height == whole ? insert_in<false>(p, worker) : insert_in<true>(p, worker);
}

template <bool InRegion>
bool Triangulator::insert_in(Corner p, Worker& worker) {
  worker.last = locate<InRegion>(p, worker);
  if (worker.last == no_index) return false;
  if (!is_in_conflict(worker.last, p)) return true;
  if (!grow_cavity<InRegion>(p, worker)) {
    leave_cavity(worker);
    return false;
  }
  fill_cavity(p, worker);
  return true;
}

std::optional<Triangulator::Corner> Triangulator::add(const WeightedPoint& point,
                                                      std::array<std::uint32_t, 2> hints) {
  assert(dimension_ == 3);
  if (atom_count_ >= max_points) fail_for_lack_of_ids(max_points, "points");
  const auto p = static_cast<Corner>(atom_count_);
  points_.push_back({point});
  ids_.push_back(AtomId(atom_count_));
  all_.rim_numbers.resize(points_.size() + 1);
  const auto* hint = std::find_if(hints.begin(), hints.end(),
                                  [&](std::uint32_t t) { return is_in_conflict(t, p); });
  all_.last = hint != hints.end() ? *hint : hints[0];
  if (hint == hints.end()) all_.last = locate<false>(p, all_);
  if (hint == hints.end() && !is_in_conflict(all_.last, p)) {
    points_.pop_back();
    ids_.pop_back();
    return std::nullopt;
  }
  ++atom_count_;
  grow_cavity<false>(p, all_);
  fill_cavity(p, all_);
  return p;
}

/// Walks from the last tetrahedron towards p, each step through a facet with p strictly behind it,
/// until there is none or the hull is left. In a regular triangulation such a walk never cycles.
/// In a region it takes what steps the region allows.
/// @return no_index if there is none; then worker.next_height is set
template <bool InRegion>
std::uint32_t Triangulator::locate(Corner p, Worker& worker) const {
  const Point& target = points_[p].position;
  std::uint32_t here = worker.last;
  if (is_ghost(tetrahedra_[here])) {
    here = tetrahedron_of(tetrahedra_[here].neighbours[3]);
    if (InRegion && !is_own(here, worker)) {
      worker.next_height = height_with(here, worker);
      return no_index;
    }
  }
  std::size_t entered_by = 4;
  while (true) {
    const Tetrahedron& t = tetrahedra_[here];
    std::array<const Point*, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) q[k] = &points_[t.corners[k]].position;
    bool is_behind = false;  // a facet
    if (InRegion) worker.next_height = whole;
    std::size_t exit = 0;
    for (; exit < 4; ++exit) {
      if (exit == entered_by) continue;
      const Point* corner = std::exchange(q[exit], &target);
      const Sign side = internal::fast_orientation(*q[0], *q[1], *q[2], *q[3]);
      q[exit] = corner;
      if (side != Sign::Negative) continue;
      is_behind = true;
      const std::uint32_t there = tetrahedron_of(t.neighbours[exit]);
      if (!InRegion || is_own(there, worker)) break;
      worker.next_height = std::min(worker.next_height, height_with(there, worker));
    }
    if (exit == 4) return is_behind ? no_index : here;
    here = tetrahedron_of(t.neighbours[exit]);
    entered_by = index_of(t.neighbours[exit]);
    if (is_ghost(tetrahedra_[here])) return here;
  }
}

/// Collects the tetrahedra in conflict with p, which are connected, and the facets around them.
/// Both lists are written each time and one advanced: the answers cannot be predicted.
///
/// @return false if the region ends there or has not slots enough for fill_cavity(); then
///         worker.next_height is set
template <bool InRegion>
bool Triangulator::grow_cavity(Corner p, Worker& worker) {
  std::vector<std::uint32_t>& cavity = worker.cavity;
  std::vector<Facet>& rim = worker.rim;
  cavity[0] = worker.last;
  worker.cavity_size = 1;
  worker.rim_size = 0;
  states_[worker.last] = State::InCavity;
  for (std::size_t next = 0; next < worker.cavity_size; ++next) {
    const std::uint32_t here = cavity[next];
    if (cavity.size() < worker.cavity_size + 5) cavity.resize(2 * cavity.size());
    if (rim.size() < worker.rim_size + 5) rim.resize(2 * rim.size());
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = tetrahedron_of(tetrahedra_[here].neighbours[k]);
      if (InRegion && !is_own(there, worker)) {
        worker.next_height = height_with(there, worker);
        return false;
      }
      if (states_[there] == State::InCavity) continue;
      const bool in_conflict = is_in_conflict(there, p);
      cavity[worker.cavity_size] = there;
      worker.cavity_size += in_conflict ? 1 : 0;
      rim[worker.rim_size] = facet_of(here, k);
      worker.rim_size += in_conflict ? 0 : 1;
      states_[there] = in_conflict ? State::InCavity : State::Live;
    }
  }
  if (!InRegion) return true;
  worker.next_height = worker.height + 1;
  const std::size_t slots = worker.free.size() + worker.unused_end - worker.unused;
  return worker.rim_size <= slots;
}

void Triangulator::leave_cavity(const Worker& worker) {
  for (std::size_t i = 0; i < worker.cavity_size; ++i) states_[worker.cavity[i]] = State::Live;
}

/// Joins p to every facet of the rim. Each filler is the cavity's tetrahedron there with the
/// opposite corner replaced by p, so orientation and infinity's index are inherited.
void Triangulator::fill_cavity(Corner p, Worker& worker) {
  worker.fillers.clear();
  for (std::size_t i = 0; i < worker.rim_size; ++i) {
    const std::size_t index = index_of(worker.rim[i]);
    const std::uint32_t filler = allocate(worker);
    const Tetrahedron& inner = tetrahedra_[tetrahedron_of(worker.rim[i])];
    const Facet outer = inner.neighbours[index];
    Tetrahedron& t = tetrahedra_[filler];
    t.corners = inner.corners;
    t.corners[index] = p;
    t.neighbours = {no_index, no_index, no_index, no_index};
    t.neighbours[index] = outer;
    tetrahedra_[tetrahedron_of(outer)].neighbours[index_of(outer)] = facet_of(filler, index);
    worker.fillers.push_back(filler);
  }
  // A rim with F triangles is a sphere, with F / 2 + 2 corners.
  worker.rim_size / 2 + 2 <= table_side ? link_by_table(worker) : link_by_turning(worker);
  for (std::size_t i = 0; i < worker.cavity_size; ++i) states_[worker.cavity[i]] = State::Free;
  worker.free.insert(worker.free.end(), worker.cavity.begin(),
                     worker.cavity.begin() + static_cast<std::ptrdiff_t>(worker.cavity_size));
  worker.last = worker.fillers.back();
}

/// Links the fillers to one another. The new facet of a filler that contains p and the edge uv of
/// the rim faces the new facet of another filler that contains p and vu. The rim's corners get
/// small numbers, by which a table holds the facet at each directed edge.
void Triangulator::link_by_table(Worker& worker) {
  std::array<std::array<std::uint32_t, 3>, 2 * table_side> numbers;
  std::uint32_t count = 0;
  if (++worker.stamp == 0) {
    std::fill(worker.rim_numbers.begin(), worker.rim_numbers.end(), Worker::RimNumber{});
    ++worker.stamp;
  }
  for (std::size_t i = 0; i < worker.rim_size; ++i) {
    const auto& corners = tetrahedra_[worker.fillers[i]].corners;
    const auto& around = indices_around[index_of(worker.rim[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      Worker::RimNumber& known = worker.rim_numbers[corners[around[k]] + 1];
      const bool is_new = known.stamp != worker.stamp;
      known = {worker.stamp, is_new ? count : known.number};
      count += is_new ? 1 : 0;
      numbers[i][k] = known.number;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      worker.edge_table[numbers[i][k] * table_side + numbers[i][(k + 1) % 3]] =
          facet_of(worker.fillers[i], around[(k + 2) % 3]);
    }
  }
  for (std::size_t i = 0; i < worker.rim_size; ++i) {
    Tetrahedron& t = tetrahedra_[worker.fillers[i]];
    const auto& around = indices_around[index_of(worker.rim[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      t.neighbours[around[(k + 2) % 3]] =
          worker.edge_table[numbers[i][(k + 1) % 3] * table_side + numbers[i][k]];
    }
  }
}

/// The same for a rim of any size, at twice the price.
void Triangulator::link_by_turning(const Worker& worker) {
  for (std::size_t i = 0; i < worker.rim_size; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == index_of(worker.rim[i])) continue;
      tetrahedra_[worker.fillers[i]].neighbours[k] = turn_to_rim(worker.rim[i], k);
    }
  }
}

/// The new facet that faces the filler of `rim` opposite its corner `exit`: turns about the edge
/// between, through the cavity, until the rim is met. There the outer side knows the filler.
Triangulator::Facet Triangulator::turn_to_rim(Facet rim, std::size_t exit) const {
  const Tetrahedron* here = &tetrahedra_[tetrahedron_of(rim)];
  std::size_t entry = index_of(rim);
  Facet across = here->neighbours[exit];
  while (states_[tetrahedron_of(across)] == State::InCavity) {
    const Corner pivot = here->corners[entry];
    here = &tetrahedra_[tetrahedron_of(across)];
    entry = index_of(across);
    exit = 0;
    while (here->corners[exit] != pivot) ++exit;
    across = here->neighbours[exit];
  }
  const Facet met = tetrahedra_[tetrahedron_of(across)].neighbours[index_of(across)];
  return facet_of(tetrahedron_of(met), entry);
}

/// @pre the region, if any, has a slot left
std::uint32_t Triangulator::allocate(Worker& worker) {
  std::uint32_t slot = worker.unused;
  if (!worker.free.empty()) {
    slot = worker.free.back();
    worker.free.pop_back();
  } else if (slot < worker.unused_end) {
    ++worker.unused;
  } else {
    assert(worker.height == whole);
    require_capacity(tetrahedra_.size(), max_tetrahedra, "tetrahedra of the triangulated atoms");
    slot = static_cast<std::uint32_t>(tetrahedra_.size());
    tetrahedra_.emplace_back();
    states_.push_back(State::Live);
  }
  states_[slot] = State::Live;
  if (worker.height < whole) {
    regions_[slot] = static_cast<std::uint8_t>(worker.region << worker.height);
  }
  return slot;
}

}  // namespace morskin::geometry
