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
  judge<long>(triangles_of_bowls, [&](long given) { return given == bowls_of_cube.triangles; },
              {{6, "That is one bowl, or all minima."},
               {42, "Those are the vertices: the lowest point of each bowl counts as well."},
               {30, "Six angles of 60 degrees go round, not five."},
               {48, "Each minimum gets a bowl; the saddles get none."}});
}

TEST_CASE("4.1-creation, run: so many bowls are made on a protein of a virus" * until(bowls)) {
  judge_run(bowls, meshed("2buk.pdb.gz", one_front(0.2)).operations.creation,
            "mesh bench/molecules/2buk.pdb.gz -C 0.2 --fronts 1 -o x.ply --json; it is "
            "operations.creation");
}

TEST_CASE("4.1-creation, explain: a projected hexagon's edges have this length" * until(rim_edge)) {
  Cases<double(double, double)> cases("r rho");
  for (const double rho : {0.1, 1.0, 3.0}) {
    const skin::SkinSurface skin({support::ball(0, 0, 0, rho)});
    for (const double share : {0.4, 0.2, 0.1, 0.05}) {
      const auto rim = [&](double angle) {
        const skin::Point q(share * rho * std::cos(angle), -rho, share * rho * std::sin(angle));
        return skin.project(q, geometry::CellId{0U})->position;
      };
      const double edge = (rim(0.3) - rim(0.3 + M_PI / 3)).norm();
      cases.add_within(1e-9, edge, share * rho, rho);
    }
  }
  cases.judge(rim_edge,
              {{[](double r, double) { return r; },
                "That is its length on the disk; it shrinks when its ends drop to the sphere."},
               {[](double r, double rho) { return r * rho * rho / (r * r + rho * rho); },
                "Both ends are scaled alike, so the edge is scaled once."},
               {[](double r, double rho) { return r * std::sqrt(1 - r * r / (rho * rho)); },
                "The points slide towards the centre, not along the normal at the lowest point."},
               {[](double r, double rho) { return std::hypot(r, rho) * r / rho; },
                "A rim point lies outside of the sphere: it comes nearer to the centre."}});
}
