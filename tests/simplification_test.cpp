#include "morse/simplification.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>

#include "morse/overlaps.h"
#include "morse/quadrangles.h"
#include "morse/validate_complex.h"
#include "tests/support/morse_complexes.h"

using namespace morskin;
using namespace morskin::morse;
using support::complex_of;
using support::random_graph;
using support::upside_down;

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

/// A random complex of up to `largest` saddles; one in four has many equal values, one in two
/// stands on its head.
MorseSmaleComplex random_complex(unsigned seed, std::size_t largest = 40) {
  support::Random random(seed);
  const support::EmbeddedGraph graph = random_graph(random, 1 + random.below(largest));
  MorseSmaleComplex complex = complex_of(graph, random, seed % 4 == 3 ? 4 : 0);
  return seed % 2 == 1 ? upside_down(std::move(complex)) : complex;
}

std::vector<CriticalId> points_of(const MorseSmaleComplex& complex, int index) {
  std::vector<CriticalId> ids;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (complex.points[i].index == index) ids.push_back(CriticalId{i});
  }
  return ids;
}

double value(const MorseSmaleComplex& complex, CriticalId id) {
  return complex.points[id.index()].value;
}

/// minima - saddles + maxima of those that survive.
long euler_characteristic(const MorseSmaleComplex& complex, const std::vector<bool>& survives) {
  long chi = 0;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    if (survives[i]) chi += complex.points[i].index == 1 ? -1 : 1;
  }
  return chi;
}

/// A complex as sets of ids, cancelled by the words of the paper: arcs are renamed, one by one.
struct PlainComplex {
  explicit PlainComplex(const MorseSmaleComplex& complex) : of(complex) {
    for (const Arc& arc : complex.arcs) {
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
    if (is_lower(of, *c, b) != is_minimum) return false;
    for (const auto& [saddle, kinds] : ends) {
      if (saddle != a && other(saddle, b) && is_lower(of, saddle, a) == is_minimum) return false;
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

using PairSet = std::set<std::pair<CriticalId, CriticalId>>;

/// Which points survive.
std::vector<bool> survivors(const MorseSmaleComplex& complex, const Quadrangles& quadrangles) {
  std::vector<bool> survives;
  for (std::size_t i = 0; i < complex.points.size(); ++i) {
    survives.push_back(quadrangles.survives(CriticalId{i}));
  }
  return survives;
}

/// A region as it reads whichever of its saddles stands first.
std::array<CriticalId, 4> turned(const std::array<CriticalId, 4>& region) {
  const auto [minimum, first, maximum, second] = region;
  return {minimum, std::min(first, second), maximum, std::max(first, second)};
}

}  // namespace

TEST_CASE("complexes made from random embedded graphs break no law") {
  std::array<std::size_t, 3> met{};  // one sphere, several components, handles
  for (unsigned seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    CHECK(validate(complex).value_or("") == "");
    const std::vector<bool> all(complex.points.size(), true);
    const long genus =
        static_cast<long>(complex.components) - euler_characteristic(complex, all) / 2;
    ++met[genus > 0 ? 2 : complex.components > 1 ? 1 : 0];
  }
  for (const std::size_t count : met) CHECK(count > 50);
}

TEST_CASE("a damaged complex breaks a law") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex good = random_complex(seed);
    support::Random random(seed);
    MorseSmaleComplex bad = good;
    bad.regions.pop_back();
    CHECK(validate(bad));
    bad = good;
    ++bad.components;
    CHECK(validate(bad));
    bad = good;
    std::swap(bad.arcs[0], bad.arcs[1]);
    CHECK(validate(bad));
    bad = good;
    bad.arcs.resize(bad.arcs.size() - 4);
    CHECK(validate(bad));
    bad = good;
    bad.points[bad.arcs[0].saddle.index()].value = -infinite;
    CHECK(validate(bad));
    bad = good;
    for (std::size_t i = 0; i < bad.points.size(); ++i) {
      const std::size_t first = bad.first_end[i];
      if (bad.first_end[i + 1] - first < 3) continue;
      std::swap(bad.ends[first], bad.ends[first + 1]);
      CHECK(validate(bad));
      break;
    }
    // An arc that ends at another minimum than it should.
    const std::vector<CriticalId> minima = points_of(good, 0);
    if (minima.size() < 2) continue;
    bad = good;
    Arc& arc = bad.arcs[4 * random.below(bad.arcs.size() / 4)];
    const CriticalId old = arc.extremum;
    while (arc.extremum == old) arc.extremum = minima[random.below(minima.size())];
    CHECK(validate(bad));
  }
}

TEST_CASE("every cancellation keeps the Euler characteristic, the components and all quadrangles") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    Quadrangles quadrangles(complex);
    std::vector<bool> survives(complex.points.size(), true);
    const long chi = euler_characteristic(complex, survives);
    for (const PersistencePair& pair : persistence_pairs(complex)) {
      REQUIRE(quadrangles.other_end(pair.saddle, pair.extremum).has_value());
      quadrangles.cancel(pair.saddle, pair.extremum);
      const MorseSmaleComplex left = quadrangles.remaining();
      survives = survivors(complex, quadrangles);
      CHECK(validate(left, survives).value_or("") == "");
      CHECK(left.regions.size() == left.arcs.size() / 2);
      CHECK(euler_characteristic(left, survives) == chi);
    }
  }
}

TEST_CASE("cancelling in any order, wherever two ends differ, keeps a surface of quadrangles") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    // Values play no part: all minima lie below all saddles, and these below all maxima.
    MorseSmaleComplex complex = random_complex(seed);
    for (CriticalPoint& p : complex.points) p.value = p.index;
    Quadrangles quadrangles(complex);
    support::Random random(seed);
    std::vector<bool> survives(complex.points.size(), true);
    const long chi = euler_characteristic(complex, survives);
    std::vector<CriticalId> saddles = points_of(complex, 1);
    for (std::size_t i = saddles.size(); i > 1; --i) {
      std::swap(saddles[i - 1], saddles[random.below(i)]);
    }
    for (const CriticalId saddle : saddles) {
      const CriticalId end = quadrangles.ends(saddle)[random.below(4)];
      if (!quadrangles.other_end(saddle, end)) continue;
      quadrangles.cancel(saddle, end);
      CHECK_FALSE(quadrangles.survives(end));
      const MorseSmaleComplex left = quadrangles.remaining();
      survives = survivors(complex, quadrangles);
      CHECK(validate(left, survives).value_or("") == "");
      CHECK(euler_characteristic(left, survives) == chi);
    }
  }
}

TEST_CASE("Figure 3: after contracting ab each region is still a quadrangle, about c") {
  for (unsigned seed = 0; seed < 200; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    const std::vector<PersistencePair> pairs = persistence_pairs(complex);
    if (pairs.empty()) continue;
    const auto [a, b, elder, persistence] = pairs.front();
    Quadrangles quadrangles(complex);
    const CriticalId c = *quadrangles.other_end(a, b);
    quadrangles.cancel(a, b);
    // By the definition: of regions with a, two that share an arc from a to an extremum of the
    // other kind become one; all others only read c for b.
    std::map<std::array<CriticalId, 4>, int> expected, found;
    for (std::array<CriticalId, 4> region : complex.regions) {
      if (region[1] == a || region[3] == a) continue;
      std::replace(region.begin(), region.end(), b, c);
      ++expected[turned(region)];
    }
    for (const auto& region : quadrangles.remaining().regions) ++found[turned(region)];
    std::size_t merged = 0;
    for (const auto& [region, count] : found) {
      const int old = expected.contains(region) ? expected.at(region) : 0;
      CHECK(count >= old);
      merged += static_cast<std::size_t>(count - old);
      expected.erase(region);
    }
    CHECK(expected.empty());
    CHECK(merged <= 2);
  }
}

TEST_CASE("pairs are those of the components of sublevel sets and superlevel sets, filled anew") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    PairSet expected, found;
    for (const int side : {0, 1}) {
      const auto is_older = [&](CriticalId p, CriticalId q) {
        return side == 0 ? is_lower(complex, p, q) : is_lower(complex, q, p);
      };
      // The oldest extremum that can be reached from `start` through saddles older than `saddle`.
      const auto oldest = [&](CriticalId start, CriticalId saddle) {
        std::set<CriticalId> reached{start};
        for (bool grew = true; grew;) {
          grew = false;
          for (std::size_t i = static_cast<std::size_t>(side); i < complex.arcs.size(); i += 4) {
            if (!is_older(complex.arcs[i].saddle, saddle)) continue;
            const CriticalId p = complex.arcs[i].extremum, q = complex.arcs[i + 2].extremum;
            if (reached.contains(p) != reached.contains(q)) {
              reached.insert({p, q});
              grew = true;
            }
          }
        }
        return *std::min_element(reached.begin(), reached.end(), is_older);
      };
      for (std::size_t i = static_cast<std::size_t>(side); i < complex.arcs.size(); i += 4) {
        const CriticalId saddle = complex.arcs[i].saddle;
        const CriticalId p = oldest(complex.arcs[i].extremum, saddle);
        const CriticalId q = oldest(complex.arcs[i + 2].extremum, saddle);
        if (p != q) expected.emplace(saddle, is_older(p, q) ? q : p);
      }
    }
    for (const PersistencePair& pair : persistence_pairs(complex)) {
      CHECK(found.emplace(pair.saddle, pair.extremum).second);
      CHECK(pair.persistence ==
            std::abs(value(complex, pair.saddle) - value(complex, pair.extremum)));
    }
    CHECK(found == expected);
  }
}

TEST_CASE("the hierarchy is what cancelling the least persistent arc again and again gives") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    if (seed % 4 == 3) continue;  // equal values: the order is open
    const MorseSmaleComplex complex = random_complex(seed, 25);
    PlainComplex plain(complex);
    const std::vector<Cancellation> all = cancel_up_to(complex, infinite, 0).cancelled;
    for (const Cancellation& c : all) {
      const auto least = plain.least([](CriticalId, CriticalId) { return true; });
      REQUIRE(least.has_value());
      CHECK(*least == std::pair(c.saddle, c.extremum));
      CHECK(plain.other(c.saddle, c.extremum) == c.heir);
      CHECK(plain.is_valid(c.saddle, c.extremum));
      plain.cancel(c.saddle, c.extremum);
    }
    CHECK_FALSE(plain.least([](CriticalId, CriticalId) { return true; }).has_value());
  }
}

TEST_CASE("each cancellation meets the persistence condition when its turn comes, ties or not") {
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    PlainComplex plain(complex);
    double last = 0;
    for (const Cancellation& c : cancel_up_to(complex, infinite, 0).cancelled) {
      REQUIRE(plain.is_valid(c.saddle, c.extremum));
      CHECK(c.persistence >= last);
      last = c.persistence;
      plain.cancel(c.saddle, c.extremum);
    }
  }
}

TEST_CASE("all cancelled, each component keeps a minimum and a maximum, each handle two saddles") {
  std::size_t handles = 0;
  for (unsigned seed = 0; seed < 500; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    const Simplification left = cancel_up_to(complex, infinite, 0.2);
    std::array<std::size_t, 3> count{};
    for (std::size_t i = 0; i < complex.points.size(); ++i) {
      if (left.survives[i]) ++count[static_cast<std::size_t>(complex.points[i].index)];
    }
    const long chi = euler_characteristic(complex, std::vector<bool>(complex.points.size(), true));
    const auto genus = static_cast<std::size_t>(static_cast<long>(complex.components) - chi / 2);
    CHECK(count[0] == complex.components);
    CHECK(count[2] == complex.components);
    CHECK(count[1] == 2 * genus);
    CHECK(validate(left.complex, left.survives).value_or("") == "");
    handles += genus;
    CriticalId lowest{0U}, highest{0U};
    for (std::size_t i = 0; i < complex.points.size(); ++i) {
      if (is_lower(complex, CriticalId{i}, lowest)) lowest = CriticalId{i};
      if (is_lower(complex, highest, CriticalId{i})) highest = CriticalId{i};
    }
    CHECK(left.survives[lowest.index()]);
    CHECK(left.survives[highest.index()]);
  }
  CHECK(handles > 100);
}

TEST_CASE("simplified to a persistence, the pairs up to it are gone and no others") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    const std::vector<PersistencePair> pairs = persistence_pairs(complex);
    if (pairs.empty()) continue;
    support::Random random(seed);
    const double limit = pairs[random.below(pairs.size())].persistence;
    const Simplification left = cancel_up_to(complex, limit, 0.2);
    std::size_t gone = 0;
    for (const PersistencePair& pair : pairs) {
      const bool is_gone = pair.persistence <= limit;
      gone += is_gone;
      CHECK(left.survives[pair.saddle.index()] != is_gone);
      CHECK(left.survives[pair.extremum.index()] != is_gone);
    }
    CHECK(left.cancelled.size() == gone);
    CHECK(validate(left.complex, left.survives).value_or("") == "");
    CHECK(cancel_up_to(complex, -1, 0.2).cancelled.empty());
  }
}

TEST_CASE("the lines of what is left are paths along old lines from the saddle to its extremum") {
  std::size_t longer = 0;
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed);
    const auto key = [](const Point& p, const Point& q) {
      return std::array{p.x(), p.y(), p.z(), q.x(), q.y(), q.z()};
    };
    std::set<std::array<double, 6>> segments;
    for (std::size_t i = 0; i < complex.arcs.size(); ++i) {
      const auto line = complex.line(ArcId{i});
      for (std::size_t k = 1; k < line.size(); ++k) {
        segments.insert(key(line[k - 1], line[k]));
        segments.insert(key(line[k], line[k - 1]));
      }
    }
    const std::vector<PersistencePair> pairs = persistence_pairs(complex);
    support::Random random(seed);
    const double limit = pairs.empty() ? 0 : pairs[random.below(pairs.size())].persistence;
    const MorseSmaleComplex left = cancel_up_to(complex, limit, 0.2).complex;
    REQUIRE(left.first_point.size() == left.arcs.size() + 1);
    for (std::size_t i = 0; i < left.arcs.size(); ++i) {
      const auto line = left.line(ArcId{i});
      const auto place = [&](CriticalId id) { return left.points[id.index()].point.position; };
      CHECK(line.front() == place(left.arcs[i].saddle));
      CHECK(line.back() == place(left.arcs[i].extremum));
      std::set<std::array<double, 6>> passed;
      for (std::size_t k = 1; k < line.size(); ++k) {
        CHECK(segments.contains(key(line[k - 1], line[k])));
        CHECK(passed.insert(key(line[k - 1], line[k])).second);   // no stretch twice
        CHECK_FALSE(passed.contains(key(line[k], line[k - 1])));  // nor back again
      }
      longer += line.size() > 3;
    }
  }
  CHECK(longer > 1000);
}

TEST_CASE("contracting short arcs is what doing the least allowed one again and again gives") {
  constexpr double share = 0.6;  // so that many pairs overlap
  std::size_t contracted = 0, refused = 0;
  for (unsigned seed = 0; seed < 400; ++seed) {
    CAPTURE(seed);
    const MorseSmaleComplex complex = random_complex(seed, 30);
    const Simplification left = contract_short_arcs(complex, share);
    const auto overlap = [&](CriticalId a, CriticalId b) {
      const skin::SurfacePoint& p = complex.points[a.index()].point;
      const skin::SurfacePoint& q = complex.points[b.index()].point;
      return (p.position - q.position).norm() < share * (p.length_scale + q.length_scale);
    };
    PlainComplex plain(complex);
    PairSet expected, found;
    while (const auto pair = plain.least(
               [&](CriticalId a, CriticalId b) { return overlap(a, b) && plain.is_valid(a, b); })) {
      expected.insert(*pair);
      plain.cancel(pair->first, pair->second);
    }
    for (const Cancellation& c : left.cancelled) found.emplace(c.saddle, c.extremum);
    CHECK(found == expected);
    contracted += found.size();
    refused += left.overlaps_left;
    CHECK(validate(left.complex, left.survives).value_or("") == "");
    CHECK(left.complex.regions.size() == left.complex.arcs.size() / 2);
    CHECK(euler_characteristic(complex, left.survives) ==
          euler_characteristic(complex, std::vector<bool>(complex.points.size(), true)));
    // What is left of the complex is what the plain one has.
    for (const Arc& arc : left.complex.arcs) {
      const auto& kinds = plain.ends.at(arc.saddle);
      const auto& two = kinds[complex.points[arc.extremum.index()].index == 0 ? 0 : 1];
      CHECK(std::find(two.begin(), two.end(), arc.extremum) != two.end());
    }
  }
  CHECK(contracted > 500);
  CHECK(refused > 500);
}

TEST_CASE("after simplification no two spheres overlap, and those that overlapped none are whole") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    const double share = 0.1 + 0.001 * seed;
    const MorseSmaleComplex complex = random_complex(seed);
    for (const Simplification& left :
         {contract_short_arcs(complex, share), cancel_up_to(complex, 0.1, share),
          keep_all(complex, share)}) {
      std::size_t shrunk = 0;
      for (std::size_t i = 0; i < complex.points.size(); ++i) {
        const double full = share * complex.points[i].point.length_scale;
        CHECK((left.radius[i] > 0) == left.survives[i]);
        bool meets = false;
        for (std::size_t j = 0; j < complex.points.size(); ++j) {
          if (i == j || !left.survives[i] || !left.survives[j]) continue;
          const double apart =
              (complex.points[i].point.position - complex.points[j].point.position).norm();
          CHECK(left.radius[i] + left.radius[j] <= apart * (1 + 1e-15));
          meets = meets || apart < full + share * complex.points[j].point.length_scale;
        }
        if (left.survives[i]) CHECK((left.radius[i] < full) == meets);
        shrunk += meets;
      }
      CHECK(left.shrunk == shrunk);
    }
  }
}

TEST_CASE("overlapping spheres are those that a look at all pairs finds, whatever their sizes") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    support::Random random(seed);
    std::vector<CriticalPoint> points(2 + random.below(60));
    std::vector<double> radii;
    for (CriticalPoint& p : points) {
      p.point.position = random.between(0, 3) * random.direction();
      radii.push_back(random.uniform() < 0.1 ? 0 : std::pow(10.0, random.between(-3, 0)));
    }
    std::vector<std::pair<CriticalId, CriticalId>> expected;
    for (std::size_t i = 0; i < points.size(); ++i) {
      for (std::size_t j = i + 1; j < points.size(); ++j) {
        const double apart = (points[i].point.position - points[j].point.position).norm();
        if (radii[i] > 0 && radii[j] > 0 && apart < radii[i] + radii[j]) {
          expected.emplace_back(CriticalId{i}, CriticalId{j});
        }
      }
    }
    CHECK(overlapping_spheres(points, radii) == expected);
  }
}

TEST_CASE("a sphere without saddles, and nothing at all, have nothing to cancel") {
  MorseSmaleComplex complex;
  complex.first_point = {0};
  complex.first_end = {0};
  CHECK(validate(complex).value_or("") == "");
  CHECK(contract_short_arcs(complex, 0.2).cancelled.empty());
  complex.components = 1;
  complex.points.resize(2);
  complex.first_end = {0, 0, 0};
  complex.points[1].index = 2;
  complex.points[1].value = 1;
  complex.points[1].point.position.y() = 1;
  for (CriticalPoint& p : complex.points) p.point.length_scale = 4;
  CHECK(validate(complex).value_or("") == "");
  const Simplification left = contract_short_arcs(complex, 0.25);
  CHECK(left.survives == std::vector<bool>{true, true});
  CHECK(left.overlaps_before == 1);
  CHECK(left.overlaps_left == 1);
  CHECK(left.shrunk == 2);
  CHECK(left.radius == std::vector<double>{0.5, 0.5});
}

TEST_CASE("turned upside down, the same pairs are cancelled and the same points survive") {
  for (unsigned seed = 0; seed < 300; ++seed) {
    CAPTURE(seed);
    if (seed % 4 == 3) continue;  // equal values fall by id, which does not turn
    const MorseSmaleComplex complex = random_complex(seed);
    const Simplification one = contract_short_arcs(complex, 0.25);
    const Simplification two = contract_short_arcs(upside_down(complex), 0.25);
    CHECK(one.survives == two.survives);
    CHECK(one.radius == two.radius);
    REQUIRE(one.cancelled.size() == two.cancelled.size());
    for (std::size_t i = 0; i < one.cancelled.size(); ++i) {
      CHECK(one.cancelled[i].heir == two.cancelled[i].heir);
    }
  }
}
