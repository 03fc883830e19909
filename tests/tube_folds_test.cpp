// Triangles across folds of N, where a proof has least to spare: they stand on the skin, so that N
// lies nearly in their plane, and are as steep as is proved.

#include <doctest/doctest.h>

#include "certify/tube.h"
#include "tests/support/meshes.h"

using namespace morskin;
using certify::TubeProof;
using geometry::CellId;
using geometry::Point;
using geometry::Vector;
using surface::SurfacePoint;

namespace {

/// An equilateral triangle about a point.
struct Standing {
  Point middle;
  CellId cell;    ///< of the middle
  Vector up;      ///< the direction of N there
  Vector normal;  ///< of the triangle, at right angles to `up` if it does not lean
  double radius;  ///< of its circumcircle
  double turn;    ///< in its plane

  Vector leaning_normal(double lean) const { return std::cos(lean) * normal + std::sin(lean) * up; }
  std::array<Point, 3> corners(double lean) const {
    const Vector n = leaning_normal(lean), e = n.unitOrthogonal(), f = n.cross(e);
    std::array<Point, 3> result;
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = turn + 2 * M_PI * static_cast<double>(k) / 3;
      result[k] = middle + radius * (std::cos(angle) * e + std::sin(angle) * f);
    }
    return result;
  }
};

Vector half_gradient(const skin::SkinSurface& skin, const Point& x, CellId hint) {
  return skin.patch(skin.locate(x, hint)).half_gradient(x);
}

/// Calls visit(point) on a grid all over a triangle.
template <class Visit>
void for_points_of(const std::array<Point, 3>& corners, int n, Visit visit) {
  for (int i = 0; i <= n; ++i) {
    for (int j = 0; i + j <= n; ++j) {
      visit(Point((i * corners[0] + j * corners[1] + (n - i - j) * corners[2]) / n));
    }
  }
}

/// How much less upright N is somewhere on the triangle than at its corners, over its radius.
double fold(const skin::SkinSurface& skin, const Standing& triangle) {
  const auto corners = triangle.corners(0);
  const auto upright = [&](const Point& x) {
    return half_gradient(skin, x, triangle.cell).dot(triangle.normal);
  };
  const double at_corners =
      std::min({upright(corners[0]), upright(corners[1]), upright(corners[2])});
  double least = at_corners;
  for_points_of(corners, 4, [&](const Point& x) { least = std::min(least, upright(x)); });
  return (at_corners - least) / triangle.radius;
}

/// About a point of the skin or another near it, one that is folded as much as random changes lead
/// to.
Standing much_folded(const skin::SkinSurface& skin, const SurfacePoint& at,
                     support::Random& random) {
  Standing best{at.position,           at.cell, at.normal, at.normal.unitOrthogonal(),
                0.2 * at.length_scale, 0};
  double most = fold(skin, best);
  for (int k = 0; k < 150; ++k) {
    const double change = std::pow(0.97, k);
    const Point beside = best.middle + 0.3 * change * at.length_scale * random.direction();
    const auto to = skin.project(beside, best.cell);
    if (!to) continue;
    const Vector across =
        to->normal.cross(best.up.cross(best.normal) + change * random.direction());
    const double share = std::clamp(
        best.radius / to->length_scale + 0.1 * change * random.between(-1, 1), 0.05, 0.3);
    const Standing next{to->position,
                        to->cell,
                        to->normal,
                        -across.normalized(),
                        share * to->length_scale,
                        best.turn + change * random.between(-1, 1)};
    const double found = fold(skin, next);
    if (found > most) most = found, best = next;
  }
  return best;
}

/// How N at the corners is told wrong.
struct Lie {
  double off;      ///< Angstrom
  double upright;  ///< the part of it along the triangle's normal; the rest is away from the others
};

TubeProof deceived_proof(const skin::SkinSurface& skin, const Standing& triangle, double lean,
                         const Lie& lie) {
  const auto corners = triangle.corners(lean);
  std::array<Vector, 3> N;
  for (std::size_t k = 0; k < 3; ++k) N[k] = half_gradient(skin, corners[k], triangle.cell);
  const Vector mean = (N[0] + N[1] + N[2]) / 3;
  std::array<SurfacePoint, 3> p;
  certify::CornerBounds known{{}, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    p[k] = skin.at(corners[k], skin.locate(corners[k], triangle.cell));
    const surface::Enclosure about = skin.enclose(corners[k], p[k].cell);
    known.max_values[k] = about.max_value();
    known.max_error = std::max(known.max_error, about.error + 1e-14 * p[k].length_scale + lie.off);
    const Vector aside = (1 - lie.upright) * (N[k] - mean).normalized();
    const Vector told = N[k] + lie.off * (aside + lie.upright * triangle.leaning_normal(lean));
    p[k].length_scale = told.norm();
    p[k].normal = told.normalized();
  }
  return certify::prove_tube(skin, {&p[0], &p[1], &p[2]},
                             certify::triangle_bounds(corners[0], corners[1], corners[2]), known);
}

/// The least lean at which a triangle is proved, if one is found.
std::optional<double> steepest(const skin::SkinSurface& skin, const Standing& triangle,
                               const Lie& lie) {
  double good = 0.5 * M_PI, bad = -0.5;
  if (!deceived_proof(skin, triangle, good, lie).holds()) return std::nullopt;
  while (good - bad > 1e-6) {
    const double lean = (good + bad) / 2;
    (deceived_proof(skin, triangle, lean, lie).holds() ? good : bad) = lean;
  }
  return good;
}

}  // namespace

TEST_CASE("the steepest triangle that is proved is upright and in the tube across any fold of N") {
  std::size_t held = 0, folded = 0;
  support::for_skins(60, [&](unsigned seed, const PreparedSkin& prepared) {
    const skin::SkinSurface& skin = prepared.surface;
    const auto samples = skin.samples().points;
    support::Random random(seed);
    for (int i = 0; i < 25; ++i) {
      const Standing triangle = much_folded(skin, samples[random.below(samples.size())], random);
      const Lie lie{i % 3 == 0 ? 0 : triangle.radius * random.between(0, 0.2),
                    i % 3 == 1 ? 0.0 : 1};
      const auto lean = steepest(skin, triangle, lie);
      if (!lean) continue;
      const auto corners = triangle.corners(*lean);
      const Vector n = (corners[1] - corners[0]).cross(corners[2] - corners[0]).normalized();
      for_points_of(corners, 12, [&](const Point& x) {
        const skin::Patch patch = skin.patch(skin.locate(x, triangle.cell));
        CHECK(patch.half_gradient(x).dot(n) > 0);
        CHECK(std::abs(patch.value(x)) < patch.half_gradient(x).squaredNorm());
      });
      ++held;
      folded += fold(skin, triangle) > 0.3;
    }
  });
  CHECK(held > 1000);
  CHECK(folded > 150);  // the law was put to the test
}
