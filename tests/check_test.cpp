// Every way in which a mesh was seen to be wrong, made from a good one, and the reason given.

#include <cmath>

#include "certify/deviations.h"
#include "certify/residuals.h"
#include "geometry/files/mesh_files.h"
#include "geometry/mesh_check.h"
#include "geometry/self_intersections.h"
#include "skin/skin_components.h"
#include "tests/support/good_mesh.h"
#include "tests/support/mesh_part.h"

using namespace morskin;
using certify::Certificate;
using certify::Claim;
using geometry::IndexedMesh;
using geometry::Point;
using support::ball;
using support::contains;
using support::Good;
using support::vdw;

namespace {

/// By component of the mesh, the component of the skin that its first vertex lies on.
std::vector<skin::SkinComponents::Sides> sides_of(const Good& good, const IndexedMesh& mesh) {
  const skin::SkinComponents parts(good.skin.surface, good.skin.topology);
  const auto points = certify::locate_vertices(mesh, good.skin.surface);
  std::vector<skin::SkinComponents::Sides> result;
  for (const geometry::MeshComponent& c : geometry::check_mesh(mesh).components) {
    const auto sides = parts.sides(points[mesh.triangles[c.first_triangle][0]]);
    REQUIRE(sides.has_value());
    result.push_back(*sides);
  }
  return result;
}

/// Triangles whose second vertex lies on another component of the skin than is said of theirs.
std::size_t vertices_elsewhere(const Good& good,
                               const std::vector<skin::SkinComponents::Sides>& sides) {
  const skin::SkinComponents parts(good.skin.surface, good.skin.topology);
  const auto points = certify::locate_vertices(good.mesh, good.skin.surface);
  const auto component = geometry::check_mesh(good.mesh).component_of_triangle;
  std::size_t wrong = 0;
  for (std::size_t t = 0; t < good.mesh.triangles.size(); ++t) {
    const auto found = parts.sides(points[good.mesh.triangles[t][1]]);
    wrong += !found || *found != sides[component[t]];
  }
  return wrong;
}

/// A ring's mesh cut through on one side, both ends closed by fans about one of their vertices.
IndexedMesh without_handle(const IndexedMesh& ring) {
  IndexedMesh cut = ring;
  // The half with x > 0 of the tube between y = -0.5 and 0.5 goes.
  std::erase_if(cut.triangles, [&](const auto& t) {
    return std::ranges::all_of(t, [&](std::uint32_t v) {
      return ring.positions[v].x() > 0 && std::abs(ring.positions[v].y()) < 0.5;
    });
  });
  std::vector<std::optional<std::uint32_t>> next(ring.positions.size());
  std::set<std::pair<std::uint32_t, std::uint32_t>> half_edges;
  for (const auto& t : cut.triangles) {
    for (std::size_t k = 0; k < 3; ++k) half_edges.emplace(t[k], t[(k + 1) % 3]);
  }
  for (const auto& [a, b] : half_edges) {
    if (!half_edges.contains({b, a})) next[b] = a;
  }
  for (std::uint32_t v = 0; v < next.size(); ++v) {
    if (!next[v]) continue;
    std::vector<std::uint32_t> loop;
    for (std::uint32_t w = v; next[w];) {
      loop.push_back(w);
      w = *std::exchange(next[w], std::nullopt);
    }
    for (std::size_t i = 2; i < loop.size(); ++i) {
      cut.triangles.push_back({loop[0], loop[i - 1], loop[i]});
    }
  }
  return support::mesh_part(cut, [](std::size_t) { return true; });
}

}  // namespace

TEST_CASE("vertices are located whatever the order of the triangles") {
  const Good good(support::molecule("1crn.pdb", skin::Model::Sas));
  IndexedMesh shuffled = good.mesh;
  support::Random random(1);
  for (std::size_t t = shuffled.triangles.size(); t > 1; --t) {
    std::swap(shuffled.triangles[t - 1], shuffled.triangles[random.below(t)]);
  }
  const skin::MixedComplex& complex = good.skin.surface.complex();
  for (const IndexedMesh& mesh : {good.mesh, shuffled}) {
    const auto points = certify::locate_vertices(mesh, good.skin.surface);
    REQUIRE(points.size() == mesh.positions.size());
    bool all_inside = true;
    for (std::size_t v = 0; v < points.size(); ++v) {
      for (const skin::Wall& wall : complex.walls(points[v].cell)) {
        const double beyond = wall.normal.dot(mesh.positions[v]) - wall.offset;
        all_inside = all_inside && beyond <= complex.wall_tolerance();
      }
    }
    CHECK(all_inside);
  }
}

TEST_CASE("right meshes pass every check there is") {
  for (const char* file : {"two_balls.xyzr", "ring12.xyzr", "shell_hollow.xyzr", "caffeine.xyz"}) {
    CAPTURE(file);
    const Good good = vdw(file);
    CHECK(geometry::check_mesh(good.mesh).is_closed_oriented_manifold());
    CHECK(geometry::self_intersections(good.mesh).count == 0);
    const Certificate certificate = good.certify(good.mesh);
    CHECK(certificate.certified);
    for (const std::string& reason : certificate.broken) CHECK(reason == "");
    CHECK(good.delaunay(good.mesh).violations == 0);
    CHECK(good.delaunay(good.mesh).undecided == 0);
  }
}

TEST_CASE("a flipped triangle and a hole break the manifold claim, and nothing else is blamed") {
  const Good good = vdw("two_balls.xyzr");
  IndexedMesh flipped = good.mesh, open = good.mesh;
  std::swap(flipped.triangles[40][1], flipped.triangles[40][2]);
  open.triangles.erase(open.triangles.begin() + 40);
  CHECK(contains(good.certify(flipped).broken_by(Claim::Manifold), "disagree on orientation"));
  CHECK(contains(good.certify(flipped).broken_by(Claim::Upright), "triangle 40 does not face"));
  CHECK(contains(good.certify(open).broken_by(Claim::Manifold), "has only one triangle"));
  for (const Claim claim : {Claim::OnSkin, Claim::Tube, Claim::L, Claim::U, Claim::Counts}) {
    CHECK(good.certify(flipped).broken_by(claim) == "");
    CHECK(good.certify(open).broken_by(claim) == "");
  }
  CHECK(good.certify(open).broken_by(Claim::Upright) == "");
}

TEST_CASE("a handle that is dropped shows in the genus") {
  const Good good = vdw("ring12.xyzr");
  const IndexedMesh bad = without_handle(good.mesh);
  REQUIRE(geometry::check_mesh(bad).defects.empty());
  CHECK(geometry::check_mesh(bad).components[0].genus() == 0);
  const Certificate certificate = good.certify(bad);
  CHECK_FALSE(certificate.is_homeomorphic);
  CHECK(certificate.broken_by(Claim::OnSkin) == "");
  CHECK(contains(certificate.broken_by(Claim::Counts), "the genus is 0, the skin's is 1"));
}

TEST_CASE("a vertex off the surface is named, and first in the list of the farthest") {
  const Good good = vdw("caffeine.xyz");
  IndexedMesh bad = good.mesh;
  const auto points = certify::locate_vertices(good.mesh, good.skin.surface);
  bad.positions[77] += 1e-5 * points[77].normal;
  const Certificate certificate = good.certify(bad);
  CHECK(contains(certificate.broken_by(Claim::OnSkin), "vertex 77 lies about 1e-05 Angstrom off"));
  const auto deviations = certify::measure_deviations(
      bad, good.skin.surface, certify::locate_vertices(bad, good.skin.surface), {});
  REQUIRE(deviations.farthest_vertices.size() == 10);
  CHECK(deviations.farthest_vertices[0].vertex == 77);
  CHECK(deviations.farthest_vertices[0].distance / 1e-5 == doctest::Approx(1).epsilon(1e-3));
  CHECK(deviations.max_vertex_distance == deviations.farthest_vertices[0].distance);
}

TEST_CASE(
    "a mesh rounded to single precision is homeomorphic, and its vertices may be no farther") {
  const Good good = vdw("ring12.xyzr");
  const IndexedMesh rounded = geometry::parse_mesh(
      geometry::serialized(good.mesh, geometry::MeshFormat::Stl), "rounded.stl");
  const Certificate certificate = good.certify(rounded);
  CHECK(certificate.is_single_precision);
  CHECK(certificate.is_homeomorphic);
  CHECK(certificate.max_distance_to_skin > 1e-9);
  CHECK(certificate.max_distance_to_skin < 1e-6);
  CHECK_FALSE(good.certify(good.mesh).is_single_precision);
  IndexedMesh mixed = rounded;  // one vertex in double precision: the others have no excuse
  mixed.positions[0].x() = std::nextafter(mixed.positions[0].x(), 100);
  CHECK(contains(good.certify(mixed).broken_by(Claim::OnSkin), "off the skin"));
  IndexedMesh far = rounded;
  far.positions[9].x() += 0x1p-12;  // exact in a float below 2^11
  CHECK(contains(good.certify(far).broken_by(Claim::OnSkin), "vertex 9 lies"));
}

TEST_CASE("a vertex pushed through the body crosses the far side") {
  const Good good({ball(0, 0, 0, 1)});
  IndexedMesh bad = good.mesh;
  bad.positions[3] *= -1.5;
  const geometry::SelfIntersections found = geometry::self_intersections(bad);
  CHECK(found.count > 0);
  CHECK(std::ranges::is_sorted(found.pairs));
  CHECK(geometry::check_mesh(bad).is_closed_oriented_manifold());
}

TEST_CASE("the deviations' extremes are the certificate's and lead their lists") {
  const Good good = vdw("caffeine.xyz");
  const certify::Sizing finer{0.07, 1.6};
  const Certificate certificate =
      certify::certify(good.mesh, good.skin.surface, good.skin.topology, finer);
  const auto d = certify::measure_deviations(
      good.mesh, good.skin.surface, certify::locate_vertices(good.mesh, good.skin.surface), finer);
  CHECK(d.shortest_edges[0].value == certificate.worst_L);
  CHECK(d.largest_triangles[0].value == certificate.worst_U);
  CHECK(d.max_vertex_relative == doctest::Approx(certificate.max_relative_distance_to_skin));
  CHECK(std::ranges::is_sorted(d.largest_triangles, std::greater{}, &certify::BadTriangle::value));
  CHECK(std::ranges::is_sorted(d.shortest_edges, {}, &certify::BadEdge::value));
  CHECK(certificate.violations_U > 0);
  CHECK(contains(certificate.broken_by(Claim::U), "triangle "));
  CHECK(d.steepest_triangles[0].value == doctest::Approx(d.max_normal_deg));
  // R < C Q rho bounds the height of a centroid, R^2 / 2 rho to first order, and the tilt.
  CHECK(d.max_centroid_relative < 0.132 * 0.132 / 2 * 1.1);
  CHECK(d.max_normal_deg < 15);
}

TEST_CASE("components of the mesh are found on the components of the skin, each on its own") {
  support::for_seeds(30, [&](unsigned seed) {
    if (!support::prepared(support::ball_set(seed))) return;
    const Good good(support::ball_set(seed));
    auto sides = sides_of(good, good.mesh);
    CHECK(sides.size() == good.skin.topology.skin_components());
    CHECK(vertices_elsewhere(good, sides) == 0);
    std::ranges::sort(sides);
    CHECK(std::ranges::adjacent_find(sides) == sides.end());
  });
}

TEST_CASE("every vertex of a component lies on the same component of the skin") {
  for (const char* file : {"shell_hollow.xyzr", "c60.xyz"}) {
    CAPTURE(file);
    const Good good = vdw(file);
    const geometry::MeshCheck check = geometry::check_mesh(good.mesh);
    const auto first = sides_of(good, good.mesh);
    REQUIRE(first.size() > 1);
    CHECK(vertices_elsewhere(good, first) == 0);
    // A void's wall has its volume negative and a void on its far side; the outer surface neither.
    for (std::size_t c = 0; c < first.size(); ++c) {
      CHECK(first[c].cavity.has_value() == (check.components[c].volume < 0));
    }
  }
}

TEST_CASE("a missing inner void and a doubled component are told by the skin's components") {
  const Good good = vdw("shell_hollow.xyzr");
  REQUIRE(geometry::check_mesh(good.mesh).components.size() == 2);
  const geometry::MeshCheck check = geometry::check_mesh(good.mesh);
  const IndexedMesh outer = support::mesh_part(
      good.mesh, [&](std::size_t t) { return check.component_of_triangle[t] == 0; });
  CHECK(contains(good.certify(outer).broken_by(Claim::Counts), "components is 1, the skin's is 2"));
  CHECK_FALSE(sides_of(good, outer)[0].cavity.has_value());
  IndexedMesh doubled = outer;
  doubled.append(outer);
  const auto sides = sides_of(good, doubled);
  CHECK(sides[0] == sides[1]);
  CHECK(good.certify(doubled).broken_by(Claim::Counts).find("components") == std::string::npos);
  CHECK(contains(good.certify(doubled).broken_by(Claim::Degree), "could not be shown to cover"));
  CHECK(geometry::self_intersections(doubled).count > 0);
}

TEST_CASE("a vertex is off the skin where G exceeds the tolerance, the first of them named") {
  const Good good({support::ball(0, 0, 0, 1)});
  IndexedMesh mesh = support::sphere_mesh(geometry::Point::Zero(), 1, 6);
  REQUIRE(mesh.positions.size() > 8192);  // more than a thread takes at once
  const auto objection = [&](const IndexedMesh& some) {
    return good.certify(some).broken_by(Claim::OnSkin);
  };
  const double tolerance = 100 * good.skin.surface.residual_bound(1);
  mesh.positions[8000] *= 1 + 0.4 * tolerance;  // G is twice as much
  CHECK(objection(mesh) == "");
  for (const double side : {-1.0, 1.0}) {
    mesh.positions[8000].normalize();
    mesh.positions[8000] *= 1 + 0.6 * side * tolerance;
    CHECK(contains(objection(mesh), "vertex 8000 lies"));
  }
  mesh.positions[5] *= 1 + 1e-3;
  const Certificate certificate = good.certify(mesh);
  CHECK(contains(certificate.broken_by(Claim::OnSkin), "vertex 5 lies"));
  CHECK(std::abs(certificate.max_distance_to_skin - 1e-3) < 1e-5);
}

TEST_CASE("a vertex in floats may be off by half a last digit and not by two") {
  const geometry::Point far(1000, 0, 0);
  const Good good({{far, 2}});
  IndexedMesh mesh = support::sphere_mesh(far, 1, 3);
  // To a float's last digit there; not by casts, which GCC 12 leaves out of pairs of doubles.
  const auto rounded = [](double x) { return std::nearbyint(x * 0x1p14) / 0x1p14; };
  for (geometry::Point& x : mesh.positions) x = x.unaryExpr(rounded);
  REQUIRE(mesh.positions[0] == geometry::Point(1001, 0, 0));
  CHECK(good.certify(mesh).holds(Claim::OnSkin));
  mesh.positions[0].x() += 0x1p-13;  // two last digits
  CHECK_FALSE(good.certify(mesh).holds(Claim::OnSkin));
  CHECK(certify::is_single_precision(mesh.positions));
  for (const int axis : {0, 1, 2}) {
    mesh.positions[7][axis] += 0x1p-40;
    CHECK_FALSE(certify::is_single_precision(mesh.positions));
    mesh.positions[7][axis] -= 0x1p-40;
  }
  CHECK_FALSE(certify::is_single_precision({}));
  // What is not known of N counts against the vertex.
  const IndexedMesh one{{far}, {}};
  const std::vector<certify::LocatedVertex> at{{{1, 0, 0}, -0.1F, 0.1F, 0.3F, {}}};
  const auto found = certify::residuals({one, at, good.skin.surface}, false, geometry::Run(1));
  CHECK(found.max_distance >= 0.7 - std::sqrt(0.49 - 0.1));
}
