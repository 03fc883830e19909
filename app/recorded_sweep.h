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
  /// By triangle of the result, the number of the laid triangle in whose place it lies: the time of
  /// its birth.
  ///
  /// A triangle that refinement left alone has its own; one that came out of a flip has that of one
  /// of the two; one beside an inserted vertex appears with the last of its neighbours.
  std::vector<std::uint32_t> birth;
};

/// morskin::make_mesh from one front, as Algorithm 1 is printed, and recorded.
/// @throws morse::DegenerateFunction
RecordedMesh mesh_and_record(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run);

/// By triangle of a refined mesh, its birth as above.
/// @param before  triangles of the sweep, in order, and the positions of their vertices
/// @pre refinement keeps the order of the vertices and triangles it leaves in place and moves no
///      vertex.
std::vector<std::uint32_t> births(const geometry::IndexedMesh& before,
                                  const geometry::IndexedMesh& after);

}  // namespace morskin::app
