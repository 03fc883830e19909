#include "morse/cell_contact.h"

#include "skin/skin_surface.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;
using skin::CellId;
using skin::SkinSurface;

TEST_CASE(
    "a place of a circle, a sphere or a stretch of a line in a cell is found whenever there is "
    "one") {
  std::array<std::size_t, 2> found{}, absent{};
  for_seeds<Random>(300, [&](unsigned seed, Random& random) {
    const SkinSurface skin(ball_set(seed));
    const Box box = box_of(skin.points());
    for (int i = 0; i < 10; ++i) {
      const Point inside = box.sample(random);
      const CellId cell = skin.locate(inside, CellId{0U});
      const Point centre = inside + random.between(0, 4) * random.direction();
      const Circle circle{centre, random.direction(), random.between(0.1, 5)};
      const Vector e = circle.axis.unitOrthogonal(), f = circle.axis.cross(e);
      for (const bool is_circle : {true, false}) {
        bool expected = false;
        for (int k = 0; k < 1000 && !expected; ++k) {
          const double turn = 6.283185307179586 * random.uniform();
          const Vector out =
              is_circle ? Vector(std::cos(turn) * e + std::sin(turn) * f) : random.direction();
          expected = side(skin.complex(), cell, centre + circle.radius * out, 0) == Where::Inside;
        }
        const auto place = is_circle
                               ? point_in_cell(skin.complex(), cell, circle, 1e-9)
                               : point_in_cell(skin.complex(), cell, centre, circle.radius, 1e-9);
        if (expected) REQUIRE(place.has_value());
        ++(place ? found : absent)[static_cast<std::size_t>(is_circle)];
        if (!place) continue;
        CHECK(side(skin.complex(), cell, *place, 1e-9) != Where::Outside);
        CHECK((*place - centre).norm() == doctest::Approx(circle.radius));
        if (is_circle) CHECK(std::abs((*place - centre).dot(circle.axis)) < 1e-12);
      }
      const Stretch stretch{centre, circle.axis, random.between(0, 2), i % 2 ? 4 : INFINITY};
      bool expected = false;
      for (double t = stretch.from; t < std::min(stretch.to, 10.0); t += 0.01) {
        const Point x = centre + t * stretch.direction;
        expected = expected || side(skin.complex(), cell, x, 0) == Where::Inside;
      }
      const auto place = point_in_cell(skin.complex(), cell, stretch, 1e-9);
      if (expected) REQUIRE(place.has_value());
      if (!place) continue;
      CHECK(side(skin.complex(), cell, *place, 1e-8) != Where::Outside);
      CHECK((*place - centre).dot(stretch.direction) >= stretch.from - 1e-12);
      CHECK((*place - centre).dot(stretch.direction) <= stretch.to + 1e-12);
    }
  });
  for (const std::size_t count : found) CHECK(count > 100);
  for (const std::size_t count : absent) CHECK(count > 100);
}
