// Rows of mmCIF that are laid out or filled in otherwise than the archive's.

#include "geometry/error.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

const std::string head =
    "data_test\nloop_\n_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.Cartn_x\n"
    "_atom_site.Cartn_y\n_atom_site.Cartn_z\n";

}  // namespace

TEST_CASE(
    "lines of mmCIF atoms are told where each has one, comments before or not, and else not") {
  const auto lines = [](const std::string& rows) {
    const Molecule molecule = parse_molecule(head + rows, "a.cif");
    REQUIRE(molecule.atoms.size() == 2);
    return std::pair(molecule.atoms[0].line, molecule.atoms[1].line);
  };
  CHECK(lines("C CA 0 0 0\nN N 3 0 0\n") == std::pair(8U, 9U));
  CHECK(lines("# carbon\nC CA 0 0 0\nN N 3 0 0\n") == std::pair(9U, 10U));
  CHECK(lines("C CA 0 0 0 N N 3 0 0\n") == std::pair(0U, 0U));
  CHECK(lines("C CA\n0 0 0\nN N\n3 0 0\n") == std::pair(0U, 0U));
}

TEST_CASE("a charge behind an mmCIF symbol is no part of the element") {
  CHECK(elements_of(parse_molecule(head + "N1+ NZ 0 0 0\nzn2+ ZN 3 0 0\nO1- OD1 6 0 0\n",
                                   "a.cif")) == "N Zn O");
}

TEST_CASE("an mmCIF coordinate without a value is no number, and its atom is named") {
  for (const std::string missing : {"?", ".", "x"}) {
    CHECK_THROWS_WITH_AS(parse_molecule(head + "C CA 0 0 0\nN N 3 " + missing + " 0\n", "a.cif"),
                         doctest::Contains(("a.cif:9: atom 2 has coordinate \"" + missing).c_str()),
                         UnreadableInput);
  }
}

TEST_CASE("models of mmCIF whose rows take turns are each one model") {
  const std::string table = head + "_atom_site.pdbx_PDB_model_num\n";
  const std::string rows = "C CA 0 0 0 1\nC CA 1 0 0 2\nN N 3 0 0 1\nN N 4 0 0 2\n";
  for (const std::int64_t number : {1, 2}) {
    Selection selection;
    selection.model = number;
    const Molecule molecule = parse_molecule(table + rows, "a.cif", {.selection = selection});
    CHECK(molecule.atoms.size() == 2);
    CHECK(molecule.counts.other_models == 1);
  }
}

TEST_CASE("a location cannot be chosen in an mmCIF file without a column of them") {
  Selection selection;
  selection.location = 'A';
  CHECK_THROWS_WITH_AS(parse_molecule(head + "C CA 0 0 0\n", "a.cif", {.selection = selection}),
                       doctest::Contains("does not tell an atom's alternate locations"),
                       RefusedInput);
}

TEST_CASE("an unknown occupancy of mmCIF is one, so that such an atom is likelier than a half") {
  const Molecule molecule = parse_molecule(
      head + "_atom_site.label_alt_id\n_atom_site.occupancy\nC CA 1 0 0 A 0.5\nC CA 2 0 0 B ?\n",
      "a.cif");
  REQUIRE(molecule.atoms.size() == 1);
  CHECK(molecule.atoms[0].position.x() == 2);
}
