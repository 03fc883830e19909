#include "morse/line_order.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace morskin::morse {

namespace {

/// Lines this many merge distances apart are certainly different.
constexpr double safely_apart = 32;
/// Lines nearer than this share of rho on every level down to their end bound a strip of skin with
/// nothing else between them; so the side read on one level holds on all.
constexpr double strip_width = 0.1;

/// The lowest level read, as a share of the rise of a line's first piece; nearer to the saddle the
/// differences are rounding.
constexpr double nearest_level = 1e-6;

struct Side {
  double gap = 0;  ///< signed, positive when the second line is counter-clockwise of the first
  double rho = 1;
  bool is_known = false;
};

class Pair {
 public:
  Pair(const IntegralLines& lines, const ArrivingLine& a, const ArrivingLine& b)
      : lines_(lines), a_(a), b_(b) {
    read_side();
  }

  bool is_second_after() const { return side_.gap > 0; }
  bool is_certain() const {
    return side_.is_known &&
           std::abs(side_.gap) > safely_apart * lines_.merge_distance(side_.rho) / 2;
  }
  /// The level from which on they are indistinguishable, if any.
  std::optional<double> meeting() const { return meeting_; }

 private:
  /// The gap where the first line passes `p`. About an extremum, counter-clockwise is velocity x
  /// normal.
  Side side_at(double level, const std::optional<IntegralLines::Passage>& p) const {
    const auto q = lines_.passage(b_.nodes, level);
    if (!p || !q) return {};
    const Vector gap = q->position - p->position;
    const Vector across = p->velocity.cross(p->normal);
    return {std::copysign(gap.norm(), gap.dot(across)), p->length_scale, true};
  }

  bool is_apart(const Side& side) const {
    return std::abs(side.gap) > safely_apart * lines_.merge_distance(side.rho);
  }

  Side side_at(double level) const { return side_at(level, lines_.passage(a_.nodes, level)); }

  /// Goes up the first line, node by node, to a level where the two are apart.
  void read_side() {
    const auto value = [&](std::size_t i) { return lines_.function()(a_.nodes.points[i]); };
    std::optional<double> below;
    for (std::size_t i = a_.nodes.points.size() - 2; i > 0; --i) {
      const double level = value(i);
      if (decides(level, side_at(level, lines_.passage_at(a_.nodes, i)), below)) return;
      below = level;
    }
    // The second line passes the first one's saddle: on levels nearer to it their gap grows.
    const double start = value(0), first = value(1);
    for (double share = 0.25; share > nearest_level; share /= 4) {
      const double level = start + share * (first - start);
      if (decides(level, side_at(level), below)) return;
      below = level;
    }
  }

  /// Whether the sides on this level end the search.
  bool decides(double level, Side side, std::optional<double> below) {
    if (!side.is_known) {
      // The level is beyond the second line's last piece, or past its saddle: then the first line
      // passes that saddle, and its side of the saddle decides.
      const double start = lines_.function()(b_.nodes.points.front());
      const bool is_past = b_.nodes.direction == Direction::Down ? level > start : level < start;
      if (!is_past) return false;
      side = side_at(start + (below.value_or(start) - start) * nearest_level);
      if (side.is_known) side_ = side;
      return true;
    }
    // If they separate suddenly between two nodes, bisect for the level where they begin to.
    for (int i = 0; i < 60 && below && std::abs(side.gap) > strip_width * side.rho; ++i) {
      const double middle = (level + *below) / 2;
      const Side between = side_at(middle);
      if (!between.is_known) break;
      if (is_apart(between)) {
        level = middle;
        side = between;
      } else {
        below = middle;
        note_meeting(middle, between);
      }
    }
    side_ = side;
    note_meeting(level, side);
    return is_apart(side);
  }

  void note_meeting(double level, const Side& side) {
    if (std::abs(side.gap) < lines_.merge_distance(side.rho)) meeting_ = level;
  }

  const IntegralLines& lines_;
  const ArrivingLine &a_, &b_;
  Side side_;
  std::optional<double> meeting_;
};

/// Sorts the lines by angle, then each group that the angles do not separate.
class Orderer {
 public:
  Orderer(const IntegralLines& lines, std::vector<ArrivingLine> arriving)
      : lines_(lines), arriving_(std::move(arriving)) {}

  LineOrder order() {
    std::sort(arriving_.begin(), arriving_.end(), [](const ArrivingLine& a, const ArrivingLine& b) {
      return std::pair(a.arrival.angle, a.id) < std::pair(b.arrival.angle, b.id);
    });
    const std::size_t n = arriving_.size();
    std::size_t start = 0;  // the first line of a group
    while (start < n && is_doubtful((start + n - 1) % n, start)) ++start;
    if (n > 1 && start == n) order_.is_certain = false;
    std::rotate(arriving_.begin(),
                arriving_.begin() + static_cast<std::ptrdiff_t>(start == n ? 0 : start),
                arriving_.end());
    for (std::size_t first = 0; first < n;) {
      std::size_t last = first;
      while (last + 1 < n && is_doubtful(last, last + 1)) ++last;
      sort_group(first, last + 1);
      first = last + 1;
    }
    for (const ArrivingLine& line : arriving_) order_.ids.push_back(line.id);
    return std::move(order_);
  }

 private:
  /// Whether the angles do not separate line i from j, the next about the extremum.
  bool is_doubtful(std::size_t i, std::size_t j) const {
    if (i == j) return false;
    const Arrival &a = arriving_[i].arrival, &b = arriving_[j].arrival;
    const double turn = b.angle - a.angle + (j == 0 ? 2 * std::numbers::pi : 0);
    const double rho = lines_.points()[a.extremum.index()].point.length_scale;
    return turn < safely_apart * lines_.merge_distance(rho) / std::min(a.radius, b.radius);
  }

  void sort_group(std::size_t first, std::size_t end) {
    if (end - first < 2) return;
    const auto at = [&](std::size_t i) { return arriving_.begin() + static_cast<long>(i); };
    std::sort(at(first), at(end),
              [](const ArrivingLine& a, const ArrivingLine& b) { return a.id < b.id; });
    // Insertion sort, by rising id.
    for (std::size_t i = first + 1; i < end; ++i) {
      std::size_t low = first, high = i;
      std::optional<Merge> merge;
      while (low < high) {
        const std::size_t middle = (low + high) / 2;
        const Pair pair(lines_, arriving_[middle], arriving_[i]);
        if (!pair.is_certain()) order_.is_certain = false;
        if (const auto level = pair.meeting()) {
          const double up = arriving_[i].nodes.direction == Direction::Down ? 1 : -1;
          if (!merge || up * *level > up * merge->level) {
            merge = Merge{arriving_[i].id, arriving_[middle].id, *level};
          }
        }
        (pair.is_second_after() ? low : high) = pair.is_second_after() ? middle + 1 : middle;
      }
      if (merge) order_.merges.push_back(*merge);
      std::rotate(at(low), at(i), at(i + 1));
    }
  }

  const IntegralLines& lines_;
  std::vector<ArrivingLine> arriving_;
  LineOrder order_;
};

}  // namespace

LineOrder order_of(const IntegralLines& lines, std::vector<ArrivingLine> arriving) {
  return Orderer(lines, std::move(arriving)).order();
}

}  // namespace morskin::morse
