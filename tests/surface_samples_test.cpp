// The law of surface.h on samples: all stand for as much of the integral of rho^-2, so that
// `each` times the sum of rho^2 over those in a part is about the part's area.

#include <algorithm>
#include <cmath>
#include <functional>

#include "implicit/expression.h"
#include "implicit/known_surfaces.h"
#include "morskin/implicit_mesh.h"
#include "skin/skin_surface.h"
#include "surface/graded_surface.h"
#include "tests/support/ball_sets.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using geometry::Point;

namespace {

using Weight = std::function<double(const surface::SurfacePoint&)>;

double sum(const surface::Samples& samples, const Weight& weight) {
  double result = 0;
  for (const surface::SurfacePoint& x : samples.points) result += samples.each * weight(x);
  return result;
}

double area(const surface::Samples& samples) {
  return sum(samples, [](const auto& x) { return x.length_scale * x.length_scale; });
}

}  // namespace

TEST_CASE("two balls that touch from inside, whose patch is a cone, leave all samples there") {
  const Balls touching{{Point(0, 0, 0), 1}, {Point(1, 1, 0), 2}};
  const skin::SkinSurface surface(weighted(touching));
  CHECK(surface.extent(surface.locate(Point(-1, -1, 0), {}), 1).area < 1e4);
  const surface::Samples samples = surface.samples();
  CHECK(samples.points.size() >= 20);
  CHECK(area(samples) == doctest::Approx(4 * M_PI * 4).epsilon(0.25));
}

TEST_CASE("limited length scales have as many samples as their own integral wants") {
  const skin::SkinSurface sphere(weighted(Balls{{Point(0, 0, 0), 2}}));
  const surface::SizeField sizes({{Point(2, 0, 0), 0.05}}, 0.2);
  const surface::GradedSurface graded(sphere, sizes);
  CHECK(area(graded.samples()) == doctest::Approx(16 * M_PI).epsilon(0.2));
  CHECK(sum(graded.samples(), [](const auto&) { return 1.0; }) >
        2 * sum(sphere.samples(), [](const auto&) { return 1.0; }));
}

TEST_CASE("every half of a torus has the samples of half its integral") {
  const implicit::PreparedSurface torus = implicit::prepare_surface(
      std::make_shared<implicit::Expression>(implicit::torus_formula(2, 0.5)),
      {{Point::Zero(), 3}, false}, {});
  const surface::Samples samples = torus.surface.samples();
  CHECK(samples.points.size() >= 200);
  const double all = static_cast<double>(samples.points.size());
  for (int axis = 0; axis < 3; ++axis) {
    const double upper = static_cast<double>(
        std::ranges::count_if(samples.points, [&](const auto& x) { return x.position[axis] > 0; }));
    CHECK(upper / all == doctest::Approx(0.5).epsilon(0.06));
  }
}
