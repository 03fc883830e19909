#pragma once

/// A Morse-Smale complex by the words of the paper, slow and plain: the oracle of its
/// simplification.

#include "morse/persistence.h"
#include "tests/support/morse_complexes.h"

namespace morskin::support {

using morse::CriticalId;
using morse::MorseSmaleComplex;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A random complex of up to `largest` saddles; one in four has many equal values, one in two
/// stands on its head.
inline MorseSmaleComplex random_complex(unsigned seed, std::size_t largest = 40) {
  Random random(seed);
  const EmbeddedGraph graph = random_graph(random, 1 + random.below(largest));
  MorseSmaleComplex complex = complex_of(graph, random, seed % 4 == 3 ? 4 : 0);
  return seed % 2 == 1 ? upside_down(std::move(complex)) : complex;
}

/// Tries a law for random complexes. It takes the complex, with its seed before or draws after it.
template <class Law>
void for_complexes(const Seeds& seeds, Law law) {
  for_seeds(seeds, [&](unsigned seed) {
    const MorseSmaleComplex complex = random_complex(seed);
    if constexpr (std::is_invocable_v<Law, const MorseSmaleComplex&>) {
      law(complex);
    } else if constexpr (std::is_invocable_v<Law, unsigned, const MorseSmaleComplex&>) {
      law(seed, complex);
    } else {
      Random random(seed);
      law(complex, random);
    }
  });
}

/// Those of an index.
inline std::vector<CriticalId> points_of(const MorseSmaleComplex& complex, int index) {
  std::vector<CriticalId> ids;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (complex.points[i].index == index) ids.push_back(CriticalId{i});
  }
  return ids;
}

inline double value(const MorseSmaleComplex& complex, CriticalId id) {
  return complex.points[id.index()].value;
}

/// minima - saddles + maxima of those that survive.
inline long euler_characteristic(const MorseSmaleComplex& complex,
                                 const std::vector<bool>& survives) {
  long chi = 0;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (survives[i]) chi += complex.points[i].index == 1 ? -1 : 1;
  }
  return chi;
}

/// A complex as sets of ids, cancelled by the words of the paper: arcs are renamed, one by one.
struct PlainComplex {
  explicit PlainComplex(const MorseSmaleComplex& complex) : of(complex) {
    for (const morse::Arc& arc : complex.arcs) {
      const int index = complex.points[arc.extremum.index()].index;
      ends[arc.saddle][index == 0 ? 0 : 1].push_back(arc.extremum);
    }
  }

  /// c, if the saddle may be cancelled with the extremum at all.
  std::optional<CriticalId> other(CriticalId a, CriticalId b) const {
    for (const auto& two : ends.at(a)) {
      if (two[0] == two[1]) continue;
      if (two[0] == b) return two[1];
      if (two[1] == b) return two[0];
    }
    return std::nullopt;
  }

  /// f(c) <= f(b), and a is the lowest saddle of b but for those with both arcs to b; or mirrored.
  bool is_valid(CriticalId a, CriticalId b) const {
    const auto c = other(a, b);
    if (!c) return false;
    const bool is_minimum = of.points[b.index()].index == 0;
    if (morse::is_lower(of, *c, b) != is_minimum) return false;
    for (const auto& [saddle, kinds] : ends) {
      if (saddle != a && other(saddle, b) && morse::is_lower(of, saddle, a) == is_minimum)
        return false;
    }
    return true;
  }

  void cancel(CriticalId a, CriticalId b) {
    const CriticalId c = *other(a, b);
    ends.erase(a);
    for (auto& [saddle, kinds] : ends) {
      for (auto& two : kinds) std::replace(two.begin(), two.end(), b, c);
    }
  }

  /// The arc of least |f(a) - f(b)| that is allowed, with the other end.
  template <class Allowed>
  std::optional<std::pair<CriticalId, CriticalId>> least(Allowed allowed) const {
    std::optional<std::pair<CriticalId, CriticalId>> best;
    double least = infinite;
    for (const auto& [saddle, kinds] : ends) {
      for (const auto& two : kinds) {
        for (const CriticalId b : two) {
          const double persistence = std::abs(value(of, saddle) - value(of, b));
          if (persistence < least && other(saddle, b) && allowed(saddle, b)) {
            least = persistence;
            best = {saddle, b};
          }
        }
      }
    }
    return best;
  }

  const MorseSmaleComplex& of;
  /// By saddle: the two minima, the two maxima.
  std::map<CriticalId, std::array<std::vector<CriticalId>, 2>> ends;
};

}  // namespace morskin::support
