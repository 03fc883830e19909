#include "skin/molecule_files.h"

#include <doctest/doctest.h>
#include <zlib.h>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "geometry/error.h"
#include "geometry/files/gzip.h"
#include "skin/radii.h"
#include "tests/support/temporary_folder.h"

using morskin::geometry::AtomId;
using morskin::geometry::bomb_bytes;
using morskin::geometry::Point;
using morskin::geometry::RefusedInput;
using morskin::geometry::UnreadableInput;
using morskin::skin::Atom;
using morskin::skin::describe;
using morskin::skin::Molecule;
using morskin::skin::molecule_format_of;
using morskin::skin::MoleculeFormat;
using morskin::skin::parse_molecule;
using morskin::skin::read_molecule;
using morskin::skin::ReadOptions;
using morskin::skin::van_der_waals_radius;
using morskin::support::TemporaryFolder;

namespace {

// An ATOM or HETATM line. `name` is columns 13-16, `residue` columns 18-20, `tail` columns 55 on.
std::string pdb_line(const char* record, const char* name, char alternate, const char* residue,
                     int number, double x, const char* tail) {
  char line[160];
  std::snprintf(line, sizeof line, "%-6s%5d %4s%c%3s A%4d    %8.3f%8.3f%8.3f%s\n", record, number,
                name, alternate, residue, number, x, 2.5, -3.25, tail);
  return line;
}

std::string gzipped(const std::string& text) {
  z_stream stream{};
  deflateInit2(&stream, 9, Z_DEFLATED, 15 + 16, 9, Z_DEFAULT_STRATEGY);
  std::string packed(deflateBound(&stream, text.size()) + 64, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  deflate(&stream, Z_FINISH);
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  return packed;
}

std::string elements_of(const Molecule& molecule) {
  std::string text;
  for (const Atom& atom : molecule.atoms) {
    if (!text.empty()) text += ' ';
    text += atom.element.view();
  }
  return text;
}

std::string names_of(const Molecule& molecule) {
  std::string text;
  for (const Atom& atom : molecule.atoms) {
    if (!text.empty()) text += ' ';
    text += atom.name.view();
  }
  return text;
}

const std::string small_cif =
    "data_test\n_cell.length_a 10\nloop_\n_atom_site.group_PDB\n_atom_site.id\n"
    "_atom_site.type_symbol\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
    "_atom_site.label_comp_id\n_atom_site.label_asym_id\n_atom_site.label_seq_id\n"
    "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n_atom_site.occupancy\n"
    "_atom_site.pdbx_PDB_model_num\n"
    "ATOM 1 C \"C1'\" . U A 1 1.5 2(1) 3 1 1\n"
    "ATOM 2 N N A U A 1 4 5 6 0.4 1\n"
    "ATOM 3 N N B U A 1 5 5 6 0.6 1\n"
    "HETATM 4 O O . HOH B . 7 8 9 1 1\n"
    "ATOM 5 C \"C1'\" . U A 1 0 0 0 1 2\n#\n";
const std::string small_pqr =
    "REMARK by hand\nATOM 1 N ALA A 1 0 0 0 -0.3 1.55\nATOM 2 HA ALA A 1 1 0 0 0.1 0.0\n"
    "ATOM 3 CA ALA 1 2 0 0 0.1 1.7\nHETATM100000 ZN ZN 2 3 0 0 2 1.39\nTER\nEND\n";
const std::string small_xyz = "3\ncomment\nC 0 0 0\ncl1 1 0 0 0.5\n8 2 0 0\n";
const std::string small_xyzr = "# balls\n0 0 0 1.5\n\n1 0 0 0 # hidden\n2 0 0 1.25\n2 0 0 1.25\n";

std::string small_pdb() {
  return "HEADER    TEST\n" + pdb_line("ATOM", " N  ", ' ', "ALA", 1, 1.5, "  1.00  0.00") +
         pdb_line("ATOM", " CA ", ' ', "ALA", 2, 4, "  1.00  0.00           C") +
         pdb_line("HETATM", "CA  ", ' ', " CA", 3, 8, "  1.00  0.00") + "END\n";
}

}  // namespace

TEST_CASE("the ending stands for the format, in upper or lower case, gzipped or not") {
  CHECK(molecule_format_of("a/1CRN.PDB") == MoleculeFormat::Pdb);
  CHECK(molecule_format_of("1crn.ent.gz") == MoleculeFormat::Pdb);
  CHECK(molecule_format_of("1crn.cif.gz") == MoleculeFormat::Mmcif);
  CHECK(molecule_format_of("a.xyzr") == MoleculeFormat::Xyzr);
  CHECK_FALSE(molecule_format_of("a.gz").has_value());
  CHECK_FALSE(molecule_format_of("-").has_value());
}

TEST_CASE("an old PDB file gives its elements by the columns of the names") {
  const Molecule molecule = parse_molecule(
      pdb_line("ATOM", " CA ", ' ', "ALA", 1, 0, "  1.00  0.00      1GRM 123") +
          pdb_line("HETATM", "CA  ", ' ', " CA", 2, 0, "  1.00  0.00      1GRM 124") +
          pdb_line("ATOM", " HG ", ' ', "SER", 3, 0, "  1.00  0.00      1GRM 125") +
          pdb_line("HETATM", "HG  ", ' ', " HG", 4, 0, "  1.00  0.00      1GRM 126") +
          pdb_line("ATOM", "HG11", ' ', "VAL", 5, 0, "") +
          pdb_line("ATOM", "1HB ", ' ', "ALA", 6, 0, "") +
          pdb_line("ATOM", "CD1 ", ' ', "LEU", 7, 0, "") +
          pdb_line("ATOM", "NE2 ", ' ', "GLN", 8, 0, "") +
          pdb_line("HETATM", "FE  ", ' ', "HEM", 9, 0, "") +
          pdb_line("HETATM", "CL12", ' ', "LIG", 10, 0, "") +
          pdb_line("HETATM", "CAAB", ' ', "LIG", 11, 0, "") +
          pdb_line("HETATM", "HO5'", ' ', "LIG", 12, 0, "") +
          pdb_line("ATOM", " O5*", ' ', "  C", 13, 0, "") +
          pdb_line("ATOM", " D  ", ' ', "ALA", 14, 0, "") +
          pdb_line("HETATM", " S1 ", ' ', "478", 15, 0, ""),
      "old.pdb");
  CHECK(elements_of(molecule) == "C Ca H Hg H H C N Fe Cl C H O D S");
}

TEST_CASE("the element columns win where the residue can have that element") {
  const Molecule molecule =
      parse_molecule(pdb_line("HETATM", " X1 ", ' ', "LIG", 1, 0, "  1.00  0.00          BR") +
                         pdb_line("ATOM", " CA ", ' ', "ALA", 2, 0, "  1.00  0.00          CA") +
                         pdb_line("HETATM", "SE  ", ' ', "MSE", 3, 0, "  1.00  0.00          SE"),
                     "new.pdb");
  CHECK(elements_of(molecule) == "Br C Se");
  CHECK(molecule.atoms[0].radius == 1.85);
}

TEST_CASE("an atom is described by name, residue, chain and line") {
  const Molecule molecule = parse_molecule(small_pdb(), "a.pdb");
  CHECK(describe(molecule, AtomId(1U)) == "atom CA of ALA 2 chain A (line 3)");
  CHECK(describe(parse_molecule(small_xyz, "a.xyz"), AtomId(1U)) == "Cl atom (line 4)");
  CHECK(describe(parse_molecule(small_xyzr, "a.xyzr"), AtomId(0U)) == "ball (line 2)");
  CHECK(molecule.atoms[0].position == Point(1.5, 2.5, -3.25));
}

TEST_CASE("of alternate locations the likeliest stays, of equals the first letter") {
  const auto place = [](const char* name, char letter, const char* residue, const char* tail) {
    return pdb_line("ATOM", name, letter, residue, 7, letter, tail);
  };
  const Molecule molecule =
      parse_molecule(place(" N  ", ' ', "SER", "  1.00") + place(" CA ", 'A', "SER", "  0.30") +
                         place(" CA ", 'B', "SER", "  0.70") + place(" OG ", 'B', "SER", "  0.50") +
                         place(" OG ", 'A', "SER", "  0.50") + place(" CB ", 'C', "SER", "  0.20"),
                     "a.pdb");
  CHECK(names_of(molecule) == "N CA OG CB");
  CHECK(molecule.atoms[1].position.x() == 'B');
  CHECK(molecule.atoms[2].position.x() == 'A');
  CHECK(molecule.counts.alternates == 2);
}

TEST_CASE("a residue with two identities keeps the atoms of one") {
  const auto place = [](const char* name, char letter, const char* residue, const char* tail) {
    return pdb_line("ATOM", name, letter, residue, 22, letter, tail);
  };
  const Molecule molecule =
      parse_molecule(place(" CB ", 'A', "PRO", "  0.60") + place(" CG ", 'A', "PRO", "  0.60") +
                         place(" CB ", 'B', "SER", "  0.40") + place(" OG ", 'B', "SER", "  0.40"),
                     "a.pdb");
  CHECK(names_of(molecule) == "CB CG");
}

TEST_CASE("hydrogen and deuterium at one site are one atom") {
  const Molecule molecule =
      parse_molecule(pdb_line("ATOM", " H  ", 'A', "ALA", 1, 0, "  0.20  0.00           H") +
                         pdb_line("ATOM", " D  ", 'B', "ALA", 1, 0, "  0.80  0.00           D"),
                     "a.pdb");
  CHECK(elements_of(molecule) == "D");
}

TEST_CASE("copies made by symmetry that share chain, number and letter all stay") {
  const std::string atom = pdb_line("ATOM", " CA ", 'A', "ALA", 1, 0, "  0.50") +
                           pdb_line("ATOM", " CA ", 'B', "ALA", 1, 1, "  0.50");
  const Molecule molecule = parse_molecule(atom + atom, "a.pdb");
  CHECK(molecule.atoms.size() == 2);
  CHECK(molecule.counts.duplicates == 1);
}

TEST_CASE("water is left out unless asked for or alone") {
  const std::string water = pdb_line("HETATM", " O  ", ' ', "HOH", 9, 9, "");
  CHECK(parse_molecule(small_pdb(), "a.pdb").atoms.size() == 3);
  CHECK(parse_molecule(water + small_pdb(), "a.pdb").atoms.size() == 3);
  CHECK(parse_molecule(water + small_pdb(), "a.pdb").counts.waters == 1);
  ReadOptions with_waters;
  with_waters.waters = true;
  CHECK(parse_molecule(water + small_pdb(), "a.pdb", with_waters).atoms.size() == 4);
  CHECK(parse_molecule(water, "a.pdb").atoms.size() == 1);
  // Alone among what can be used: the others have no radius, or no element.
  const std::string pqr = "HETATM 1 O HOH 1 0 0 0 0.0 1.5\nATOM 2 H ALA 2 3 0 0 0.0 0.0\n";
  CHECK(parse_molecule(pqr, "a.pqr").atoms.size() == 1);
  CHECK(parse_molecule(pqr, "a.pqr").counts.waters == 0);
  CHECK(parse_molecule(pqr, "a.pqr").counts.zero_radii == 1);
}

TEST_CASE("only the first model is read") {
  const std::string atom = pdb_line("ATOM", " CA ", ' ', "ALA", 1, 0, "");
  const Molecule numbered =
      parse_molecule("MODEL        1\n" + atom + "ENDMDL\nMODEL        2\n" + atom + atom +
                         "ENDMDL\nMODEL        3\n" + atom + "ENDMDL\nEND\n",
                     "a.pdb");
  CHECK(numbered.atoms.size() == 1);
  CHECK(numbered.counts.other_models == 2);
  CHECK(parse_molecule(atom + "END\n" + atom + "END\n", "a.pdb").counts.other_models == 1);
  const Molecule frames = parse_molecule(small_xyz + small_xyz + "\n", "a.xyz");
  CHECK(frames.atoms.size() == 3);
  CHECK(frames.counts.other_models == 1);
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

TEST_CASE("a PQR file gives its own radii and loses atoms of radius 0") {
  const Molecule molecule = parse_molecule(small_pqr, "a.pqr");
  REQUIRE(molecule.atoms.size() == 3);
  CHECK(molecule.atoms[1].radius == 1.7);
  CHECK(molecule.atoms[1].chain.is_empty());
  CHECK(molecule.counts.zero_radii == 1);
  CHECK(elements_of(molecule) == "N C Zn");
}

TEST_CASE("an XYZ file takes symbols and atomic numbers, an XYZR file comments") {
  CHECK(elements_of(parse_molecule(small_xyz, "a.xyz")) == "C Cl O");
  const Molecule balls = parse_molecule(small_xyzr, "a.xyzr");
  CHECK(balls.atoms.size() == 3);
  CHECK(balls.counts.zero_radii == 1);
  CHECK(balls.counts.duplicates == 1);
}

TEST_CASE("without an ending the content tells the format") {
  CHECK(parse_molecule(small_pdb(), "-").atoms.size() == 3);
  CHECK(parse_molecule("# made by hand\n" + small_cif, "-").atoms.size() == 2);
  CHECK(parse_molecule(small_pqr, "-").atoms.size() == 3);
  CHECK(parse_molecule(small_xyz, "-").atoms.size() == 3);
  CHECK(parse_molecule(small_xyzr, "-").atoms.size() == 3);
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
  const std::string before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE.utf8"}) {
    if (std::setlocale(LC_ALL, name) == nullptr) continue;
    CHECK(parse_molecule(small_xyzr, "a.xyzr").atoms[0].radius == 1.5);
    CHECK(parse_molecule(small_cif, "a.cif").atoms[0].position.x() == 1.5);
  }
  std::setlocale(LC_ALL, before.c_str());
}

TEST_CASE("gzipped files are read, whatever their name, from one part or several") {
  const TemporaryFolder folder;
  CHECK(read_molecule(folder.file("a.xyzr.gz", gzipped(small_xyzr))).atoms.size() == 3);
  CHECK(read_molecule(folder.file("a.xyzr", gzipped(small_xyzr))).atoms.size() == 3);
  CHECK(parse_molecule(gzipped(small_xyzr) + gzipped("7 7 7 1\n"), "a.xyzr").atoms.size() == 4);
}

TEST_CASE("a gzipped file that is cut short, damaged or too large is turned down") {
  const std::string packed = gzipped(small_pdb());
  for (std::size_t size = 2; size < packed.size(); ++size) {
    CAPTURE(size);
    CHECK_THROWS_AS(parse_molecule(packed.substr(0, size), "a.pdb"), UnreadableInput);
  }
  std::string damaged = packed;
  damaged[packed.size() / 2] ^= 0x10;
  CHECK_THROWS_AS(parse_molecule(damaged, "a.pdb"), UnreadableInput);
  ReadOptions small;
  small.max_bytes = 1000;
  CHECK_THROWS_WITH_AS(parse_molecule(gzipped(std::string(100000, ' ')), "a.pdb", small),
                       doctest::Contains("more than 1000 bytes"), UnreadableInput);
  small.max_bytes = small_pdb().size();
  CHECK(parse_molecule(packed, "a.pdb", small).atoms.size() == 3);
}

TEST_CASE("a gzip bomb is turned down, a file that merely packs well is not") {
  const std::string ball = "0 0 0 1\n";
  const auto packed = [&](std::size_t bytes) {
    std::string text;
    while (text.size() < bytes) text += ball;
    return gzipped(text);
  };
  CHECK_THROWS_WITH_AS(parse_molecule(packed(bomb_bytes + 4096), "a.xyzr"),
                       doctest::Contains("unpacks from"), UnreadableInput);
  CHECK(parse_molecule(packed(1 << 16), "a.xyzr").atoms.size() == (1 << 16) / ball.size());
}

TEST_CASE("a file that holds more than it may is turned down before all of it is read") {
  const TemporaryFolder folder;
  ReadOptions options;
  options.max_bytes = 15;
  const auto path = folder.file("a.xyzr", "0 0 0 1\n1 0 0 1\n");
  CHECK_THROWS_WITH_AS(read_molecule(path, options), doctest::Contains("more than 15 bytes"),
                       UnreadableInput);
  CHECK_THROWS_AS(read_molecule("/dev/zero", options), UnreadableInput);
  options.max_bytes = 16;
  CHECK(read_molecule(path, options).atoms.size() == 2);
}

TEST_CASE("bad input is turned down with its line, the atom and what to do") {
  const auto refused = [](const std::string& text, const char* name, const char* part) {
    CHECK_THROWS_WITH_AS(parse_molecule(text, name), doctest::Contains(part), RefusedInput);
  };
  const auto unreadable = [](const std::string& text, const char* name, const char* part) {
    CHECK_THROWS_WITH_AS(parse_molecule(text, name), doctest::Contains(part), UnreadableInput);
  };
  refused("0 0 0 1\nnan 0 0 1\n", "a.xyzr", "a.xyzr:2: ball (line 2) has a coordinate that is not");
  refused("0 0 0 -1\n", "a.xyzr", "a.xyzr:1: ball (line 1) has a radius");
  refused("0 0 2e6 1\n", "a.xyzr", "10^6 Angstrom from the origin");
  refused("0 0 0 0\n", "a.xyzr", "no atom with a radius above 0");
  refused("# nothing\n", "a.xyzr", "no atom");
  refused(pdb_line("HETATM", "PM  ", ' ', " PM", 5, 0, ""), "a.pdb",
          "a.pdb:1: atom PM of PM 5 chain A (line 1) has element \"Pm\"");
  refused(pdb_line("HETATM", " Q1 ", ' ', "LIG", 5, 0, ""), "a.pdb", "no known element");
  unreadable("0 0 0\n", "a.xyzr", "a.xyzr:1: expected x y z r");
  unreadable("1\n\nXx 0 0 0\n", "a.xyz", "a.xyz:3: \"Xx\" is no element");
  unreadable("2\n\nC 0 0 0\n", "a.xyz", "1 atoms where 2 were announced");
  unreadable("1\n\nC 0 0 0\nC 0 0 0\n", "a.xyz", "a.xyz:4: expected the number of atoms");
  unreadable("9000000000000000000\n\nC 0 0 0\n", "a.xyz", "announced");
  unreadable("ATOM 1 N ALA 1 0 0 0 1\n", "a.pqr", "a.pqr:1: expected 10 or 11 fields");
  unreadable("ATOM      1  CA  ALA A   1      1.000\n", "a.pdb",
             "a.pdb:1: no coordinate in columns");
  unreadable("data_x\n_cell.length_a 1\n", "a.cif", "no table _atom_site");
  unreadable("data_x\nloop_\n_a.b\n'unclosed\n", "a.cif", "a.cif:");
  unreadable("garbage", "a.pdb", "no ATOM or HETATM");
  unreadable("garbage", "-", "recognised");
  unreadable("  \n\n", "a.pdb", "is empty");
  unreadable("", "-", "is empty");
}

TEST_CASE("an atom whose element the file calls unknown is left out and counted") {
  const Molecule molecule = parse_molecule(
      small_pdb() + pdb_line("HETATM", " UNK", ' ', "UNX", 9, 0, "  1.00  0.00           X"),
      "a.pdb");
  CHECK(molecule.counts.unknown == 0);  // after END
  CHECK(parse_molecule(
            pdb_line("HETATM", " UNK", ' ', "UNX", 9, 0, "  1.00  0.00           X") + small_pdb(),
            "a.pdb")
            .counts.unknown == 1);
}

TEST_CASE("a missing file and a folder are turned down") {
  const TemporaryFolder folder;
  CHECK_THROWS_WITH_AS(read_molecule(folder / "none.pdb"), doctest::Contains("cannot be opened"),
                       UnreadableInput);
  CHECK_THROWS_WITH_AS(read_molecule(folder / ""), doctest::Contains("is a folder"),
                       UnreadableInput);
}

TEST_CASE("a file cut short or with flipped bits is read or turned down, never worse") {
  const std::vector<std::pair<const char*, std::string>> files = {
      {"a.pdb", small_pdb()}, {"a.cif", small_cif},   {"a.pqr", small_pqr},
      {"a.xyz", small_xyz},   {"a.xyzr", small_xyzr}, {"a.pdb", gzipped(small_pdb())},
      {"-", small_pdb()},     {"-", small_cif}};
  const auto survives = [](const std::string& bytes, const char* name) {
    try {
      for (const Atom& atom : parse_molecule(bytes, name).atoms) {
        REQUIRE(atom.position.allFinite());
        REQUIRE(atom.radius > 0);
      }
    } catch (const UnreadableInput&) {
    } catch (const RefusedInput&) {
    }
  };
  for (const auto& [name, bytes] : files) {
    CAPTURE(name);
    for (std::size_t size = 0; size < bytes.size(); ++size) survives(bytes.substr(0, size), name);
    for (unsigned seed = 0; seed < 1000; ++seed) {
      CAPTURE(seed);
      std::mt19937 random(seed);
      std::string damaged = bytes;
      for (unsigned flip = 0; flip <= seed % 4; ++flip) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      survives(damaged, name);
    }
  }
  survives(std::string(1000, '\0'), "a.pdb");
  std::string atom_line = "ATOM";
  atom_line.resize(80);
  survives(atom_line, "a.pdb");
  survives("ATOM\t1\tCA\tALA\t1\t0\t0\t0\n", "a.pdb");
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
  CHECK(morskin::skin::element_symbol(118) == "Og");
  CHECK_FALSE(morskin::skin::element_symbol(119).has_value());
}
