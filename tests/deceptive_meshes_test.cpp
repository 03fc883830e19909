/// Meshes made on purpose to be called homeomorphic where they are not. Each would be, if its
/// vertices lay on the skin exactly, or if the cells were found without rounding.

#include <doctest/doctest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "certify/certificate.h"
#include "certify/triangle_geometry.h"
#include "geometry/files/mesh_files.h"
#include "geometry/mesh_check.h"
#include "skin/dual_complex.h"
#include "tests/support/good_mesh.h"
#include "tests/support/wrong_meshes.h"

using namespace morskin;
using certify::Certificate;
using certify::Claim;
using geometry::IndexedMesh;
using geometry::Point;
using support::ball;

namespace {

/// Over the mesher's tolerance, under that of the claim "on the skin".
constexpr double small = 0.9e-9;

struct Skin {
  explicit Skin(const support::WeightedPoints& points)
      : surface(points), topology(skin::dual_complex(surface)) {}
  Certificate certify(const IndexedMesh& mesh, const certify::Sizing& sizing = {}) const {
    return certify::certify(mesh, surface, topology, sizing);
  }

  skin::SkinSurface surface;
  surface::Topology topology;
};

/// One ball of radius 1 at the origin, and one apart that the meshes below leave out.
Skin two_balls() { return Skin({ball(0, 0, 0, 1), ball(9, 0, 0, 1)}); }

void scale(IndexedMesh& mesh, std::size_t first, std::size_t last, double factor) {
  for (std::size_t v = first; v < last; ++v) mesh.positions[v] *= factor;
}

}  // namespace

TEST_CASE("the fine poles make a mesh of the sphere that is proved") {
  const Skin skin({ball(0, 0, 0, 1)});
  for (const double smallest : {0.1, 1e-5}) {
    const Certificate certificate = skin.certify(support::sphere_with_fine_poles(smallest));
    CHECK(certificate.broken_by(Claim::Manifold) == "");
    CHECK(certificate.is_homeomorphic);
  }
}

TEST_CASE("two sheets, each with a vertex pushed out over the other's circumcentre, are no proof") {
  const Skin skin = two_balls();
  for (const int levels : {2, 3, 4}) {
    for (const double off : {small, 1e-7, 1e-4}) {
      CAPTURE(levels);
      CAPTURE(off);
      IndexedMesh first = support::sphere_mesh(Point::Zero(), 1, levels);
      const auto& [a, b, c] = first.triangles.back();
      const Point centre =
          certify::circumcircle(first.positions[a], first.positions[b], first.positions[c])
              .centre.normalized();
      const std::uint32_t v = 0;
      // The half turn that swaps v and the circumcentre carries the first sheet to the second.
      const geometry::Vector axis = (first.positions[v] + centre).normalized();
      IndexedMesh second = first;
      for (Point& p : second.positions) p = (2 * axis.dot(p) * axis - p).normalized();
      for (IndexedMesh* sheet : {&first, &second}) {
        scale(*sheet, 0, sheet->positions.size(), 1 - off);
        sheet->positions[v] *= (1 + off) / (1 - off);
        *sheet = support::begun_at(*sheet, v);
      }
      const Certificate certificate = skin.certify(support::together(first, second));
      CHECK(certificate.components == 2);
      CHECK_FALSE(certificate.is_homeomorphic);
      CHECK(certificate.broken_by(Claim::Degree) != "");
    }
  }
}

TEST_CASE("a branched double cover with a vertex pushed out over the other sheet is no proof") {
  const Skin skin({ball(0, 0, 0, 1)});
  for (const double off : {small, 1e-7, 1e-4}) {
    const IndexedMesh simple = support::sphere_mesh(Point::Zero(), 1, 3);
    const std::size_t t = simple.triangles.size() - 1;
    IndexedMesh cover = support::double_cover(simple);
    // The copies of triangle t are entries t and the last. The first is cut at its circumcentre.
    const auto [a, b, c] = cover.triangles[t];
    const Point centre =
        certify::circumcircle(cover.positions[a], cover.positions[b], cover.positions[c])
            .centre.normalized();
    scale(cover, 0, cover.positions.size(), 1 - off);
    const auto v = static_cast<std::uint32_t>(cover.positions.size());
    support::cut(cover, t, (1 + off) * centre);
    const Certificate certificate = skin.certify(support::begun_at(cover, v));
    CHECK(certificate.broken_by(Claim::Manifold) == "");
    CHECK(certificate.broken_by(Claim::Counts) == "");
    CHECK_FALSE(certificate.is_homeomorphic);
  }
}

TEST_CASE("a branched double cover is no proof at whichever vertex, branch points too") {
  const Skin skin({ball(0, 0, 0, 1)});
  for (const int levels : {2, 3}) {
    const IndexedMesh cover = support::double_cover(support::sphere_mesh(Point::Zero(), 1, levels));
    for (std::uint32_t v = 0; v < cover.positions.size(); ++v) {
      CAPTURE(v);
      CHECK_FALSE(skin.certify(support::begun_at(cover, v)).is_homeomorphic);
    }
  }
}

TEST_CASE(
    "a component that covers its ball once is no proof for another that covers its own twice") {
  const Skin skin = two_balls();
  const IndexedMesh once = support::sphere_mesh(Point::Zero(), 1, 3);
  const IndexedMesh twice = support::double_cover(support::sphere_mesh(Point(9, 0, 0), 1, 3));
  for (const IndexedMesh& mesh : {support::together(once, twice), support::together(twice, once)}) {
    const Certificate certificate = skin.certify(mesh);
    CHECK(certificate.broken_by(Claim::Manifold) == "");
    CHECK(certificate.broken_by(Claim::Counts) == "");
    CHECK(certificate.degree_vertices.size() == 1);
    CHECK_FALSE(certificate.covering_degree_ok);
    CHECK_FALSE(certificate.is_homeomorphic);
  }
}

TEST_CASE("a component that is not proved has the number that a check of the mesh alone gives it") {
  const Skin skin = two_balls();
  const IndexedMesh once = support::sphere_mesh(Point::Zero(), 1, 3);
  const IndexedMesh twice = support::double_cover(support::sphere_mesh(Point(9, 0, 0), 1, 3));
  for (IndexedMesh mesh : {support::together(once, twice), support::together(twice, once)}) {
    for (int turn = 0; turn < 2; ++turn) {
      std::ranges::reverse(mesh.triangles);
      const geometry::MeshCheck check = geometry::check_mesh(mesh);
      REQUIRE(check.components.size() == 2);
      const auto& first = mesh.triangles[check.components[0].first_triangle];
      const char* name = mesh.positions[first[0]].x() > 4 ? "component 0 " : "component 1 ";
      CHECK(skin.certify(mesh).broken_by(Claim::Degree).starts_with(name));
    }
  }
}

TEST_CASE("two icosahedra in one ball, whose triangles are all coarse, are no proof of two balls") {
  const Skin skin = two_balls();
  IndexedMesh first;
  const double golden = (1 + std::sqrt(5.0)) / 2;
  for (const double s : {-1.0, 1.0}) {
    for (const double t : {-golden, golden}) {
      for (const Point& p : {Point(0, s, t), Point(s, t, 0), Point(t, 0, s)}) {
        first.positions.push_back(p.normalized());
      }
    }
  }
  const auto is_edge = [&](std::uint32_t i, std::uint32_t j) {
    return (first.positions[i] - first.positions[j]).norm() < 1.1;
  };
  for (std::uint32_t a = 0; a < 12; ++a) {
    for (std::uint32_t b = a + 1; b < 12; ++b) {
      for (std::uint32_t c = a + 1; c < 12; ++c) {
        const geometry::Vector n = first.positions[a].cross(first.positions[b]);
        const bool is_face = is_edge(a, b) && is_edge(b, c) && is_edge(c, a);
        if (b != c && is_face && n.dot(first.positions[c]) > 0)
          first.triangles.push_back({a, b, c});
      }
    }
  }
  REQUIRE(first.triangles.size() == 20);
  for (const double turn : {0.0, 0.3, 1.0}) {
    IndexedMesh second = first;
    const Eigen::AngleAxisd rotation(turn, Point(1, 2, 3).normalized());
    for (Point& p : second.positions) p = rotation * p;
    const Certificate certificate = skin.certify(support::together(first, second));
    CHECK(certificate.holds(Claim::Tube));
    CHECK(certificate.degree_vertices.empty());
    CHECK_FALSE(certificate.is_homeomorphic);
  }
}

TEST_CASE("a mesh wound twice or thrice round a ring is no proof though all its counts are right") {
  const support::Good ring = support::vdw("ring12.xyzr");
  REQUIRE(ring.skin.topology.skin_genus() == 1);
  for (const std::uint32_t sheets : {2U, 3U}) {
    for (const double off : {0.0, small, 1e-4, 0.05}) {
      constexpr int across = 2;  // the ring lies about the z axis
      IndexedMesh cover = support::wound_cover(ring.mesh, sheets, Point::Zero(), across);
      REQUIRE(cover.positions.size() == sheets * ring.mesh.positions.size());
      for (std::size_t v = 0; v < cover.positions.size(); ++v) {
        const auto sheet = static_cast<double>(v / ring.mesh.positions.size());
        cover.positions[v] *= 1 + off * (sheet - 0.5);
      }
      const Certificate certificate = ring.certify(cover);
      CHECK(certificate.broken_by(Claim::Manifold) == "");
      CHECK(certificate.broken_by(Claim::Counts) == "");
      CHECK(certificate.broken_by(Claim::Degree) != "");
      CHECK_FALSE(certificate.is_homeomorphic);
    }
  }
}

TEST_CASE("two sheets that are farther apart than their triangles are small are no proof") {
  const Skin skin = two_balls();
  for (const double smallest : {1e-5, 1e-6}) {
    IndexedMesh inner = support::sphere_with_fine_poles(smallest), outer = inner;
    scale(inner, 0, inner.positions.size(), 1 - small);
    scale(outer, 0, outer.positions.size(), 1 + small);
    const Certificate certificate = skin.certify(support::together(inner, outer));
    CHECK(certificate.broken_by(Claim::Counts) == "");
    CHECK_FALSE(certificate.is_homeomorphic);
  }
}

TEST_CASE("sheets in floats far from the origin are no proof of two components, or of one") {
  const Point far(1e6, 0, 0);
  const Skin two({{far, 2}, {far + Point(0, 9, 0), 2}}), one({{far, 2}});
  const IndexedMesh outer = support::sphere_mesh(far, 1.05, 3);
  const IndexedMesh inner = support::sphere_mesh(far, 0.95, 3);
  const certify::Sizing sizing{0.1, 3};
  CHECK_FALSE(two.certify(geometry::in_single_precision(support::together(outer, inner)), sizing)
                  .is_homeomorphic);
  IndexedMesh cover = support::double_cover(support::sphere_mesh(Point::Zero(), 1, 3));
  const std::size_t simple = outer.positions.size();
  for (std::size_t v = 0; v < cover.positions.size(); ++v) {
    cover.positions[v] = far + (v < simple ? 1.05 : 0.95) * cover.positions[v];
  }
  CHECK_FALSE(one.certify(geometry::in_single_precision(cover), sizing).is_homeomorphic);
  // A single sheet is proved, as far off as these are.
  CHECK(one.certify(geometry::in_single_precision(outer), sizing).is_homeomorphic);
  CHECK(one.certify(geometry::in_single_precision(inner), sizing).is_homeomorphic);
}

TEST_CASE("a tiny pair beside a far ball is told joined from apart") {
  constexpr double tiny = 1e-7;
  const support::WeightedPoints points{{Point(0, 0, 0), 2 * tiny * tiny},
                                       {Point(1.5 * tiny, 0, 0), 2 * tiny * tiny},
                                       {Point(1e6, 0, 0), 2},
                                       {Point(1e6, 9, 0), 2}};
  const Skin skin(points);
  REQUIRE(skin.topology.components == 3);
  IndexedMesh mesh = support::sphere_mesh(points[0].position, tiny, 3);
  mesh = support::together(mesh, support::sphere_mesh(points[1].position, tiny, 3));
  mesh = support::together(mesh, support::sphere_mesh(points[2].position, 1, 3));
  for (const double C : {0.02, 0.08}) {
    const Certificate certificate = skin.certify(mesh, {C, 7});
    CHECK(certificate.components == 3);
    CHECK_FALSE(certificate.is_homeomorphic);
    CHECK_FALSE(certificate.certified);
  }
}

TEST_CASE("a mesh in a gap thinner than the last digits of the weights is not called on the skin") {
  // Two balls that all but touch, and a mesh between them, where |G| is about 1e-16.
  const double half = std::sqrt(2.0);
  const Skin skin({{Point(0, 0, 0), 2}, {Point(2 * half, 0, 0), 2}});
  for (const double radius : {1e-8, 1e-10, 1e-14}) {
    CAPTURE(radius);
    const IndexedMesh mesh = support::sphere_mesh(Point(half, 0, 0), radius, 2);
    const Certificate certificate = skin.certify(mesh);
    CHECK_FALSE(certificate.is_homeomorphic);
    CHECK_FALSE(certificate.holds(Claim::OnSkin));
  }
}

TEST_CASE("a vertex that is no number, or far beyond the skin, is named and nothing is proved") {
  const Skin skin({ball(0, 0, 0, 1)});
  for (const double bad : {1e9, 1e160, 1e300, std::nan(""), std::numeric_limits<double>::infinity(),
                           std::nextafter(0.0, 1.0)}) {
    IndexedMesh mesh = support::sphere_mesh(Point::Zero(), 1, 3);
    mesh.positions[7].y() = bad;
    const Certificate certificate = skin.certify(mesh);
    CHECK_FALSE(certificate.is_homeomorphic);
    CHECK(certificate.broken_by(Claim::OnSkin).find("vertex 7") != std::string::npos);
  }
}

TEST_CASE("a mesh that lies off the skin may be proved homeomorphic, and is not certified") {
  const Skin skin({ball(0, 0, 0, 1)});
  for (const double off : {1e-6, 1e-3, 0.05}) {
    IndexedMesh mesh = support::sphere_mesh(Point::Zero(), 1 + off, 4);
    const Certificate certificate = skin.certify(mesh);
    CHECK(certificate.is_homeomorphic);
    CHECK_FALSE(certificate.certified);
    CHECK(certificate.reason.find("off the skin") != std::string::npos);
    CHECK(certificate.max_distance_to_skin >= off * (1 - 1e-6));
  }
}
