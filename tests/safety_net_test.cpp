#include "morskin/safety_net.h"

#include <memory>

#include "front/subdomains.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::support;
using geometry::VertexId;

namespace {

/// Two balls far apart and a hollow shell: three bodies, four components of the skin, one within
/// another.
WeightedPoints four_components() {
  WeightedPoints points = molecule("shell_hollow.xyzr", skin::Model::Sas);
  points.push_back(ball(100, 0, 0, 1));
  points.push_back(ball(-100, 0, 0, 2));
  return points;
}

/// A sweep that leaves out the triangles that `is_lost` says: (corner's position, how many sweeps
/// there have been).
template <class IsLost>
Mesher sweep_without(IsLost is_lost) {
  auto count = std::make_shared<int>(0);
  return [=](const PreparedSkin& skin, const MeshingOptions& options, Observer& observer,
             const Run& run) {
    MethodResult result = sweep_method(skin, options, observer, run);
    ++*count;
    surface::Mesh broken;
    for (const surface::SurfacePoint& p : result.mesh.points) broken.add_vertex(p);
    for (const auto& [a, b, c] : result.mesh.surface.triangle_list()) {
      if (is_lost(broken.position(VertexId{a}), *count)) continue;
      broken.surface.add_triangle(VertexId{a}, VertexId{b}, VertexId{c});
    }
    result.mesh = broken;
    return result;
  };
}

/// Not glued any more, as every surface with a hole is built.
geometry::SurfaceMesh without_first_triangle(const geometry::SurfaceMesh& surface) {
  geometry::SurfaceMesh open;
  for (std::size_t v = 0; v < surface.vertex_count(); ++v) open.add_vertex();
  const auto triangles = surface.triangle_list();
  for (std::size_t t = 1; t < triangles.size(); ++t) {
    const auto& [a, b, c] = triangles[t];
    open.add_triangle(VertexId{a}, VertexId{b}, VertexId{c});
  }
  return open;
}

MeshResult mesh_by(const WeightedPoints& points, const Mesher& mesher) {
  return meshed(points, {.sizing = {}, .mesher = mesher});
}

/// So many components have been replaced, all by this method, and the whole is certified.
void check_mended(const MeshResult& mended, std::size_t components, Method method) {
  CHECK(mended.certificate.certified);
  REQUIRE(mended.fallbacks.size() == components);
  for (const Fallback& fallback : mended.fallbacks) {
    REQUIRE(fallback.replacement);
    CHECK(fallback.replacement->method == method);
  }
}

/// The positions of a mesh's vertices that are far out on one side, in order.
std::vector<std::array<double, 3>> far_out(const MeshResult& result, double side) {
  std::vector<std::array<double, 3>> list;
  for (const geometry::Point& p : result.mesh.positions) {
    if (side * p.x() > 50) list.push_back({p.x(), p.y(), p.z()});
  }
  std::sort(list.begin(), list.end());
  return list;
}

}  // namespace

TEST_CASE("a component that the sweep spoils is swept in another direction") {
  const WeightedPoints points = four_components();
  const MeshResult plain = meshed(points, {.sizing = {}, .angle_goal_deg = 0});
  REQUIRE(plain.certificate.certified);
  CHECK(plain.fallbacks.empty());
  const MeshResult mended = mesh_by(points, sweep_without([](const auto& p, int sweeps) {
                                      return sweeps == 1 && p.x() > 100.5;
                                    }));
  check_mended(mended, 1, Method::Sweep);
  CHECK(contains(mended.fallbacks[0].reason, "manifold"));
  // Only that component was replaced.
  CHECK(far_out(mended, -1) == far_out(plain, -1));
  CHECK(far_out(mended, 1) != far_out(plain, 1));
}

TEST_CASE("a component that every sweep spoils is meshed by the static method") {
  const MeshResult mended =
      mesh_by(four_components(),
              sweep_without([](const auto& p, int) { return p.norm() < 20 && p.z() > 0.1; }));
  check_mended(mended, 2, Method::Static);  // both sides of the shell
  CHECK(mended.fallbacks[0].component != mended.fallbacks[1].component);
}

TEST_CASE("a component that the sweep does not find at all is meshed by the static method") {
  const MeshResult mended =
      mesh_by(four_components(), sweep_without([](const auto& p, int) { return p.x() < -50; }));
  check_mended(mended, 1, Method::Static);
}

TEST_CASE("where a sweep stays open somewhere no component is left unrefined") {
  // As sweep_method() does: what is open is not refined at all.
  const Mesher mesher = [sweeps = std::make_shared<int>(0)](const PreparedSkin& skin,
                                                            const MeshingOptions& options,
                                                            Observer& observer, const Run& run) {
    if (++*sweeps > 1) return sweep_method(skin, options, observer, run);
    const morse::Guide guide = guide_for(skin, options.sizing);
    MethodResult result;
    result.mesh = front::sweep_once(skin.surface, guide, {.sizing = options.sizing}).mesh;
    result.function = guide.function;
    result.open_edges = 3;
    result.mesh.surface = without_first_triangle(result.mesh.surface);
    return result;
  };
  const MeshResult mended = mesh_by(four_components(), mesher);
  check_mended(mended, 4, Method::Sweep);
  CHECK(mended.certificate.restricted_delaunay_violations == 0);
}

TEST_CASE("a mesh that runs from one component to another is replaced on both") {
  // One triangle between the two balls.
  const Mesher joining = [](const PreparedSkin& skin, const MeshingOptions& options,
                            Observer& observer, const Run& run) {
    MethodResult result = sweep_method(skin, options, observer, run);
    const auto by_x = [](const auto& p, const auto& q) { return p.position.x() < q.position.x(); };
    const auto& points = result.mesh.points;
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), by_x);
    const auto id = [&](auto it) {
      return VertexId{static_cast<std::size_t>(it - points.begin())};
    };
    const VertexId next = result.mesh.surface.target(*result.mesh.surface.outgoing(id(low)));
    result.mesh.surface.add_triangle(id(low), next, id(high));
    return result;
  };
  const MeshResult mended =
      mesh_by({ball(0, 0, 0, 1), ball(9, 0, 0, 2), ball(4, 7, 0, 1)}, joining);
  CHECK(mended.certificate.certified);
  CHECK(mended.fallbacks.size() == 2);
}

TEST_CASE("the net holds in the nasty case of two components that nearly touch") {
  const double apart = 2 * std::sqrt(2.0) * (1 + 1e-6);
  const WeightedPoints points{ball(0, 0, 0, 1), ball(apart, 0, 0, 1)};
  const MeshResult mended =
      mesh_by(points, sweep_without([](const auto& p, int) { return p.x() < 0.3; }));
  check_mended(mended, 1, Method::Static);
}

TEST_CASE("when nothing helps the report says so and the mesh stays as it was") {
  // Triangles as big as the surface's features.
  const MeshResult result = meshed(octahedron_balls(), with({.C = 0.9, .Q = 1.9}));
  CHECK_FALSE(result.certificate.certified);
  REQUIRE(result.fallbacks.size() == 1);
  CHECK_FALSE(result.fallbacks[0].replacement);
}

TEST_CASE("what other methods and narrow guards do is not mended") {
  const Mesher mesher = sweep_without([](const auto&, int) { return true; });
  for (const MeshingOptions& options :
       {MeshingOptions{.sizing = {}, .method = Method::Static, .mesher = mesher},
        MeshingOptions{.sizing = {}, .mesher = mesher, .guard = front::Guard::Spheres}}) {
    const MeshResult result = meshed({ball(0, 0, 0, 1)}, options);
    CHECK_FALSE(result.certificate.certified);
    CHECK(result.fallbacks.empty());
  }
}
