#include "bench/baselines/growth.h"

#include "bench/baselines/dynamic_skin.h"
#include "geometry/predicates.h"
#include "morskin/pipeline.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::baselines;
using namespace morskin::support;

namespace {

/// What the dual complex says of the balls grown to time t, unless that skin is singular.
std::optional<long> expected_at(const PreparedSkin& skin, double t) {
  WeightedPoints points = skin.surface.points();
  bool is_empty = true;
  for (geometry::WeightedPoint& p : points) {
    p.weight = geometry::on_exact_grid(p.weight + t);
    is_empty = is_empty && p.weight <= 0;
  }
  if (is_empty) return 0;
  const auto grown = prepared(points);
  if (!grown) return std::nullopt;
  return grown->topology.skin_euler_characteristic();
}

struct Grown {
  MeshResult result;
  GrowthCounts counts;
  std::size_t triangles_at_last = 0;  ///< after the last metamorphosis
  std::size_t compared = 0;           ///< states of the mesh with the dual complex
};

/// Grows a skin and checks the mesh about every metamorphosis.
Grown grown(const PreparedSkin& skin) {
  constexpr std::array<long, 4> change{2, -2, 2, -2};  // of the Euler characteristic, by kind
  Grown out;
  const auto metamorphoses = find_metamorphoses(skin.surface, 0);
  std::size_t next = 0;
  long before = 0;
  GrowthOptions options;
  options.observer = [&](const Metamorphosis& m, const SurfaceMesh& surface, bool is_after) {
    CAPTURE(m.time);
    CAPTURE(static_cast<int>(m.kind));
    REQUIRE(geometry::validate(surface).value_or("") == "");
    const long now = euler_characteristic(surface);
    if (!is_after) {
      before = now;
      return;
    }
    out.triangles_at_last = surface.triangle_list().size();
    CHECK(now - before == change[static_cast<std::size_t>(m.kind)]);
    ++next;
    // Half way to the next one, if doubles have room there.
    const double until = next < metamorphoses.size() ? metamorphoses[next].time : 0;
    if (until - m.time < 1e-9 * std::abs(m.time)) return;
    const auto expected = expected_at(skin, (m.time + until) / 2);
    if (!expected) return;
    CHECK(now == *expected);
    ++out.compared;
  };
  out.result = make_mesh(
      skin,
      {.sizing = {}, .mesher = dynamic_mesher(options, &out.counts), .has_safety_net = false});
  CHECK(out.counts.failed == 0);
  CHECK(out.result.certificate.reason == "");
  CHECK(out.result.certificate.certified);
  const auto& all = out.counts.metamorphoses;
  CHECK(std::accumulate(all.begin(), all.end(), std::size_t{0}) == metamorphoses.size());
  return out;
}
Grown grown(const WeightedPoints& points) {
  const auto skin = prepared(points);
  REQUIRE(skin.has_value());
  return grown(*skin);
}

using Four = std::array<std::size_t, 4>;

}  // namespace

TEST_CASE("a ball is born once and only grows") {
  const Grown out = grown({ball(0, 0, 0, 1)});
  CHECK(out.counts.metamorphoses == Four{1, 0, 0, 0});
  CHECK(out.triangles_at_last == out.result.mesh.triangles.size());
}

TEST_CASE("two balls join in a neck when their patches meet, and only then") {
  const double touching = std::sqrt(2.0) * 2;
  CHECK(grown({ball(0, 0, 0, 1), ball(2, 0.1, 0, 1.2)}).counts.metamorphoses == Four{2, 1, 0, 0});
  CHECK(grown({ball(0, 0, 0, 1), ball(touching * 0.999, 0, 0, 1)}).counts.metamorphoses ==
        Four{2, 1, 0, 0});
  CHECK(grown({ball(0, 0, 0, 1), ball(touching * 1.001, 0, 0, 1)}).counts.metamorphoses ==
        Four{2, 0, 0, 0});
  CHECK(grown({ball(0, 0, 0, 1), ball(4, 0, 0, 1)}).counts.metamorphoses == Four{2, 0, 0, 0});
}

TEST_CASE("three balls close a tunnel and four a void") {
  const WeightedPoints four = tetrahedron_balls(3.4);
  CHECK(grown({four[0], four[1], four[2]}).counts.metamorphoses == Four{3, 3, 1, 0});
  CHECK(grown(four).counts.metamorphoses == Four{4, 6, 4, 1});
}

TEST_CASE("the eight corners of a cube join, close six tunnels, and then the void") {
  const Grown out = grown(molecule("cube8.xyzr", skin::Model::Vdw));
  CHECK(out.counts.metamorphoses == Four{8, 12, 6, 1});
}

TEST_CASE("random sets of balls grow to certified meshes") {
  std::size_t compared = 0;
  for_skins(6, [&](const PreparedSkin& skin) { compared += grown(skin).compared; });
  CHECK(compared > 50);
}

TEST_CASE("inspections come out by time, whatever is put in meanwhile") {
  for_seeds<Random>(20, [&](Random& random) {
    InspectionQueue queue;
    std::vector<std::pair<double, std::uint32_t>> expected;
    double now = -10;
    std::uint32_t put = 0;
    for (int step = 0; step < 2000; ++step) {
      if (expected.empty() || random.uniform() < 0.52) {
        // Many at equal times, some far off.
        const double later = std::ldexp(std::floor(random.between(0, 16)), -4);
        const double time = now + (random.uniform() < 0.1 ? 100 * later : later);
        queue.push(time, TriangleId{put});
        expected.emplace_back(time, put++);
        continue;
      }
      const double least = std::ranges::min_element(expected)->first;
      REQUIRE(queue.next_time() == least);
      const InspectionQueue::Entry next = queue.pop();
      REQUIRE(next.time == least);
      CHECK(std::erase(expected, std::pair(least, next.triangle.value)) == 1);
      now = least;
      REQUIRE(queue.size() == expected.size());
    }
  });
}

TEST_CASE("a growth stopped early is the growth of smaller balls") {
  const auto skin = prepared({ball(0, 0, 0, 1), ball(2, 0.1, 0, 1.2)});
  REQUIRE(skin.has_value());
  GrowthOptions options;
  options.end = -1.5;  // two spheres, not joined yet
  Growth growth(skin->surface, options);
  growth.run();
  const surface::Mesh mesh = growth.mesh();
  CHECK(geometry::validate(mesh.surface).value_or("") == "");
  CHECK(geometry::components(mesh.surface).count == 2);
  const LevelSet level(skin->surface, options.end);
  for (const SurfacePoint& p : mesh.points) {
    CHECK(std::abs(level.patch(p.cell).value(p.position)) <=
          10 * level.residual_bound(p.length_scale));
  }
}

TEST_CASE("snapshots are closed meshes that come at the times asked for") {
  const auto skin = prepared({ball(0, 0, 0, 1), ball(2, 0.1, 0, 1.2)});
  REQUIRE(skin.has_value());
  GrowthOptions options;
  options.snapshot_times = {-3, -2, -1, 0};
  std::vector<long> seen;
  options.snapshot = [&](double time, const surface::Mesh& mesh) {
    CHECK(time == options.snapshot_times[seen.size()]);
    CHECK(geometry::validate(mesh.surface).value_or("") == "");
    seen.push_back(euler_characteristic(mesh.surface));
  };
  Growth growth(skin->surface, options);
  growth.run();
  CHECK(seen == std::vector<long>{0, 4, 2, 2});
}

TEST_CASE("a thin triangle whose ball is centred on another part of the skin is not broken there") {
  const auto skin = prepared(support::ball_set(20));
  REQUIRE(skin);
  grown(*skin);
}

TEST_SUITE("slow") {
  TEST_CASE("a hundred random sets of balls grow to certified meshes") {
    for_skins({6, 100}, [](const PreparedSkin& skin) { grown(skin); });
  }
}
