#include "skin/line_crossings.h"

#include "skin/level_set.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

struct Segment {
  Point p, q;

  Point at(double share) const { return p + share * (q - p); }
};

/// A random segment through the box of a set of balls, now and then a long or a short one.
Segment random_segment(Random& random, const Box& box) {
  const Point p = box.sample(random), q = box.sample(random);
  const double kind = random.uniform();
  return {p, p + (kind < 0.2 ? 0.05 : kind > 0.8 ? 20 : 1) * (q - p)};
}

/// A segment along a line or plane through the centres of some balls, now and then a little off it.
Segment segment_through_centres(Random& random, const SkinSurface& skin) {
  const auto some_centre = [&] {
    return skin.points()[random.below(skin.points().size())].position;
  };
  const Point a = some_centre(), b = some_centre(), c = some_centre();
  const double shift = random.uniform() < 0.5 ? 0 : random.between(-1, 1);
  Segment segment{a + shift * (c - a) - 0.5 * (b - a), a + shift * (c - a) + 1.5 * (b - a)};
  const double kind = random.uniform();
  if (kind < 0.3) segment.q = (b + c) / 2;
  if (kind > 0.7) segment.q += std::pow(10.0, random.between(-15, -3)) * random.direction();
  return segment;
}

/// Whether all crossings of a segment are found that samples of G tell of.
bool has_all_crossings(const surface::Surface& skin, const Segment& segment, double span) {
  const auto value = [&](double share) {
    const Point x = segment.at(share);
    return skin.jet(x, skin.locate(x, CellId{0U})).value;
  };
  const LineCrossings found = skin.crossings(segment.p, segment.q, CellId{0U});
  const double length = (segment.q - segment.p).norm();
  const double rounding = 1e-10 * (span + length) * (span + length);
  const double start = value(0);
  bool is_right = found.is_complete;
  if (length == 0 || std::abs(start) < rounding) return is_right;
  bool is_outside = start > 0;
  double from = 0;
  for (std::size_t k = 0; k <= found.all.size(); ++k) {
    const double to = k < found.all.size() ? found.all[k].at : 1;
    is_right &= to >= from && to <= 1;
    constexpr int samples = 50;
    for (int s = 0; s <= samples; ++s) {
      const double g = value(from + (to - from) * s / samples);
      is_right &= is_outside ? g > -rounding : g < rounding;
    }
    if (k == found.all.size()) break;
    is_right &= std::abs(skin.jet(found.all[k].position, found.all[k].cell).value) < rounding;
    is_outside = !is_outside;
    from = to;
  }
  return is_right;
}

}  // namespace

TEST_CASE("between two crossings that follow each other a line stays on one side of the skin") {
  for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    const SkinSurface skin(seed % 2 == 0 ? ball_set(seed) : nasty_set(seed));
    const Box box = box_of(skin.points());
    for (int i = 0; i < 4; ++i) {
      CHECK(has_all_crossings(skin, random_segment(random, box), span_of(box)));
    }
  });
}

TEST_CASE("lines that run in walls, as from atom to atom of a lattice, have all crossings too") {
  for (unsigned round = 0; round < 100; ++round) {
    for (const Nasty kind :
         {Nasty::Lattice, Nasty::Coplanar, Nasty::SmallIntegers, Nasty::Cospherical}) {
      const auto seed = static_cast<unsigned>(round * nasty_kinds + static_cast<std::size_t>(kind));
      CAPTURE(seed);
      const SkinSurface skin(nasty_set(seed), MixedComplex::Keep::All);
      const LevelSet grown(skin, 0.3);
      const double span = span_of(box_of(skin.points()));
      Random random(seed);
      for (int i = 0; i < 10; ++i) {
        const Segment segment = segment_through_centres(random, skin);
        CHECK(has_all_crossings(skin, segment, span));
        CHECK(has_all_crossings(grown, segment, span));
      }
    }
  }
}

TEST_CASE("a segment that is surely clear of the skin does not cross it") {
  std::size_t clear = 0, all = 0;
  for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const Box box = box_of(skin.points());
    for (int i = 0; i < 10; ++i) {
      const Segment segment = random_segment(random, box);
      const double g = skin.value(segment.p, CellId{0U}), h = skin.value(segment.q, CellId{0U});
      if ((g > 0) != (h > 0)) continue;
      ++all;
      if (!surface::is_certainly_clear((segment.q - segment.p).norm(), std::sqrt(std::abs(g)),
                                       std::sqrt(std::abs(h)))) {
        continue;
      }
      ++clear;
      CHECK(line_crossings(skin, segment.p, segment.q, CellId{0U}).all.empty());
    }
  });
  CHECK(clear > all / 4);  // the test is worth asking
}

TEST_CASE("a segment that is surely clear beyond a crossing does not cross the skin again") {
  std::size_t clear = 0, all = 0;
  for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    const SkinSurface skin(seed % 2 == 0 ? ball_set(seed) : nasty_set(seed));
    const Box box = box_of(skin.points());
    for (int i = 0; i < 10; ++i) {
      const Segment segment = random_segment(random, box);
      const Vector along = segment.q - segment.p;
      const auto found = line_crossings(skin, segment.p, segment.q, CellId{0U}).all;
      for (std::size_t k = 0; k < found.size(); ++k) {
        const auto& [at, position, cell] = found[k];
        const double slope = 2 * std::abs(skin.jet(position, cell).half_gradient.dot(along));
        const double share = random.between(at, 1);
        const auto later = std::count_if(found.begin() + static_cast<std::ptrdiff_t>(k) + 1,
                                         found.end(), [&](const auto& c) { return c.at < share; });
        if (later % 2 != 0) continue;
        ++all;
        if (!surface::is_certainly_clear_beyond(
                (share - at) * along.norm(), slope / along.norm(),
                std::sqrt(std::abs(skin.value(segment.at(share), cell))))) {
          continue;
        }
        ++clear;
        CHECK(later == 0);
      }
    }
  });
  CHECK(clear > all / 4);  // the test is worth asking
}

TEST_CASE("a line through the middle of two balls crosses each of them twice") {
  const SkinSurface skin({ball(0, 0, 0, 1), ball(5, 0, 0, 2)});
  const LineCrossings found = line_crossings(skin, {-10, 0, 0}, {10, 0, 0}, CellId{0U});
  REQUIRE(found.all.size() == 4);
  CHECK(found.all[0].position.x() == doctest::Approx(-1));
  CHECK(found.all[3].position.x() == doctest::Approx(7));
}
