#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "geometry/error.h"
#include "geometry/predicates_internal.h"
#include "geometry/spatial_order.h"
#include "geometry/triangulator_hole.h"

namespace morskin::geometry {
namespace {

constexpr Triangulator::Facet unlinked = 0xffffffff;

constexpr Triangulator::Facet facet_of(std::uint32_t tetrahedron, std::size_t place) {
  return tetrahedron << 2 | static_cast<std::uint32_t>(place);
}

/// The places around the facet opposite each place, all turning the same way.
constexpr std::array<std::array<std::size_t, 3>, 4> indices_around{
    {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}};

/// The greatest power of two up to |x|, times 2^shift; for zero, 2^shift.
double scaled_power_of_two(double x, int shift) {
  return std::ldexp(1.0, (x == 0 ? 0 : std::ilogb(x)) + shift);
}

/// By facet of the first tetrahedron and its ghosts, the other one with the same corners. Which one
/// that is does not depend on the corners' numbers.
std::array<Triangulator::Facet, 20> facets_behind_first(
    std::span<const Triangulator::Tetrahedron> tetrahedra) {
  const auto corners_of = [&](Triangulator::Facet f) {
    std::array<Triangulator::Corner, 4> corners =
        tetrahedra[Triangulator::tetrahedron_of(f)].corners;
    std::swap(corners[Triangulator::index_of(f)], corners[3]);
    std::sort(corners.begin(), corners.begin() + 3);
    return std::array{corners[0], corners[1], corners[2]};
  };
  std::array<Triangulator::Facet, 20> behind{};
  for (Triangulator::Facet f = 0; f < 20; ++f) {
    for (Triangulator::Facet g = 0; g < 20; ++g) {
      if (f != g && corners_of(f) == corners_of(g)) behind[f] = g;
    }
  }
  return behind;
}

}  // namespace

Triangulator::Triangulator(std::span<const WeightedPoint> points, const Told& told)
    : atom_count_(points.size()) {
  if (points.size() > max_points) fail_for_lack_of_ids(max_points, "atoms");
  if (points.empty()) return;
  std::vector<AtomId> order = spatial_order(points);
  find_first_tetrahedron(points, order);
  points_.reserve(points.size() + 3);
  ids_ = std::move(order);
  for (const AtomId id : ids_) points_.push_back({points[id.index()]});
  if (dimension_ < 1) return;
  add_apexes(points);
  tetrahedra_.reserve(8 * points_.size());
  states_.reserve(8 * points_.size());
  rim_numbers_.resize(points_.size() + 1);
  make_first_tetrahedron();
  for (std::size_t p = static_cast<std::size_t>(dimension_) + 1; p < atom_count_; ++p) {
    insert(static_cast<Corner>(p));
    constexpr std::size_t points_between_reports = 4096;
    if (told && p % points_between_reports == 0) {
      told(static_cast<double>(p) / static_cast<double>(atom_count_));
    }
  }
}

/// Moves affinely independent points to the front of the order, as many as there are.
void Triangulator::find_first_tetrahedron(std::span<const WeightedPoint> points,
                                          std::vector<AtomId>& order) {
  const auto at = [&](std::size_t i) -> const Point& { return points[order[i].index()].position; };
  dimension_ = 0;
  for (std::size_t i = 1; i < order.size() && dimension_ < 3; ++i) {
    const bool is_independent = dimension_ == 0 ? at(i) != at(0)
                                : dimension_ == 1
                                    ? !are_collinear(at(0), at(1), at(i))
                                    : orientation(at(0), at(1), at(2), at(i)) != Sign::Zero;
    if (!is_independent) continue;
    ++dimension_;
    std::swap(order[static_cast<std::size_t>(dimension_)], order[i]);
  }
}

/// An apex is the first point moved along an axis, which leaves the span of the points before it
/// for at least one of the three. The move is a power of two, to stay on the exact grid; at most
/// half the points' extent and towards the origin, to stay in range; and far above rounding.
void Triangulator::add_apexes(std::span<const WeightedPoint> points) {
  Point low = points[0].position;
  Point high = low;
  for (const WeightedPoint& p : points) {
    low = low.cwiseMin(p.position);
    high = high.cwiseMax(p.position);
  }
  const double step = scaled_power_of_two((high - low).maxCoeff(), -1);
  for (int known = dimension_; known < 3; ++known) {
    for (int axis = 0; axis < 3; ++axis) {
      Point apex = points_[0].position;
      const double reach = std::max({step, scaled_power_of_two(apex[axis], -40), 0x1p-64});
      apex[axis] += apex[axis] > 0 ? -reach : reach;
      const Point& second = points_[1].position;
      const bool is_independent =
          known == 1 ? !are_collinear(points_[0].position, second, apex)
                     : orientation(points_[0].position, second,
                                   dimension_ == 2 ? points_[2].position : points_.back().position,
                                   apex) != Sign::Zero;
      if (!is_independent) continue;
      points_.push_back({{apex, 0}});
      ids_.push_back(AtomId(ids_.size()));
      break;
    }
  }
}

/// The first four corners and, behind facet i, a ghost: the tetrahedron with corner i sent to
/// infinity, through the facet, and turned so that infinity is its last corner.
void Triangulator::make_first_tetrahedron() {
  std::array<Corner, 4> first{};
  for (std::size_t k = 0; k < 4; ++k) {
    const auto real = static_cast<std::size_t>(dimension_) + 1;
    first[k] = static_cast<Corner>(k < real ? k : atom_count_ + k - real);
  }
  const auto position = [&](std::size_t k) -> const Point& { return points_[first[k]].position; };
  if (orientation(position(0), position(1), position(2), position(3)) == Sign::Negative) {
    std::swap(first[0], first[1]);
  }
  tetrahedra_.push_back({first, {unlinked, unlinked, unlinked, unlinked}});
  for (std::size_t i = 0; i < 4; ++i) {
    std::array<Corner, 4> ghost = first;
    i == 3 ? std::swap(ghost[0], ghost[1]) : std::swap(ghost[i], ghost[3]);
    ghost[3] = infinity;
    tetrahedra_.push_back({ghost, {unlinked, unlinked, unlinked, unlinked}});
  }
  states_.assign(5, State::Live);
  static const std::array<Facet, 20> behind = facets_behind_first(tetrahedra_);
  for (Facet f = 0; f < 20; ++f) tetrahedra_[tetrahedron_of(f)].neighbours[index_of(f)] = behind[f];
}

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
  const bool is_reused = !removed_corners_.empty();
  if (!is_reused && atom_count_ >= max_points) fail_for_lack_of_ids(max_points, "points");
  const auto p = is_reused ? removed_corners_.back() : static_cast<Corner>(atom_count_);
  if (is_reused) {
    points_[p] = {point};
  } else {
    points_.push_back({point});
    ids_.push_back(AtomId(atom_count_));
    rim_numbers_.resize(points_.size() + 1);
  }
  const auto* hint = std::find_if(hints.begin(), hints.end(),
                                  [&](std::uint32_t t) { return is_in_conflict(t, p); });
  last_ = hint != hints.end() ? *hint : hints[0];
  if (hint == hints.end()) last_ = locate(p);
  if (hint == hints.end() && !is_in_conflict(last_, p)) {
    if (!is_reused) {
      points_.pop_back();
      ids_.pop_back();
    }
    return std::nullopt;
  }
  grow_cavity(p);
  // A new id, the greatest, would have lost that tie.
  if (is_reused && cavity_has_equal(points_[p])) {
    for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Live;
    return std::nullopt;
  }
  is_reused ? removed_corners_.pop_back() : void(++atom_count_);
  fill_cavity(p);
  return p;
}

/// Walks from the last place towards p, each step through a facet with p strictly behind it, until
/// there is none or the hull is left. In a regular triangulation such a walk never cycles.
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

bool Triangulator::cavity_has_equal(const WeightedPoint& point) const {
  for (std::size_t i = 0; i < cavity_size_; ++i) {
    for (const Corner c : tetrahedra_[cavity_[i]].corners) {
      if (c != infinity && points_[c].position == point.position &&
          points_[c].weight == point.weight) {
        return true;
      }
    }
  }
  return false;
}

/// Joins p to every facet of the rim. Each filler is the cavity's tetrahedron there with the
/// opposite corner replaced by p, so orientation and infinity's place are inherited.
void Triangulator::fill_cavity(Corner p) {
  fillers_.clear();
  for (std::size_t i = 0; i < rim_size_; ++i) {
    const std::size_t place = index_of(rim_[i]);
    const std::uint32_t filler = allocate();
    const Tetrahedron& inner = tetrahedra_[tetrahedron_of(rim_[i])];
    const Facet outer = inner.neighbours[place];
    Tetrahedron& t = tetrahedra_[filler];
    t.corners = inner.corners;
    t.corners[place] = p;
    t.neighbours = {unlinked, unlinked, unlinked, unlinked};
    t.neighbours[place] = outer;
    tetrahedra_[tetrahedron_of(outer)].neighbours[index_of(outer)] = facet_of(filler, place);
    fillers_.push_back(filler);
  }
  // A rim with F triangles is a sphere, with F / 2 + 2 corners.
  rim_size_ / 2 + 2 <= table_side ? link_by_table() : link_by_turning();
  free_cavity();
  last_ = fillers_.back();
}

void Triangulator::free_cavity() {
  for (std::size_t i = 0; i < cavity_size_; ++i) states_[cavity_[i]] = State::Free;
  free_.insert(free_.end(), cavity_.begin(),
               cavity_.begin() + static_cast<std::ptrdiff_t>(cavity_size_));
}

/// Links the fillers to one another. The new facet of a filler that contains p and the edge uv of
/// the rim faces the new facet of another filler that contains p and vu. The rim's corners get
/// small numbers, by which a table holds the facet at each directed edge.
void Triangulator::link_by_table() {
  std::array<std::array<std::uint32_t, 3>, 2 * table_side> numbers;
  std::uint32_t count = 0;
  next_stamp();
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

/// A stamp that no corner has.
std::uint32_t Triangulator::next_stamp() {
  if (++stamp_ == 0) {
    std::fill(rim_numbers_.begin(), rim_numbers_.end(), RimNumber{});
    ++stamp_;
  }
  return stamp_;
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
