#include "morse/validate_complex.h"

#include <algorithm>
#include <array>
#include <numeric>

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

/// Walks round the extrema from arc to arc. The next arc is the one after the sector matched to the
/// sector that the arc starts.
Complaint check_circles(const MorseSmaleComplex& complex,
                        const std::vector<std::uint32_t>& matched) {
  std::vector<bool> is_unclear(complex.points.size(), false), walked(complex.arcs.size(), false),
      has_circle(complex.points.size(), false);
  for (std::size_t i = 0; i < complex.arcs.size(); i += 4) {
    if (complex.arcs[i].extremum != complex.arcs[i + 2].extremum ||
        complex.arcs[i + 1].extremum != complex.arcs[i + 3].extremum) {
      continue;
    }
    is_unclear[complex.arcs[i].extremum.index()] = true;
    is_unclear[complex.arcs[i + 1].extremum.index()] = true;
  }
  for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
    const CriticalId extremum = complex.arcs[i].extremum;
    if (walked[i] || is_unclear[extremum.index()]) continue;
    if (has_circle[extremum.index()]) {
      return "the arcs of " + number(extremum) + " form more than one circle";
    }
    has_circle[extremum.index()] = true;
    for (std::size_t k = i; !walked[k]; k = matched[k] - matched[k] % 4 + (matched[k] + 1) % 4) {
      if (complex.arcs[k].extremum != extremum) {
        return "the circle of arcs about " + number(extremum) + " meets another extremum";
      }
      walked[k] = true;
    }
  }
  return std::nullopt;
}

Complaint check_parts(const MorseSmaleComplex& complex, const std::vector<bool>& survives) {
  std::vector<std::uint32_t> parent(complex.points.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t i) {
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
  };
  std::vector<bool> has_arcs(complex.points.size(), false);
  for (const auto& [saddle, extremum] : complex.arcs) {
    has_arcs[extremum.index()] = has_arcs[saddle.index()] = true;
    parent[root(extremum.value)] = root(saddle.value);
  }
  std::size_t parts = 0;
  std::array<std::size_t, 3> alone{};
  long chi = 0;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (!survives[i]) continue;
    const int index = complex.points[i].index;
    chi += index == 1 ? -1 : 1;
    parts += has_arcs[i] && root(static_cast<std::uint32_t>(i)) == i;
    if (!has_arcs[i]) ++alone[static_cast<std::size_t>(index)];
  }
  if (alone[0] != alone[2]) {
    return std::to_string(alone[0]) + " minima and " + std::to_string(alone[2]) +
           " maxima have no arc";
  }
  parts += alone[0];
  if (parts != complex.components) {
    return "the arcs join " + std::to_string(parts) + " components, not " +
           std::to_string(complex.components);
  }
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
  if (2 * complex.regions.size() != complex.arcs.size()) {
    return std::to_string(complex.regions.size()) + " regions for " +
           std::to_string(complex.arcs.size() / 4) + " saddles";
  }
  const auto matched = matched_sectors(complex);
  if (!matched) return "the regions do not fit between the arcs";
  if (Complaint complaint = check_circles(complex, *matched)) return complaint;
  return check_parts(complex, of);
}

}  // namespace morskin::morse
