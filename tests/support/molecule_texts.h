#pragma once

/// Small molecules as the bytes of files.

#include <zlib.h>

#include <cstdio>
#include <string>

#include "skin/molecule_files.h"

namespace morskin::support {

using skin::Atom;
using skin::Molecule;

/// An ATOM or HETATM line. `name` is columns 13-16, `residue` columns 18-20, `tail` columns 55 on.
inline std::string pdb_line(const char* record, const char* name, char alternate,
                            const char* residue, int number, double x, const char* tail) {
  char line[160];
  std::snprintf(line, sizeof line, "%-6s%5d %4s%c%3s A%4d    %8.3f%8.3f%8.3f%s\n", record, number,
                name, alternate, residue, number, x, 2.5, -3.25, tail);
  return line;
}

inline std::string gzipped(const std::string& text) {
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

inline std::string elements_of(const Molecule& molecule) {
  std::string text;
  for (const Atom& atom : molecule.atoms) {
    if (!text.empty()) text += ' ';
    text += atom.element.view();
  }
  return text;
}

inline std::string names_of(const Molecule& molecule) {
  std::string text;
  for (const Atom& atom : molecule.atoms) {
    if (!text.empty()) text += ' ';
    text += atom.name.view();
  }
  return text;
}

inline const std::string small_cif =
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
inline const std::string small_pqr =
    "REMARK by hand\nATOM 1 N ALA A 1 0 0 0 -0.3 1.55\nATOM 2 HA ALA A 1 1 0 0 0.1 0.0\n"
    "ATOM 3 CA ALA 1 2 0 0 0.1 1.7\nHETATM100000 ZN ZN 2 3 0 0 2 1.39\nTER\nEND\n";
inline const std::string small_xyz = "3\ncomment\nC 0 0 0\ncl1 1 0 0 0.5\n8 2 0 0\n";
inline const std::string small_xyzr =
    "# balls\n0 0 0 1.5\n\n1 0 0 0 # hidden\n2 0 0 1.25\n2 0 0 1.25\n";

inline std::string small_pdb() {
  return "HEADER    TEST\n" + pdb_line("ATOM", " N  ", ' ', "ALA", 1, 1.5, "  1.00  0.00") +
         pdb_line("ATOM", " CA ", ' ', "ALA", 2, 4, "  1.00  0.00           C") +
         pdb_line("HETATM", "CA  ", ' ', " CA", 3, 8, "  1.00  0.00") + "END\n";
}

}  // namespace morskin::support
