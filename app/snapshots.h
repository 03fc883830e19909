#pragma once

/// Intermediate states of a sweep as mesh files (the paper's Figure 4).

#include <filesystem>

#include "front/snapshots.h"

namespace morskin::app {

/// Writes snapshot-K.ply, the mesh laid so far, and snapshot-K.vtu, the same with the edges of the
/// front, marked by the integer `front`, and the Morse function's value at every vertex.
/// @throws geometry::UnwritableOutput
void write_snapshot(const std::filesystem::path& folder, std::size_t number,
                    const front::Snapshot& snapshot);
/// Writes snapshot-K.ply, a state of the growing skin.
/// @throws geometry::UnwritableOutput
void write_snapshot(const std::filesystem::path& folder, std::size_t number,
                    const surface::Mesh& mesh);

}  // namespace morskin::app
