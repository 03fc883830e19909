#include "morse/critical_points.h"

#include "certify/sizing.h"
#include "morse/skin_spheres.h"
#include "tests/support/critical_laws.h"

using namespace morskin;
using namespace morskin::morse;
using namespace morskin::support;
using skin::SkinSurface;
using surface::SurfacePoint;

namespace {

const double share = certify::Sizing{}.tangent_disk_share();

/// A random non-degenerate height of a random ball set and its critical points.
struct Case {
  explicit Case(unsigned seed)
      : random(seed),
        skin(ball_set(seed)),
        height{random.direction()},
        critical(critical_points(skin, height)) {}
  bool is_degenerate() const { return !critical.degeneracies.empty(); }

  Random random;
  SkinSurface skin;
  MorseFunction height;
  CriticalPoints critical;
};

}  // namespace

TEST_CASE("every critical point lies on the skin with its normal along the direction") {
  for_seeds<Case>(500, [&](const Case& test) {
    for (const CriticalPoint& p : test.critical.points) {
      check_on_skin(test.skin, p);
      CHECK(std::abs(std::abs(p.point.normal.dot(test.height.direction)) - 1) < 1e-12);
      CHECK(p.value == test.height(p.point.position));
    }
  });
}

TEST_CASE("the index counts the descending directions of differences of the height") {
  std::array<std::size_t, 3> met{};
  for_seeds<Case>(500, [&](const Case& test) {
    for (const CriticalPoint& p : test.critical.points) {
      const skin::Patch& patch = test.skin.complex().patch(p.point.cell);
      const double h = 1e-3 * p.point.length_scale;
      const auto rise = [&](const Vector& step) {
        return test.height.direction.dot(on_patch(patch, p.point.position + h * step) -
                                         p.point.position);
      };
      // In units of 1 / rho, where the steeper curvature is 1.
      const Eigen::Vector2d values =
          hessian_values(p.point.normal, rise) * p.point.length_scale / (h * h);
      constexpr double flat = 1e-3;  // fourth order in h, and rounding over h^2
      if (values.cwiseAbs().minCoeff() < flat ||
          p.point.length_scale < 1e9 * test.skin.complex().wall_tolerance()) {
        continue;
      }
      ++met[static_cast<std::size_t>(p.index)];
      CHECK(p.index == (values[0] < 0) + (values[1] < 0));
      CHECK(std::abs(values.cwiseAbs().maxCoeff() - 1) < 10 * flat);
      if (p.index == 1) {
        CHECK(std::abs(p.descending.norm() - 1) < 1e-12);
        CHECK(std::abs(p.descending.dot(p.point.normal)) < 1e-12);
        CHECK(rise(p.descending) < 0);
        CHECK(rise(-p.descending) < 0);
        const Vector across = p.point.normal.cross(p.descending);
        CHECK(rise(across) > 0);
        CHECK(rise(-across) > 0);
      } else {
        CHECK(p.descending == Vector::Zero());
      }
    }
  });
  for (const std::size_t count : met) CHECK(count > 100);
}

TEST_CASE("one ball has one minimum and one maximum, at its poles") {
  for_seeds<Random>(100, [&](Random& random) {
    const MorseFunction height{random.direction()};
    const Point centre = random.between(0, 10) * random.direction();
    const double radius = random.between(0.5, 3);
    const auto critical =
        critical_points(SkinSurface({ball(centre.x(), centre.y(), centre.z(), radius)}), height);
    REQUIRE(critical.points.size() == 2);
    for (const CriticalPoint& p : critical.points) {
      const double side = p.index == 2 ? 1 : -1;
      CHECK(p.index != 1);
      CHECK((p.point.position - centre - side * radius * height.direction).norm() <
            1e-12 * radius + 1e-14);
    }
    CHECK(critical.count(0) == 1);
  });
}

TEST_CASE(
    "no point of the skin is lower than the lowest minimum or higher than the highest maximum") {
  for_seeds<Case>(200, [&](Case& test) {
    if (test.is_degenerate()) return;
    double lowest = INFINITY, highest = -INFINITY;
    for (const CriticalPoint& p : test.critical.points) {
      if (p.index == 0) lowest = std::min(lowest, p.value);
      if (p.index == 2) highest = std::max(highest, p.value);
    }
    const Box box = box_of(test.skin.points());
    const double rounding = 1e-10 * span_of(box);
    for (int i = 0; i < 100; ++i) {
      const auto p = test.skin.project(box.sample(test.random), skin::CellId{0U});
      if (!p) continue;
      CHECK(test.height(p->position) >= lowest - rounding);
      CHECK(test.height(p->position) <= highest + rounding);
    }
  });
}

TEST_CASE(
    "a direction along an axis of the cube is degenerate and said to be so, the default is not") {
  for (const skin::Model model : {skin::Model::Paper, skin::Model::Sas, skin::Model::Vdw}) {
    const SkinSurface cube(molecule("cube8.xyzr", model));
    for (int axis = 0; axis < 3; ++axis) {
      CAPTURE(axis);
      CHECK_FALSE(critical_points(cube, {Vector::Unit(axis)}).degeneracies.empty());
    }
    CHECK(critical_points(cube, {}).degeneracies.empty());
  }
}

TEST_CASE("critical points on the wall between two spheres' patches are reported as degenerate") {
  // Two balls of one size side by side: seen along their axis, tilted by 45 degrees, the sphere's
  // pole passes into the neck's cell.
  const SkinSurface pair({ball(-1, 0, 0, 1), ball(1, 0, 0, 1)});
  const skin::Wall wall = pair.complex().walls(skin::CellId{0U})[0];
  const double height = wall.normal.dot(Vector(-1, 0, 0));
  const double along = wall.offset - height;  // from the centre to the wall, patch radius 1
  const Vector pole = along * wall.normal + std::sqrt(1 - along * along) * Vector::UnitY();
  CHECK_FALSE(critical_points(pair, {pole.normalized()}).degeneracies.empty());
  constexpr double tilt = 1e-3;
  for (const double side : {-tilt, tilt}) {
    const MorseFunction tilted{(pole + side * wall.normal).normalized()};
    const auto critical = critical_points(pair, tilted);
    CHECK(critical.degeneracies.empty());
    CHECK(critical.euler_characteristic() == 2);
  }
}

TEST_CASE(
    "a height along the asymptotic cone of a neck that is nearly none has a singular Hessian") {
  // w/2 = 2^-49 at half a distance of 4 (weights 16 + 2^-48): the smallest neck of all. At 45
  // degrees to the axis, within rounding, its two saddles run off to where the cell still is.
  const SkinSurface skin({{{-4, 0, 0}, 16 + 0x1p-48}, {{4, 0, 0}, 16 + 0x1p-48}});
  std::size_t reported = 0;
  for (int i = -8; i <= 8; ++i) {
    const double axial = std::sqrt(0.5) + i * 0x1p-53;
    const auto critical = critical_points(skin, {Vector(axial, std::sqrt(0.5), 0)});
    for (const std::string& text : critical.degeneracies) {
      reported += contains(text, "Hessian is singular");
    }
  }
  CHECK(reported > 0);
  CHECK(critical_points(skin, {Vector(0.6, 0.8, 0)}).degeneracies.empty());
}

TEST_CASE("protecting spheres are disjoint, no larger than asked and hold their own centres") {
  for_seeds<Case>(300, [](const Case& test) {
    if (test.is_degenerate()) return;
    const auto& points = test.critical.points;
    const ProtectingSpheres spheres = protecting_spheres(test.skin, points, share);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double r = spheres.radius(CriticalId{i});
      CHECK(r > 0);
      double expected = share * points[i].point.length_scale;
      for (std::size_t j = 0; j < points.size(); ++j) {
        if (j == i) continue;
        const double apart = (points[j].point.position - points[i].point.position).norm();
        expected = std::min(expected, apart / 2);
      }
      CHECK(r == expected);
      CHECK(spheres.containing(points[i].point) == CriticalId{i});
      for (std::size_t j = 0; j < i; ++j) {
        const double apart = (points[i].point.position - points[j].point.position).norm();
        CHECK(r + spheres.radius(CriticalId{j}) <= apart * (1 + 1e-15));
      }
    }
  });
}

TEST_CASE("protecting spheres of a ball that holds thousands contain their critical points") {
  // 8,000 balls inside; were each of 96,000 cells held against all before it, 5 * 10^9 questions.
  const SkinSurface skin(seeds_in_a_ball(8000));
  const CriticalPoints critical = critical_points(skin, MorseFunction{});
  REQUIRE(critical.points.size() == 2);
  const ProtectingSpheres spheres = protecting_spheres(skin, critical.points, share);
  for (const CriticalId id : {CriticalId{0U}, CriticalId{1U}}) {
    CHECK(spheres.containing(critical.points[id.index()].point) == id);
  }
}

TEST_CASE(
    "the sphere that holds a point of the skin is the one that a search of all spheres finds") {
  std::size_t held = 0;
  for_seeds<Case>(300, [&](Case& test) {
    if (test.is_degenerate()) return;
    const auto& points = test.critical.points;
    const ProtectingSpheres spheres = protecting_spheres(test.skin, points, share);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const SurfacePoint& centre = points[i].point;
      const Vector tangent = centre.normal.cross(test.random.direction()).normalized();
      const double step = test.random.between(0, 1.5) * spheres.radius(CriticalId{i});
      const auto x = test.skin.project(centre.position + step * tangent, centre.cell);
      if (!x) continue;
      std::optional<CriticalId> expected;
      for (std::size_t j = 0; j < points.size(); ++j) {
        const double r = spheres.radius(CriticalId{j});
        if ((points[j].point.position - x->position).squaredNorm() < r * r)
          expected = CriticalId{j};
      }
      held += expected.has_value();
      CHECK(spheres.containing(*x) == expected);
    }
  });
  CHECK(held > 1000);
}
