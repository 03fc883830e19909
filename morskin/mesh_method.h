#pragma once

namespace morskin {

/// The library's ways of meshing a skin.
enum class Method {
  Sweep,   ///< Algorithm 1 of the paper: an advancing front along a Morse function
  Static,  ///< restricted Delaunay refinement: slower, but surer and coarser where C is above 0.25
};

}  // namespace morskin
