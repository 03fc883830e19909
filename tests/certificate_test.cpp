#include "certify/certificate.h"

#include "certify/triangle_geometry.h"
#include "tests/support/good_mesh.h"
#include "tests/support/mesh_part.h"
#include "tests/support/wrong_meshes.h"

using namespace morskin;
using certify::Certificate;
using geometry::IndexedMesh;
using geometry::Point;
using support::ball;
using support::double_cover;
using support::Good;
using support::together;
using support::turned_inside_out;

namespace {

Good one_ball() { return Good({ball(0, 0, 0, 1)}); }
Good two_overlapping() { return Good({ball(0, 0, 0, 1), ball(1.5, 0, 0, 1.2)}); }
Good two_apart() { return Good({ball(0, 0, 0, 1), ball(9, 0, 0, 1.2)}); }
/// A cage of four balls with a void inside.
Good cage() { return Good(support::tetrahedron_balls(2.8)); }

void check_uncertified(const Certificate& certificate, const std::string& reason) {
  CHECK_FALSE(certificate.certified);
  CHECK_MESSAGE(support::contains(certificate.reason, reason), certificate.reason);
}
void check_rejected(const Certificate& certificate, const std::string& reason) {
  check_uncertified(certificate, reason);
  CHECK_FALSE(certificate.is_homeomorphic);
}

/// The components of a mesh of two_apart() to the left of the middle, or to the right.
IndexedMesh side(const IndexedMesh& mesh, bool left) {
  return support::mesh_part(
      mesh, [&](std::size_t t) { return (mesh.positions[mesh.triangles[t][0]].x() < 4) == left; });
}

}  // namespace

TEST_CASE("good meshes are certified, with the skin's own counts") {
  for (const Good& good : {one_ball(), two_overlapping(), two_apart(), cage()}) {
    const Certificate certificate = good.certify(good.mesh);
    CHECK(certificate.reason == "");
    CHECK(certificate.certified);
    CHECK(certificate.components == good.skin.topology.skin_components());
    CHECK(certificate.genus == static_cast<long>(good.skin.topology.skin_genus()));
    CHECK(certificate.euler_characteristic == good.skin.topology.skin_euler_characteristic());
    CHECK(certificate.vertices == good.mesh.positions.size());
    CHECK(certificate.triangles == good.mesh.triangles.size());
    CHECK(certificate.volume > 0);
  }
}

TEST_CASE("a mesh with one triangle facing the wrong way is rejected") {
  const Good good = two_overlapping();
  for (const std::size_t t : {std::size_t{0}, good.mesh.triangles.size() / 2}) {
    CAPTURE(t);
    IndexedMesh bad = good.mesh;
    std::swap(bad.triangles[t][0], bad.triangles[t][1]);
    check_rejected(good.certify(bad), "disagree on orientation");
  }
}

TEST_CASE("a mesh with a missing component is rejected, whichever it is") {
  const Good good = two_apart();
  for (const bool left : {true, false}) {
    CAPTURE(left);
    const IndexedMesh bad = side(good.mesh, left);
    const Certificate certificate = good.certify(bad);
    check_rejected(certificate, "components is 1, the skin's is 2");
    CHECK(certificate.covering_degree_ok);
  }
}

TEST_CASE("a mesh with a missing inner void is rejected, and so is the void alone") {
  for (const Good& good :
       {cage(), Good(support::molecule("shell_hollow.xyzr", skin::Model::Vdw))}) {
    const auto built = geometry::closed_mesh(good.mesh.positions.size(), good.mesh.triangles);
    const auto parts = geometry::components(built.mesh);
    REQUIRE(parts.count == 2);
    for (const std::uint32_t kept : {0U, 1U}) {
      CAPTURE(kept);
      IndexedMesh chosen{good.mesh.positions, {}};
      for (std::size_t t = 0; t < good.mesh.triangles.size(); ++t) {
        if (parts.of_triangle[t] == kept) chosen.triangles.push_back(good.mesh.triangles[t]);
      }
      const IndexedMesh bad = support::mesh_part(chosen, [](std::size_t) { return true; });
      check_rejected(good.certify(bad), "components is 1, the skin's is 2");
    }
  }
}

TEST_CASE("a mesh laid twice over the skin is rejected") {
  for (const Good& good : {one_ball(), two_apart()}) {
    const Certificate certificate = good.certify(together(good.mesh, good.mesh));
    check_rejected(certificate, "could not be shown to cover the skin once");
    CHECK_FALSE(certificate.covering_degree_ok);
  }
  // One of two components doubled, the other missing: components and Euler characteristic agree.
  const Good good = two_apart();
  const IndexedMesh left = side(good.mesh, true);
  const Certificate certificate = good.certify(together(left, left));
  check_rejected(certificate, "could not be shown to cover the skin once");
  CHECK(certificate.components == certificate.expected_components);
  CHECK(certificate.euler_characteristic == certificate.expected_euler_characteristic);
}

TEST_CASE("a second sheet whose vertices lie elsewhere on the skin is rejected") {
  const Good good = two_apart();
  const IndexedMesh left = side(good.mesh, true);
  IndexedMesh turned = left;
  for (Point& p : turned.positions) p = Point(p.y(), p.z(), p.x());  // about the ball's centre
  check_rejected(good.certify(together(left, turned)), "could not be shown to cover the skin once");
}

TEST_CASE("a connected double cover of a ball is rejected though all its counts are a sphere's") {
  const Good good = one_ball();
  const Certificate certificate = good.certify(double_cover(good.mesh));
  check_rejected(certificate, "could not be shown to cover the skin once");
  CHECK(certificate.components == 1);
  CHECK(certificate.euler_characteristic == 2);
  CHECK(certificate.violations_L + certificate.violations_U == 0);
}

TEST_CASE("coarse meshes are certified up to C = 0.4, and their double covers rejected") {
  for (const double C : {0.12, 0.16, 0.2, 0.25, 0.3, 0.35, 0.4}) {
    CAPTURE(C);
    const certify::Sizing sizing{C, certify::Sizing::quality_for(C)};
    for (const Good& good : {one_ball(), two_overlapping(), two_apart(), cage()}) {
      const IndexedMesh mesh = morskin::make_mesh(good.skin, support::with(sizing)).mesh;
      const auto certify = [&](const IndexedMesh& other) {
        return certify::certify(other, good.skin.surface, good.skin.topology, sizing);
      };
      const Certificate certificate = certify(mesh);
      CHECK_MESSAGE(certificate.certified, certificate.reason);
      check_rejected(certify(together(mesh, mesh)), "could not be shown to cover the skin once");
      IndexedMesh turned = mesh;  // a second sheet beside the first: the same, moved within it
      for (Point& p : turned.positions) p = Point(p.x(), p.z(), -p.y());
      check_rejected(certify(together(mesh, turned)), "");
    }
    const Good ball = one_ball();
    check_rejected(
        certify::certify(double_cover(morskin::make_mesh(ball.skin, support::with(sizing)).mesh),
                         ball.skin.surface, ball.skin.topology, sizing),
        "could not be shown to cover the skin once");
  }
}

TEST_CASE("a mesh with a hole is rejected") {
  const Good good = two_overlapping();
  IndexedMesh bad = good.mesh;
  bad.triangles.erase(bad.triangles.begin() + 17);
  check_rejected(good.certify(bad), "has only one triangle");
}

TEST_CASE(
    "a mesh with a vertex off the skin is not certified, however near, and the vertex named") {
  const Good good = one_ball();
  for (const double off : {1e-6, -1e-6, 0.5, -0.5}) {
    CAPTURE(off);
    IndexedMesh bad = good.mesh;
    bad.positions[5] *= 1 + off;
    const Certificate certificate = good.certify(bad);
    check_uncertified(certificate, "vertex 5 lies");
    CHECK(certificate.is_homeomorphic == (off > -0.1));  // a spike is a graph over the ball
    CHECK(certificate.max_distance_to_skin > std::abs(off) / 2);
    CHECK(support::contains(certificate.broken_by(certify::Claim::Tube), "off") == (off < -0.1));
  }
}

TEST_CASE("a mesh with a vertex moved over the skin to its far side is rejected") {
  const Good good = one_ball();
  IndexedMesh bad = good.mesh;
  bad.positions[5] *= -1;
  CHECK(good.certify(bad).max_distance_to_skin < 1e-12);
  check_rejected(good.certify(bad), "triangle");
}

TEST_CASE("a mesh that is inside out is rejected") {
  for (const Good& good : {one_ball(), cage()}) {
    const Certificate certificate = good.certify(turned_inside_out(good.mesh));
    check_rejected(certificate, "does not face the way the skin does");
    CHECK(certificate.volume < 0);
  }
}

TEST_CASE("a mesh of another molecule of one kind is homeomorphic and not certified") {
  const Good good = two_overlapping();
  const Good other({ball(0, 0, 0, 1), ball(1.5001, 0, 0, 1.2)});
  for (const Certificate& certificate : {good.certify(other.mesh), other.certify(good.mesh)}) {
    check_uncertified(certificate, "off the skin");
    CHECK(certificate.is_homeomorphic);
  }
}

TEST_CASE("a mesh too coarse for its sizing is homeomorphic but breaks [U]") {
  const Good good = two_overlapping();
  constexpr certify::Sizing finer{0.06, 1.65};
  const Certificate certificate =
      certify::certify(good.mesh, good.skin.surface, good.skin.topology, finer);
  CHECK(certificate.is_homeomorphic);
  CHECK_FALSE(certificate.certified);
  CHECK_MESSAGE(support::contains(certificate.reason, "break [U]"), certificate.reason);
  CHECK(certificate.violations_U > 0);
  CHECK(certificate.worst_U > 1);
}

TEST_CASE(
    "an octahedron in place of a ball is too coarse to be proved, one cut finer once is not") {
  const Good good = one_ball();
  check_rejected(good.certify(support::sphere_mesh(Point::Zero(), 1, 0)), "is too big");
  CHECK(good.certify(support::sphere_mesh(Point::Zero(), 1, 1)).is_homeomorphic);
}

TEST_CASE("a triangle that faces the right way but is too large to be proved is not accused") {
  const Good good = two_overlapping();
  IndexedMesh coarse = support::sphere_mesh(Point::Zero(), 1, 0);
  for (Point& x : coarse.positions) {  // the tips, and about the neck
    x = x.x() > 0.5 ? Point(2.5, 0, 0) : x.x() < -0.5 ? Point(-1, 0, 0) : Point(0.7, x.y(), x.z());
    const auto on = good.skin.surface.project(x, {});
    REQUIRE(on.has_value());
    x = on->position;
  }
  for (const auto& [a, b, c] : coarse.triangles) {
    const Point& p = coarse.positions[a];
    const auto normal = (coarse.positions[b] - p).cross(coarse.positions[c] - p);
    for (const std::uint32_t v : {a, b, c}) {
      const Point& x = coarse.positions[v];
      const auto cell = good.skin.surface.locate(x, {});
      CHECK(good.skin.surface.jet(x, cell).half_gradient.dot(normal) > 0);
    }
  }
  check_rejected(good.certify(coarse), "is not shown to face the way the skin does");
  check_rejected(good.certify(turned_inside_out(coarse)), "does not face the way the skin does");
}

TEST_CASE("a mesh with one vertex too near to another is homeomorphic but breaks [L]") {
  const Good good = one_ball();
  IndexedMesh fine = good.mesh;
  const auto [a, b, c] = fine.triangles[3];
  const auto x = static_cast<std::uint32_t>(fine.positions.size());
  fine.positions.push_back(
      (0.7 * fine.positions[a] + 0.15 * fine.positions[b] + 0.15 * fine.positions[c]).normalized());
  fine.triangles[3] = {a, b, x};
  fine.triangles.push_back({b, c, x});
  fine.triangles.push_back({c, a, x});
  const Certificate certificate = good.certify(fine);
  CHECK(certificate.is_homeomorphic);
  CHECK_FALSE(certificate.certified);
  CHECK(certificate.violations_L > 0);
  CHECK(certificate.worst_L < 1);
  CHECK_MESSAGE(support::contains(certificate.reason, "[L]"), certificate.reason);
}

TEST_CASE("coordinates that are no numbers are rejected") {
  const Good good = one_ball();
  for (const double bad_number :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    CAPTURE(bad_number);
    IndexedMesh bad = good.mesh;
    bad.positions[7].y() = bad_number;
    CHECK_FALSE(good.certify(bad).certified);
    CHECK_FALSE(good.certify(bad).is_homeomorphic);
    for (Point& p : bad.positions) p = Point::Constant(bad_number);
    CHECK_FALSE(good.certify(bad).certified);
    CHECK_FALSE(good.certify(bad).is_homeomorphic);
  }
}

TEST_CASE("an empty mesh, a mesh without triangles and one with an unused vertex are rejected") {
  const Good good = one_ball();
  check_rejected(good.certify({}), "no triangles");
  check_rejected(good.certify({good.mesh.positions, {}}), "no triangles");
  IndexedMesh bad = good.mesh;
  bad.positions.push_back(bad.positions[0]);
  check_rejected(good.certify(bad), "belongs to no triangle");
}

TEST_CASE("the measured angles, area and volume are those of a count triangle by triangle") {
  const Good good = cage();
  const Certificate certificate = good.certify(good.mesh);
  double smallest = 180, largest = 0, area = 0, volume = 0;
  for (const auto& [a, b, c] : good.mesh.triangles) {
    const Point &p = good.mesh.positions[a], &q = good.mesh.positions[b],
                &r = good.mesh.positions[c];
    const auto range = certify::angle_range(p, q, r);
    smallest = std::min(smallest, range.smallest_deg);
    largest = std::max(largest, range.largest_deg);
    area += (q - p).cross(r - p).norm() / 2;
    volume += p.dot((q - p).cross(r - p)) / 6;
  }
  constexpr double rounding = 1e-9;
  CHECK(std::abs(certificate.min_angle_deg - smallest) < rounding);
  CHECK(std::abs(certificate.max_angle_deg - largest) < rounding);
  CHECK(std::abs(certificate.area - area) < rounding * area);
  CHECK(std::abs(certificate.volume - volume) < rounding * area);
}
