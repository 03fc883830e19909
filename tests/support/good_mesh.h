#pragma once

#include "certify/certificate.h"
#include "certify/located_vertices.h"
#include "certify/restricted_delaunay.h"
#include "tests/support/meshes.h"

namespace morskin::support {

using geometry::IndexedMesh;

/// A skin and a good mesh of it.
struct Good {
  explicit Good(const WeightedPoints& points)
      : skin(morskin::prepare_skin(points)), mesh(morskin::make_mesh(skin, uncertified()).mesh) {}

  certify::Certificate certify(const IndexedMesh& other) const {
    return certify::certify(other, skin.surface, skin.topology);
  }
  certify::RestrictedDelaunay delaunay(const IndexedMesh& other, unsigned threads = 1) const {
    const auto points = certify::locate_vertices(other, skin.surface);
    return certify::restricted_delaunay(other, skin.surface, points, 10, geometry::Run(threads));
  }

  morskin::PreparedSkin skin;
  IndexedMesh mesh;
};

/// Of a molecule's van der Waals skin.
inline Good vdw(const char* file) { return Good(molecule(file, skin::Model::Vdw)); }

}  // namespace morskin::support
