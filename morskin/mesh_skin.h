#pragma once

/// The one public call of the library: weighted points in; mesh, certificate and counts out.
/// It never prints and never exits.

#include <string>
#include <vector>

#include "certify/certificate.h"
#include "geometry/error.h"
#include "geometry/indexed_mesh.h"
#include "morskin/method.h"

namespace morskin {

/// A component of the skin that did not pass the certificate, and what took its place.
struct Fallback {
  std::size_t component;
  std::string from;  ///< the method whose mesh did not pass
  std::string to;    ///< the run whose mesh did; "nothing" if none did
  std::string why;   ///< the certificate's reason, or that the part was not refined
};

struct MeshResult : RunCounts {
  geometry::IndexedMesh mesh;
  /// By vertex, the mixed cell it lies in.
  std::vector<geometry::CellId> cells;
  /// By half-edge of the mesh (geometry/surface_mesh.h), its twin. Only the certificate asks for
  /// them, and takes them away.
  std::vector<geometry::HalfEdgeId> twins;
  certify::Certificate certificate;  ///< empty unless asked for
  skin::DualComplex expected;
  std::vector<Fallback> fallbacks;  ///< empty in a good run (safety_net.h)
};

/// @param points  coordinates and weights of at most 2^30, Angstrom and Angstrom^2; they are
/// rounded
///                to multiples of 2^-64, the grid of the exact predicates
/// @param threads  at most; the answer is the same for any number
/// @throws skin::SingularSkin, geometry::RefusedInput
PreparedSkin prepare_skin(std::vector<geometry::WeightedPoint> points,
                          const Progress& progress = {}, unsigned threads = 1);

/// @throws morse::DegenerateFunction when options.function is degenerate for this skin;
///         geometry::RefusedInput for a method without a mesher.
MeshResult mesh_skin(const PreparedSkin& skin, const MeshOptions& options = {});
/// The same from weighted points.
/// @throws skin::SingularSkin when the skin is singular, geometry::RefusedInput when there is none.
MeshResult mesh_skin(std::vector<geometry::WeightedPoint> points, const MeshOptions& options = {});

/// Seconds to move every vertex of a mesh 0.1 rho along its tangent plane and to locate and project
/// it again from its old cell, once: the floor that no mesher can pass on this machine.
double floor_seconds(const skin::SkinSurface& skin, const MeshResult& result);

}  // namespace morskin
