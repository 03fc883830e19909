// Up to where a triangle's corners alone prove (c1) and (c2), by the bounds of
// papers/certificate.md written out here: each is told as much as is known, and is to count all of
// it.

#include "certify/tube.h"
#include "skin/skin_surface.h"
#include "tests/support/blurred_surface.h"
#include "tests/support/test.h"

using namespace morskin;
using certify::TubeProof;
using geometry::Point;
using geometry::Vector;
using surface::SurfacePoint;

namespace {

/// An equilateral triangle and N at its corners, whose part along its normal, z, is the same.
struct Told {
  std::array<Point, 3> at;
  std::array<Vector, 3> N;
  double normal_error = 0, max_error = 0, max_G = 0;

  /// @param spread  N's differences over those of the corners: 1 on a sphere, 0 on a cylinder's end
  Told(double R, const Point& centre, const Vector& middle_N, double spread) {
    constexpr double grid = 0x1p-12;  // is left of coordinates about 2^40
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = 2 * M_PI * static_cast<double>(k) / 3;
      const Vector arm =
          ((R / grid * Vector(std::cos(angle), std::sin(angle), 0)).array().round() * grid)
              .matrix();
      at[k] = centre + arm;
      N[k] = middle_N + spread * arm;
    }
  }

  certify::TriangleBounds shape() const {
    certify::TriangleBounds bounds = certify::triangle_bounds(at[0], at[1], at[2]);
    bounds.normal_error = normal_error;
    return bounds;
  }
  /// Where the middles of sides tell nothing.
  TubeProof proof() const {
    static const skin::SkinSurface ball({support::ball(0, 0, 0, 1)});
    constexpr double unknown = 1e9;  // times N
    std::array<SurfacePoint, 3> p;
    for (std::size_t k = 0; k < 3; ++k) {
      p[k] = {at[k], N[k].normalized(), N[k].norm(), geometry::CellId{0U}};
    }
    return certify::prove_tube(support::Blurred(ball, unknown, [] { return Vector(0, 0, 1); }),
                               {&p[0], &p[1], &p[2]}, shape(), {{max_G, max_G, max_G}, max_error});
  }

  /// How far pieces' corners may lie from their places, and N from the N of these.
  double off() const {
    double largest = 0;
    for (const Point& x : at) largest = std::max(largest, x.lpNorm<1>());
    return 0x1p-49 * largest;
  }
  double doubt() const { return max_error + off(); }
  /// Of N from its affine interpolation (Lemma 9).
  double bend() const {
    const double R = shape().circumradius;
    double fold = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t l = (k + 1) % 3;
      fold = std::max(fold, (at[l] - at[k]).squaredNorm() - (N[l] - N[k]).squaredNorm());
    }
    return std::min(R, std::sqrt((fold + 16 * doubt() * (R + doubt())) / 3));
  }
  /// Up to which |G| at the corners the tube holds.
  double largest_G() const {
    const auto [least, most] = std::minmax({N[0].norm(), N[1].norm(), N[2].norm()});
    const double R = shape().circumradius, known = least - doubt();
    const double least_N = std::sqrt(known * known - R * R) - bend();
    return least_N * least_N - R * R - (2 * (most + max_error) + off()) * off();
  }
};

/// The largest number from 0 on, known to the last digit, for which a condition holds.
/// @pre it holds for 0 and not for `no`
template <class Condition>
double largest(double no, Condition holds) {
  double yes = 0;
  for (double middle = no / 2; middle != yes && middle != no; middle = yes + (no - yes) / 2) {
    (holds(middle) ? yes : no) = middle;
  }
  return yes;
}

const std::array centres{Point(0, 0, 0), Point(0x1p40, 0, 0)};

}  // namespace

TEST_CASE("a coarse triangle is in the tube up to what its bend and all doubts leave") {
  for (const Point& centre : centres) {
    for (const double error : {0.0, 0.003, 0.01}) {
      for (const double spread : {1.0, 0.99}) {
        for (const double share : {0.9, 0.9995, 1.0005, 1.1}) {
          CAPTURE(centre.x());
          CAPTURE(error);
          CAPTURE(spread);
          CAPTURE(share);
          Told told(0.55, centre, Vector(0, 0, 0.8), spread);
          told.max_error = error;
          REQUIRE(told.largest_G() > 0.02);
          told.max_G = share * told.largest_G();
          CHECK(told.proof().holds() == (share < 1));
        }
      }
    }
  }
}

TEST_CASE("a coarse triangle is upright while N along its normal is above bend and all doubts") {
  constexpr double R = 0.25;
  for (const Point& centre : centres) {
    for (const double error : {0.0, 0.003}) {
      for (const double normal_error : {0.0, 0.01}) {
        for (const double spread : {0.0, 0.9}) {
          for (const double share : {0.9, 0.998, 1.002, 1.1}) {
            CAPTURE(centre.x());
            CAPTURE(error);
            CAPTURE(normal_error);
            CAPTURE(spread);
            CAPTURE(share);
            // N is near 2, so that no tube is in question, and leans to one side.
            const auto told = [&](double upright) {
              Told result(R, centre, Vector(2, 0, upright), spread);
              result.max_error = error;
              result.normal_error = normal_error;
              return result;
            };
            const Told any = told(0.1);
            double size = 0;
            for (const Vector& N : any.N) size = std::max(size, N.norm());
            const double least = any.bend() + any.doubt() + normal_error * size;
            CHECK(told(share * least).proof().holds() == (share > 1));
          }
        }
      }
    }
  }
}

TEST_CASE("a fine triangle is proved until the doubts about N and its normal eat what is left") {
  constexpr double R = 0x1p-9, upright = 0.25;
  for (const double part : {0.0, 0.3, 1.0}) {
    CAPTURE(part);
    for (const double share : {0.5, 0.98, 1.02, 2.0}) {
      CAPTURE(share);
      // One corner alone proves it, with a side's length to spare.
      const double most = upright - std::sqrt(3) * R;
      Told leaning(R, Point::Zero(), Vector(1, 0, upright), 0);
      leaning.max_error = share * part * most;
      leaning.normal_error = share * (1 - part) * most / leaning.N[0].norm();
      CHECK(leaning.proof().holds() == (share < 1));
      Told straight(R, Point::Zero(), Vector(0, 0, 1), 0);
      straight.max_error = 0.3 * part;
      const double known = 1 - straight.max_error - straight.shape().circumradius;
      straight.max_G = share * known * known;
      CHECK(straight.proof().holds() == (share < 1));
    }
  }
}

TEST_CASE("up to the last digit a proof holds of the very numbers told, whatever is rounded") {
  support::for_seeds(400, [](unsigned seed) {
    support::Random random(seed);
    const double R = std::exp2(-random.between(4, 8));
    Told told(R, Point::Zero(), Vector(random.between(1.2, 2), 0, random.between(0.5, 1)), 0);
    // As prove_tube has N and its size.
    const Vector N = told.N[0].norm() * told.N[0].normalized();
    const long double size = std::hypot(static_cast<long double>(N.x()), N.z());
    const long double bound = told.shape().circumradius;  // on the bend, too
    const long double upright = N.z() * static_cast<long double>(told.shape().normal.z());
    const auto is_proved_with = [&](double& number) {
      return [&](double value) {
        number = value;
        return told.proof().holds();
      };
    };

    told.normal_error = random.between(0, 0.1);
    told.max_error = largest(2, is_proved_with(told.max_error));
    CHECK(upright - told.normal_error * size - told.max_error - told.off() > bound);

    told.normal_error = 0;
    told.max_error = random.between(0.1, 0.4);
    told.max_G = largest(10, is_proved_with(told.max_G));
    // One corner alone shows more than all three with their bend.
    const long double least_N = told.N[0].norm() - static_cast<long double>(told.max_error) - bound;
    CHECK(least_N * least_N > told.max_G + bound * bound);
  });
}
