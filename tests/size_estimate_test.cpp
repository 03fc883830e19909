#include "morskin/size_estimate.h"

#include "morskin/bent_part.h"
#include "morskin/voids.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;

namespace {

MeshingOptions limited(double C, double limit) {
  certify::Sizing sizing{.C = C, .Q = certify::Sizing::quality_for(C)};
  sizing.largest_length_scale = limit;
  return {.sizing = sizing};
}

/// The vertices made over those foreseen.
double made_over_foreseen(const PreparedSkin& skin, const MeshingOptions& options) {
  const MeshResult result = make_mesh(skin, options);
  CHECK_MESSAGE(result.certificate.certified, result.certificate.reason);
  return static_cast<double>(result.mesh.positions.size()) /
         SizeEstimate(skin).vertices(options.sizing, method_of(skin, options));
}

}  // namespace

TEST_CASE("the vertices of a mesh are foreseen within a tenth, of both methods and with any C") {
  std::size_t by_sweep = 0, by_static_method = 0;
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [&](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    for (const auto& [C, limit] :
         {std::pair(0.4, 1.2), std::pair(0.4, 0.7), std::pair(0.4, 0.42), std::pair(0.4, 0.3),
          std::pair(0.3, 0.5), std::pair(0.25, 0.6), std::pair(0.2, 0.7), std::pair(0.1, 1.)}) {
      const MeshingOptions options = limited(C, limit);
      CAPTURE(options.sizing.C);
      CAPTURE(options.sizing.largest_length_scale);
      CHECK(made_over_foreseen(skin, options) == doctest::Approx(1).epsilon(0.1));
      ++(method_of(skin, options) == Method::Sweep ? by_sweep : by_static_method);
    }
  });
  CHECK(by_sweep > 0);
  CHECK(by_static_method > 0);
}

TEST_CASE("the walls of voids to be dropped are not foreseen") {
  PreparedSkin skin = prepare_skin(molecule("shell_hollow.xyzr", skin::Model::Vdw));
  const MeshingOptions options = limited(0.4, 0.7);
  const auto vertices = [&] {
    return SizeEstimate(skin).vertices(options.sizing, method_of(skin, options));
  };
  const double whole = vertices();
  drop_voids(skin, std::numeric_limits<double>::infinity());
  CHECK(vertices() < 0.9 * whole);
  CHECK(made_over_foreseen(skin, options) == doctest::Approx(1).epsilon(0.1));
}

TEST_CASE("the bent share of the area is that of the points spread over the skin") {
  for_molecules({"5tmn_ligand.pdb", "9dna.pdb"}, [](const auto& balls) {
    const PreparedSkin skin = prepare_skin(balls);
    for (const double limit : {0.3, 0.6, 0.9}) {
      CAPTURE(limit);
      double area = 0, bent = 0;
      for (const surface::SurfacePoint& p : skin.surface.samples().points) {
        const double here = p.length_scale * p.length_scale;
        area += here;
        if (p.length_scale < limit) bent += here;
      }
      const BentPart found = bent_part(skin.surface, make_mesh(skin, limited(0.4, limit)));
      CHECK(found.area_share == doctest::Approx(bent / area).epsilon(0.05));
    }
  });
}
