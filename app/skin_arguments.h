#pragma once

/// The options that say whose skin a mesh is, and how fine: as typed, and as values.

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <stdexcept>
#include <string>

#include "app/selection_arguments.h"
#include "certify/sizing.h"
#include "skin/model.h"
#include "skin/selection.h"

namespace morskin::app {

/// Wrong arguments; the text names them and the reason. The command's exit code is 2.
class UsageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The arguments of every command that reads a molecule.
struct MoleculeArguments {
  std::filesystem::path input;
  skin::Model model = skin::Model::Vdw;
  double probe = 1.4;  ///< Angstrom
  skin::Selection selection = {};
  std::optional<std::string> radii = {};  ///< as skin::radius_table takes them
  double drop_voids_below = 0;            ///< Angstrom^3; infinite for all
};

/// "model sas, probe 1.4 A"; the probe only where it plays a part.
std::string model_text(const MoleculeArguments& molecule);
/// Adds `model`, and `probe` where it plays a part.
void add_model(nlohmann::ordered_json& json, const MoleculeArguments& molecule);

/// The options as typed, before they are checked; absent where the default holds.
struct TypedSkin {
  std::optional<std::string> model, radii, voids;
  std::optional<double> probe, C, Q, size;
  TypedSelection selection;
};

/// Whether any of them was typed.
bool is_set(const TypedSkin& typed);
/// Whether any was that only skins of molecules have: one but -C, -Q and --size.
bool is_of_molecules(const TypedSkin& typed);

/// Whether what it says is gone once it was read: standard input, or a pipe.
bool is_read_once(const std::filesystem::path& file);

/// @param file  the molecule; not molecule.input where that is a mesh
/// @throws UsageError
void finish(MoleculeArguments& molecule, const std::filesystem::path& file, const TypedSkin& typed);

/// -C, -Q and --size.
/// @param default_C  where neither -C nor --size is given
/// @throws UsageError
void finish(certify::Sizing& sizing, const TypedSkin& typed, double default_C);

}  // namespace morskin::app
