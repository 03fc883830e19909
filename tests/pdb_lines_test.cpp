// Which lines of a PDB file are atoms, and what blanks in them stand for.

#include "tests/support/molecule_texts.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

std::string carbon(char letter, double x, const char* occupancy) {
  return pdb_line("ATOM", " CA ", letter, "SER", 5, x, occupancy);
}

}  // namespace

TEST_CASE("lines that only begin like an atom's or have a chain of two letters tell of no atom") {
  std::string atom = pdb_line("ATOM", " CA ", ' ', "POP", 5, 0, "");
  atom.replace(17, 5, "POPCB");
  const std::string remark = "REMARK   3 GROUP LEUXX\n";
  REQUIRE(remark.substr(17, 5) == "LEUXX");
  const Molecule molecule = parse_molecule("ATOMIC RADII OF BONDI\n" + remark + atom, "a.pdb");
  REQUIRE(molecule.atoms.size() == 1);
  CHECK(describe(molecule.atoms[0]) == "atom CA of POPC 5 chain B (line 3)");
}

TEST_CASE(
    "an atom without a letter is another place of the one that has a letter, and goes or stays") {
  for (const auto& [plain, lettered, kept] :
       {std::tuple("  0.60", "  0.40", 1.0), std::tuple("  0.40", "  0.60", 2.0)}) {
    const Molecule molecule =
        parse_molecule(carbon(' ', 1, plain) + carbon('B', 2, lettered) +
                           pdb_line("ATOM", " N  ", ' ', "SER", 5, 3, "  0.10"),
                       "a.pdb");
    REQUIRE(molecule.atoms.size() == 2);
    CHECK(molecule.atoms[0].position.x() == kept);
    CHECK(molecule.atoms[1].position.x() == 3);
    CHECK(molecule.counts.alternates == 1);
  }
}

TEST_CASE("a blank occupancy is one, so that such an atom is likelier than a half") {
  const Molecule molecule =
      parse_molecule(carbon('A', 1, "  0.50") + carbon('B', 2, "      "), "a.pdb");
  REQUIRE(molecule.atoms.size() == 1);
  CHECK(molecule.atoms[0].position.x() == 2);
}

TEST_CASE("what begins in column 55 behind a blank has moved nothing, and is read over") {
  std::string line = carbon(' ', 1, "12 of 20");
  line[53] = ' ';  // z has two decimals
  CHECK(parse_molecule(line, "a.pdb").atoms[0].position.z() == -3.25);
}

TEST_CASE("charges, numbers in hybrid-36 and what is told beside the atoms change no atom") {
  const Molecule molecule = parse_molecule(
      "HETATM    1 NA   LIG A   1       0.000   0.000   0.000  1.00  0.00           N1+\n"
      "ANISOU    1 NA   LIG A   1     2406   1892   1614    198    519   -328       N1+\n"
      "HETATM    2 CA   LIG A   1       9.000   0.000   0.000  1.00  0.00          FE2+\n"
      "ATOM  A0000  CA  ALA aA000      18.000   0.000   0.000  1.00  0.00           C\n"
      "SIGATM    3  CA  ALA aA000       0.030   0.030   0.030  0.00  0.00           C\n"
      "ATOM  A0001  O   ALA a-999      28.000   0.000   0.000  1.00  0.00           O1-\n"
      "TER   A0002      ALA a-999\nCONECT    1    2\n",
      "a.pdb");
  CHECK(elements_of(molecule) == "N Fe C O");
  REQUIRE(molecule.atoms.size() == 4);
  CHECK(describe(molecule.atoms[1]) == "atom CA of LIG 1 chain A (line 3)");
  CHECK(describe(molecule.atoms[2]) == "atom CA of ALA A000 chain a (line 4)");
  CHECK(describe(molecule.atoms[3]) == "atom O of ALA -999 chain a (line 6)");
}
