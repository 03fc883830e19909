#include "morse/persistence.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace morskin::morse {

namespace {

/// Components of a growing level set; each is named by its oldest extremum.
class Components {
 public:
  explicit Components(std::size_t points) : parent_(points) {
    std::iota(parent_.begin(), parent_.end(), 0U);
  }
  CriticalId oldest(CriticalId id) {
    std::uint32_t i = id.value;
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return CriticalId{i};
  }
  void end(CriticalId younger, CriticalId elder) { parent_[younger.index()] = elder.value; }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Pairs of one kind of extremum: `side` 0 follows the descending arcs with rising values, 1 the
/// ascending arcs with falling ones.
void append_pairs(const MorseSmaleComplex& complex, std::span<const std::uint32_t> saddles_upwards,
                  std::size_t side, std::vector<PersistencePair>& pairs) {
  Components components(complex.points.size());
  const std::size_t n = saddles_upwards.size();
  for (std::size_t i = 0; i < n; ++i) {
    // [excerpt: pairs]
    const std::size_t first_arc = 4 * saddles_upwards[side == 0 ? i : n - 1 - i];
    CriticalId younger = components.oldest(complex.arcs[first_arc + side].extremum);
    CriticalId elder = components.oldest(complex.arcs[first_arc + side + 2].extremum);
    if (younger == elder) continue;
    if (is_lower(complex, younger, elder) == (side == 0)) std::swap(younger, elder);
    const CriticalId saddle = complex.arcs[first_arc].saddle;
    const double persistence =
        std::abs(complex.points[saddle.index()].value - complex.points[younger.index()].value);
    pairs.push_back({saddle, younger, elder, persistence});
    components.end(younger, elder);
    // [/excerpt]
  }
}

}  // namespace

std::vector<PersistencePair> persistence_pairs(const MorseSmaleComplex& complex) {
  std::vector<std::uint32_t> upwards(complex.arcs.size() / 4);
  std::iota(upwards.begin(), upwards.end(), 0U);
  std::sort(upwards.begin(), upwards.end(), [&](std::uint32_t s, std::uint32_t t) {
    return is_lower(complex, complex.arcs[4 * s].saddle, complex.arcs[4 * t].saddle);
  });
  std::vector<PersistencePair> pairs;
  pairs.reserve(upwards.size());
  append_pairs(complex, upwards, 0, pairs);
  append_pairs(complex, upwards, 1, pairs);
  // Each pass finds inner pairs before outer ones. Subtraction rounds monotonically, so an inner
  // pair never has the larger persistence, and a stable sort keeps the order of equal ones.
  std::stable_sort(pairs.begin(), pairs.end(),
                   [](const auto& a, const auto& b) { return a.persistence < b.persistence; });
  return pairs;
}

}  // namespace morskin::morse
