#include "skin/line_crossings.h"

#include "tests/support/nasty_sets.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

/// A random segment through the box of a set of balls, now and then a long or a short one.
struct Segment {
  Point p, q;

  Segment(Random& random, const Box& box) : p(box.sample(random)), q(box.sample(random)) {
    const double kind = random.uniform();
    if (kind < 0.2) q = p + 0.05 * (q - p);
    if (kind > 0.8) q = p + 20 * (q - p);
  }
  Point at(double share) const { return p + share * (q - p); }
};

}  // namespace

TEST_CASE("between two crossings that follow each other a line stays on one side of the skin") {
  for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    const SkinSurface skin(seed % 2 == 0 ? ball_set(seed) : nasty_set(seed));
    const Box box = box_of(skin.points());
    const double span = span_of(box);
    for (int i = 0; i < 4; ++i) {
      const Segment segment(random, box);
      const LineCrossings found = line_crossings(skin, segment.p, segment.q, CellId{0U});
      CHECK(found.is_complete);
      const double length = (segment.q - segment.p).norm();
      const double rounding = 1e-10 * (span + length) * (span + length);
      bool is_outside = skin.value(segment.p, CellId{0U}) > 0;
      double from = 0;
      bool is_right = true;
      for (std::size_t k = 0; k <= found.all.size(); ++k) {
        const double to = k < found.all.size() ? found.all[k].at : 1;
        is_right &= to >= from && to <= 1;
        constexpr int samples = 50;
        for (int s = 0; s <= samples; ++s) {
          const double g = skin.value(segment.at(from + (to - from) * s / samples), CellId{0U});
          is_right &= is_outside ? g > -rounding : g < rounding;
        }
        if (k == found.all.size()) break;
        is_right &= std::abs(skin.value(found.all[k].position, found.all[k].cell)) < rounding;
        is_outside = !is_outside;
        from = to;
      }
      CHECK(is_right);
    }
  });
}

TEST_CASE("a segment that is surely clear of the skin does not cross it") {
  std::size_t clear = 0, all = 0;
  for_seeds<Random>(1000, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const Box box = box_of(skin.points());
    for (int i = 0; i < 10; ++i) {
      const Segment segment(random, box);
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

TEST_CASE("a line through the middle of two balls crosses each of them twice") {
  const SkinSurface skin({ball(0, 0, 0, 1), ball(5, 0, 0, 2)});
  const LineCrossings found = line_crossings(skin, {-10, 0, 0}, {10, 0, 0}, CellId{0U});
  REQUIRE(found.all.size() == 4);
  CHECK(found.all[0].position.x() == doctest::Approx(-1));
  CHECK(found.all[3].position.x() == doctest::Approx(7));
}
