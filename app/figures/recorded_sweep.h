#pragma once

/// A recorded sweep, for figures and for the viewer to run through again. Triangles are only added,
/// so a state of the sweep is a number of triangles, and its front the edges that only one of them
/// has.

#include <cstdint>
#include <vector>

#include "app/figures/seams.h"
#include "morse/guide.h"
#include "morskin/pipeline.h"

namespace morskin::figures {

struct Event {
  front::Operation operation;
  std::size_t before, after;  ///< triangles laid
};

struct RecordedSweep {
  morse::Guide guide;
  std::vector<Event> events;
  surface::Mesh mesh;            ///< as it was swept
  std::vector<bool> is_on_seam;  ///< by birth; those beyond the end are not
  std::uint32_t laid = 0;        ///< triangles, those counted that coarsening took out again
  morskin::MeshResult result;    ///< refined and certified
  /// By triangle of the result, how many had been laid before it (geometry::TriangleBirths).
  std::vector<std::uint32_t> birth;
};

/// morskin::make_mesh from one front, as in Algorithm 1, without the safety net: what that
/// made would not be what the sweep laid.
/// @throws morse::DegenerateFunction
RecordedSweep recorded_sweep(const morskin::PreparedSkin& skin, morskin::MeshingOptions options,
                             const morskin::Run& run = morskin::Run());

}  // namespace morskin::figures
