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
