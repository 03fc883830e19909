#include "morse/quadrangles.h"

#include <cassert>

namespace morskin::morse {

namespace {

/// By critical point, the number of a saddle's first arc.
std::vector<std::uint32_t> first_arcs(const MorseSmaleComplex& complex) {
  std::vector<std::uint32_t> first(complex.points.size(), 0);
  for (std::size_t i = 0; i < complex.arcs.size(); i += 4) {
    first[complex.arcs[i].saddle.index()] = static_cast<std::uint32_t>(i);
  }
  return first;
}

/// The sector that ends at an arc.
Sector before_arc(ArcId arc) { return arc.value - arc.value % 4 + (arc.value + 3) % 4; }

}  // namespace

std::optional<std::vector<Sector>> matched_sectors(const MorseSmaleComplex& complex) {
  constexpr Sector none = ~Sector{0};
  std::vector<Sector> matched(complex.arcs.size(), none);
  const auto match = [&](Sector a, Sector b) {
    if (matched[a] != none && matched[a] != b) return false;
    matched[a] = b;
    return true;
  };
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    const std::span<const ArcId> about = complex.arcs_at(CriticalId{i});
    for (std::size_t k = 0; k < about.size(); ++k) {
      // The region between this arc and the next precedes this one about its saddle and follows the
      // next one about its own.
      const Sector before = before_arc(about[k]), after = about[(k + 1) % about.size()].value;
      if (!match(before, after) || !match(after, before)) return std::nullopt;
    }
  }
  return matched;
}

Quadrangles::Quadrangles(const MorseSmaleComplex& complex)
    : complex_(complex),
      first_arc_(first_arcs(complex)),
      matched_(matched_sectors(complex).value()),
      survives_(complex.points.size(), true),
      heir_(complex.points.size()) {
  for (std::size_t i = 0; i < heir_.size(); ++i) heir_[i] = CriticalId{i};
}

CriticalId Quadrangles::heir(CriticalId id) const {
  while (heir_[id.index()] != id) {
    heir_[id.index()] = heir_[heir_[id.index()].index()];
    id = heir_[id.index()];
  }
  return id;
}

std::array<CriticalId, 4> Quadrangles::ends(CriticalId saddle) const {
  std::array<CriticalId, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    result[k] = heir(complex_.arcs[first_arc_[saddle.index()] + k].extremum);
  }
  return result;
}

std::optional<CriticalId> Quadrangles::other_end(CriticalId saddle, CriticalId extremum) const {
  const std::array<CriticalId, 4> to = ends(saddle);
  for (std::size_t k = 0; k < 4; ++k) {
    if (to[k] == extremum && to[(k + 2) % 4] != extremum) return to[(k + 2) % 4];
  }
  return std::nullopt;
}

void Quadrangles::join_across(Sector before, Sector after) {
  // If their partners are sectors of the same saddle, joining across its opposite arc replaces
  // them.
  const Sector left = matched_[before], right = matched_[after];
  matched_[left] = right;
  matched_[right] = left;
}

void Quadrangles::cancel(CriticalId saddle, CriticalId extremum) {
  const std::optional<CriticalId> other = other_end(saddle, extremum);
  assert(other);
  const Sector first = first_arc_[saddle.index()];
  if (complex_.points[extremum.index()].index == 0) {
    join_across(first, first + 1);
    join_across(first + 2, first + 3);
  } else {
    join_across(first + 1, first + 2);
    join_across(first + 3, first);
  }
  heir_[extremum.index()] = *other;
  survives_[saddle.index()] = survives_[extremum.index()] = false;
}

ArcId Quadrangles::next_about_extremum(ArcId arc) const { return ArcId{matched_[before_arc(arc)]}; }

std::vector<std::array<CriticalId, 4>> Quadrangles::regions() const {
  std::vector<std::array<CriticalId, 4>> result;
  for (std::size_t i = 0; i < complex_.arcs.size(); i += 4) {
    const CriticalId first = complex_.arcs[i].saddle;
    if (!survives(first)) continue;
    // Counter-clockwise from the minimum, the first saddle has the region between an arc to the
    // maximum and the next one, to the minimum.
    for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
      const CriticalId second = complex_.arcs[matched_[i + k]].saddle;
      result.push_back({heir(complex_.arcs[i + (k + 1) % 4].extremum), first,
                        heir(complex_.arcs[i + k].extremum), second});
    }
  }
  return result;
}

MorseSmaleComplex Quadrangles::remaining() const {
  MorseSmaleComplex left;
  left.points = complex_.points;
  left.components = complex_.components;
  left.merged_lines = complex_.merged_lines;
  left.degeneracies = complex_.degeneracies;
  left.regions = regions();
  std::vector<ArcId> old_arcs;                             // by arc that is left
  std::vector<std::uint32_t> index(complex_.arcs.size());  // by old arc
  for (std::size_t i = 0; i < complex_.arcs.size(); ++i) {
    const auto [saddle, extremum] = complex_.arcs[i];
    if (!survives(saddle)) continue;
    index[i] = static_cast<std::uint32_t>(old_arcs.size());
    old_arcs.push_back(ArcId{i});
    left.arcs.push_back({saddle, heir(extremum)});
  }
  std::vector<std::optional<ArcId>> first(complex_.points.size());  // by extremum, an arc to it
  for (const ArcId arc : old_arcs) {
    std::optional<ArcId>& one = first[heir(complex_.arcs[arc.index()].extremum).index()];
    if (!one) one = arc;
  }
  for (const std::optional<ArcId>& one : first) {
    if (one) {
      ArcId arc = *one;
      do {
        left.ends.items.push_back(ArcId{index[arc.index()]});
        arc = next_about_extremum(arc);
      } while (arc != *one);
    }
    left.ends.first.push_back(static_cast<std::uint32_t>(left.ends.items.size()));
  }
  return left;
}

}  // namespace morskin::morse
