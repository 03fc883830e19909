#pragma once

/// The one pipeline: a prepared skin in; mesh, certificate and counts out. The library's face
/// (morskin.h), the command, the viewer's recording, the figures and the benchmarks all call it.
/// It never prints and never exits.

#include <string>
#include <vector>

#include "certify/certificate.h"
#include "morskin/method.h"

namespace morskin {

/// A component of the skin that did not pass the certificate, and what took its place.
struct Fallback {
  /// A run that made a mesh which passed.
  struct Replacement {
    Method method;
    morse::MorseFunction function;
  };

  std::size_t component;
  std::string reason;  ///< the certificate's, or that the part was not refined
  std::optional<Replacement> replacement;
};

struct MeshResult : RunCounts {
  Method method;                        ///< that made it, first; of the library's
  certify::Sizing sizing;               ///< as a size goal has set it
  geometry::IndexedMesh mesh;           ///< as it was delivered
  std::vector<geometry::CellId> cells;  ///< by vertex, the mixed cell it lies in
  certify::Certificate certificate;     ///< of the mesh as it was delivered
  std::vector<Fallback> fallbacks;      ///< empty in a good run (safety_net.h)
};

/// Meshes, delivers and certifies a skin. Stages: "critical points", "integral lines", "sweep",
/// "refine", "smooth", "deliver", "certify" and, where they are needed, "thin", "thicken", "improve
/// angles", "refine angles", "refine angles in space"; other methods leave some out. The static
/// method and the last of these make all cells of the skin, in "triangulate" and "mixed complex".
/// @throws morse::DegenerateFunction when options.function is degenerate for this skin;
///         geometry::RefusedInput for options that make no sense; geometry::Stopped
MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
                     const Run& run = Run());
/// The same unobserved.
MeshResult make_mesh(const PreparedSkin& skin, const MeshingOptions& options = {},
                     const Run& run = Run());

/// Seconds to move every vertex of a mesh 0.1 rho along its tangent plane and to locate and project
/// it again from its old cell, once: the floor that no mesher can pass on this machine. Measured on
/// an eighth of the vertices.
double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result);

}  // namespace morskin
