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

}  // namespace

std::optional<std::vector<Sector>> matched_sectors(const MorseSmaleComplex& complex) {
  const std::vector<std::uint32_t> first_arc = first_arcs(complex);
  const std::size_t arcs = complex.arcs.size();
  constexpr Sector none = ~Sector{0};
  std::vector<Sector> matched(arcs, none);
  // A free sector of the saddle that comes after an arc to `from` and before one to `to`.
  const auto free_sector = [&](CriticalId saddle, CriticalId from, CriticalId to) {
    const std::size_t first = first_arc[saddle.index()];
    for (std::size_t k = 0; k < 4 && first + 3 < arcs; ++k) {
      if (matched[first + k] == none && complex.arcs[first + k].saddle == saddle &&
          complex.arcs[first + k].extremum == from &&
          complex.arcs[first + (k + 1) % 4].extremum == to) {
        return static_cast<Sector>(first + k);
      }
    }
    return none;
  };
  // Counter-clockwise about a region from its minimum comes the saddle that has it between an arc
  // to the maximum and the next arc, to the minimum; last comes the one with these exchanged.
  for (const auto& [minimum, first, maximum, second] : complex.regions) {
    const Sector s = free_sector(first, maximum, minimum);
    const Sector t = free_sector(second, minimum, maximum);
    if (s == none || t == none) return std::nullopt;
    matched[s] = t;
    matched[t] = s;
  }
  for (const Sector s : matched) {
    if (s == none) return std::nullopt;
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
  // If these two belong to quadrangles with further sectors of the same saddle, the match made here
  // still names one of those, and joining across the saddle's opposite arc settles it.
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

std::vector<std::array<CriticalId, 4>> Quadrangles::regions() const {
  std::vector<std::array<CriticalId, 4>> result;
  for (std::size_t i = 0; i < complex_.arcs.size(); i += 4) {
    const CriticalId first = complex_.arcs[i].saddle;
    if (!survives(first)) continue;
    for (const std::size_t k : {std::size_t{1}, std::size_t{3}}) {
      const CriticalId second = complex_.arcs[matched_[i + k]].saddle;
      result.push_back({heir(complex_.arcs[i + (k + 1) % 4].extremum), first,
                        heir(complex_.arcs[i + k].extremum), second});
    }
  }
  return result;
}

}  // namespace morskin::morse
