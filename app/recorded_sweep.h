#pragma once

/// A mesh together with the sweep that made it, for the viewer to run through again.

#include <cstdint>
#include <vector>

#include "morskin/pipeline.h"

namespace morskin::app {

/// What happened after how many triangles.
struct RecordedStep {
  front::Operation operation;
  std::uint32_t triangles;  ///< laid by the end of it
};

struct RecordedMesh {
  morskin::MeshResult result;       ///< refined and certified
  std::uint32_t laid = 0;           ///< triangles, by the sweep
  std::vector<RecordedStep> steps;  ///< of the sweep
  /// By triangle of the result, how many had been laid before it (geometry::TriangleBirths).
  std::vector<std::uint32_t> birth;
};

/// morskin::make_mesh from one front, as Algorithm 1 is printed, and recorded.
/// @throws morse::DegenerateFunction
RecordedMesh mesh_and_record(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run);

}  // namespace morskin::app
