// Which atoms of a file are read, and as which element.

#include "geometry/error.h"
#include "tests/support/molecule_texts.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::geometry;
using namespace morskin::skin;
using namespace morskin::support;

namespace {

/// An atom whose x is the letter of its alternate location.
std::string alternate(const char* name, char letter, const char* residue, const char* tail) {
  return pdb_line("ATOM", name, letter, residue, 7, letter, tail);
}

}  // namespace

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

TEST_CASE(
    "HG from column 13 is mercury, from column 14 hydrogen, and in a residue HG always mercury") {
  const auto element = [](const char* record, const char* name, const char* residue) {
    return elements_of(parse_molecule(pdb_line(record, name, ' ', residue, 1, 0, ""), "old.pdb"));
  };
  CHECK(element("HETATM", "HG  ", "EMC") == "Hg");
  CHECK(element("HETATM", "HG1 ", "EMC") == "Hg");
  CHECK(element("HETATM", " HG ", "LIG") == "H");
  CHECK(element("HETATM", " HG1", "LIG") == "H");
  CHECK(element("HETATM", "HG11", "LIG") == "H");
  CHECK(element("HETATM", "1HG ", "LIG") == "H");
  // A standard residue has no mercury, and the residue HG nothing else.
  CHECK(element("ATOM", "HG  ", "SER") == "H");
  CHECK(element("HETATM", " HG ", "HG") == "Hg");
  CHECK(element("HETATM", " HG ", "HG ") == "Hg");
  CHECK(element("HETATM", "  HG", " HG") == "Hg");
}

TEST_CASE("an ion that is called like its residue is that element wherever its name begins") {
  const auto element = [](const char* name, const char* residue) {
    return elements_of(parse_molecule(pdb_line("HETATM", name, ' ', residue, 1, 0, ""), "old.pdb"));
  };
  CHECK(element(" ZN ", "ZN") == "Zn");
  CHECK(element(" CA ", "CA") == "Ca");
  CHECK(element(" CD ", "CD") == "Cd");
  CHECK(element(" K  ", "K") == "K");
  CHECK(element(" CA ", "LIG") == "C");
  CHECK(element(" C  ", "C") == "C");
  // With its charge behind, as Amber and GROMACS write it.
  CHECK(element(" Na+", "Na+") == "Na");
  CHECK(element(" NA ", "NA+") == "Na");
  CHECK(element(" CL ", "CL-") == "Cl");
  CHECK(element(" K+ ", "K+") == "K");
  CHECK(element(" MG2", "MG2") == "Mg");
  // As CHARMM calls it: no sulphur, phosphorus and carbon.
  CHECK(element(" SOD", "SOD") == "Na");
  CHECK(element(" POT", "POT") == "K");
  CHECK(element(" CLA", "CLA") == "Cl");
  CHECK(element(" CAL", "CAL") == "Ca");
  CHECK(element(" CA ", "CAL") == "C");
  CHECK(element(" CHA", "CLA") == "C");
}

TEST_CASE("the iron of a heme is no fluorine where its name begins in column 14, as of CHARMM") {
  const auto line_of = [](const char* name, const char* residue) {
    return pdb_line("ATOM", name, ' ', residue, 1, 0, "  1.00  0.00      HEM ");
  };
  std::string heme = line_of(" FE ", "HEM");
  CHECK(elements_of(parse_molecule(heme, "charmm.pdb")) == "Fe");
  heme.replace(17, 5, "HEMEA");
  CHECK(elements_of(parse_molecule(heme, "charmm.pdb")) == "Fe");
  CHECK(elements_of(parse_molecule(line_of(" FE ", "FE2"), "charmm.pdb")) == "Fe");
  CHECK(elements_of(parse_molecule(line_of(" ZN ", "ZN2"), "charmm.pdb")) == "Zn");
  CHECK(elements_of(parse_molecule(line_of(" CD ", "CD2"), "charmm.pdb")) == "Cd");
  CHECK(elements_of(parse_molecule(line_of(" CD ", "LIG"), "charmm.pdb")) == "C");
  CHECK(elements_of(parse_molecule(line_of(" FE ", "LIG"), "charmm.pdb")) == "F");
}

TEST_CASE("in a longer name without columns the first letter decides as in one of four") {
  std::string text;
  for (const char* name : {"HO5''", "NA123", "CA123", "CO123", "CA12", "FE", "CL123"}) {
    text += "HETATM 1 " + std::string(name) + " LIG 1 0.0 0.0 0.0 0.1 1.7\n";
  }
  CHECK(elements_of(parse_molecule(text, "a.pqr")) == "H N C C C Fe Cl");
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

TEST_CASE("a PDBQT file gives its elements by AutoDock's types, one column further right") {
  std::string text;
  for (const char* type : {"C", "A", "Cl", "Br", "Fe", "NA", "Na", "OA", "OS", "SA", "HD"}) {
    const std::string tail = std::string("  1.00  0.00    -0.085 ") + type;
    text += pdb_line("ATOM", " C1 ", ' ', "UNL", 1, 0, tail.c_str());
  }
  CHECK(elements_of(parse_molecule(text, "a.pdbqt")) == "C C Cl Br Fe N Na O O S H");
}

TEST_CASE("of alternate places the likeliest stays, of equals the first letter") {
  const Molecule molecule = parse_molecule(
      alternate(" N  ", ' ', "SER", "  1.00") + alternate(" CA ", 'A', "SER", "  0.30") +
          alternate(" CA ", 'B', "SER", "  0.70") + alternate(" OG ", 'B', "SER", "  0.50") +
          alternate(" OG ", 'A', "SER", "  0.50") + alternate(" CB ", 'C', "SER", "  0.20"),
      "a.pdb");
  CHECK(names_of(molecule) == "N CA OG CB");
  CHECK(molecule.atoms[1].position.x() == 'B');
  CHECK(molecule.atoms[2].position.x() == 'A');
  CHECK(molecule.counts.alternates == 2);
}

TEST_CASE("a residue with two identities keeps the atoms of one") {
  const Molecule molecule = parse_molecule(
      alternate(" CB ", 'A', "PRO", "  0.60") + alternate(" CG ", 'A', "PRO", "  0.60") +
          alternate(" CB ", 'B', "SER", "  0.40") + alternate(" OG ", 'B', "SER", "  0.40"),
      "a.pdb");
  CHECK(names_of(molecule) == "CB CG");
}

TEST_CASE("two ligands without a number are two residues, each with its own alternate places") {
  std::string text;
  for (const char* residue : {"LIG", "GOL"}) {
    for (const char letter : {'A', 'B'}) {
      std::string line = alternate(" C1 ", letter, residue, letter == 'A' ? "  0.70" : "  0.30");
      text += line.replace(22, 5, "     ");
    }
  }
  const Molecule molecule = parse_molecule(text, "a.pdb");
  CHECK(names_of(molecule) == "C1 C1");
  CHECK(molecule.atoms[0].position.x() == 'A');
  CHECK(molecule.atoms[1].position.x() == 'A');
}

TEST_CASE("residues of one number without a chain are told apart by segments and by asym_ids") {
  std::string pdb,
      cif =
          "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.label_alt_id\n"
          "_atom_site.label_asym_id\n_atom_site.auth_asym_id\n_atom_site.auth_seq_id\n"
          "_atom_site.auth_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
  for (const std::string chain : {"A", "B"}) {
    const std::string residue = chain == "A" ? "ALA" : "GLY";
    for (const char* const letter : {"A", "B"}) {
      pdb += "ATOM      1  CA " + std::string(letter) + residue +
             "     5       0.000   0.000   0.000  0.50  0.00      SEG" + chain + " C\n";
      cif += "C " + std::string(letter) + " " + chain + " ? 5 " + residue + " 0 0 0\n";
    }
  }
  CHECK(parse_molecule(pdb, "a.pdb").counts.alternates == 2);
  CHECK(parse_molecule(cif, "a.cif").counts.alternates == 2);
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
  with_waters.selection.waters = true;
  CHECK(parse_molecule(water + small_pdb(), "a.pdb", with_waters).atoms.size() == 4);
  CHECK(parse_molecule(water, "a.pdb").atoms.size() == 1);
  // Alone among what can be used: the others have no radius, or no element.
  const std::string pqr = "HETATM 1 O HOH 1 0 0 0 0.0 1.5\nATOM 2 H ALA 2 3 0 0 0.0 0.0\n";
  CHECK(parse_molecule(pqr, "a.pqr").atoms.size() == 1);
  CHECK(parse_molecule(pqr, "a.pqr").counts.waters == 0);
  CHECK(parse_molecule(pqr, "a.pqr").counts.zero_radii == 1);
}

TEST_CASE("sites of water that are no atoms are left out and counted") {
  const std::string text = pdb_line("ATOM", " OW ", ' ', "SOL", 1, 0, "") +
                           pdb_line("ATOM", " MW ", ' ', "SOL", 1, 1, "") +
                           pdb_line("ATOM", " O  ", ' ', "WAT", 2, 5, "") +
                           pdb_line("ATOM", "EPW ", ' ', "WAT", 2, 6, "");
  const Molecule molecule = parse_molecule(text, "box.pdb");
  CHECK(elements_of(molecule) == "O O");
  CHECK(molecule.counts.unknown == 2);
  CHECK(molecule.counts.waters == 0);
}

TEST_CASE("a chain of a long name is chosen by all of it or by what an error tells of it") {
  const std::string text =
      "data_x\nloop_\n_atom_site.type_symbol\n_atom_site.auth_asym_id\n_atom_site.Cartn_x\n"
      "_atom_site.Cartn_y\n_atom_site.Cartn_z\nC heavychain1 0 0 0\nC B 5 0 0\n";
  const auto chosen = [&](const std::string& chain) {
    return parse_molecule(text, "a.cif", {.selection = {.chains = {chain}}}).atoms.size();
  };
  CHECK(chosen("heavychain1") == 1);
  CHECK(chosen("heavycha") == 1);
  CHECK_THROWS_WITH_AS(chosen("heavychain2"),
                       "a.cif: has no chain heavychain2; choose from B, heavycha", RefusedInput);
}

TEST_CASE("chains of two letters in a PDB file are no names of residues with four, which stay") {
  const auto line = [](const char* residue_and_chain, double x, char letter = ' ') {
    std::string text = pdb_line("ATOM", " CA ", letter, "UNL", 5, x, "");
    return text.replace(17, 5, residue_and_chain);
  };
  const std::string waters = line("HOHAB", 9) + line("HOH C", 9);
  const Molecule two = parse_molecule(
      line("SERAB", 0, 'A') + line("SERAB", 1, 'B') + line("LEUBB", 5) + line("LIGBB", 7) + waters,
      "a.pdb");
  CHECK(two.atoms.size() == 3);
  CHECK(two.counts.waters == 2);
  CHECK(describe(two.atoms[0]) == "atom CA of SER 5 chain AB (line 1)");
  CHECK(describe(two.atoms[2]) == "atom CA of LIG 5 chain BB (line 4)");
  const Molecule four =
      parse_molecule(line("LYSHA", 0) + line("LEU A", 3) + line("POPCB", 6), "a.pdb");
  CHECK(describe(four.atoms[0]) == "atom CA of LYSH 5 chain A (line 1)");
  CHECK(describe(four.atoms[2]) == "atom CA of POPC 5 chain B (line 3)");
}

TEST_CASE("an mmCIF atom without an author's name, residue or number has its label's") {
  std::string tags = "data_x\nloop_\n";
  for (const char* tag :
       {"type_symbol", "label_alt_id", "label_atom_id", "label_comp_id", "label_seq_id",
        "label_asym_id", "auth_atom_id", "auth_comp_id", "auth_seq_id", "auth_asym_id", "occupancy",
        "Cartn_x", "Cartn_y", "Cartn_z"}) {
    tags += std::string("_atom_site.") + tag + "\n";
  }
  const std::string first = "C A CA ALA 1 A ? ? ? ? 0.4 0 0 0\nC B CA ALA 1 A ? ? ? ? 0.6 1 0 0\n";
  const std::string others =
      "O . O  ALA 1 A .  .  . . 1 3 0 0\nC . CA ALA 2 A ?  ?  ? ? 1 6 0 0\n"
      "C . CA ALA 1 B CX MSE 7 X 1 9 0 0\nO . O HOH . C ? ? ? ? 1 12 0 0\n";
  const Molecule molecule = parse_molecule(tags + first + others, "a.cif");
  CHECK(names_of(molecule) == "CA O CA CX");
  CHECK(molecule.counts.alternates == 1);
  CHECK(molecule.counts.waters == 1);
  REQUIRE(molecule.atoms.size() == 4);
  CHECK(describe(molecule.atoms[2]) == "atom CA of ALA 2 (line 20)");
  CHECK(describe(molecule.atoms[3]) == "atom CX of MSE 7 chain X (line 21)");
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
