#include "answers/4.1-algorithm.h"

#include "geometry/dissection.h"
#include "morse/choose_function.h"
#include "papers/exercises/tests/course_support.h"

using namespace morskin;

TEST_CASE("4.1-algorithm, predict: the reversed function has these critical points" *
          until(of_reversed)) {
  const PreparedSkin skin = prepare_skin(support::molecule("5tmn_ligand.pdb", skin::Model::Paper));
  const auto function = morse::MorseFunction{}.reversed();
  const auto critical = morse::critical_points(skin.surface, function);
  REQUIRE(critical.degeneracies.empty());
  for (int index = 0; index < 3; ++index) {
    CAPTURE(index);
    CHECK((*of_reversed)[static_cast<std::size_t>(index)] ==
          static_cast<long>(critical.count(index)));
  }
}

TEST_CASE("4.1-algorithm, run: so many bowls are made on 9DNA in subdomains" *
          until(bowls_of_subdomains)) {
  CHECK(*bowls_of_subdomains == static_cast<long>(meshed("9dna.pdb").operations.creation));
}

TEST_CASE("4.1-algorithm, explain: so many boxes has a dissection" * until(sweeps)) {
  for (const int depth : {0, 1, 2, 5, 9}) {
    CHECK((*sweeps)(depth) == static_cast<double>(geometry::Dissection({}, depth).size()));
  }
}
