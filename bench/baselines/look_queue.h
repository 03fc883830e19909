#pragma once

/// When which triangle is to be looked at: a monotone priority queue in flat buckets.
///
/// What is taken out never lies before what was taken out last. So an entry is kept in the bucket
/// of the highest bit in which its time differs from that one's; it moves to a lower bucket at most
/// 64 times, always in a sweep through memory, where a heap's entries would jump about.
/// Source: Ahuja, Mehlhorn, Orlin & Tarjan 1990, Faster algorithms for the shortest path problem
/// (radix heap).

#include <array>
#include <bit>
#include <cassert>
#include <cstdint>
#include <limits>
#include <vector>

#include "geometry/surface_mesh.h"

namespace morskin::baselines {

class LookQueue {
 public:
  struct Look {
    double time;
    geometry::TriangleId triangle;
  };

  /// @pre time is a number, and not before any time taken out so far.
  void push(double time, geometry::TriangleId triangle) {
    const std::uint64_t key = key_of(time);
    assert(key >= last_);
    buckets_[bucket_of(key)].push_back({key, triangle});
    if (key < least_) least_ = key;
    ++size_;
  }

  /// The time of the next look, or infinity.
  double next_time() const {
    return size_ == 0 ? std::numeric_limits<double>::infinity() : time_of(least_);
  }

  /// Takes out a look at the next time. @pre next_time() is finite.
  Look pop() {
    if (buckets_[0].empty()) spread();
    const Entry entry = buckets_[0].back();
    buckets_[0].pop_back();
    --size_;
    if (buckets_[0].empty()) find_least();
    return {time_of(entry.key), entry.triangle};
  }

  std::size_t size() const { return size_; }
  /// Forgets everything, but not how far time has gone.
  void clear() {
    for (auto& bucket : buckets_) bucket.clear();
    size_ = 0;
    least_ = none;
  }

 private:
  struct Entry {
    std::uint64_t key;
    geometry::TriangleId triangle;
  };
  static constexpr std::uint64_t none = ~std::uint64_t{0};
  static constexpr std::uint64_t sign_bit = std::uint64_t{1} << 63;

  // An order of the bits that is the order of the numbers.
  static std::uint64_t key_of(double time) {
    const auto bits = std::bit_cast<std::uint64_t>(time + 0.0);  // -0 becomes 0
    return (bits & sign_bit) != 0 ? ~bits : bits | sign_bit;
  }
  static double time_of(std::uint64_t key) {
    return std::bit_cast<double>((key & sign_bit) != 0 ? key & ~sign_bit : ~key);
  }
  std::size_t bucket_of(std::uint64_t key) const {
    return static_cast<std::size_t>(std::bit_width(key ^ last_));
  }

  void find_least() {
    least_ = none;
    for (const auto& bucket : buckets_) {
      for (const Entry& entry : bucket) least_ = entry.key < least_ ? entry.key : least_;
      if (!bucket.empty()) return;
    }
  }
  /// Moves on to the least time: its bucket is spread over the lower ones.
  void spread() {
    const std::size_t from = bucket_of(least_);
    last_ = least_;
    for (const Entry& entry : buckets_[from]) buckets_[bucket_of(entry.key)].push_back(entry);
    buckets_[from].clear();
  }

  std::array<std::vector<Entry>, 65> buckets_;
  std::uint64_t last_ = 0;  ///< not above any key in the queue
  std::uint64_t least_ = none;
  std::size_t size_ = 0;
};

}  // namespace morskin::baselines
