#include "answers/4.1-creation.h"

#include "front/subdomains.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-creation, predict: so many triangles lie on the cube before the first creep" *
          until(triangles_of_bowls)) {
  // As they are at the first departure.
  class Bowls : public Observer, public front::SweepObserver {
   public:
    long triangles = 0;
    std::vector<front::SweepObserver*> sweep_observers() override { return {this}; }
    void departed(const front::Departure&, const front::Front& front) override {
      if (triangles == 0) triangles = static_cast<long>(front.mesh().surface.triangle_count());
    }
  } bowls_of_cube;
  make_mesh(prepare_skin(support::molecule("cube8.xyzr", skin::Model::Paper)), one_front(),
            bowls_of_cube);
  CHECK(*triangles_of_bowls == bowls_of_cube.triangles);
}

TEST_CASE("4.1-creation, run: so many bowls are made on 9DNA" * until(bowls)) {
  CHECK(*bowls == static_cast<long>(meshed("9dna.pdb", one_front()).operations.creation));
}

TEST_CASE("4.1-creation, explain: a projected hexagon's edges have this length" * until(rim_edge)) {
  for (const double rho : {0.1, 1.0, 3.0}) {
    const skin::SkinSurface skin({support::ball(0, 0, 0, rho)});
    for (const double share : {0.05, 0.1, 0.2, 0.4}) {
      const auto rim = [&](double angle) {
        const skin::Point q(share * rho * std::cos(angle), -rho, share * rho * std::sin(angle));
        return skin.project(q, geometry::CellId{0U})->position;
      };
      const double edge = (rim(0.3) - rim(0.3 + M_PI / 3)).norm();
      CHECK((*rim_edge)(share * rho, rho) == doctest::Approx(edge).epsilon(1e-9));
    }
  }
}
