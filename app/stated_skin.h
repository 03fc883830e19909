#pragma once

/// What a mesh file states of its skin, taken by `check` where the command line says nothing. No
/// statement is believed: it only says which skin to check against.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/molecule_input.h"
#include "app/skin_arguments.h"
#include "geometry/provenance.h"

namespace morskin::app {

/// The value of a key; nothing if the file has none, or more than one.
std::optional<std::string> stated(const geometry::Provenance& provenance, std::string_view key);

struct StatedSkin {
  TypedSkin typed;                     ///< as given, completed by the file
  std::vector<std::string> taken;      ///< names of options whose values are the file's
  std::vector<std::string> not_taken;  ///< "model: is named twice", ...
};

/// @param given     on the command line; goes first. C, Q and size are one choice
/// @param molecule  the file to be read, if any: whether it gives radii is told by its ending
StatedSkin completed(const TypedSkin& given, const geometry::Provenance& provenance,
                     const std::filesystem::path& molecule = {});

/// The molecule of a mesh, read as it was for it.
struct StatedMolecule {
  MoleculeInput input;
  MoleculeArguments molecule;
  certify::Sizing sizing;
  std::vector<std::string> taken, not_taken;  ///< as above
};

/// By what the mesh file states, but for statements that do not fit the molecule or those before.
/// @param molecule, sizing  by the options alone
/// @param given             the same as typed
/// @throws  as read_input()
StatedMolecule read_stated(MoleculeArguments molecule, const certify::Sizing& sizing,
                           const TypedSkin& given, const geometry::Provenance& provenance);

}  // namespace morskin::app
