#include "answers/3.2-morse-smale-complex.h"

#include "morse/morse_smale_complex.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

namespace {

morse::MorseSmaleComplex complex_of(const char* file) {
  const skin::SkinSurface skin(support::molecule(file, skin::Model::Paper));
  const morse::MorseFunction f;
  return morse::morse_smale_complex(skin, f, morse::critical_points(skin, f));
}

}  // namespace

TEST_CASE("3.2-morse-smale-complex, predict: an inhibitor with 12 saddles has so many regions" *
          until(regions_of_12_saddles)) {
  const morse::MorseSmaleComplex complex = complex_of("5tmn_ligand.pdb");
  REQUIRE(complex.arcs.size() == 4 * 12);
  CHECK(*regions_of_12_saddles == static_cast<long>(complex.regions.size()));
}

TEST_CASE("3.2-morse-smale-complex, run: so many arcs are traced on 9DNA" * until(dna_arcs)) {
  CHECK(*dna_arcs == static_cast<long>(complex_of("9dna.pdb").arcs.size()));
}

TEST_CASE("3.2-morse-smale-complex, explain: the rise from an extremum is exact on its patch" *
          until(rise)) {
  support::for_skins(30, [](const PreparedSkin& skin) {
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
        const double expected = f(x) - f(p.point.position);
        CHECK(std::abs((*rise)(2 * f.curvature, mu, d.squaredNorm(), d.dot(patch.reflect(d))) -
                       expected) < 1e-9 * (1 + std::abs(f(x))));
      }
    }
  });
}
