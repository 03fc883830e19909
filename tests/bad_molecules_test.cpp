// Molecule files that are turned down, and how.

#include "geometry/error.h"
#include "geometry/files/gzip.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;
using namespace morskin::support;

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
  --small.max_bytes;
  CHECK_THROWS_AS(parse_molecule(packed, "a.pdb", small), UnreadableInput);
}

TEST_CASE("names of mmCIF that a short label does not tell apart are refused, not taken for one") {
  const std::string table =
      "data_a\nloop_\n_atom_site.label_atom_id\n_atom_site.label_alt_id\n"
      "_atom_site.auth_asym_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n"
      "_atom_site.type_symbol\n";
  const auto with_chains = [&](const std::string& one, const std::string& other) {
    return table + "C1 . " + one + " 0 0 0 C\nC1 . " + other + " 5 0 0 C\n";
  };
  CHECK(parse_molecule(with_chains("ABCDEFGH", "ABCDEFG"), "a.cif").atoms.size() == 2);
  for (const char* other : {"ABCDEFGH", "ABCDEFGHJ"}) {
    CHECK_THROWS_AS(parse_molecule(with_chains("ABCDEFGHI", other), "a.cif"), RefusedInput);
    CHECK_THROWS_AS(parse_molecule(with_chains(other, "ABCDEFGHI"), "a.cif"), RefusedInput);
  }
  CHECK_THROWS_WITH_AS(parse_molecule(table + "C1 A1 A 0 0 0 C\nC1 A2 A 0.1 0 0 C\n", "a.cif"),
                       doctest::Contains("alternate location"), RefusedInput);
}

TEST_CASE("a PDB number that overflows into full columns is refused, not read with its digits") {
  const std::string start = "ATOM      1  C   LIG A   1    ";
  for (const char* rest :
       {"  10.000-1000.1231000.000  1.00  0.00           C  ",
        "-1000.1231000.0001000.000  1.00  0.00           C  ", "-1000.1231000.0001000.000"}) {
    CAPTURE(rest);
    CHECK_THROWS_WITH_AS(parse_molecule(start + rest, "a.pdb"),
                         doctest::Contains("a.pdb:1: no occupancy in columns 55-60"),
                         UnreadableInput);
  }
  for (const char* rest : {"-1000.1231000.001000.000  1.00", "1000.0001000.0001000.000100.00",
                           "10.000   1.0     2.0", "1000.0001000.0001000.000",
                           "1000.0001000.0001000.0001.00", "1000.0001000.0001000.000******"}) {
    CAPTURE(rest);
    CHECK(parse_molecule(start + rest, "a.pdb").atoms.size() == 1);
  }
}

TEST_CASE("a name of PQR that a label would cut is refused with its line, one that fits is not") {
  const auto with = [](const std::string& name, const std::string& residue,
                       const std::string& chain, const std::string& number) {
    return "ATOM 1 C ALA A 1 5 0 0 0 1.7\nATOM 2 " + name + " " + residue + " " + chain + " " +
           number + " 0 0 0 0 1.7\n";
  };
  const Molecule whole =
      parse_molecule(with("C2345678", "R2345678", "CHAIN678", "12345678"), "a.pqr");
  CHECK(describe(whole.atoms[1]) == "atom C2345678 of R2345678 12345678 chain CHAIN678 (line 2)");
  const auto refused = [](const std::string& text, const char* message) {
    CHECK_THROWS_WITH_AS(parse_molecule(text, "a.pqr"), message, RefusedInput);
  };
  refused(
      with("C23456789", "ALA", "A", "2"),
      "a.pqr:2: atom \"C23456789\" has the name \"C23456789\", longer than 8 letters; shorten it");
  refused(with("C", "R23456789", "A", "2"),
          "a.pqr:2: atom \"C\" has the residue \"R23456789\", longer than 8 letters; shorten it");
  refused(with("C", "ALA", "CHAIN6789", "2"),
          "a.pqr:2: atom \"C\" has the chain \"CHAIN6789\", longer than 8 letters; shorten it");
  refused(with("C", "ALA", "A", "123456789"),
          "a.pqr:2: atom \"C\" has the residue number \"123456789\", longer than 8 letters; "
          "shorten it");
}

TEST_CASE("an alternate location of PQR, which tells of none, is refused") {
  const std::string ball = "ATOM 1 C ALA A 1 0 0 0 0 1.7\n";
  for (const Selection& selection :
       {Selection{.all_locations = true}, Selection{.location = 'A'}}) {
    CHECK_THROWS_WITH_AS(parse_molecule(ball, "a.pqr", {.selection = selection}),
                         "a.pqr: does not tell an atom's alternate locations; do not choose by it",
                         RefusedInput);
  }
  CHECK(parse_molecule(ball, "a.pqr", {.selection = {.chains = {"A"}}}).atoms.size() == 1);
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
  unreadable("0 0 0\n", "a.xyzr", "a.xyzr:1: expected x y z r, found the end of the line;");
  unreadable("1\n\nXx 0 0 0\n", "a.xyz", "a.xyz:3: \"Xx\" is no element");
  unreadable("2\n\nC 0 0 0\n", "a.xyz", "end after 1 of 2 announced");
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

TEST_CASE("a PQR line with a number too many is turned down, not read one column on") {
  CHECK(parse_molecule("ATOM 1 N ALA A -1B 1.0 2.0 3.0 0.1 1.5\n", "a.pqr").atoms.size() == 1);
  for (const std::string number : {"0.0", "7"}) {
    CAPTURE(number);
    CHECK_THROWS_WITH_AS(
        parse_molecule("ATOM 1 N ALA 1 1.0 2.0 3.0 " + number + " 0.1 1.5\n", "a.pqr"),
        doctest::Contains("a.pqr:1: expected the residue's number, found \"1.0\";"),
        UnreadableInput);
  }
}

TEST_CASE("a PQR line of twelve fields is turned down, and a minus begins no chain's name") {
  const std::string line = "ATOM 1 N ALA -5 1 2 3 0.1 1.5\n";
  CHECK(describe(parse_molecule(line, "a.pqr").atoms[0]) == "atom N of ALA -5 (line 1)");
  CHECK_THROWS_WITH_AS(parse_molecule("ATOM 1 N ALA A 5 1 2 3 0.1 1.5 N\n", "a.pqr"),
                       doctest::Contains("a.pqr:1: expected 10 or 11 fields"), UnreadableInput);
}

TEST_CASE("balls with weights are not read as balls with radii") {
  const std::string balls = "# x y z w\n0 0 0 2\n";
  CHECK(parse_molecule(balls, "a.xyzw").weights == std::vector{2.0});
  CHECK_THROWS_WITH_AS(parse_molecule(balls, "a.xyzr"),
                       doctest::Contains("a.xyzr:1: the fourth numbers are weights"),
                       UnreadableInput);
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
  for (const auto& file : files) {
    const auto& name = file.first;
    const auto& bytes = file.second;
    CAPTURE(name);
    for (std::size_t size = 0; size < bytes.size(); ++size) survives(bytes.substr(0, size), name);
    for_seeds<std::mt19937>(1000, [&](unsigned seed, std::mt19937& random) {
      std::string damaged = bytes;
      for (unsigned flip = 0; flip <= seed % 4; ++flip) {
        damaged[random() % damaged.size()] = static_cast<char>(random() % 256);
      }
      survives(damaged, name);
    });
  }
  survives(std::string(1000, '\0'), "a.pdb");
  std::string atom_line = "ATOM";
  atom_line.resize(80);
  survives(atom_line, "a.pdb");
  survives("ATOM\t1\tCA\tALA\t1\t0\t0\t0\n", "a.pdb");
}
