// The search for critical points of a height where coordinates are coarse beside its boxes.

#include "implicit/critical_heights.h"

#include "implicit/expression.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Point;
using geometry::Vector;

TEST_CASE("a critical point is found or left undecided, however small boxes are beside rounding") {
  // A bowl whose deepest point lies between two coordinates that are doubles.
  const implicit::Expression bowl("(z-1048576)-((x-1048576)-1.75e-10)^2-((y-1048576)-1.75e-10)^2");
  const Point middle = Point::Constant(1048576);
  for (int exponent = 4; exponent <= 32; ++exponent) {  // 2^-32 apart are the doubles there
    CAPTURE(exponent);
    implicit::Cover cover;
    for (int k = 0; k < 8; ++k) {
      const implicit::Box box = implicit::Box{middle, std::ldexp(2, -exponent)}.octant(k);
      cover.boxes.push_back({box, 1, 1, 2, 1});
    }
    const implicit::CriticalHeights found = implicit::critical_heights(
        bowl, cover, {Vector::UnitX(), Vector::UnitY()}, geometry::Run());
    if (exponent < 18) CHECK(found.is_complete());
    CHECK((found.points.size() == 1 || !found.is_complete()));
  }
}
