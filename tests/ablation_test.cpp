#include "bench/ablation/as_printed.h"
#include "bench/ablation/breaches.h"
#include "bench/ablation/contraction_by_distance.h"
#include "bench/ablation/refining_observer.h"
#include "front/sweep.h"
#include "front/sweep_plan.h"
#include "tests/support/meshes.h"
#include "tests/support/plain_complex.h"

using namespace morskin;
using namespace morskin::ablation;
using namespace morskin::support;

namespace {

MeshingOptions options_for(const AsPrinted& printed) {
  MeshingOptions options = uncertified();
  options.mesher = mesher(printed);
  return options;
}

bool is_same(const geometry::IndexedMesh& a, const geometry::IndexedMesh& b) {
  return a.triangles == b.triangles && a.positions == b.positions;
}

AsPrinted only(bool AsPrinted::*member) {
  AsPrinted printed;
  printed.*member = true;
  return printed;
}

/// Sweeps once from below.
/// @return where edges of the front start, in the order in which they opened
std::vector<surface::Point> laid_vertices(const PreparedSkin& skin, surface::Mesh& mesh,
                                          std::vector<front::SweepObserver*> observers = {}) {
  struct Recorder : front::SweepObserver {
    void follow(const front::FrontChange& change) override {
      for (const auto e : change.opened) positions.push_back(change.front[e].position);
    }
    std::vector<surface::Point> positions;
  } recorder;
  observers.push_back(&recorder);
  const morse::Guide guide = guide_for(skin);
  front::Sweep(skin.surface, guide, {}, mesh, observers).run({}, front::minima_of(guide));
  return recorder.positions;
}

}  // namespace

TEST_CASE("with nothing as printed the ablation's mesh is that of one front, unsmoothed") {
  for_skins(8, [](const PreparedSkin& skin) {
    MeshingOptions one_front = uncertified();
    one_front.angle_goal_deg = 0;
    one_front.fronts = 1;
    const MeshResult expected = make_mesh(skin, one_front),
                     found = make_mesh(skin, options_for({}));
    CHECK(is_same(found.mesh, expected.mesh));
    CHECK(found.certificate.certified == expected.certificate.certified);
  });
}

TEST_CASE("each departure that is taken back changes some mesh") {
  for (const auto& each : switches) {
    CAPTURE(each.first);
    const auto changes = [m = each.second](const PreparedSkin& skin) {
      const MeshResult ours = make_mesh(skin, options_for({}));
      return !is_same(make_mesh(skin, options_for(only(m))).mesh, ours.mesh);
    };
    bool is_changed = false;
    for_skins(2, [&](const PreparedSkin& skin) { is_changed = is_changed || changes(skin); });
    // By distance and by persistence other arcs are contracted on few molecules.
    CHECK((is_changed || changes(prepare_skin(molecule("1grm_model1.pdb", skin::Model::Paper)))));
  }
}

TEST_CASE("sectors rounded up have at most 60 degrees, and are never fewer than the nearest") {
  const front::Spacing nearest, printed = spacing({.sectors = true});
  constexpr double degree = M_PI / 180;
  for (double angle = 0.1; angle < 360; angle += 0.25) {  // no multiple of 60
    CAPTURE(angle);
    const double n = printed.sectors(angle * degree);
    CHECK(n >= nearest.sectors(angle * degree));
    CHECK(n == std::ceil(angle / 60));
    CHECK(nearest.sectors(angle * degree) == doctest::Approx(angle / 60).epsilon(0.5 / n));
  }
}

TEST_CASE("the printed disk is a fixed share of the length scale, and never smaller than ours") {
  const certify::Sizing sizing;
  for_skins(10, [&](const PreparedSkin& skin) {
    const front::TangentDisk ours(skin.surface, sizing);
    const AsPrinted both{.radius = true, .length_scale = true};
    const front::TangentDisk printed(skin.surface, sizing, spacing(both));
    for (const morse::CriticalPoint& p : guide_for(skin).points) {
      const double r = printed.radius(p.point, p.descending);
      CHECK(r == doctest::Approx(sizing.tangent_disk_share() * p.point.length_scale));
      CHECK(ours.radius(p.point, p.descending) <= 0.87 * r * (1 + 1e-12));
    }
  });
}

TEST_CASE(
    "the disk is 0.87 of the paper's or, for small C, the one whose even fan takes 0.88 of [U]") {
  const PreparedSkin skin = prepare_skin({{{0, 0, 0}, 1.0}});
  bool is_by_disk = false, is_by_fan = false;
  for (const double C : {0.002, 0.01, 0.04, 0.05, 0.08, 0.2}) {
    CAPTURE(C);
    const certify::Sizing sizing{C, certify::Sizing::quality_for(C)};
    const double share = front::TangentDisk(skin.surface, sizing).share();
    const double by_disk = share / sizing.tangent_disk_share();
    const double by_fan = share / (std::sqrt(3) * sizing.C * sizing.Q);  // circumradius over [U]'s
    CHECK(by_disk <= 0.87 * (1 + 1e-12));
    CHECK(by_fan <= 0.88 * (1 + 1e-12));
    is_by_disk |= by_disk > 0.87 * (1 - 1e-12);
    is_by_fan |= by_fan > 0.88 * (1 - 1e-12);
  }
  const auto by_disk = [&](double C) {
    const certify::Sizing sizing{C, 1.65};
    return front::TangentDisk(skin.surface, sizing).share() / sizing.tangent_disk_share();
  };
  CHECK(by_disk(0.0423) == doctest::Approx(0.87).epsilon(1e-9));
  CHECK(by_disk(0.0421) < 0.87 * (1 - 1e-6));
  CHECK(is_by_disk);
  CHECK(is_by_fan);
}

TEST_CASE("contracted by distance, spheres at the ends of an arc overlap only where none is left") {
  constexpr double share = 0.3;
  std::size_t contracted = 0;
  for_complexes(300, [&](const morse::MorseSmaleComplex& complex) {
    const morse::Simplification simple = contract_by_distance(complex, share);
    CHECK(euler_characteristic(complex, simple.survives) ==
          euler_characteristic(complex, std::vector<bool>(complex.points.size(), true)));
    contracted += complex.arcs.size() - simple.complex.arcs.size();
    for (std::size_t i = 0; i < simple.complex.arcs.size(); ++i) {
      const auto [saddle, extremum] = simple.complex.arcs[i];
      const bool has_no_heir = simple.complex.arcs[i ^ 2U].extremum == extremum;
      const surface::SurfacePoint& p = complex.points[saddle.index()].point;
      const surface::SurfacePoint& q = complex.points[extremum.index()].point;
      const double radii = share * (p.length_scale + q.length_scale);
      CHECK((has_no_heir || (p.position - q.position).norm() >= radii));
    }
  });
  CHECK(contracted > 0);
}

TEST_CASE(
    "refined in the loop, the sweep lays the same vertices and leaves nothing that is short") {
  for_skins(8, [](const PreparedSkin& skin) {
    surface::Mesh plain, refined;
    RefiningObserver refining(skin.surface, {}, refined);
    const auto expected = laid_vertices(skin, plain);
    CHECK(laid_vertices(skin, refined, {&refining}) == expected);
    const Breaches before = count_breaches({}, plain), after = count_breaches({}, refined);
    CHECK(after.short_edges == 0);
    CHECK(after.big_triangles <= before.big_triangles / 20);
    CHECK(!geometry::validate(refined.surface));
  });
}

TEST_CASE("a mesh has as many breaches as its certificate counts") {
  for_skins(10, [](const PreparedSkin& skin) {
    surface::Mesh mesh;
    laid_vertices(skin, mesh);
    const Breaches found = count_breaches({}, mesh);
    const certify::Certificate certificate =
        certify::certify(surface::indexed_mesh(mesh), skin.surface, skin.topology);
    CHECK(found.short_edges == certificate.violations_L);
    CHECK(found.big_triangles == certificate.violations_U);
    const geometry::IndexedMesh angles = surface::indexed_mesh(mesh);
    CHECK(angles_below(60, angles) >= angles.triangles.size());
    CHECK(angles_below(certificate.min_angle_deg * (1 - 1e-9), angles) == 0);
    CHECK(angles_below(certificate.min_angle_deg * (1 + 1e-9), angles) > 0);
  });
}
