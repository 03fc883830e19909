#pragma once

/// What networks that learn on molecular surfaces take, in one call: the arrays that the command
/// `morskin features` writes, of the same mesh. papers/features.md says what each is.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <variant>
#include <vector>

#include "morskin/morskin.h"

namespace morskin {

/// An array by its name there.
struct FeatureArray {
  std::string name;
  std::variant<std::vector<double>, std::vector<std::int32_t>, std::vector<std::int64_t>,
               std::vector<std::uint32_t>, std::vector<std::string>>
      values;
  std::size_t columns = 1;  ///< values of each row, side by side; 1 for an array of one dimension
};

struct FeatureOptions {
  ReadOptions reading = {};
  SkinOptions skin = {.model = Model::SesLike,
                      .drop_voids_below = std::numeric_limits<double>::infinity()};
  MeshOptions mesh = {.C = MeshOptions::coarsest_C, .density = 2};
};

struct Features {
  SkinMesh mesh;                     ///< with its certificate
  std::vector<FeatureArray> arrays;  ///< all but those of the file's origin
};

/// Reads a molecule, meshes its skin and describes it.
/// @throws Error  Unreadable, Refused, Singular, Degenerate, Limit, Stopped
Features features(const std::filesystem::path& file, const FeatureOptions& options = {},
                  const RunOptions& run = {});

}  // namespace morskin
