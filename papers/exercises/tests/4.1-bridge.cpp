#include "answers/4.1-bridge.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-bridge, predict: so many bridges are built on a ring" * until(ring_bridges)) {
  const MeshResult ring = meshed("ring12.xyzr", one_front());
  REQUIRE(ring.surviving_points[1] == 2);
  const long bridges = static_cast<long>(ring.operations.bridge);
  judge<long>(ring_bridges, [&](long given) { return given == bridges; },
              {{1, "That closes the front's two ends below. How does it leave the ring above?"},
               {0, "At a saddle two sides of a front, or two fronts, meet."},
               {4, "One at a saddle; the minimum and the maximum have none."}});
}

TEST_CASE("4.1-bridge, run: so many touches lie outside of protecting spheres" *
          until(touches_outside)) {
  judge_run(touches_outside,
            meshed("2buk.pdb.gz", one_front(0.18)).operations.guard_outside_protecting,
            "mesh bench/molecules/2buk.pdb.gz -C 0.18 --fronts 1 -o x.ply --json; it is "
            "operations.guard_outside_protecting");
}

TEST_CASE("4.1-bridge, explain: the level set below a neck's upper saddle has this gap" *
          until(depth_of_gap)) {
  // The waist of a neck of radius rho about the x axis: y^2 + z^2 = rho^2 at x = 0.
  Cases<double(double, double)> cases("rho edge");
  for (const double rho : {0.5, 1.0, 4.0}) {
    for (const double share : {0.01, 0.02, 0.1}) {
      const double y = share * rho / 2, depth = rho - std::sqrt(rho * rho - y * y);
      cases.add_within(0.004 * depth, depth, rho, share * rho);
    }
  }
  cases.judge(depth_of_gap,
              {{[](double rho, double edge) { return edge * edge / (2 * rho); },
                "The branches stand at y and at -y."},
               {[](double rho, double edge) { return edge * edge / (4 * rho); },
                "Each branch is half an edge away, and that is squared."},
               {[](double rho, double edge) { return edge / (8 * rho); },
                "The skin falls off with the square of the distance."},
               {[](double rho, double edge) { return edge * edge * rho / 8; },
                "That is no length. Where the skin bends more it falls off faster."}});
}
