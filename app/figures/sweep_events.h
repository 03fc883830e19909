#pragma once

/// A recorded sweep. Triangles are only added, so a state of the sweep is a number of triangles,
/// and its front the edges that only one of them has.

#include "morse/guide.h"
#include "morskin/pipeline.h"

namespace morskin::figures {

struct Event {
  front::Operation operation;
  std::size_t before, after;  ///< triangles
};

struct RecordedSweep {
  morse::Guide guide;
  surface::Mesh mesh;
  std::vector<Event> events;
};

/// A sweep from below, Algorithm 1 as printed.
RecordedSweep recorded_sweep(const morskin::PreparedSkin& skin, double C);

}  // namespace morskin::figures
