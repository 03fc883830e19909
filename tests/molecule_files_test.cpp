#include "skin/molecule_files.h"

#include <clocale>
#include <locale>

#include "geometry/error.h"
#include "skin/radii.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;
using namespace morskin::support;

TEST_CASE("the ending stands for the format, in upper or lower case, gzipped or not") {
  CHECK(molecule_format_of("a/1CRN.PDB") == MoleculeFormat::Pdb);
  CHECK(molecule_format_of("1crn.ent.gz") == MoleculeFormat::Pdb);
  CHECK(molecule_format_of("1crn.cif.gz") == MoleculeFormat::Mmcif);
  CHECK(molecule_format_of("a.xyzr") == MoleculeFormat::Xyzr);
  CHECK_FALSE(molecule_format_of("a.gz").has_value());
  CHECK_FALSE(molecule_format_of("-").has_value());
}

TEST_CASE("an atom is described by name, residue, chain and line") {
  const Molecule molecule = parse_molecule(small_pdb(), "a.pdb");
  CHECK(describe(molecule, AtomId(1U)) == "atom CA of ALA 2 chain A (line 3)");
  CHECK(describe(parse_molecule(small_xyz, "a.xyz"), AtomId(1U)) == "Cl atom (line 4)");
  CHECK(describe(parse_molecule(small_xyzr, "a.xyzr"), AtomId(0U)) == "ball (line 2)");
  CHECK(molecule.atoms[0].position == Point(1.5, 2.5, -3.25));
}

TEST_CASE("an mmCIF file gives names, lines, alternates and the first model") {
  const Molecule molecule = parse_molecule(small_cif, "a.cif");
  REQUIRE(molecule.atoms.size() == 2);
  CHECK(describe(molecule, AtomId(0U)) == "atom C1' of U 1 chain A (line 17)");
  CHECK(molecule.atoms[0].position == Point(1.5, 2, 3));
  CHECK(molecule.atoms[1].position == Point(5, 5, 6));
  CHECK(molecule.counts.waters == 1);
  CHECK(molecule.counts.alternates == 1);
  CHECK(molecule.counts.other_models == 1);
}

TEST_CASE("the only atom of an mmCIF file may be written as tags with their values") {
  const std::string ion =
      "data_zinc\n"
      "_atom_site.group_PDB HETATM\n_atom_site.id 1\n_atom_site.type_symbol ZN\n"
      "_atom_site.label_atom_id ZN\n_atom_site.label_comp_id ZN\n_atom_site.label_asym_id A\n"
      "_atom_site.Cartn_x 1.5\n_atom_site.Cartn_y -2.25\n_atom_site.Cartn_z 3.0\n";
  for (const char* name : {"zinc.cif", "-"}) {
    const Molecule molecule = parse_molecule(ion, name);
    REQUIRE(molecule.atoms.size() == 1);
    CHECK(molecule.atoms[0].position == Point(1.5, -2.25, 3));
    CHECK(describe(molecule, AtomId(0U)) == "atom ZN of ZN chain A (number 1)");
  }
  CHECK_THROWS_AS(parse_molecule("data_zinc\n_atom_site.Cartn_x 1.5\n", "zinc.cif"),
                  UnreadableInput);
}

TEST_CASE("a PQR file gives its own radii and loses atoms of radius 0") {
  const Molecule molecule = parse_molecule(small_pqr, "a.pqr");
  REQUIRE(molecule.atoms.size() == 3);
  CHECK(molecule.atoms[1].radius == 1.7);
  CHECK(molecule.atoms[1].chain.is_empty());
  CHECK(molecule.counts.zero_radii == 1);
  CHECK(elements_of(molecule) == "N C Zn");
  CHECK(molecule.charges == std::vector{-0.3, 0.1, 2.0});
  CHECK(molecule.radii == "input");
  CHECK(parse_molecule(small_xyz, "a.xyz").charges.empty());
  CHECK(parse_molecule(small_xyz, "a.xyz").radii == "elements");
}

TEST_CASE("an XYZ file takes symbols and atomic numbers, an XYZR file comments") {
  CHECK(elements_of(parse_molecule(small_xyz, "a.xyz")) == "C Cl O");
  const Molecule balls = parse_molecule(small_xyzr, "a.xyzr");
  CHECK(balls.atoms.size() == 3);
  CHECK(balls.counts.zero_radii == 1);
  CHECK(balls.counts.duplicates == 1);
}

TEST_CASE("an extended XYZ file has its columns where its comment says") {
  const auto atom_of = [](const std::string& comment, const std::string& row) {
    return parse_molecule("1\n" + comment + "\n" + row + "\n", "a.xyz").atoms.at(0);
  };
  const std::vector<std::pair<std::string, std::string>> files = {
      {"Properties=species:S:1:pos:R:3:charge:R:1", "O 4 5 6 -0.8"},
      {"Properties=species:S:1:id:I:1:pos:R:3", "O 1 4 5 6"},
      {"Lattice=\"9 0 0 0 9 0 0 0 9\" Properties=\"id:I:1:species:S:1:pos:R:3\"", "1 O 4 5 6"},
      {"Properties=pos:R:3:Z:I:1:forces:R:3", "4 5 6 8 1 2 3"},
      {"Properties=Z:I:1:forces:R:3:pos:R:3:species:S:1", "7 1 2 3 4 5 6 O"},
      {"Properties=unknown", "O 4 5 6"}};
  for (const auto& [comment, row] : files) {
    CAPTURE(comment);
    const Atom atom = atom_of(comment, row);
    CHECK(atom.element.view() == "O");
    CHECK(atom.position == geometry::Point(4, 5, 6));
  }
  const auto unreadable = [&](const std::string& comment, const char* part) {
    CHECK_THROWS_WITH_AS(atom_of(comment, "O 4 5 6"), doctest::Contains(part),
                         geometry::UnreadableInput);
  };
  unreadable("Properties=species:S:1:vel:R:3", "a.xyz:2: Properties names no column pos:R:3;");
  unreadable("Properties=id:I:1:pos:R:3", "a.xyz:2: Properties names no column species:S:1 or");
  unreadable("Properties=species:S:1:id:I:1:pos:R:3", "a.xyz:3: expected a coordinate, found the");
}

TEST_CASE("without an ending the content tells the format") {
  CHECK(parse_molecule(small_pdb(), "-").atoms.size() == 3);
  CHECK(parse_molecule("# made by hand\n" + small_cif, "-").atoms.size() == 2);
  CHECK(parse_molecule(small_pqr, "-").atoms.size() == 3);
  CHECK(parse_molecule(small_xyz, "-").atoms.size() == 3);
  CHECK(parse_molecule(small_xyzr, "-").atoms.size() == 3);
}

TEST_CASE("a PQR file is known by its content, a serial number sticking to the record or not") {
  const std::string rest = " C1 LIG 1 0.0 0.0 0.0 0.1 1.7\n";
  for (const std::string begin : {"HETATM 1", "HETATM10000", "ATOM 1", "ATOM100000"}) {
    CAPTURE(begin);
    CHECK(parse_molecule(begin + rest, "-").atoms.at(0).radius == 1.7);
  }
}

TEST_CASE("a byte order mark and other line ends change nothing") {
  const auto with_ends = [](std::string text, const std::string& end) {
    for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) {
      text.replace(at, 1, end);
    }
    return "\xEF\xBB\xBF" + text;
  };
  CHECK(parse_molecule(with_ends(small_pdb(), "\r\n"), "a.pdb").atoms.size() == 3);
  CHECK(parse_molecule(with_ends(small_pdb(), "\r"), "a.pdb").atoms.size() == 3);
  CHECK(parse_molecule(with_ends(small_cif, "\r\n"), "a.cif").atoms.size() == 2);
  CHECK(parse_molecule(with_ends(small_pqr, "\r\n"), "a.pqr").atoms.size() == 3);
  CHECK(parse_molecule(with_ends(small_xyz, "\r\n"), "a.xyz").atoms.size() == 3);
  CHECK(parse_molecule(with_ends(small_xyzr, "\r\n"), "a.xyzr").atoms.size() == 3);
  CHECK(parse_molecule("0\t0\t0\t1\n", "a.xyzr").atoms.size() == 1);
}

TEST_CASE("a locale with a decimal comma changes nothing") {
  struct Comma : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
  };
  const auto check = [] {
    CHECK(parse_molecule(small_xyzr, "a.xyzr").atoms[0].radius == 1.5);
    CHECK(parse_molecule(small_cif, "a.cif").atoms[0].position.x() == 1.5);
    CHECK(parse_molecule(small_pdb(), "a.pdb").atoms[0].position.x() == 1.5);
    CHECK(parse_molecule(small_pqr, "a.pqr").charges[0] == -0.3);
    CHECK(xyzr_text({{{12345.5, 0, 0}, 4.5}}) == "12345.5 0 0 1.5\n");
  };
  check();
  const std::string before = std::setlocale(LC_ALL, nullptr);
  const std::locale plain = std::locale::global(std::locale(std::locale(), new Comma));
  check();
  std::locale::global(plain);
  // Of those of C only what this machine has.
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"}) {
    if (std::setlocale(LC_ALL, name) != nullptr) check();
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("gzipped files are read, whatever their name, from one part or several") {
  const TemporaryFolder folder;
  CHECK(read_molecule(folder.file("a.xyzr.gz", gzipped(small_xyzr))).atoms.size() == 3);
  CHECK(read_molecule(folder.file("a.xyzr", gzipped(small_xyzr))).atoms.size() == 3);
  CHECK(parse_molecule(gzipped(small_xyzr) + gzipped("7 7 7 1\n"), "a.xyzr").atoms.size() == 4);
}

TEST_CASE("many data blocks are passed over in time that grows with their number") {
  // A quarter of a million lines; were each table looked for from the first, some 3,000 million.
  constexpr std::size_t count = 30'000;
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    text += "data_" + std::to_string(i) + "\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n" +
            "_atom_site.Cartn_y\n_atom_site.Cartn_z\nC " + std::to_string(i) + " 0 0\n";
  }
  const Molecule molecule = parse_molecule(text, "many.cif");
  CHECK(molecule.counts.other_models == count - 1);
  REQUIRE(molecule.atoms.size() == 1);
  CHECK(molecule.atoms[0].line == 7);
}

namespace {

/// An operator that shifts by (5, 5, 5), and a table of assemblies that its rows follow.
std::string shift_and_assemblies() {
  std::string text = "_pdbx_struct_oper_list.id 1\n";
  for (const std::string row : {"1", "2", "3"}) {
    for (const std::string column : {"1", "2", "3"}) {
      text += "_pdbx_struct_oper_list.matrix[" + row + "][" + column + "] ";
      text += row == column ? "1\n" : "0\n";
    }
    text += "_pdbx_struct_oper_list.vector[" + row + "] 5\n";
  }
  return text +
         "loop_\n_pdbx_struct_assembly_gen.assembly_id\n_pdbx_struct_assembly_gen.oper_expression\n"
         "_pdbx_struct_assembly_gen.asym_id_list\n";
}

}  // namespace

TEST_CASE("an assembly is found among many in time that grows with their number") {
  // 100,000 rows; were each held against all before it, 5,000 million.
  constexpr int count = 100'000;
  std::string text =
      "data_a\n_atom_site.type_symbol C\n_atom_site.Cartn_x 1\n_atom_site.Cartn_y 0\n"
      "_atom_site.Cartn_z 0\n_atom_site.label_asym_id A\n" +
      shift_and_assemblies();
  for (int i = 1; i <= count; ++i) text += std::to_string(i) + " 1 A\n";
  ReadOptions options;
  options.selection.assembly = std::to_string(count);
  CHECK(parse_molecule(text, "a.cif", options).atoms.at(0).position == Point(6, 5, 5));
}

TEST_CASE("an assembly of many chains is copied in time that grows with their number") {
  // 60,000 chains of one atom; were each atom asked for each chain, 3,600 million questions.
  constexpr std::size_t count = 60'000;
  std::string text =
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
      "_atom_site.Cartn_z\n_atom_site.label_asym_id\n";
  for (std::size_t i = 0; i < count; ++i) {
    text += "C " + std::to_string(i) + " 0 0 C" + std::to_string(i) + "\n";
  }
  text += shift_and_assemblies();
  for (std::size_t i = 0; i < count; ++i) text += "1 1 C" + std::to_string(i) + "\n";
  ReadOptions options;
  options.selection.assembly = "1";
  const Molecule molecule = parse_molecule(text, "a.cif", options);
  REQUIRE(molecule.atoms.size() == count);
  CHECK(molecule.atoms.back().position == Point(count - 1 + 5., 5, 5));
}

TEST_CASE("an assembly that names one operator many times has each chain once") {
  // 20,000 chains and 100,000 times one operator; were each asked for each, 2,000 million
  // questions.
  constexpr std::size_t chains = 20'000, times = 100'000;
  std::string text =
      "data_a\nloop_\n_atom_site.type_symbol\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
      "_atom_site.Cartn_z\n_atom_site.label_asym_id\n";
  std::string names, operators = "1";
  for (std::size_t i = 0; i < chains; ++i) {
    text += "C " + std::to_string(i) + " 0 0 C" + std::to_string(i) + "\n";
    names += (i == 0 ? "C" : ",C") + std::to_string(i);
  }
  for (std::size_t i = 1; i < times; ++i) operators += ",1";
  text += shift_and_assemblies() + "1 " + operators + " " + names + "\n";
  ReadOptions options;
  options.selection.assembly = "1";
  const Molecule molecule = parse_molecule(text, "a.cif", options);
  REQUIRE(molecule.atoms.size() == chains);
  CHECK(molecule.atoms.back().position == Point(chains - 1 + 5., 5, 5));
}

TEST_CASE("the radii are Bondi's where Bondi gives one") {
  // Bondi 1964, table 1.
  const std::map<std::string, double> bondi{{"H", 1.20},  {"He", 1.40}, {"C", 1.70},  {"N", 1.55},
                                            {"O", 1.52},  {"F", 1.47},  {"Ne", 1.54}, {"Si", 2.10},
                                            {"P", 1.80},  {"S", 1.80},  {"Cl", 1.75}, {"Ar", 1.88},
                                            {"As", 1.85}, {"Se", 1.90}, {"Br", 1.85}, {"Kr", 2.02},
                                            {"Te", 2.06}, {"I", 1.98},  {"Xe", 2.16}};
  for (const auto& [symbol, radius] : bondi) CHECK(van_der_waals_radius(symbol) == radius);
  CHECK(van_der_waals_radius("d") == 1.20);
  CHECK(van_der_waals_radius("CL") == 1.75);
  CHECK(van_der_waals_radius("Ca") == 2.31);
  CHECK(van_der_waals_radius("fe") == 2.44);
  CHECK_FALSE(van_der_waals_radius("Pm").has_value());
  CHECK_FALSE(van_der_waals_radius("").has_value());
  CHECK(element_symbol(118) == "Og");
  CHECK_FALSE(element_symbol(119).has_value());
}
