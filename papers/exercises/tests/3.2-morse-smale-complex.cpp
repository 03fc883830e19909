#include "answers/3.2-morse-smale-complex.h"

#include "morse/morse_smale_complex.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

namespace {

morse::MorseSmaleComplex complex_of(const char* file, skin::Model model) {
  const skin::SkinSurface skin(support::molecule(file, model));
  const morse::MorseFunction f;
  return morse::morse_smale_complex(skin, f, morse::critical_points(skin, f));
}

}  // namespace

TEST_CASE("3.2-morse-smale-complex, predict: caffeine with 6 saddles has so many regions" *
          until(regions_of_6_saddles)) {
  const morse::MorseSmaleComplex complex = complex_of("caffeine.xyz", skin::Model::Paper);
  REQUIRE(complex.arcs.size() == 4 * 6);
  judge<long>(
      regions_of_6_saddles,
      [&](long given) { return given == static_cast<long>(complex.regions.size()); },
      {{24, "So many arcs there are. Each region has four of them."},
       {6, "An arc borders on two regions."},
       {48, "Each region has four arcs, and each arc two regions."},
       {8, "V - E + F counts critical points, arcs and regions; saddles alone do not do."}});
}

TEST_CASE("3.2-morse-smale-complex, run: so many arcs are traced on a protein of a virus" *
          until(arcs_of_2buk)) {
  judge_run(arcs_of_2buk, complex_of("2buk.pdb.gz", skin::Model::Vdw).arcs.size(),
            "morse bench/molecules/2buk.pdb.gz --raw -o x.json; it is before.arcs");
}

TEST_CASE("3.2-morse-smale-complex, explain: the rise from an extremum is exact on its patch" *
          until(rise)) {
  Cases<double(double, double, double, double)> cases("c mu d_d d_Md");
  cases.add(1.5, 2, 1, 2, 1);
  cases.add(-1, 0, 2, 3, 1);
  support::for_skins(30, [&](const PreparedSkin& skin) {
    support::Random random(1);
    for (const auto& f :
         {morse::MorseFunction{}, morse::MorseFunction::squared_distance({0.3, -7, 0.4})}) {
      for (const auto& p : morse::critical_points(skin.surface, f).points) {
        if (p.index == 1) continue;
        const skin::Patch& patch = skin.surface.complex().patch(p.point.cell);
        const double rho = p.point.length_scale;
        const skin::Point x = patch.slide(p.point.position + 0.3 * rho * random.direction());
        const skin::Vector d = x - p.point.position;
        const double mu = f.gradient(p.point.position).dot(p.point.normal) / rho;
        cases.add_within(1e-9 * (1 + std::abs(f(x))), f(x) - f(p.point.position), 2 * f.curvature,
                         mu, d.squaredNorm(), d.dot(patch.reflect(d)));
      }
    }
  });
  cases.judge(
      rise,
      {{[](double c, double mu, double d_d, double d_Md) { return c / 2 * d_d + mu / 2 * d_Md; },
        "Look at the sign: on the patch 2 N(p) . d is not d . M d."},
       {[](double c, double mu, double d_d, double d_Md) { return c / 2 * d_d - mu * d_Md; },
        "N is half the gradient of G."},
       {[](double c, double mu, double d_d, double d_Md) { return c * d_d - mu / 2 * d_Md; },
        "For a squared distance c is 2, and |d|^2 comes in once."},
       {[](double, double mu, double, double d_Md) { return -mu / 2 * d_Md; },
        "That is right for heights; a distance bends too."}});
}
