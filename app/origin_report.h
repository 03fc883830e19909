#pragma once

/// What `check` tells of the origin that a mesh file states.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "app/skin_arguments.h"
#include "geometry/files/mesh_files.h"

namespace morskin::app {

struct OriginReport {
  geometry::Provenance stated;         ///< empty if the file states nothing
  std::vector<std::string> taken;      ///< options whose values are the file's
  std::vector<std::string> not_taken;  ///< with their reasons
  /// Whether the hashes that are stated are those found; absent where none is stated or found.
  std::optional<bool> coordinates_match, faces_match, input_matches;
  bool has_curves = false;  ///< the hashes are those of the corners alone

  /// Compares the hashes of the mesh.
  void compare_mesh(const geometry::MeshFile& file, unsigned threads);
  /// Compares the hash of the molecule's file.
  void compare_input(const std::string& sha256);
};

/// Adds an object `origin`; nothing if the file states nothing.
void add_origin(nlohmann::ordered_json& json, const OriginReport& origin);
/// Lines; none if the file states nothing.
std::string origin_text(const OriginReport& origin);

/// Adds what is said of the skin that a mesh is checked against.
void add_skin(nlohmann::ordered_json& json, const MoleculeArguments& molecule);
/// The same and the sizes, in a line.
std::string skin_text(const MoleculeArguments& molecule, const certify::Sizing& sizing);

}  // namespace morskin::app
