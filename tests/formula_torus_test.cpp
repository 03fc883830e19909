// The front, the refinement and the certificate know nothing of molecules: they mesh and certify a
// torus given by a formula.

#include "certify/certificate.h"
#include "front/subdomains.h"
#include "refine/refinement.h"
#include "refine/smoothing.h"
#include "tests/support/formula_surfaces.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::support;

namespace {

/// A torus about the z axis and the height along x, whose four critical points lie on the x axis.
struct TorusRun {
  double R, r;
  Torus torus{R, r};
  certify::Sizing sizing = {};

  morse::CriticalPoint critical(double x, int index) const {
    morse::CriticalPoint p{torus.at({x, 0, 0}, surface::CellId{0U}), index, x};
    // At both saddles the hole's rim turns one way, the tube the other.
    if (index == 1) {
      p.descending = x > 0 ? geometry::Vector::UnitY() : geometry::Vector::UnitZ();
      p.ascending = x > 0 ? geometry::Vector::UnitZ() : geometry::Vector::UnitY();
    }
    return p;
  }

  morse::Guide guide() const {
    morse::Guide guide;
    guide.function = morse::MorseFunction::height(geometry::Vector::UnitX());
    guide.points = {critical(-R - r, 0), critical(r - R, 1), critical(R - r, 1),
                    critical(R + r, 2)};
    guide.found = {1, 2, 1};
    const double radius = sizing.tangent_disk_share() * r;
    std::vector<morse::ProtectingSpheres::Incidence> incidences;
    for (std::size_t i = 0; i < guide.points.size(); ++i) {
      incidences.emplace_back(surface::CellId{0U}, morse::CriticalId{i});
    }
    guide.spheres = {guide.points, std::vector<double>(guide.points.size(), radius), incidences,
                     torus.cell_count()};
    return guide;
  }

  certify::Certificate certificate(front::SweepResult swept) const {
    CHECK(swept.open_edges == 0);
    refine::Refinement refinement(torus, sizing, swept.mesh);
    refinement.run();
    refine::smooth(torus, sizing, swept.mesh, 30);
    return certify::certify(indexed_mesh(swept.mesh), torus, {1, 1, 0}, sizing);
  }
};

void check(const certify::Certificate& certificate) {
  CHECK_MESSAGE(certificate.certified, certificate.reason);
  CHECK(certificate.genus == 1);
  CHECK(certificate.min_angle_deg > 29.9);
  CHECK(certificate.restricted_delaunay_violations == 0);
}

}  // namespace

TEST_CASE("the front meshes a torus given by a formula, certified") {
  for (const double R : {2.0, 2.5, 4.0}) {
    CAPTURE(R);
    const TorusRun run{R, 1};
    check(run.certificate(front::sweep_once(run.torus, run.guide(), {.sizing = run.sizing})));
    check(run.certificate(front::sweep_subdomains(run.torus, run.guide(), {.sizing = run.sizing})));
  }
}

TEST_CASE("a torus is not certified as a sphere") {
  const TorusRun run{3, 1};
  const auto swept = front::sweep_once(run.torus, run.guide(), {.sizing = run.sizing});
  const certify::Certificate certificate =
      certify::certify(indexed_mesh(swept.mesh), run.torus, {1, 0, 2}, run.sizing);
  CHECK(!certificate.is_homeomorphic);
  CHECK(!certificate.broken_by(certify::Claim::Counts).empty());
}
