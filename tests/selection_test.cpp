// Which atoms of a file are read when a selection asks for some of them.

#include "skin/selection.h"

#include <algorithm>
#include <vector>

#include "geometry/error.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

struct Row {
  const char* record;
  const char* name;
  const char* residue;
  char chain;
  const char* element;
  char alternate = '.';
  double occupancy = 1;
};

// Two chains and atoms of none; a ligand in either chain; water; a serine in two places.
const std::vector<Row> rows = {{"ATOM", "N", "ALA", 'A', "N"},
                               {"ATOM", "H", "ALA", 'A', "H"},
                               {"ATOM", "OG", "SER", 'A', "O", 'A', 0.3},
                               {"ATOM", "OG", "SER", 'A', "O", 'B', 0.5},
                               {"ATOM", "OG", "SER", 'A', "O", 'C', 0.2},
                               {"HETATM", "C1", "LIG", 'A', "C"},
                               {"ATOM", "CB", "GLY", 'B', "C", 'A', 0.6},
                               {"ATOM", "CB", "GLY", 'B', "C", 'C', 0.4},
                               {"ATOM", "D", "GLY", 'B', "D"},
                               {"HETATM", "S", "SO4", 'B', "S"},
                               {"HETATM", "O", "HOH", 'B', "O"},
                               {"ATOM", "P", "DA", ' ', "P"}};

using Rows = std::vector<Row>;

std::string pdb_of(const Rows& atoms) {
  std::string text;
  int number = 0;
  for (const Row& row : atoms) {
    char line[160];
    std::snprintf(line, sizeof line,
                  "%-6s%5d  %-3s%c%3s %c%4d    %8.3f%8.3f%8.3f%6.2f  0.00          %2s\n",
                  row.record, number, row.name, row.alternate == '.' ? ' ' : row.alternate,
                  row.residue, row.chain, 1, 3.0 * number, 0.0, 0.0, row.occupancy, row.element);
    text += line;
    ++number;
  }
  return text;
}

std::string mmcif_of(const Rows& atoms, const std::string& model = "1") {
  std::string text;
  int number = 0;
  for (const Row& row : atoms) {
    text += std::string(row.record) + " " + row.element + " " + row.name + " " + row.residue +
            " 1 " + (row.chain == ' ' ? '?' : row.chain) + " Z " + row.alternate + " " +
            std::to_string(row.occupancy) + " " + std::to_string(3 * number++) + " 0 0 " + model +
            "\n";
  }
  return text;
}

const std::string cif_head =
    "data_test\nloop_\n_atom_site.group_PDB\n_atom_site.type_symbol\n_atom_site.label_atom_id\n"
    "_atom_site.label_comp_id\n_atom_site.auth_seq_id\n_atom_site.auth_asym_id\n"
    "_atom_site.label_asym_id\n_atom_site.label_alt_id\n_atom_site.occupancy\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.pdbx_PDB_model_num\n";

// Without alternate locations, which the format does not have.
std::string pqr_of(const Rows& atoms) {
  std::string text;
  int number = 0;
  for (const Row& row : atoms) {
    if (row.alternate == '.' || row.alternate == 'A') {
      text += std::string(row.record) + " " + std::to_string(number) + " " + row.name + " " +
              row.residue + " " + (row.chain == ' ' ? "" : std::string(1, row.chain)) + " 1 " +
              std::to_string(3 * number) + " 0 0 0.1 1.5\n";
    }
    ++number;
  }
  return text;
}

struct File {
  std::string name, text;
};
const std::vector<File> files = {
    {"a.pdb", pdb_of(rows)}, {"a.cif", cif_head + mmcif_of(rows)}, {"a.pqr", pqr_of(rows)}};

Molecule read(const File& file, Selection selection = {}) {
  return parse_molecule(file.text, file.name, {.selection = std::move(selection)});
}

// The atoms by their x, which is another for each.
std::vector<double> places(const Molecule& molecule) {
  std::vector<double> xs;
  for (const Atom& atom : molecule.atoms) xs.push_back(atom.position.x());
  std::ranges::sort(xs);
  return xs;
}

std::string refusal(const File& file, const Selection& selection) {
  try {
    read(file, selection);
  } catch (const RefusedInput& refused) {
    return refused.what();
  }
  return "";
}

std::string letters(const Molecule& molecule) {
  std::string text;
  for (const Atom& atom : molecule.atoms) {
    const auto row = static_cast<std::size_t>(atom.position.x() / 3);
    if (rows[row].alternate != '.') text += rows[row].alternate;
  }
  return text;
}

std::size_t all_left_out(const ReadingCounts& counts) {
  return counts.other_chains + counts.waters + counts.hetatms + counts.alternates +
         counts.hydrogens;
}

}  // namespace

TEST_CASE("the atoms of chain A and those of the others together are all atoms") {
  for (const File& file : files) {
    CAPTURE(file.name);
    const Molecule all = read(file);
    const Molecule a = read(file, {.chains = {"A"}});
    const Molecule others = read(file, {.chains = {"_", "B"}});
    CHECK(std::ranges::all_of(a.atoms, [](const Atom& atom) { return atom.chain.view() == "A"; }));
    CHECK(others.atoms.back().name.view() == "P");
    std::vector<double> both = places(a);
    std::ranges::copy(places(others), std::back_inserter(both));
    std::ranges::sort(both);
    CHECK(both == places(all));
    CHECK(places(read(file, {.chains = {"A", "B", "_"}})) == places(all));
  }
}

TEST_CASE("a chain that no atom has is refused and the chains that there are named") {
  for (const File& file : files) {
    CAPTURE(file.name);
    CHECK(refusal(file, {.chains = {"A", "x", ""}}) ==
          file.name + ": has no chain \"\", x; choose from A, B, _");
  }
}

TEST_CASE("what a format does not tell cannot be chosen by") {
  for (const File& file :
       {File{"a.xyz", small_xyz}, File{"a.xyzr", small_xyzr}, File{"a.xyzw", "0 0 0 2\n"}}) {
    CAPTURE(file.name);
    CHECK(refusal(file, {.chains = {"A"}}) ==
          file.name + ": does not tell an atom's chain; do not choose by it");
    CHECK_FALSE(refusal(file, {.hetatms = std::vector<std::string>{}}).empty());
    CHECK_FALSE(refusal(file, {.all_locations = true}).empty());
    CHECK_FALSE(refusal(file, {.location = 'A'}).empty());
  }
  CHECK_FALSE(refusal({"a.xyzr", small_xyzr}, {.hydrogens = false}).empty());
  CHECK(read({"a.xyz", "2\n\nH 0 0 0\nC 1 0 0\n"}, {.hydrogens = false}).atoms.size() == 1);
}

TEST_CASE("everything left out is counted under one reason") {
  const std::vector<Selection> selections = {
      {.chains = {"A"}},
      {.chains = {"B"}, .waters = true},
      {.hetatms = std::vector<std::string>{}},
      {.hetatms = std::vector<std::string>{"LIG"}, .location = 'C', .hydrogens = false},
      {.waters = true, .all_locations = true}};
  for (const File& file : files) {
    const std::size_t atoms = file.name == "a.pqr" ? rows.size() - 3 : rows.size();
    for (Selection selection : selections) {
      if (file.name == "a.pqr") selection.location = {}, selection.all_locations = false;
      const Molecule molecule = read(file, selection);
      CHECK(molecule.atoms.size() + all_left_out(molecule.counts) == atoms);
    }
  }
}

TEST_CASE("with all locations, waters and hydrogens nothing is dropped") {
  for (const File& file : {files[0], files[1]}) {
    CHECK(all_left_out(read(file, {.waters = true, .all_locations = true}).counts) == 0);
  }
  CHECK(read(files[0], {.waters = true, .all_locations = true}).atoms.size() == rows.size());
}

TEST_CASE("a letter is kept where an atom has it, and elsewhere the likeliest") {
  for (const File& file : {files[0], files[1]}) {
    CAPTURE(file.name);
    CHECK(letters(read(file)) == "BA");
    CHECK(letters(read(file, {.location = 'A'})) == "AA");
    CHECK(letters(read(file, {.location = 'B'})) == "BA");
    CHECK(letters(read(file, {.location = 'C'})) == "CC");
    CHECK(letters(read(file, {.location = 'D'})) == "BA");
  }
}

TEST_CASE("a letter chooses among the identities of a residue") {
  const File file{"a.pdb", pdb_of({{"ATOM", "CB", "PRO", 'A', "C", 'A', 0.6},
                                   {"ATOM", "CG", "PRO", 'A', "C", 'A', 0.6},
                                   {"ATOM", "CB", "SER", 'A', "C", 'B', 0.4},
                                   {"ATOM", "OG", "SER", 'A', "O", 'B', 0.4}})};
  CHECK(names_of(read(file)) == "CB CG");
  CHECK(names_of(read(file, {.location = 'B'})) == "CB OG");
}

TEST_CASE("without hydrogens all others stay, and a file without any stays whole") {
  for (const File& file : files) {
    const Molecule molecule = read(file, {.hydrogens = false});
    CHECK(molecule.counts.hydrogens == 2);
    CHECK(molecule.atoms.size() + 2 == read(file).atoms.size());
    CHECK(elements_of(molecule).find_first_of("HD") == std::string::npos);
  }
  const File bare{"a.pdb", small_pdb()};
  CHECK(places(read(bare, {.hydrogens = false})) == places(read(bare)));
  CHECK(read(bare, {.hydrogens = false}).counts.hydrogens == 0);
}

TEST_CASE("of HETATM records all, none or the residues named are kept") {
  for (const File& file : files) {
    CAPTURE(file.name);
    const std::size_t all = read(file).atoms.size();
    const Molecule none = read(file, {.hetatms = std::vector<std::string>{}});
    CHECK(none.counts.hetatms == 2);
    CHECK(none.atoms.size() == all - 2);
    const Molecule ligand = read(file, {.hetatms = std::vector<std::string>{"LIG"}});
    CHECK(ligand.counts.hetatms == 1);
    CHECK(places(read(file, {.hetatms = std::vector<std::string>{"SO4", "LIG"}})) ==
          places(read(file)));
    CHECK(refusal(file, {.hetatms = std::vector<std::string>{"ALA"}}) ==
          file.name + ": has no HETATM record of a residue ALA; choose from LIG, SO4");
  }
}

TEST_CASE("waters go and stay as they are asked for, whatever is said of HETATM records") {
  for (const File& file : files) {
    for (const auto& hetatms :
         {std::optional<std::vector<std::string>>(), {std::vector<std::string>{}}}) {
      CHECK(read(file, {.hetatms = hetatms}).counts.waters == 1);
      const Molecule wet = read(file, {.waters = true, .hetatms = hetatms});
      CHECK(wet.counts.waters == 0);
      CHECK(std::ranges::count(wet.atoms, Label("HOH"), &Atom::residue) == 1);
    }
  }
}

TEST_CASE("a selection that leaves nothing says what it left out last") {
  const File water{"a.pdb", pdb_of({{"ATOM", "N", "ALA", 'A', "N"},
                                    {"HETATM", "O", "HOH", 'W', "O"},
                                    {"HETATM", "C", "LIG", 'L', "C"},
                                    {"ATOM", "H", "ALA", 'H', "H"}})};
  CHECK(refusal(water, {.chains = {"W"}}) ==
        "a.pdb: no atom of chain W is left without water; leave less out");
  CHECK(refusal(water, {.chains = {"L"}, .hetatms = std::vector<std::string>{}}) ==
        "a.pdb: no atom of chain L is left without the HETATM records; leave less out");
  CHECK(refusal(water, {.chains = {"H"}, .hydrogens = false}) ==
        "a.pdb: no atom of chain H is left without hydrogen; leave less out");
  CHECK(read(water, {.chains = {"W"}, .waters = true}).atoms.size() == 1);
}

TEST_CASE("a model is found by its number, or by its place where the file gives none") {
  const auto one = [](double x) { return pdb_line("ATOM", " CA ", ' ', "ALA", 1, x, ""); };
  const File numbered{"a.pdb", "MODEL        3\n" + one(3) + "ENDMDL\nMODEL        7\n" + one(7) +
                                   one(8) + "ENDMDL\nMODEL        5\n" + one(5) + "ENDMDL\n"};
  const File placed{"a.pdb", one(1) + "END\n" + one(2) + "END\n"};
  CHECK(places(read(numbered)) == std::vector<double>{3});
  CHECK(places(read(numbered, {.model = 7})) == std::vector<double>{7, 8});
  CHECK(read(numbered, {.model = 7}).counts.other_models == 2);
  CHECK(refusal(numbered, {.model = 1}) == "a.pdb: has no model 1; choose from 3, 5, 7");
  CHECK(places(read(placed, {.model = 2})) == std::vector<double>{2});
  CHECK(refusal(placed, {.model = 3}) == "a.pdb: has no model 3; choose from 1, 2");
  CHECK(refusal({"a.xyzr", small_xyzr}, {.model = 2}) ==
        "a.xyzr: has no model 2; its only one is number 1");
}

TEST_CASE("a model of mmCIF, XYZ and PQR is found as that of PDB") {
  const File cif{"a.cif",
                 cif_head + mmcif_of({rows[0]}, "10") + mmcif_of({rows[0], rows[1]}, "12")};
  CHECK(read(cif).atoms.size() == 1);
  CHECK(read(cif, {.model = 12}).atoms.size() == 2);
  CHECK(read(cif, {.model = 12}).counts.other_models == 1);
  CHECK(refusal(cif, {.model = 2}) == "a.cif: has no model 2; choose from 10, 12");
  const File xyz{"a.xyz", small_xyz + "1\n\nC 9 0 0\n"};
  CHECK(places(read(xyz, {.model = 2})) == std::vector<double>{9});
  CHECK(read(xyz, {.model = 1}).atoms.size() == 3);
  const File pqr{"a.pqr", "MODEL 1\n" + pqr_of({rows[0]}) + "ENDMDL\nMODEL 2\n" +
                              pqr_of({rows[0], rows[1]}) + "ENDMDL\n"};
  CHECK(read(pqr, {.model = 2}).atoms.size() == 2);
}
