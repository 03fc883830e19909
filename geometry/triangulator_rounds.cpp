// The part of Triangulator that inserts the points, in several regions at once where they are many.

#include <algorithm>
#include <atomic>
#include <mutex>
#include <tuple>
#include <utility>

#include "geometry/dissection.h"
#include "geometry/parallel.h"
#include "geometry/triangulator.h"

namespace morskin::geometry {

/// Inserts points, and reports.
class Triangulator::Batches {
 public:
  Batches(Triangulator& to, const Run& run, std::size_t region)
      : to_(to), run_(run), region_(std::max<std::size_t>(region, 1)) {}

  /// Halves space as often as each half keeps points enough, and inserts from the smallest regions
  /// up. The last are few, near the first cut.
  void insert(std::span<const Corner> points) {
    const int depth = depth_for(points.size());
    if (depth == 0) return insert_all(points);
    const Dissection space(sample(points), depth);
    assign_tetrahedra(space);
    std::vector<Lists> at_height{by_leaf(points, space)};
    for (int height = 1; height <= depth; ++height) at_height.emplace_back(1U << (depth - height));
    for (int height = 0; height < depth; ++height) insert_in_regions(at_height, height);
    std::vector<Corner>& last = at_height.back()[0];
    std::ranges::sort(last);
    insert_all(last);
  }

 private:
  using Lists = std::vector<std::vector<Corner>>;  ///< by region
  struct Refused {
    Corner point;
    int next_height;  ///< at which it may be tried again
  };
  int depth_for(std::size_t count) const {
    int depth = 0;
    while (depth < whole && count >> (depth + 1) >= region_) ++depth;
    return depth;
  }

  std::vector<Point> sample(std::span<const Corner> points) const {
    const std::size_t step = 1 + points.size() / 8192;
    std::vector<Point> result;
    for (std::size_t i = 0; i < points.size(); i += step) {
      result.push_back(to_.points_[points[i]].position);
    }
    return result;
  }

  /// To the smallest regions.
  void assign_tetrahedra(const Dissection& space) {
    const auto work = [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t t = begin; t < end; ++t) {
        if (to_.states_[t] != State::Live) continue;
        to_.regions_[t] = leaf_of(centre(to_.tetrahedra_[t]), space);
      }
    };
    to_.regions_.resize(to_.states_.size());
    for_each_block(run_.threads(), to_.states_.size(), work);
  }

  static std::uint8_t leaf_of(const Point& x, const Dissection& space) {
    return static_cast<std::uint8_t>(space.box_of(x, space.first_leaf()) - space.first_leaf());
  }

  /// The middle of the corners that are atoms.
  Point centre(const Tetrahedron& t) const {
    Point sum = Point::Zero();
    int count = 0;
    for (const Corner c : t.corners) {
      if (c >= to_.atom_count_) continue;
      sum += to_.points_[c].position;
      ++count;
    }
    return sum / count;
  }

  Lists by_leaf(std::span<const Corner> points, const Dissection& space) const {
    std::vector<std::uint8_t> leaves(points.size());
    const auto work = [&](std::size_t begin, std::size_t end, std::size_t) {
      for (std::size_t i = begin; i < end; ++i) {
        leaves[i] = leaf_of(to_.points_[points[i]].position, space);
      }
    };
    for_each_block(run_.threads(), points.size(), work);
    Lists lists(space.leaf_count());
    for (std::size_t i = 0; i < points.size(); ++i) lists[leaves[i]].push_back(points[i]);
    return lists;
  }

  /// Inserts each list of a height in the region of its number, and puts the points that are
  /// refused into those of greater heights.
  void insert_in_regions(std::vector<Lists>& at_height, int height) {
    Lists& lists = at_height[static_cast<std::size_t>(height)];
    std::vector<Apart<Worker>> workers(lists.size());
    for (std::size_t k = 0; k < lists.size(); ++k) {
      workers[k].region = static_cast<std::uint32_t>(k);
      workers[k].height = height;
      provide_slots(workers[k], lists[k].size());
    }
    std::vector<std::vector<std::uint32_t>> places(lists.size());
    for_each_task(run_.threads(), lists.size(),
                  [&](std::size_t k) { places[k] = starts(workers[k]); });
    std::vector<std::vector<Refused>> refused(lists.size());
    for_each_task(run_.threads(), lists.size(), [&](std::size_t k) {
      take_rim_numbers(workers[k]);
      std::ranges::sort(lists[k]);
      refused[k] = insert_some(lists[k], workers[k], places[k]);
      give_back_rim_numbers(workers[k]);
    });
    std::vector<std::uint32_t>& free = to_.all_.free;
    for (const Worker& worker : workers) {
      for (std::uint32_t slot = worker.unused_end; slot > worker.unused;) free.push_back(--slot);
      free.insert(free.end(), worker.free.begin(), worker.free.end());
    }
    for (std::size_t k = 0; k < lists.size(); ++k) {
      for (const auto& [point, next_height] : refused[k]) {
        at_height[static_cast<std::size_t>(next_height)][k >> (next_height - height)].push_back(
            point);
      }
    }
  }

  /// They are as many as all points: one table for each thread.
  void take_rim_numbers(Worker& worker) {
    {
      const std::lock_guard lock(taking_);
      if (!tables_.empty()) {
        std::tie(worker.rim_numbers, worker.stamp) = std::move(tables_.back());
        return tables_.pop_back();
      }
    }
    worker.rim_numbers.resize(to_.points_.size() + 1);
  }
  void give_back_rim_numbers(Worker& worker) {
    const std::lock_guard lock(taking_);
    tables_.emplace_back(std::move(worker.rim_numbers), worker.stamp);
  }

  /// More than the points need, as a rule; where they do not suffice, some are left.
  void provide_slots(Worker& worker, std::size_t points) {
    std::vector<std::uint32_t>& free = to_.all_.free;
    const std::size_t wanted = 8 * points, taken = std::min(wanted, free.size());
    worker.free.assign(free.end() - static_cast<std::ptrdiff_t>(taken), free.end());
    free.resize(free.size() - taken);
    worker.unused = static_cast<std::uint32_t>(to_.tetrahedra_.size());
    worker.unused_end = static_cast<std::uint32_t>(
        std::min<std::size_t>(worker.unused + (wanted - taken), max_tetrahedra));
    to_.tetrahedra_.resize(worker.unused_end);
    to_.states_.resize(worker.unused_end, State::Free);
    to_.regions_.resize(worker.unused_end);
  }

  /// Live tetrahedra of a region, where walks can start. @pre nothing is being inserted
  std::vector<std::uint32_t> starts(const Worker& worker) const {
    constexpr std::size_t enough = 8;
    std::vector<std::uint32_t> result;
    for (std::uint32_t t = 0; t < to_.states_.size() && result.size() < enough; ++t) {
      if (to_.states_[t] == State::Live && to_.is_own(t, worker)) result.push_back(t);
    }
    return result;
  }

  /// @param starts  of walks, then places of earlier points: a region may be in several pieces, and
  ///                a walk may end in a corner of it
  /// @return        the points that could not be inserted
  std::vector<Refused> insert_some(std::span<const Corner> points, Worker& worker,
                                   std::vector<std::uint32_t> starts) {
    constexpr std::size_t points_between_starts = 32, many = 256;
    std::vector<Refused> refused;
    std::size_t done = 0, next = 0;
    worker.last = no_index;
    for (const Corner p : points) {
      // Where all tetrahedra share far corners, as of a filament, hardly any belongs to the region,
      // and each point would go all the way through for nothing.
      if (refused.size() >= many && done < refused.size() / 4) {
        refused.push_back({p, worker.height + 1});
        continue;
      }
      for (std::size_t k = 0; worker.last == no_index && k < starts.size(); ++k) {
        const std::uint32_t start = starts[next++ % starts.size()];
        if (to_.states_[start] == State::Live && to_.is_own(start, worker)) worker.last = start;
      }
      if (worker.last == no_index) {
        refused.push_back({p, worker.height + 1});
      } else if (!to_.insert(p, worker)) {
        refused.push_back({p, worker.next_height});
      } else if (++done % points_between_starts == 0) {
        starts[next++ % starts.size()] = worker.last;
        count(points_between_starts);
      }
    }
    count(done % points_between_starts);
    return refused;
  }

  void insert_all(std::span<const Corner> points) {
    std::uint32_t& last = to_.all_.last;
    if (to_.states_[last] != State::Live) {
      const auto live = std::ranges::find(to_.states_, State::Live);
      last = static_cast<std::uint32_t>(live - to_.states_.begin());
    }
    for (const Corner p : points) {
      to_.insert(p, to_.all_);
      count(1);
    }
  }

  void count(std::size_t more) {
    constexpr std::size_t points_between_reports = 4096;
    const std::size_t before = inserted_.fetch_add(more), now = before + more;
    if (before / points_between_reports == now / points_between_reports) return;
    const std::lock_guard lock(reporting_);
    run_.report(static_cast<double>(now) / static_cast<double>(to_.atom_count_));
  }

  Triangulator& to_;
  const Run& run_;
  std::size_t region_;
  std::atomic<std::size_t> inserted_{0};
  std::mutex reporting_;
  std::vector<std::pair<std::vector<Worker::RimNumber>, std::uint32_t>> tables_;
  std::mutex taking_;
};

void Triangulator::insert_rounds(std::span<const std::size_t> ends, const Run& run,
                                 std::size_t region) {
  Batches batches(*this, run, region);
  auto next = static_cast<std::size_t>(dimension_) + 1;
  for (const std::size_t end : ends) {
    std::vector<Corner> round;
    for (; next < end; ++next) round.push_back(static_cast<Corner>(next));
    batches.insert(round);
  }
  regions_ = std::vector<std::uint8_t>();
}

}  // namespace morskin::geometry
