// The part of Triangulator that takes points out and moves them.

#include <algorithm>
#include <cassert>
#include <utility>

#include "geometry/spatial_order.h"
#include "geometry/triangulator_hole.h"

namespace morskin::geometry {

Triangulator::Triangulator(Triangulator&&) noexcept = default;
Triangulator& Triangulator::operator=(Triangulator&&) noexcept = default;
Triangulator::~Triangulator() = default;

/// The tetrahedra that vanish with p are those about it, and the ones that come instead have only
/// neighbours of p as corners, for whatever is new has p inside its orthosphere: inserting p again
/// would remove just these. They are empty of all points, so they belong to the triangulation of
/// the neighbours alone, where p is in conflict with them; and whatever p is in conflict with
/// there fills the same hole. So the neighbours are triangulated, under the ids they have, and what
/// the insertion of p would take out of that is put in here.
bool Triangulator::remove(Corner p, std::uint32_t tetrahedron) {
  assert(dimension_ == 3);
  if (!hole_) hole_ = std::make_unique<Hole>();
  hole_->open.clear();
  grow_star(p, tetrahedron);
  if (triangulate_link(p)) {
    fill_hole();
  } else if (!fill_flat_hole()) {
    for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Live;
    return false;
  }
  glue_hole();
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
    if (orientation(points_[t.corners[0]].position, points_[t.corners[1]].position,
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
      const Corner beyond = tetrahedra_[there].corners[place_of(behind)];
      if (beyond != infinity && is_in_conflict_exactly(tetrahedra_[here], beyond)) return false;
    }
  }
  return true;
}

/// Triangulates the neighbours of p, whose star is the cavity, and finds what is in conflict with p
/// there: the cavity of `link`.
/// @return whether the neighbours span space; otherwise nothing is found
bool Triangulator::triangulate_link(Corner p) {
  Hole& hole = *hole_;
  hole.neighbours.clear();
  hole.points.clear();
  const std::uint32_t stamp = next_stamp();
  for (std::size_t i = 0; i < cavity_size_; ++i) {
    for (const Corner c : tetrahedra_[cavity_[i]].corners) {
      if (c == infinity || c == p) continue;
      if (std::exchange(rim_numbers_[c + 1].stamp, stamp) == stamp) continue;
      hole.neighbours.push_back(c);
      hole.points.push_back(points_[c]);
    }
  }
  // The order is one of going round p, good enough for a few.
  constexpr std::size_t few = 100;
  std::vector<AtomId> order;
  if (hole.points.size() > few) {
    order = spatial_order(hole.points);
  } else {
    for (std::size_t i = 0; i < hole.points.size(); ++i) order.push_back(AtomId(i));
  }
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
  assert(link.is_in_conflict(link.last_, q));
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
  fillers_.clear();
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
            hole.renamed[there] << 2 | static_cast<Facet>(place_of(found.neighbours[k]));
      } else {
        hole.add_open(t, k, fillers_[i] << 2 | k);
      }
    }
  }
}

/// With all neighbours in one plane, the point is a corner of the hull, the tip of a pyramid. What it
/// leaves is the base, whose triangles get ghosts: the tetrahedra of the pyramid with infinity in
/// p's place, turned so that it comes last.
/// @return false if there is nothing on the other side of the base
bool Triangulator::fill_flat_hole() {
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const Tetrahedron& t = tetrahedra_[tetrahedron_of(rim_[i])];
    if (is_ghost(t)) continue;
    if (is_ghost(tetrahedra_[tetrahedron_of(t.neighbours[place_of(rim_[i])])])) return false;
  }
  fillers_.clear();
  for (std::size_t i = 0; i < rim_size_; ++i) {
    std::array<Corner, 4> corners = tetrahedra_[tetrahedron_of(rim_[i])].corners;
    if (corners[3] == infinity) continue;
    const std::size_t place = place_of(rim_[i]);
    if (place != 3) {
      std::swap(corners[place], corners[3]);
      std::swap(corners[0], corners[1]);
    }
    corners[3] = infinity;
    fillers_.push_back(allocate());
    tetrahedra_[fillers_.back()].corners = corners;
  }
  for (const std::uint32_t filler : fillers_) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      hole_->add_open(tetrahedra_[filler], k, filler << 2 | k);
    }
  }
  return true;
}

/// Joins the open facets to one another and to those around the hole, which come in pairs with the
/// same corners.
void Triangulator::glue_hole() {
  std::vector<Hole::Open>& open = hole_->open;
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const Tetrahedron& t = tetrahedra_[tetrahedron_of(rim_[i])];
    hole_->add_open(t, place_of(rim_[i]), t.neighbours[place_of(rim_[i])]);
  }
  std::sort(open.begin(), open.end(),
            [](const Hole::Open& a, const Hole::Open& b) { return a.corners < b.corners; });
  assert(open.size() % 2 == 0);
  for (std::size_t i = 0; i + 1 < open.size(); i += 2) {
    const Facet f = open[i].facet, g = open[i + 1].facet;
    assert(open[i].corners == open[i + 1].corners);
    tetrahedra_[tetrahedron_of(f)].neighbours[place_of(f)] = g;
    tetrahedra_[tetrahedron_of(g)].neighbours[place_of(g)] = f;
  }
}

}  // namespace morskin::geometry
