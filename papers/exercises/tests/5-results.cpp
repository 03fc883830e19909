#include "answers/5-results.h"

#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("5-results, predict: so many seconds, with as many triangles in each, within 1 s" *
          until(linear_seconds)) {
  const double triangles_per_second = 24336.0 / 5;
  judge<double>(linear_seconds,
                [&](double given) { return std::abs(given - 305186 / triangles_per_second) < 1; },
                {{202, "That is what it took."},
                 {5 * 24336.0 / 305186, "More triangles take longer."},
                 {305186.0 / 24336, "That is how many times the triangles there are."}});
}

TEST_CASE("5-results, run: the smallest angle of an inhibitor from one front, unsmoothed" *
          until(smallest_angle_deg)) {
  const auto smallest_of = [](double goal_deg) {
    return meshed("amprenavir.pdb", {.sizing = {}, .angle_goal_deg = goal_deg, .fronts = 1})
        .certificate.min_angle_deg;
  };
  const double smallest = smallest_of(0);
  judge<double>(
      smallest_angle_deg, [&](double given) { return std::abs(given - smallest) < 0.006; },
      {{smallest_of(35), "That is with vertices moved: --angle-goal 0 leaves them."},
       {certify::Sizing{}.angle_bound_deg(), "That is what [L] and [U] promise for every mesh."}});
}

TEST_CASE("5-results, explain: the power is that of the law the times follow" * until(power)) {
  Cases<double(double, double, double, double)> cases("n1 t1 n2 t2");
  for (int i = 2; i < 12; ++i) {
    const double p = 0.25 * i;
    for (const double n : {10.0, 1e3, 1e6}) {
      const double k = 1e-6, m = 7 * n;
      cases.add(p, n, k * std::pow(n, p), m, k * std::pow(m, p));
    }
  }
  cases.add_within(0.01, 1.46, 24336, 5, 305186, 202);
  using std::log;
  cases.judge(
      power,
      {{[](double n1, double t1, double n2, double t2) { return (t2 / t1) / (n2 / n1); },
        "A power is a ratio of logarithms."},
       {[](double n1, double t1, double n2, double t2) { return log(n2 / n1) / log(t2 / t1); },
        "That is the power with which the triangles grow."},
       {[](double n1, double t1, double n2, double t2) { return log(t2 - t1) / log(n2 - n1); },
        "Divide the rows, do not subtract them."},
       {[](double, double, double n2, double t2) { return log(t2) / log(n2); },
        "One row does not do: the constant before the power is not known."}});
}
