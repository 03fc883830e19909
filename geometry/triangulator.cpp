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
void Triangulator::insert(Corner p) {
  last_ = locate(p);
  if (!is_in_conflict(last_, p)) return;
  grow_cavity(p);
  fill_cavity(p);
}

std::optional<Triangulator::Corner> Triangulator::add(const WeightedPoint& point,
                                                      std::array<std::uint32_t, 2> hints) {
  assert(dimension_ == 3);
  if (atom_count_ >= max_points) fail_for_lack_of_ids(max_points, "points");
  const auto p = static_cast<Corner>(atom_count_);
  points_.push_back({point});
  ids_.push_back(AtomId(atom_count_));
  rim_numbers_.resize(points_.size() + 1);
  const auto* hint = std::find_if(hints.begin(), hints.end(),
                                  [&](std::uint32_t t) { return is_in_conflict(t, p); });
  last_ = hint != hints.end() ? *hint : hints[0];
  if (hint == hints.end()) last_ = locate(p);
  if (hint == hints.end() && !is_in_conflict(last_, p)) {
    points_.pop_back();
    ids_.pop_back();
    return std::nullopt;
  }
  ++atom_count_;
  grow_cavity(p);
  fill_cavity(p);
  return p;
}

/// Walks from the last tetrahedron towards p, each step through a facet with p strictly behind it,
/// until there is none or the hull is left. In a regular triangulation such a walk never cycles.
std::uint32_t Triangulator::locate(Corner p) const {
  const Point& target = points_[p].position;
  std::uint32_t here = last_;
  if (is_ghost(tetrahedra_[here])) here = tetrahedron_of(tetrahedra_[here].neighbours[3]);
  std::size_t entered_by = 4;
  while (true) {
    const Tetrahedron& t = tetrahedra_[here];
    std::array<const Point*, 4> q{};
    for (std::size_t k = 0; k < 4; ++k) q[k] = &points_[t.corners[k]].position;
    std::size_t exit = 0;
    for (; exit < 4; ++exit) {
      if (exit == entered_by) continue;
      const Point* corner = std::exchange(q[exit], &target);
      const Sign side = internal::fast_orientation(*q[0], *q[1], *q[2], *q[3]);
      q[exit] = corner;
      if (side == Sign::Negative) break;
    }
    if (exit == 4) return here;
    here = tetrahedron_of(t.neighbours[exit]);
    entered_by = index_of(t.neighbours[exit]);
    if (is_ghost(tetrahedra_[here])) return here;
  }
}

/// Collects the tetrahedra in conflict with p, which are connected, and the facets around them.
/// Both lists are written each time and one advanced: the answers cannot be predicted.
void Triangulator::grow_cavity(Corner p) {
  cavity_[0] = last_;
  cavity_size_ = 1;
  rim_size_ = 0;
  states_[last_] = State::InCavity;
  for (std::size_t next = 0; next < cavity_size_; ++next) {
    const std::uint32_t here = cavity_[next];
    if (cavity_.size() < cavity_size_ + 5) cavity_.resize(2 * cavity_.size());
    if (rim_.size() < rim_size_ + 5) rim_.resize(2 * rim_.size());
    for (std::size_t k = 0; k < 4; ++k) {
      const std::uint32_t there = tetrahedron_of(tetrahedra_[here].neighbours[k]);
      if (states_[there] == State::InCavity) continue;
      const bool in_conflict = is_in_conflict(there, p);
      cavity_[cavity_size_] = there;
      cavity_size_ += in_conflict ? 1 : 0;
      rim_[rim_size_] = facet_of(here, k);
      rim_size_ += in_conflict ? 0 : 1;
      states_[there] = in_conflict ? State::InCavity : State::Live;
    }
  }
}

/// Joins p to every facet of the rim. Each filler is the cavity's tetrahedron there with the
/// opposite corner replaced by p, so orientation and infinity's index are inherited.
void Triangulator::fill_cavity(Corner p) {
  fillers_.clear();
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const std::size_t index = index_of(rim_[i]);
    const std::uint32_t filler = allocate();
    const Tetrahedron& inner = tetrahedra_[tetrahedron_of(rim_[i])];
    const Facet outer = inner.neighbours[index];
    Tetrahedron& t = tetrahedra_[filler];
    t.corners = inner.corners;
    t.corners[index] = p;
    t.neighbours = {no_index, no_index, no_index, no_index};
    t.neighbours[index] = outer;
    tetrahedra_[tetrahedron_of(outer)].neighbours[index_of(outer)] = facet_of(filler, index);
    fillers_.push_back(filler);
  }
  // A rim with F triangles is a sphere, with F / 2 + 2 corners.
  rim_size_ / 2 + 2 <= table_side ? link_by_table() : link_by_turning();
  for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Free;
  free_.insert(free_.end(), cavity_.begin(),
               cavity_.begin() + static_cast<std::ptrdiff_t>(cavity_size_));
  last_ = fillers_.back();
}

/// Links the fillers to one another. The new facet of a filler that contains p and the edge uv of
/// the rim faces the new facet of another filler that contains p and vu. The rim's corners get
/// small numbers, by which a table holds the facet at each directed edge.
void Triangulator::link_by_table() {
  std::array<std::array<std::uint32_t, 3>, 2 * table_side> numbers;
  std::uint32_t count = 0;
  if (++stamp_ == 0) {
    std::fill(rim_numbers_.begin(), rim_numbers_.end(), RimNumber{});
    ++stamp_;
  }
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const auto& corners = tetrahedra_[fillers_[i]].corners;
    const auto& around = indices_around[index_of(rim_[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      RimNumber& known = rim_numbers_[corners[around[k]] + 1];
      const bool is_new = known.stamp != stamp_;
      known = {stamp_, is_new ? count : known.number};
      count += is_new ? 1 : 0;
      numbers[i][k] = known.number;
    }
    for (std::size_t k = 0; k < 3; ++k) {
      edge_table_[numbers[i][k] * table_side + numbers[i][(k + 1) % 3]] =
          facet_of(fillers_[i], around[(k + 2) % 3]);
    }
  }
  for (std::size_t i = 0; i < rim_size_; ++i) {
    Tetrahedron& t = tetrahedra_[fillers_[i]];
    const auto& around = indices_around[index_of(rim_[i])];
    for (std::size_t k = 0; k < 3; ++k) {
      t.neighbours[around[(k + 2) % 3]] =
          edge_table_[numbers[i][(k + 1) % 3] * table_side + numbers[i][k]];
    }
  }
}

/// The same for a rim of any size, at twice the price.
void Triangulator::link_by_turning() {
  for (std::size_t i = 0; i < rim_size_; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      if (k == index_of(rim_[i])) continue;
      tetrahedra_[fillers_[i]].neighbours[k] = turn_to_rim(rim_[i], k);
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

std::uint32_t Triangulator::allocate() {
  if (free_.empty()) {
    require_capacity(tetrahedra_.size(), max_tetrahedra, "tetrahedra of the triangulated atoms");
    tetrahedra_.emplace_back();
    states_.push_back(State::Live);
    return static_cast<std::uint32_t>(tetrahedra_.size() - 1);
  }
  const std::uint32_t reused = free_.back();
  free_.pop_back();
  states_[reused] = State::Live;
  return reused;
}

}  // namespace morskin::geometry
