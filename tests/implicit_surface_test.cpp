// Surfaces given by functions: the laws of the seam, all critical points of a height, refusals, and
// the same front, refinement and certificate as for skins.

#include "implicit/implicit_surface.h"

#include "certify/certificate.h"
#include "implicit/expression.h"
#include "implicit/gaussians.h"
#include "implicit/known_surfaces.h"
#include "morskin/implicit_mesh.h"
#include "tests/support/mesh_part.h"
#include "tests/support/surface_laws.h"
#include "tests/support/test.h"

using namespace morskin;
using geometry::Point;
using geometry::Vector;

namespace {

implicit::PreparedSurface of_formula(const std::string& text,
                                     const std::optional<Vector>& height = {}) {
  return implicit::prepare_surface(std::make_shared<implicit::Expression>(text),
                                   {{Point::Zero(), 1}, false}, height);
}

implicit::PreparedSurface of_gaussians(const std::vector<implicit::Ball>& balls,
                                       const implicit::GaussianOptions& options = {}) {
  const auto f = std::make_shared<implicit::Gaussians>(balls, options);
  return implicit::prepare_surface(f, {f->extent(), false}, {});
}

std::vector<implicit::Ball> some_balls(unsigned seed) {
  support::Random random(seed);
  std::vector<implicit::Ball> balls;
  const std::size_t count = 1 + random.below(5);
  for (std::size_t i = 0; i < count; ++i) {
    balls.push_back({2.5 * random.uniform() * random.direction(), 1 + random.uniform()});
  }
  return balls;
}

const std::string two_spheres = "(x^2+y^2+z^2-1)*((x-3)^2+y^2+z^2-1)/(2+x^2+y^2+z^2)";

certify::Sizing coarse() { return {0.2, certify::Sizing::quality_for(0.2)}; }

morskin::MeshResult meshed(const implicit::PreparedSurface& prepared,
                           const certify::Sizing& sizing = coarse()) {
  morskin::Observer unobserved;
  return morskin::make_mesh(prepared, {.sizing = sizing}, unobserved);
}

void check_certified(const implicit::PreparedSurface& prepared, std::size_t components,
                     long genus) {
  const morskin::MeshResult result = meshed(prepared);
  CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
  CHECK(result.certificate.components == components);
  CHECK(result.certificate.genus == genus);
  CHECK(result.certificate.proved_angle_deg() >= 30);
}

std::string refusal(const std::function<void()>& work) {
  try {
    work();
  } catch (const geometry::RefusedInput& error) {
    return error.what();
  }
  return "";
}

}  // namespace

TEST_CASE("surfaces given by formulas obey the laws of a surface") {
  for (const std::string& text : {implicit::sphere_formula(1.3), two_spheres,
                                  implicit::genus2_formula(), std::string("x^4+y^4+z^4-1")}) {
    CAPTURE(text);
    const implicit::PreparedSurface prepared = of_formula(text);
    for (unsigned seed = 0; seed < 3; ++seed) {
      support::check_surface_laws(prepared.surface, seed, 1e-9, support::Enclosed::NearTheSurface);
    }
  }
}

TEST_CASE("Gaussian surfaces obey the laws of a surface") {
  support::for_seeds(8, [&](unsigned seed) {
    support::check_surface_laws(of_gaussians(some_balls(seed)).surface, seed, 1e-9,
                                support::Enclosed::NearTheSurface);
  });
}

TEST_CASE("bounds of Gaussians over a box hold at points of the box") {
  support::for_seeds(60, [&](unsigned seed) {
    const implicit::Gaussians f(some_balls(seed), {.decay = 0.3 + 0.01 * seed});
    support::Random random(seed);
    const implicit::Box box{3 * random.uniform() * random.direction(),
                            std::exp2(-6 * random.uniform())};
    const auto bounds = f.bounds(box);
    for (int k = 0; k < 20; ++k) {
      Point x = box.centre;
      for (int i = 0; i < 3; ++i) x[i] += box.half * (2 * random.uniform() - 1);
      const auto there = f.over({x, 0});
      const auto near = f.enclose(x);
      CHECK(near.value.low <= bounds.value.high);
      CHECK(near.value.high >= bounds.value.low);
      CHECK(near.value.contains(f.at(x).value));
      CHECK(near.value.width() < 1e-12);
      for (std::size_t i = 0; i < 3; ++i) {
        CHECK(near.gradient[i].low <= bounds.gradient[i].high);
        CHECK(near.gradient[i].high >= bounds.gradient[i].low);
      }
      for (std::size_t i = 0; i < 6; ++i) {
        CHECK(there.hessian[i].width() < 1e-9);
        CHECK(there.hessian[i].low <= bounds.hessian[i].high);
        CHECK(there.hessian[i].high >= bounds.hessian[i].low);
      }
    }
  });
}

TEST_CASE("bounds of Gaussians hold over boxes larger than the molecule") {
  support::for_seeds(20, [&](unsigned seed) {
    const implicit::Gaussians f(some_balls(seed), {});
    support::Random random(seed);
    for (const double share : {0.5, 1.0, 2.0, 8.0}) {
      const implicit::Box box{f.extent().centre, share * f.extent().half};
      const auto bounds = f.bounds(box);
      CHECK(bounds.value.contains(f.at(some_balls(seed).front().centre).value));
      for (int k = 0; k < 20; ++k) {
        const Point x = box.centre + box.half * random.uniform() * random.direction();
        CHECK(bounds.value.contains(f.at(x).value));
      }
    }
  });
}

TEST_CASE("the Hessian of Gaussians is that of differences") {
  support::for_seeds(20, [&](unsigned seed) {
    const implicit::Gaussians f(some_balls(seed), {});
    support::Random random(seed);
    const Point x = 2 * random.uniform() * random.direction();
    const auto there = f.over({x, 0});
    constexpr double step = 1e-5;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector e = step * Vector::Unit(static_cast<int>(i));
      const Vector row = (f.at(x + e).gradient - f.at(x - e).gradient) / (2 * step);
      for (std::size_t j = 0; j < 3; ++j) {
        CHECK(there.hessian[implicit::symmetric_index[i][j]].middle() ==
              doctest::Approx(row[static_cast<int>(j)]).epsilon(1e-6));
      }
    }
  });
}

TEST_CASE("one Gaussian is a sphere whose length scale is its radius") {
  const implicit::PreparedSurface prepared = of_gaussians({{Point(1, 2, 3), 1.7}});
  CHECK(prepared.surface.max_length_scale() > 0.9 * 1.7 / 1.2);
  CHECK(prepared.surface.max_length_scale() < 1.7 * 1.6);
  CHECK(prepared.surface.project(Point(1, 2, 4.5), surface::CellId{0U})->position.z() ==
        doctest::Approx(4.7));
}

TEST_CASE("all critical points of a height are found, and none twice") {
  using Counts = std::array<std::size_t, 3>;
  const std::vector<Vector> heights{{0.0231, 1, 0.0137}, {1, 0.3, 0.2}, {0.1, -0.7, 0.4}};
  for (const Vector& height : heights) {
    CHECK(of_formula(implicit::sphere_formula(1), height).critical.counts() == Counts{1, 0, 1});
    CHECK(of_formula(two_spheres, height).critical.counts() == Counts{2, 0, 2});
  }
  const implicit::CriticalHeights torus = of_formula(implicit::torus_formula(3, 1)).critical;
  CHECK(torus.counts() == Counts{1, 2, 1});
  for (const implicit::CriticalHeight& p : torus.points) CHECK(p.doubt < 1e-9);
}

TEST_CASE("critical points lie where they are known to") {
  // The height along x on a torus about the z axis: at -R-r, r-R, R-r and R+r.
  const auto prepared = of_formula(implicit::torus_formula(3, 1), Vector(1, 0, 0));
  std::vector<std::pair<double, int>> found;
  for (const implicit::CriticalHeight& p : prepared.critical.points) {
    CHECK(std::hypot(p.position.y(), p.position.z()) <= 2 * p.doubt);
    found.emplace_back(std::round(1e6 * p.position.x()) / 1e6, p.index);
  }
  std::ranges::sort(found);
  CHECK(found == std::vector<std::pair<double, int>>{{-4, 0}, {-2, 1}, {2, 1}, {4, 2}});
  const std::string waves = "(x^2+y^2+z^2-1.5)*0.3+sin(2*x)*sin(4*y)*0.5*cos(4*z)";
  for (const implicit::CriticalHeight& p : of_formula(waves).critical.points) {
    CHECK(p.doubt < 1e-12);
  }
}

TEST_CASE("a singular level is refused with its critical value") {
  const auto refused = [](const std::string& text) { return refusal([&] { of_formula(text); }); };
  CHECK(support::contains(refused("x^2*(x-1)^2+y^2+z^2-1/16"), "critical value"));
  CHECK(support::contains(refused("x^2+y^2-z^2*(1-z^2)"), "(0, 0, 0)"));
  try {
    of_formula("x^2+y^2-z^2*(1-z^2)+1e-13");
    FAIL("not refused");
  } catch (const implicit::SingularLevel& error) {
    CHECK(error.critical_value / 1e-13 == doctest::Approx(1));
    CHECK(error.place.norm() < 1e-6);
  }
}

TEST_CASE("a thin neck next to a singular level is meshed") {
  check_certified(of_formula("x^2+y^2-z^2*(1-z^2)-1e-4"), 1, 0);
  check_certified(of_formula("x^2+y^2-z^2*(1-z^2)+1e-4"), 2, 0);
}

TEST_CASE("a surface that is open, missing or without room is refused") {
  const auto refused = [](const std::string& text, double half) {
    return refusal([&] {
      implicit::prepare_surface(std::make_shared<implicit::Expression>(text),
                                {{Point::Zero(), half}, true}, {});
    });
  };
  CHECK(support::contains(refused("z", 2), "not closed"));
  CHECK(support::contains(refused("1-x^2-y^2-z^2", 2), "not above zero outside"));
  CHECK(support::contains(refused("x^2+y^2+z^2+1", 2), "no zero"));
  CHECK(support::contains(refused("x^2+y^2+z^2-2", 2), "room"));
  CHECK(refused("x^2+y^2+z^2-1", 8) == "");
}

TEST_CASE("in the room of a surface its half gradient is 1-Lipschitz") {
  const implicit::PreparedSurface prepared = of_formula(implicit::genus2_formula());
  const implicit::ImplicitSurface& of_genus2 = prepared.surface;
  const surface::CellId cell{0U};
  support::Random random(1);
  std::size_t count = 0;
  double largest = 0;
  for (const implicit::CoverBox& b : of_genus2.cover().boxes) {
    const auto p = of_genus2.project(b.box.centre, cell);
    if (!p) continue;
    const auto near = [&] {
      return Point(p->position + 2 * p->length_scale * random.uniform() * random.direction());
    };
    const Point x = near(), y = near();
    const surface::Jet at_x = of_genus2.jet(x, cell);
    const Vector change = at_x.half_gradient - of_genus2.jet(y, cell).half_gradient;
    CHECK(change.norm() <= (x - y).norm() * (1 + 1e-9));
    largest = std::max(largest, change.norm() / (x - y).norm());
    CHECK(std::isfinite(of_genus2.enclose(x, cell).error) ==
          of_genus2.room().contains(x, 2 * at_x.half_gradient.norm()));
    ++count;
  }
  CHECK(count > 1000);
  CHECK(largest > 0.3);  // else the bound is of little use
}

TEST_CASE("sphere, torus, genus 2, two spheres and a user's formula are certified") {
  check_certified(of_formula(implicit::sphere_formula(2)), 1, 0);
  check_certified(of_formula(implicit::torus_formula(2.5, 1)), 1, 1);
  check_certified(of_formula(implicit::genus2_formula()), 1, 2);
  check_certified(of_formula(two_spheres), 2, 0);
  check_certified(of_formula("x^4+y^4+z^4-1-sin(2*x)*cos(y)/4"), 1, 0);
}

TEST_CASE("Gaussian surfaces of random balls are certified") {
  support::for_seeds(6, [&](unsigned seed) {
    const morskin::MeshResult result = meshed(of_gaussians(some_balls(seed)));
    CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
  });
}

TEST_CASE("a mesh without one of the surface's components is not certified") {
  const implicit::PreparedSurface prepared = of_formula(two_spheres);
  const geometry::IndexedMesh whole = meshed(prepared).mesh;
  const geometry::IndexedMesh kept = support::mesh_part(
      whole, [&](std::size_t t) { return whole.positions[whole.triangles[t][0]].x() < 1.5; });
  const auto certificate = morskin::certify_implicit(kept, {}, prepared, coarse());
  CHECK(certificate.holds(certify::Claim::Degree));
  CHECK(!certificate.holds(certify::Claim::Counts));
  CHECK(!certificate.certified);
}

// A torus changes no Euler characteristic, and the number of components alone told the two apart:
// the minimum that no vertex of the coarse one was near counted for the one that was left out.
TEST_CASE("a mesh of one of two tori is not certified, though it is too coarse for its minimum") {
  const implicit::PreparedSurface prepared = of_formula("(x^2+y^2+(z^2-9)^2/36+3)^2-16*(x^2+y^2)");
  const certify::Sizing sizing{0.56, certify::Sizing::quality_for(0.56)};
  morskin::Observer unobserved;
  const auto whole = make_mesh(prepared, {.sizing = sizing, .angle_goal_deg = 0}, unobserved).mesh;
  for (const double side : {-1, 1}) {
    const geometry::IndexedMesh torus = support::mesh_part(whole, [&](std::size_t t) {
      return side * whole.positions[whole.triangles[t][0]].z() > 0;
    });
    const auto certificate = morskin::certify_implicit(torus, {}, prepared, sizing);
    CHECK(certificate.holds(certify::Claim::Degree));
    CHECK(support::contains(certificate.broken_by(certify::Claim::Counts), "minimum"));
    CHECK(!certificate.certified);
  }
}

TEST_CASE("bodies that a larger cube adds have room, however symmetric they lie to those before") {
  // Within 0.15 of four points.
  const auto prepared = of_formula(
      "0.3 - exp(-60*((x-0.75)^2+(y-0.75)^2+(z-0.75)^2)) - exp(-60*(x^2+(y-1.25)^2+z^2))"
      "- exp(-60*((x+0.75)^2+(y+0.75)^2+(z+0.75)^2)) - exp(-60*(x^2+(y+1.25)^2+z^2))");
  CHECK(prepared.critical.points.size() == 8);
  for (const auto& p : prepared.critical.points)
    CHECK(std::isfinite(prepared.surface.enclose(p.position, surface::CellId{0U}).error));
}
