#include "morse/morse_smale_complex.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <thread>
#include <utility>

#include "geometry/parallel.h"
#include "geometry/sort_unique.h"
#include "geometry/union_find.h"
#include "morse/line_order.h"
#include "morse/saddle_lines.h"

namespace morskin::morse {

namespace {

using skin::CellId;

/// Where it is, for messages.
std::string location(const CriticalPoint& p) { return position_text(p.point.position); }

class Builder {
 public:
  Builder(const skin::SkinSurface& skin, const MorseFunction& f, const CriticalPoints& critical,
          Polylines polylines, const geometry::Run& run)
      : skin_(skin),
        f_(f),
        run_(run),
        polylines_(polylines),
        lines_(
            skin, f, critical.points, run,
            polylines == Polylines::Keep ? SaddleLines::Kept::All : SaddleLines::Kept::EveryOther) {
    complex_.points = critical.points;
    complex_.degeneracies = critical.degeneracies;
  }

  MorseSmaleComplex build() {
    if (!take_arcs()) return undecided();
    orders_.resize(complex_.points.size());
    is_stale_.assign(complex_.points.size(), 1);
    // Traces doubtful lines again, finer, until all are certain or no finer step is left.
    do {
      order_arcs();
      find_regions();
    } while (refine_doubtful());
    if (complex_.arcs.size() < lines_.size()) return undecided();
    report_doubts();
    if (polylines_ == Polylines::Keep) build_polylines();
    count_components();
    return std::move(complex_);
  }

 private:
  const CriticalPoint& point(CriticalId id) const { return complex_.points[id.index()]; }
  void report(std::string what) { complex_.degeneracies.push_back(std::move(what)); }

  /// The points and degeneracies alone.
  MorseSmaleComplex undecided() {
    MorseSmaleComplex empty;
    empty.points = std::move(complex_.points);
    empty.degeneracies = std::move(complex_.degeneracies);
    empty.ends.first.assign(empty.points.size() + 1, 0);
    empty.first_point.assign(1, 0);
    return empty;
  }

  /// @return whether every line has arrived; if not, there are no arcs.
  bool take_arcs() {
    complex_.arcs.clear();
    bool all = true;
    for (std::uint32_t a = 0; a < lines_.size(); ++a) {
      const Course& course = lines_.course(a);
      if (course.arrival) {
        complex_.arcs.push_back({lines_.saddle(a), course.arrival->extremum});
        continue;
      }
      all = false;
      const std::string end =
          course.saddle       ? "runs into the saddle " + location(point(*course.saddle))
          : course.is_at_rest ? "comes to rest where the function is flat within rounding"
                              : "finds no extremum";
      report("the integral line from the saddle " + location(point(lines_.saddle(a))) + " " + end);
    }
    if (!all) complex_.arcs.clear();
    return all;
  }

  /// Lists the arcs that end at each extremum, and sorts them where their order is stale.
  void order_arcs() {
    const std::size_t n = complex_.points.size();
    complex_.ends = geometry::grouped<ArcId>(n, [&](auto visit) {
      for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
        visit(complex_.arcs[a].extremum.index(), ArcId{a});
      }
    });
    constexpr std::size_t block_size = 16;    // points: about half a millisecond
    constexpr std::size_t report_every = 64;  // blocks
    const auto teller = std::this_thread::get_id();
    const auto sort_ends = [&](std::size_t begin, std::size_t end, std::size_t block) {
      if ((block + 1) % report_every == 0 && std::this_thread::get_id() == teller) {
        run_.report(geometry::unknown_share);
      }
      for (std::size_t i = begin; i < end; ++i) {
        const std::span ends = complex_.ends.of(i);
        if (std::exchange(is_stale_[i], 0) != 0) orders_[i] = order_at(ends);
        std::transform(orders_[i].ids.begin(), orders_[i].ids.end(), ends.begin(),
                       [](std::uint32_t a) { return ArcId{a}; });
      }
    };
    geometry::for_each_block(run_.threads(), n, sort_ends, block_size);
  }

  LineOrder order_at(std::span<const ArcId> ends) const {
    std::vector<ArrivingLine> arriving;
    int fineness = SaddleLines::finest;  // of the coarsest line
    for (const ArcId a : ends) {
      arriving.push_back({a.value, lines_.nodes(a.value), *lines_.course(a.value).arrival});
      fineness = std::min(fineness, lines_.fineness(a.value));
    }
    return order_of(lines_.tracer(fineness), std::move(arriving));
  }

  /// Refines the lines that end at an extremum with an uncertain order or bound a face that is no
  /// quadrangle. @return whether there were any.
  bool refine_doubtful() {
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      if (orders_[i].is_certain) continue;
      doubtful_.insert(doubtful_.end(), orders_[i].ids.begin(), orders_[i].ids.end());
    }
    geometry::sort_unique(doubtful_);
    bool any = false;
    for (const std::uint32_t a : doubtful_) {
      const Course before = lines_.course(a);
      if (!lines_.refine(a)) continue;
      any = true;
      is_stale_[before.arrival->extremum.index()] = 1;
      const auto& arrival = lines_.course(a).arrival;
      if (arrival) is_stale_[arrival->extremum.index()] = 1;
    }
    return any && take_arcs();
  }

  void report_doubts() {
    for (std::size_t i = 0; i < orders_.size(); ++i) {
      if (orders_[i].is_certain) continue;
      report("integral lines to the extremum " + location(complex_.points[i]) +
             " are too near to each other to be told apart");
    }
    // One quadrangle for each descending arc.
    const std::size_t expected = complex_.arcs.size() / 2;
    if (complex_.regions.size() < expected) {
      report("rounding leaves the ends of integral lines undecided: only " +
             std::to_string(complex_.regions.size()) + " of " + std::to_string(expected) +
             " regions are quadrangles");
      complex_.regions.clear();
    }
  }

  /// Builds the polylines; a merged line ends with its parent's end.
  void build_polylines() {
    std::vector<Merge> merges;
    for (const LineOrder& order : orders_) {
      merges.insert(merges.end(), order.merges.begin(), order.merges.end());
    }
    std::sort(merges.begin(), merges.end(),
              [](const Merge& a, const Merge& b) { return a.child < b.child; });
    complex_.merged_lines = merges.size();
    auto merge = merges.begin();
    complex_.line_points.reserve(lines_.node_count());
    for (std::uint32_t a = 0; a < complex_.arcs.size(); ++a) {
      complex_.first_point.push_back(static_cast<std::uint32_t>(complex_.line_points.size()));
      const std::span<const Point> own = lines_.nodes(a).points;
      if (merge == merges.end() || merge->child != a) {
        complex_.line_points.insert(complex_.line_points.end(), own.begin(), own.end());
        continue;
      }
      const double sign = lines_.direction(a) == Direction::Up ? 1 : -1;
      for (const Point& x : own) {
        if (sign * (f_(x) - merge->level) < 0) complex_.line_points.push_back(x);
      }
      // By index, since the array grows.
      const std::uint32_t end = complex_.first_point[merge->parent + 1];
      for (std::uint32_t i = complex_.first_point[merge->parent]; i < end; ++i) {
        const Point x = complex_.line_points[i];
        if (sign * (f_(x) - merge->level) >= 0) complex_.line_points.push_back(x);
      }
      ++merge;
    }
    complex_.first_point.push_back(static_cast<std::uint32_t>(complex_.line_points.size()));
  }

  /// A dart is a directed arc: 2 a from the saddle, 2 a + 1 from the extremum.
  /// @return  by dart, the next dart of the face on its left: it leaves the dart's end, next
  ///          clockwise after the opposite dart
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
    complex_.regions.clear();
    doubtful_.clear();
    const std::vector<std::uint32_t> next = successors();
    // [excerpt: regions]
    // A quadrangle has one dart from its minimum to a saddle, and each such dart one face; so the
    // faces found from those darts are all, if every one closes after four.
    for (std::uint32_t a = 0; a < complex_.arcs.size(); a += 2) {
      const std::uint32_t start = 2 * a + 1, second = next[start], third = next[second],
                          last = next[third];
      if (next[last] == start && lines_.direction(second / 2) == Direction::Up) {
        complex_.regions.push_back({complex_.arcs[a].extremum, complex_.arcs[a].saddle,
                                    complex_.arcs[second / 2].extremum,
                                    complex_.arcs[third / 2].saddle});
        continue;
      }
      std::uint32_t dart = start;
      do {
        doubtful_.push_back(dart / 2);
        dart = next[dart];
      } while (dart != start);
    }
    // [/excerpt]
  }

  void count_components() {
    geometry::UnionFind sets(complex_.points.size());
    for (const Arc& arc : complex_.arcs) sets.join(arc.saddle.value, arc.extremum.value);
    for (std::uint32_t i = 0; i < complex_.points.size(); ++i) {
      if (complex_.points[i].index != 0 || !complex_.arcs_at(CriticalId{i}).empty()) continue;
      if (const auto top = maximum_above(CriticalId{i})) {
        sets.join(i, top->value);
      } else {
        report("the integral line from beside the minimum " + location(complex_.points[i]) +
               " finds no maximum");
      }
    }
    for (std::uint32_t i = 0; i < complex_.points.size(); ++i) {
      complex_.components += sets.root(i) == i;
    }
  }

  /// The maximum at the end of a line from beside a minimum.
  std::optional<CriticalId> maximum_above(CriticalId minimum) const {
    const surface::SurfacePoint& at = point(minimum).point;
    constexpr double beside = 0.1;  // of rho, or half the distance to the nearest wall
    const double away =
        std::min(beside * at.length_scale, lines_.tracer(0).wall_distance(minimum) / 2);
    const Point x = at.position + away * at.normal.unitOrthogonal();
    const auto start = skin_.project(x, at.cell);
    if (!start) return std::nullopt;
    std::vector<Point> points;
    std::vector<CellId> cells;
    const Course course = lines_.tracer(0).trace(*start, Direction::Up, points, cells);
    if (!course.arrival) return std::nullopt;
    return course.arrival->extremum;
  }

  const skin::SkinSurface& skin_;
  MorseFunction f_;
  const geometry::Run& run_;
  Polylines polylines_;
  MorseSmaleComplex complex_;
  SaddleLines lines_;
  std::vector<LineOrder> orders_;  ///< by point
  std::vector<char> is_stale_;     ///< by point: whether its order must be computed again
  std::vector<std::uint32_t> doubtful_;
};

}  // namespace

MorseSmaleComplex morse_smale_complex(const skin::SkinSurface& skin, const MorseFunction& f,
                                      const CriticalPoints& critical, Polylines polylines,
                                      const geometry::Run& run) {
  return Builder(skin, f, critical, polylines, run).build();
}

}  // namespace morskin::morse
