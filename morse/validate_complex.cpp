#include "morse/validate_complex.h"

#include <algorithm>
#include <array>

#include "geometry/union_find.h"
#include "morse/quadrangles.h"

namespace morskin::morse {

namespace {

using Complaint = std::optional<std::string>;

std::string number(CriticalId id) { return std::to_string(id.value); }

Complaint check_arcs(const MorseSmaleComplex& complex, const std::vector<bool>& survives) {
  constexpr std::array<int, 4> kinds{0, 2, 0, 2};
  std::vector<bool> has_arcs(complex.points.size(), false);
  if (complex.arcs.size() % 4 != 0) return "the arcs are not four to a saddle";
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const auto [saddle, extremum] = complex.arcs[i];
    if (std::max(saddle.index(), extremum.index()) >= complex.points.size()) {
      return "arc " + std::to_string(i) + " names a critical point that is not there";
    }
    const CriticalPoint& a = complex.points[saddle.index()];
    const CriticalPoint& b = complex.points[extremum.index()];
    const std::string arc = "the arc from " + number(saddle) + " to " + number(extremum);
    if (!survives[saddle.index()] || !survives[extremum.index()]) return arc + " has a lost end";
    if (a.index != 1 || b.index != kinds[i % 4]) return arc + " joins the wrong kinds";
    if (b.index == 0 ? !(b.value < a.value) : !(b.value > a.value)) {
      return arc + " does not lead " + (b.index == 0 ? "down" : "up");
    }
    if (i % 4 == 0 && has_arcs[saddle.index()]) return number(saddle) + " has its arcs twice";
    if (saddle != complex.arcs[i - i % 4].saddle) return arc + " stands among another's";
    has_arcs[saddle.index()] = true;
  }
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (survives[i] && complex.points[i].index == 1 && !has_arcs[i]) {
      return "saddle " + std::to_string(i) + " has no arcs";
    }
  }
  return std::nullopt;
}

/// Each arc is listed once, at its extremum.
Complaint check_orders(const MorseSmaleComplex& complex) {
  if (complex.ends.group_count() != complex.points.size() ||
      complex.ends.first.back() != complex.arcs.size() ||
      complex.ends.items.size() != complex.arcs.size()) {
    return "the arcs are not all in order about their extrema";
  }
  std::vector<bool> stands(complex.arcs.size(), false);
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    for (const ArcId arc : complex.arcs_at(CriticalId{i})) {
      if (arc.index() >= complex.arcs.size() || stands[arc.index()] ||
          complex.arcs[arc.index()].extremum != CriticalId{i}) {
        return "the order of the arcs about " + std::to_string(i) + " has a wrong one";
      }
      stands[arc.index()] = true;
    }
  }
  return std::nullopt;
}

/// The regions are those that lie between the arcs, none twice.
Complaint check_regions(const MorseSmaleComplex& complex) {
  if (2 * complex.regions.size() != complex.arcs.size()) {
    return std::to_string(complex.regions.size()) + " regions for " +
           std::to_string(complex.arcs.size() / 4) + " saddles";
  }
  const auto matched = matched_sectors(complex);
  if (!matched) return "the orders about minima and maxima do not make quadrangles";
  std::vector<std::array<CriticalId, 4>> expected, found = complex.regions;
  for (std::size_t i = 1; i < matched->size(); i += 2) {
    expected.push_back({complex.arcs[i - i % 4 + (i + 1) % 4].extremum, complex.arcs[i].saddle,
                        complex.arcs[i].extremum, complex.arcs[(*matched)[i]].saddle});
  }
  std::sort(expected.begin(), expected.end());
  std::sort(found.begin(), found.end());
  if (expected != found) return "the regions are not those between the arcs";
  return std::nullopt;
}

/// Parts that some of the arcs join: all, or every second one, the descending or the ascending.
class Parts {
 public:
  Parts(const MorseSmaleComplex& complex, std::size_t start, std::size_t step)
      : sets_(complex.points.size()), is_joined_(complex.points.size(), false) {
    for (std::size_t i = start; i < complex.arcs.size(); i += step) {
      const auto [saddle, extremum] = complex.arcs[i];
      is_joined_[saddle.index()] = is_joined_[extremum.index()] = true;
      sets_.join(extremum.value, saddle.value);
    }
  }
  bool is_joined(std::size_t i) const { return is_joined_[i]; }
  std::size_t count() {
    std::size_t roots = 0;
    for (std::uint32_t i = 0; i < sets_.size(); ++i) roots += is_joined_[i] && sets_.root(i) == i;
    return roots;
  }

 private:
  geometry::UnionFind sets_;
  std::vector<bool> is_joined_;
};

Complaint check_parts(const MorseSmaleComplex& complex, const std::vector<bool>& survives) {
  Parts all(complex, 0, 1), below(complex, 0, 2), above(complex, 1, 2);
  std::array<std::size_t, 3> alone{};
  long chi = 0;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (!survives[i]) continue;
    const int index = complex.points[i].index;
    chi += index == 1 ? -1 : 1;
    alone[static_cast<std::size_t>(index)] += !all.is_joined(i);
  }
  if (alone[0] != alone[2]) {
    return std::to_string(alone[0]) + " minima and " + std::to_string(alone[2]) +
           " maxima have no arc";
  }
  const std::size_t parts = all.count() + alone[0];
  if (parts != complex.components) {
    return "the arcs join " + std::to_string(parts) + " components, not " +
           std::to_string(complex.components);
  }
  if (below.count() + alone[0] != parts) return "descending arcs leave a component in parts";
  if (above.count() + alone[2] != parts) return "ascending arcs leave a component in parts";
  const long doubled_genus = 2 * static_cast<long>(parts) - chi;
  if (doubled_genus < 0 || doubled_genus % 2 != 0) {
    return "minima - saddles + maxima is " + std::to_string(chi) + ", which no surface of " +
           std::to_string(parts) + " components has";
  }
  return std::nullopt;
}

}  // namespace

std::optional<std::string> validate(const MorseSmaleComplex& complex,
                                    const std::vector<bool>& survives) {
  const std::vector<bool> of =
      survives.empty() ? std::vector<bool>(complex.points.size(), true) : survives;
  if (Complaint complaint = check_arcs(complex, of)) return complaint;
  if (Complaint complaint = check_orders(complex)) return complaint;
  if (Complaint complaint = check_regions(complex)) return complaint;
  return check_parts(complex, of);
}

}  // namespace morskin::morse
