// The part of Triangulator that takes points out and moves them.

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/predicates_internal.h"
#include "geometry/spatial_order.h"
#include "geometry/triangulator_hole.h"

namespace morskin::geometry {

Triangulator::Triangulator(Triangulator&&) noexcept = default;
Triangulator& Triangulator::operator=(Triangulator&&) noexcept = default;
Triangulator::~Triangulator() = default;

/// The tetrahedra that vanish with p are those about it, and the ones that come instead have only
/// neighbours of p as corners, for whatever is new has p inside its orthosphere: inserting p again
/// would remove just these. They are empty of all points, so they belong to the triangulation of
/// the neighbours alone. With few neighbours the hole is filled from its facets, one tetrahedron
/// after the other; with many the neighbours are triangulated, and what the insertion of p would
/// take out of that is put in here.
bool Triangulator::remove(Corner p, std::uint32_t tetrahedron) {
  assert(dimension_ == 3);
  constexpr std::size_t few = 80;  // where the one takes as long as the other
  if (!hole_) hole_ = std::make_unique<Hole>();
  grow_star(p, tetrahedron);
  find_neighbours(p);
  fillers_.clear();
  if (hole_->neighbours.size() > few && triangulate_link(p)) {
    fill_hole();
    glue_hole();
  } else if (!wrap_hole()) {
    for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Live;
    return false;
  }
  free_cavity();
  last_ = fillers_.back();
  removed_corners_.push_back(p);
  return true;
}

/// A triangulation stays the regular one where its tetrahedra keep their orientation and every two
/// neighbours are regular, which only those about the moved point can lose (papers/5-dynamic.md).
bool Triangulator::move(Corner p, const WeightedPoint& to, std::uint32_t tetrahedron) {
  assert(dimension_ == 3);
  const StoredPoint from = std::exchange(points_[p], StoredPoint{to});
  grow_star(p, tetrahedron);
  const bool stands = is_star_regular();
  for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Live;
  if (!stands) points_[p] = from;
  return stands;
}

/// Collects the tetrahedra at p as the cavity and, in the same order, their facets opposite p.
void Triangulator::grow_star(Corner p, std::uint32_t first) {
  assert(is_live(first));
  cavity_[0] = first;
  cavity_size_ = 1;
  rim_size_ = 0;
  states_[first] = State::InCavity;
  for (std::size_t next = 0; next < cavity_size_; ++next) {
    const std::uint32_t here = cavity_[next];
    if (cavity_.size() < cavity_size_ + 5) cavity_.resize(2 * cavity_.size());
    if (rim_.size() < rim_size_ + 5) rim_.resize(2 * rim_.size());
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (tetrahedra_[here].corners[k] == p) {
        rim_[rim_size_++] = here << 2 | k;
        continue;
      }
      const std::uint32_t there = tetrahedron_of(tetrahedra_[here].neighbours[k]);
      if (states_[there] == State::InCavity) continue;
      states_[there] = State::InCavity;
      cavity_[cavity_size_++] = there;
    }
  }
  assert(rim_size_ == cavity_size_);
}

/// That a ghost's facet is turned outward its finite neighbour's orientation says.
bool Triangulator::is_star_regular() const {
  for (std::size_t i = 0; i < cavity_size_; ++i) {
    const Tetrahedron& t = tetrahedra_[cavity_[i]];
    if (is_ghost(t)) continue;
    if (internal::fast_orientation(points_[t.corners[0]].position, points_[t.corners[1]].position,
                                   points_[t.corners[2]].position,
                                   points_[t.corners[3]].position) != Sign::Positive) {
      return false;
    }
  }
  for (std::size_t i = 0; i < cavity_size_; ++i) {
    const std::uint32_t here = cavity_[i];
    for (const Facet behind : tetrahedra_[here].neighbours) {
      const std::uint32_t there = tetrahedron_of(behind);
      if (states_[there] == State::InCavity && there < here) continue;  // seen from there
      const Corner beyond = tetrahedra_[there].corners[index_of(behind)];
      if (beyond != infinity && is_in_conflict_exactly(tetrahedra_[here], beyond)) return false;
    }
  }
  return true;
}

void Triangulator::find_neighbours(Corner p) {
  std::vector<Corner>& neighbours = hole_->neighbours;
  neighbours.clear();
  const std::uint32_t stamp = next_stamp();
  for (std::size_t i = 0; i < cavity_size_; ++i) {
    for (const Corner c : tetrahedra_[cavity_[i]].corners) {
      if (c == infinity || c == p) continue;
      if (std::exchange(rim_numbers_[c + 1].stamp, stamp) != stamp) neighbours.push_back(c);
    }
  }
}

/// Fills the hole from its facets inward. On the inner side of a facet of three points stands the
/// neighbour whose sphere through them no other is inside of, or, if there is none on that side,
/// infinity. Facets with infinity find their other side by themselves.
/// @return false, with nothing done, if the points left lie in one plane
bool Triangulator::wrap_hole() {
  Hole& hole = *hole_;
  hole.open.clear();
  hole.open_at_infinity.clear();
  const auto join = [&](std::uint32_t t, std::size_t place, Facet facet) {
    const Hole::Open one = Hole::opened(tetrahedra_[t], place, facet);
    std::vector<Hole::Open>& open = one.last == infinity ? hole.open_at_infinity : hole.open;
    const auto other = std::find_if(open.rbegin(), open.rend(), [&](const Hole::Open& known) {
      return known.has_corners_of(one);
    });
    if (other == open.rend()) {
      open.push_back(one);
      return;
    }
    tetrahedra_[tetrahedron_of(facet)].neighbours[index_of(facet)] = other->facet;
    tetrahedra_[tetrahedron_of(other->facet)].neighbours[index_of(other->facet)] = facet;
    *other = open.back();
    open.pop_back();
  };
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const Tetrahedron& t = tetrahedra_[tetrahedron_of(rim_[i])];
    const std::size_t place = index_of(rim_[i]);
    const Hole::Open one = Hole::opened(t, place, t.neighbours[place]);
    (one.last == infinity ? hole.open_at_infinity : hole.open).push_back(one);
  }
  while (!hole.open.empty()) {
    const Facet outer = hole.open.back().facet;
    hole.open.pop_back();
    const std::array<Corner, 4> corners = wrapped(outer);
    if (corners[3] == infinity && is_ghost(tetrahedra_[tetrahedron_of(outer)])) {
      assert(fillers_.empty());
      return false;
    }
    const std::uint32_t filler = allocate();
    fillers_.push_back(filler);
    Tetrahedron& t = tetrahedra_[filler];
    t.corners = corners;
    const std::size_t wrapped_index = corners[3] == infinity ? 3 : index_of(outer);
    t.neighbours[wrapped_index] = outer;
    tetrahedra_[tetrahedron_of(outer)].neighbours[index_of(outer)] =
        filler << 2 | static_cast<Facet>(wrapped_index);
    for (std::uint32_t k = 0; k < 4; ++k) {
      if (k != wrapped_index) join(filler, k, filler << 2 | k);
    }
  }
  assert(hole.open_at_infinity.empty());
  return true;
}

/// The tetrahedron, or ghost, to stand behind a facet, turned so that it is positive.
std::array<Triangulator::Corner, 4> Triangulator::wrapped(Facet outer) const {
  const std::size_t place = index_of(outer);
  std::array<Corner, 4> corners = tetrahedra_[tetrahedron_of(outer)].corners;
  // The corners of the facet, the other way round.
  std::swap(corners[place == 0 ? 1 : 0], corners[place < 2 ? 2 : 1]);
  std::array<const WeightedPoint*, 4> q{};
  for (std::size_t k = 0; k < 4; ++k) {
    if (k != place) q[k] = &points_[corners[k]];
  }
  corners[place] = infinity;
  for (const Corner c : hole_->neighbours) {
    if (std::find(corners.begin(), corners.end(), c) != corners.end()) continue;
    const WeightedPoint* const best = std::exchange(q[place], &points_[c]);
    const bool is_above = internal::fast_orientation(q[0]->position, q[1]->position, q[2]->position,
                                                     q[3]->position) == Sign::Positive;
    const bool is_first = corners[place] == infinity;
    if (!is_above) {
      q[place] = best;
    } else if (is_first) {
      corners[place] = c;
    } else {
      q[place] = best;
      if (is_inside(q, corners, c)) {
        corners[place] = c;
        q[place] = &points_[c];
      }
    }
  }
  if (corners[place] == infinity && place != 3) {
    std::swap(corners[place], corners[3]);
    std::swap(corners[place == 0 ? 1 : 0], corners[place < 2 ? 2 : 1]);
  }
  return corners;
}

/// Whether a corner lies inside the orthosphere of four.
bool Triangulator::is_inside(const std::array<const WeightedPoint*, 4>& q,
                             const std::array<Corner, 4>& corners, Corner c) const {
  const WeightedPoint& p = points_[c];
  if (const auto sign = internal::filtered_orthosphere(*q[0], *q[1], *q[2], *q[3], p)) {
    return *sign == Sign::Positive;
  }
  return orthosphere_side(*q[0], *q[1], *q[2], *q[3], p,
                          {ids_[corners[0]], ids_[corners[1]], ids_[corners[2]], ids_[corners[3]],
                           ids_[c]}) == Side::Inside;
}

/// Triangulates the neighbours of p, whose star is the cavity, and finds what is in conflict with p
/// there: the cavity of `link`. It belongs to the hole: that is where inserting p would make the
/// star anew.
/// @return whether the neighbours span space; otherwise nothing is found
bool Triangulator::triangulate_link(Corner p) {
  Hole& hole = *hole_;
  hole.points.clear();
  for (const Corner c : hole.neighbours) hole.points.push_back(points_[c]);
  std::vector<AtomId> order = spatial_order(hole.points);
  Triangulator& link = hole.link;
  link.find_first_tetrahedron(hole.points, order);
  if (link.dimension_ < 3) return false;
  hole.corners.clear();
  for (const AtomId id : order) hole.corners.push_back(hole.neighbours[id.index()]);
  link.points_.clear();
  link.ids_.clear();
  for (const Corner c : hole.corners) {
    link.points_.push_back(points_[c]);
    link.ids_.push_back(ids_[c]);
  }
  link.restart();
  const auto q = static_cast<Corner>(link.points_.size());
  link.points_.push_back(points_[p]);
  link.ids_.push_back(ids_[p]);
  link.last_ = link.locate(q);
  assert(link.is_in_conflict_exactly(link.tetrahedra_[link.last_], q));
  link.grow_cavity(q);
  return true;
}

/// Triangulates points_ anew, the first four of which span space.
void Triangulator::restart() {
  atom_count_ = points_.size();
  if (rim_numbers_.size() < atom_count_ + 1) rim_numbers_.resize(atom_count_ + 1);
  tetrahedra_.clear();
  free_.clear();
  last_ = 0;
  make_first_tetrahedron();
  for (std::size_t c = 4; c < atom_count_; ++c) insert(static_cast<Corner>(c));
}

/// Puts what was found in conflict with the point into the hole it leaves.
void Triangulator::fill_hole() {
  Hole& hole = *hole_;
  const Triangulator& link = hole.link;
  hole.open.clear();
  hole.renamed.resize(link.tetrahedra_.size());
  for (std::size_t i = 0; i < link.cavity_size_; ++i) {
    fillers_.push_back(allocate());
    hole.renamed[link.cavity_[i]] = fillers_.back();
  }
  for (std::size_t i = 0; i < link.cavity_size_; ++i) {
    const Tetrahedron& found = link.tetrahedra_[link.cavity_[i]];
    Tetrahedron& t = tetrahedra_[fillers_[i]];
    for (std::size_t k = 0; k < 4; ++k) {
      t.corners[k] = found.corners[k] == infinity ? infinity : hole.corners[found.corners[k]];
    }
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t there = tetrahedron_of(found.neighbours[k]);
      if (link.states_[there] == State::InCavity) {
        t.neighbours[k] =
            hole.renamed[there] << 2 | static_cast<Facet>(index_of(found.neighbours[k]));
      } else {
        hole.open.push_back(Hole::opened(t, k, fillers_[i] << 2 | k));
      }
    }
  }
}

/// Joins the open facets to those around the hole with the same corners.
void Triangulator::glue_hole() {
  std::vector<Hole::Open>& open = hole_->open;
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const Tetrahedron& t = tetrahedra_[tetrahedron_of(rim_[i])];
    open.push_back(Hole::opened(t, index_of(rim_[i]), t.neighbours[index_of(rim_[i])]));
  }
  std::sort(open.begin(), open.end(), [](const Hole::Open& a, const Hole::Open& b) {
    return std::pair(a.first_two, a.last) < std::pair(b.first_two, b.last);
  });
  assert(open.size() % 2 == 0);
  for (std::size_t i = 0; i + 1 < open.size(); i += 2) {
    const Facet f = open[i].facet, g = open[i + 1].facet;
    assert(open[i].has_corners_of(open[i + 1]));
    tetrahedra_[tetrahedron_of(f)].neighbours[index_of(f)] = g;
    tetrahedra_[tetrahedron_of(g)].neighbours[index_of(g)] = f;
  }
}

}  // namespace morskin::geometry
