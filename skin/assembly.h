#pragma once

// Inside molecule_files: biological assemblies, of which a file gives one part and how to copy it.

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "skin/molecule_formats.h"

namespace morskin::skin::molecule_formats {

/// A rigid motion that makes a copy: x becomes rotation x + translation, Angstrom.
struct Motion {
  std::string name;  ///< the same for the same motion within one file
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
  geometry::Vector translation = geometry::Vector::Zero();
};

/// Chains and the motions of which each makes a copy of them.
struct AssemblyPart {
  std::set<Label> chains;  ///< as AtomRecord::assembly_chain
  std::vector<Motion> motions;
};

struct Assembly {
  std::string name;
  std::vector<AssemblyPart> parts;
};

/// The assembly of that name: in REMARK 350 of PDB, or in _pdbx_struct_assembly_gen of mmCIF.
/// @throws RefusedInput     the file tells of none, or of others; a motion is no rotation with a
///                          shift; there are more than 100,000
/// @throws UnreadableInput  what it tells cannot be understood
Assembly pdb_assembly(std::string_view bytes, const std::string& source, const std::string& name);
Assembly mmcif_assembly(std::string_view bytes, const std::string& source, const std::string& name);

/// Puts the assembly in the place of its atoms, motion by motion, and those in the file's order.
/// With the k-th motion of the assembly chain A becomes A-k, with the first it stays A; another
/// mark stands for the hyphen where a chain's name has one.
/// @return how many of the atoms are in no part of it
/// @throws RefusedInput  there are none in it, or more than `max_atoms`; or names of chains get
///                       longer than a Label
std::size_t assemble(std::vector<AtomRecord>& atoms, const Assembly& assembly,
                     const std::string& source, std::size_t max_atoms);

/// @throws RefusedInput  unless the motion is a rotation with a shift, to the decimals of files
void check_motion(const Motion& motion, const std::string& location);

/// @throws RefusedInput  says that there is no such assembly
[[noreturn]] void refuse_assembly(const std::string& source, const std::string& name,
                                  const std::vector<std::string>& others);

/// The tables of mmCIF that tell of assemblies, as texts; empty where it lacks them.
struct AssemblyTables {
  struct Generator {
    std::string assembly, expression, chains;
  };
  struct Operator {
    std::string id;
    std::array<std::string, 12> numbers;  ///< of the rotation by rows, then of the translation
  };
  std::vector<Generator> generators;
  std::vector<Operator> operators;
};
/// @throws UnreadableInput  the bytes are no mmCIF
AssemblyTables assembly_tables(std::string_view bytes, const std::string& source);

constexpr std::size_t max_motions = 100'000;  // 70 times those of the largest entry of the PDB

}  // namespace morskin::skin::molecule_formats
