#pragma once

/// What of a skin makes a mesh finer than a solver wishes: voids, necks and tunnels.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "morskin/pipeline.h"
#include "skin/void_volume.h"
#include "skin/waists.h"

namespace morskin::app {

struct SkinParts {
  struct Cavity {
    geometry::Point at;                        ///< its deepest point
    std::optional<skin::VolumeBounds> volume;  ///< Angstrom^3
    std::size_t bodies_inside;
    bool is_dropped;
  };
  std::size_t outer_surfaces = 0;  ///< that border on the outside
  double void_area = 0;            ///< of the mesh on the walls of voids, Angstrom^2
  std::vector<Cavity> voids;       ///< the largest first
  std::vector<skin::Waist> necks;  ///< the narrowest first
  std::vector<skin::Waist> tunnels;
};

/// Before there is a mesh, with bounds on the volumes. In the stage "voids".
SkinParts skin_parts(const morskin::PreparedSkin& skin, const morskin::Run& run);
/// With the volumes that the walls in a closed mesh enclose, bodies inside taken off; none of voids
/// that are dropped.
SkinParts skin_parts(const morskin::PreparedSkin& skin, const morskin::MeshResult& result);

/// Adds "voids", all of them, "necks" and "tunnels", the number and the narrowest.
void add_skin_parts(nlohmann::ordered_json& json, const SkinParts& parts);
/// Voids, necks and tunnels.
std::string skin_parts_text(const SkinParts& parts);
/// Outer surfaces and voids, of a mesh of this area, Angstrom^2.
std::string surfaces_text(const SkinParts& parts, double area);
/// Necks and tunnels.
std::string waists_text(const SkinParts& parts);

}  // namespace morskin::app
