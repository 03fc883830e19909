#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "front/front.h"

namespace morskin::front {

/// The corners that the operation going on has made or changed: those that may need a wing.
class FreshCorners : public FrontMirror {
 public:
  void restart(FrontEdgeId first) {
    corners_.assign({first});
    next_ = unchanged_since_ = 0;
  }
  /// The next to inspect: one not yet returned since the last change.
  std::optional<FrontEdgeId> next() {
    while (next_ < corners_.size()) {
      const auto here = corners_.begin() + static_cast<std::ptrdiff_t>(next_++);
      const auto first = corners_.begin() + static_cast<std::ptrdiff_t>(unchanged_since_);
      if (std::find(first, here, *here) == here) return *here;
    }
    return std::nullopt;
  }
  void follow(const FrontChange& change) override {
    for (const FrontEdgeId corner : change.corners) corners_.push_back(corner);
    unchanged_since_ = next_;
  }

 private:
  std::vector<FrontEdgeId> corners_;
  std::size_t next_ = 0, unchanged_since_ = 0;
};

}  // namespace morskin::front
