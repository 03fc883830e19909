#include "morse/persistence.h"

#include "morse/quadrangles.h"
#include "morse/simplification.h"
#include "morse/validate_complex.h"
#include "tests/support/plain_complex.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;

namespace {

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
  for_complexes(500, [&](const MorseSmaleComplex& complex) {
    CHECK(validate(complex).value_or("") == "");
    const std::vector<bool> all(complex.points.size(), true);
    const long genus =
        static_cast<long>(complex.components) - euler_characteristic(complex, all) / 2;
    ++met[genus > 0 ? 2 : complex.components > 1 ? 1 : 0];
  });
  for (const std::size_t count : met) CHECK(count > 50);
}

TEST_CASE("a damaged complex breaks a law") {
  for_seeds<Random>(200, [&](unsigned seed, Random& random) {
    const MorseSmaleComplex good = random_complex(seed);
    const auto check_broken = [&](auto damage) {
      MorseSmaleComplex bad = good;
      damage(bad);
      CHECK(validate(bad));
    };
    check_broken([](auto& bad) { bad.regions.pop_back(); });
    check_broken([](auto& bad) { ++bad.components; });
    check_broken([](auto& bad) { std::swap(bad.arcs[0], bad.arcs[1]); });
    check_broken([](auto& bad) { bad.arcs.resize(bad.arcs.size() - 4); });
    check_broken([](auto& bad) { bad.points[bad.arcs[0].saddle.index()].value = -infinite; });
    for (std::size_t i = 0; i < good.points.size(); ++i) {
      const std::size_t first = good.ends.first[i];
      if (good.ends.of(i).size() < 3) continue;
      check_broken([&](auto& bad) { std::swap(bad.ends.items[first], bad.ends.items[first + 1]); });
      break;
    }
    // An arc that ends at another minimum than it should.
    const std::vector<CriticalId> minima = points_of(good, 0);
    if (minima.size() < 2) return;
    check_broken([&](auto& bad) {
      Arc& arc = bad.arcs[4 * random.below(bad.arcs.size() / 4)];
      const CriticalId old = arc.extremum;
      while (arc.extremum == old) arc.extremum = minima[random.below(minima.size())];
    });
  });
}

TEST_CASE("every cancellation keeps the Euler characteristic, the components and all quadrangles") {
  for_complexes(300, [&](const MorseSmaleComplex& complex) {
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
  });
}

TEST_CASE("cancelling in any order, wherever two ends differ, keeps a surface of quadrangles") {
  for_seeds<Random>(300, [&](unsigned seed, Random& random) {
    // Values play no part: all minima lie below all saddles, and these below all maxima.
    MorseSmaleComplex complex = random_complex(seed);
    for (CriticalPoint& p : complex.points) p.value = p.index;
    Quadrangles quadrangles(complex);
    std::vector<bool> survives(complex.points.size(), true);
    const long chi = euler_characteristic(complex, survives);
    std::vector<CriticalId> saddles = points_of(complex, 1);
    random.shuffle(saddles);
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
  });
}

TEST_CASE("Figure 3: after contracting ab each region is still a quadrangle, about c") {
  for_complexes(200, [&](const MorseSmaleComplex& complex) {
    const std::vector<PersistencePair> pairs = persistence_pairs(complex);
    if (pairs.empty()) return;
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
  });
}

TEST_CASE("pairs are those of the components of sublevel sets and superlevel sets, filled anew") {
  for_complexes(300, [&](const MorseSmaleComplex& complex) {
    std::set<std::pair<CriticalId, CriticalId>> expected, found;
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
  });
}

TEST_CASE("the hierarchy is what cancelling the least persistent arc again and again gives") {
  for_seeds(300, [&](unsigned seed) {
    if (seed % 4 == 3) return;  // equal values: the order is open
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
  });
}

TEST_CASE("each cancellation meets the persistence condition when its turn comes, ties or not") {
  for_complexes(400, [&](const MorseSmaleComplex& complex) {
    PlainComplex plain(complex);
    double last = 0;
    for (const Cancellation& c : cancel_up_to(complex, infinite, 0).cancelled) {
      REQUIRE(plain.is_valid(c.saddle, c.extremum));
      CHECK(c.persistence >= last);
      last = c.persistence;
      plain.cancel(c.saddle, c.extremum);
    }
  });
}
