#include "morse/morse_smale_complex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <utility>

#include "morse/integral_lines.h"
#include "morse/line_order.h"

namespace morskin::morse {

namespace {

using skin::CellId;

std::string place_of(const CriticalPoint& p) {
  const Point& x = p.point.position;
  std::string text("(");
  text += std::to_string(x.x()) + ", " + std::to_string(x.y()) + ", " + std::to_string(x.z());
  return text + ")";
}

/// The smallest of a set stands for it.
class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void unite(std::uint32_t a, std::uint32_t b) {
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

/// The nodes of all lines, by arc.
struct Nodes {
  std::vector<Point> points;
  std::vector<CellId> cells;
  std::vector<std::uint32_t> first;
};

class Builder {
 public:
  Builder(const skin::SkinSurface& skin, const MorseFunction& f, const CriticalPoints& critical,
          double step)
      : skin_(skin), f_(f), lines_(skin, f, critical.points, step) {
    complex_.points = critical.points;
    complex_.degeneracies = critical.degeneracies;
  }

  MorseSmaleComplex build() {
    if (!trace_lines()) {
      complex_.arcs.clear();
      return std::move(complex_);
    }
    order_arcs();
    lay_lines();
    find_regions();
    count_components();
    return std::move(complex_);
  }

 private:
  const CriticalPoint& point(CriticalId id) const { return complex_.points[id.index()]; }

  struct Departure {
    Vector tangent;
    Way way;
  };
  /// The tangents of a saddle's four arcs, counter-clockwise seen from outside.
  static std::array<Departure, 4> departures(const CriticalPoint& saddle) {
    const Vector& down = saddle.descending;
    const bool turns = saddle.point.normal.cross(down).dot(saddle.ascending) > 0;
    const Vector up = turns ? saddle.ascending : Vector(-saddle.ascending);
    return {{{down, Way::Down}, {up, Way::Up}, {-down, Way::Down}, {-up, Way::Up}}};
  }

  void report(std::string what) { complex_.degeneracies.push_back(std::move(what)); }

  bool trace_lines() {
    bool all = true;
    std::size_t arcs = 0;
    for (const CriticalPoint& p : complex_.points) arcs += p.index == 1 ? 4 : 0;
    constexpr std::size_t usual_nodes = 90;  // of a line, on average
    nodes_.points.reserve(usual_nodes * arcs);
    nodes_.cells.reserve(usual_nodes * arcs);
    for (std::size_t i = 0; i < complex_.points.size(); ++i) {
      if (complex_.points[i].index != 1) continue;
      for (const Departure& departure : departures(complex_.points[i])) {
        nodes_.first.push_back(static_cast<std::uint32_t>(nodes_.points.size()));
        const Course course = lines_.trace(CriticalId{i}, departure.tangent, departure.way,
                                           nodes_.points, nodes_.cells);
        if (!course.arrival) {
          report("the integral line from the saddle at " + place_of(complex_.points[i]) +
                 (course.saddle ? " runs into the saddle at " + place_of(point(*course.saddle))
                                : std::string(" finds no extremum")));
          all = false;
          continue;
        }
        complex_.arcs.push_back({CriticalId{i}, course.arrival->extremum});
        departures_.push_back(departure);
        arrivals_.push_back(*course.arrival);
      }
    }
    nodes_.first.push_back(static_cast<std::uint32_t>(nodes_.points.size()));
    return all;
  }

  LineNodes nodes_of(std::uint32_t arc) const {
    const std::size_t first = nodes_.first[arc], count = nodes_.first[arc + 1] - first;
    return {complex_.arcs[arc].saddle,
            departures_[arc].tangent,
            departures_[arc].way,
            {nodes_.points.data() + first, count},
            {nodes_.cells.data() + first, count}};
  }

  void order_arcs() {
    const std::size_t n = complex_.points.size();
    std::vector<std::uint32_t>& first = complex_.first_end;
    first.assign(n + 1, 0);
    for (const Arc& arc : complex_.arcs) ++first[arc.extremum.index() + 1];
    std::partial_sum(first.begin(), first.end(), first.begin());
    complex_.ends.resize(complex_.arcs.size());
    std::vector<std::uint32_t> filled(first.begin(), first.end() - 1);
    for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
      complex_.ends[filled[complex_.arcs[a].extremum.index()]++] = ArcId{a};
    }
    std::vector<ArrivingLine> arriving;
    for (std::size_t i = 0; i < n; ++i) {
      arriving.clear();
      for (std::uint32_t e = first[i]; e < first[i + 1]; ++e) {
        const std::uint32_t a = complex_.ends[e].value;
        arriving.push_back({a, nodes_of(a), arrivals_[a]});
      }
      const LineOrder order = order_of(lines_, arriving);
      for (std::size_t k = 0; k < order.ids.size(); ++k) {
        complex_.ends[first[i] + k] = ArcId{order.ids[k]};
      }
      merges_.insert(merges_.end(), order.merges.begin(), order.merges.end());
      if (!order.is_certain) {
        report("integral lines to the extremum at " + place_of(complex_.points[i]) +
               " are too near to each other to be told apart");
      }
    }
    complex_.merged_lines = merges_.size();
  }

  /// The polylines, children's with the ends of their parents'.
  void lay_lines() {
    std::sort(merges_.begin(), merges_.end(),
              [](const Merge& a, const Merge& b) { return a.child < b.child; });
    auto merge = merges_.begin();
    complex_.line_points.reserve(nodes_.points.size());
    for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
      complex_.first_point.push_back(static_cast<std::uint32_t>(complex_.line_points.size()));
      const std::span<const Point> own = nodes_of(a).points;
      if (merge == merges_.end() || merge->child != a) {
        complex_.line_points.insert(complex_.line_points.end(), own.begin(), own.end());
        continue;
      }
      const double way = departures_[a].way == Way::Up ? 1 : -1;
      for (const Point& x : own) {
        if (way * (f_(x) - merge->level) < 0) complex_.line_points.push_back(x);
      }
      // By place, as the array grows.
      const std::uint32_t end = complex_.first_point[merge->parent + 1];
      for (std::uint32_t i = complex_.first_point[merge->parent]; i < end; ++i) {
        const Point x = complex_.line_points[i];
        if (way * (f_(x) - merge->level) >= 0) complex_.line_points.push_back(x);
      }
      ++merge;
    }
    complex_.first_point.push_back(static_cast<std::uint32_t>(complex_.line_points.size()));
  }

  /// A dart is an arc with a direction: 2 a from the saddle, 2 a + 1 from the extremum.
  /// @return  by dart, the dart that leaves where it ends, the next clockwise after its own
  /// opposite: both have the same face on their left.
  std::vector<std::uint32_t> successors() const {
    std::vector<std::uint32_t> next(2 * complex_.arcs.size());
    for (std::size_t i = 0; i < complex_.points.size(); ++i) {
      const auto arcs = complex_.arcs_at(CriticalId{i});
      for (std::size_t k = 0; k < arcs.size(); ++k) {
        const ArcId before = arcs[(k + arcs.size() - 1) % arcs.size()];
        next[2 * arcs[k].value] = 2 * before.value + 1;
      }
    }
    for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
      next[2 * a + 1] = 2 * (a % 4 == 0 ? a + 3 : a - 1);
    }
    return next;
  }

  void find_regions() {
    const std::vector<std::uint32_t> next = successors();
    // A quadrangle has one dart from its minimum to a saddle, and each such dart one face; so the
    // faces found from those darts are all, if every one closes after four.
    std::size_t odd = 0;
    for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
      if (departures_[a].way == Way::Up) continue;
      const std::uint32_t start = 2 * a + 1, second = next[start], third = next[second],
                          last = next[third];
      const bool is_quadrangle = next[last] == start && departures_[second / 2].way == Way::Up;
      if (!is_quadrangle) {
        ++odd;
        continue;
      }
      complex_.regions.push_back({complex_.arcs[a].extremum, complex_.arcs[a].saddle,
                                  complex_.arcs[second / 2].extremum,
                                  complex_.arcs[third / 2].saddle});
    }
    if (odd > 0) {
      report(std::to_string(odd) + " regions are not quadrangles");
      complex_.regions.clear();
    }
  }

  void count_components() {
    DisjointSets sets(complex_.points.size());
    for (const Arc& arc : complex_.arcs) sets.unite(arc.saddle.value, arc.extremum.value);
    for (std::uint32_t i = 0; i < complex_.points.size(); ++i) {
      if (complex_.points[i].index != 0 || !complex_.arcs_at(CriticalId{i}).empty()) continue;
      if (const auto top = maximum_above(CriticalId{i})) {
        sets.unite(i, top->value);
      } else {
        report("the integral line from beside the minimum at " + place_of(complex_.points[i]) +
               " finds no maximum");
      }
    }
    for (std::uint32_t i = 0; i < complex_.points.size(); ++i) {
      complex_.components += sets.root(i) == i;
    }
  }

  /// The maximum at the end of a line from beside a minimum.
  std::optional<CriticalId> maximum_above(CriticalId minimum) const {
    const skin::SurfacePoint& at = point(minimum).point;
    constexpr double beside = 0.1;  // of rho, or half of the way to the nearest wall
    const double away = std::min(beside * at.length_scale, lines_.wall_distance(minimum) / 2);
    const Point x = at.position + away * at.normal.unitOrthogonal();
    const auto start = skin_.project(x, at.cell);
    if (!start) return std::nullopt;
    std::vector<Point> points;
    std::vector<CellId> cells;
    const Course course = lines_.trace(*start, Way::Up, points, cells);
    if (!course.arrival) return std::nullopt;
    return course.arrival->extremum;
  }

  const skin::SkinSurface& skin_;
  MorseFunction f_;
  MorseSmaleComplex complex_;
  IntegralLines lines_;
  Nodes nodes_;
  std::vector<Departure> departures_;  ///< by arc
  std::vector<Arrival> arrivals_;      ///< by arc
  std::vector<Merge> merges_;
};

}  // namespace

MorseSmaleComplex morse_smale_complex(const skin::SkinSurface& skin, const MorseFunction& f,
                                      CriticalPoints critical) {
  MorseSmaleComplex complex;
  // Should a line pass a saddle on the wrong side for its error, half the step has 1/256 of it.
  for (const double share : {1.0, 0.5, 0.25}) {
    complex = Builder(skin, f, critical, share * IntegralLines::usual_step).build();
    if (complex.degeneracies.size() == critical.degeneracies.size()) break;
  }
  return complex;
}

}  // namespace morskin::morse
