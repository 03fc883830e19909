#include "morse/gradient_flow.h"

#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;

TEST_CASE("the part orthogonal to a unit vector is orthogonal for any angle between the two") {
  Random random(2);
  for (int i = 0; i < 10000; ++i) {
    const Vector n = random.direction(), across = n.unitOrthogonal();
    const double tilt = std::pow(10, random.between(-20, 3));
    const Vector part = geometry::unit_orthogonal_part(n + tilt * across, n);
    CHECK(std::abs(part.dot(n)) < 8 * 0x1p-53);  // of the three products and the rounding of part
    CHECK(std::abs(part.norm() - 1) < 4e-16);
    CHECK((part - across).norm() < 1e-15 + 1e-15 / tilt + (tilt < 4e-16 ? 2 : 0));
  }
  CHECK(geometry::unit_orthogonal_part(Vector::Zero(), Vector::UnitX()).x() == 0);
}

TEST_CASE("the frame of a gradient flow is orthonormal for any angle of gradient and axis") {
  Random random(1);
  for (int i = 0; i < 10000; ++i) {
    skin::Patch patch{};
    patch.axis = random.direction();
    patch.centre = Vector::Zero();
    patch.half_weight = 1;
    const double tilt = std::pow(10, random.between(-20, 1));
    const double length = std::pow(10, random.between(-5, 5));
    const GradientFlow flow(
        patch, MorseFunction::height(length * (patch.axis + tilt * random.direction())),
        Direction::Up);
    const Vector a = random.direction(), b = random.direction();
    CHECK(std::abs(flow.to_local(a).dot(flow.to_local(b)) - a.dot(b)) < 1e-14);
    CHECK((flow.to_space(flow.to_local(a)) - a).norm() < 1e-14);
  }
}
