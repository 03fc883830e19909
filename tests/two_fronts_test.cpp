#include "front/two_fronts.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "morse/make_guide.h"
#include "morskin/pipeline.h"
#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::front;

namespace {

/// A skin with the guide of a sweep over it.
struct Swept {
  explicit Swept(unsigned seed) : skin(support::prepared(support::ball_set(seed))) {
    if (!skin) return;
    guide = morse::make_guide(skin->surface, skin->topology.skin_euler_characteristic(), {},
                              certify::Sizing{}.tangent_disk_share());
  }
  SweepResult sweep(unsigned threads) const {
    return sweep_from_both_ends(skin->surface, guide, {}, {}, geometry::Run(threads));
  }

  std::optional<PreparedSkin> skin;
  morse::Guide guide;
};

}  // namespace

TEST_CASE("two fronts leave a closed mesh of the same surface that one front leaves") {
  support::for_skins(30, [&](const PreparedSkin& skin) {
    MeshingOptions one, two;
    one.fronts = 1;
    const MeshResult a = make_mesh(skin, one), b = make_mesh(skin, two);
    CHECK_MESSAGE(a.certificate.certified, a.certificate.reason);
    CHECK_MESSAGE(b.certificate.certified, b.certificate.reason);
    CHECK(std::abs(a.certificate.area - b.certificate.area) < 2e-3 * a.certificate.area);
  });
}

TEST_CASE("two fronts lay the same triangles in one thread as in two") {
  support::for_seeds(10, [&](unsigned seed) {
    const Swept swept(seed);
    if (!swept.skin) return;
    const SweepResult a = swept.sweep(1), b = swept.sweep(2);
    CHECK(a.mesh.surface.triangle_list() == b.mesh.surface.triangle_list());
    CHECK(a.open_edges == 0);
  });
}

TEST_CASE("three fronts absorbed in either bracketing leave the same bytes") {
  std::size_t closed = 0, runs = 0;
  support::for_seeds(30, [&](unsigned seed) {
    const Swept swept(seed);
    if (!swept.skin) return;
    const skin::SkinSurface& surface = swept.skin->surface;
    const morse::Guide &guide = swept.guide, reversed = guide.reversed();
    std::vector<double> values;
    for (const auto& p : guide.points) values.push_back(p.value);
    std::ranges::sort(values);
    const double low = values.front() + (values.back() - values.front()) / 3;
    const double high = values.front() + (values.back() - values.front()) * 2 / 3;
    const auto mesh = [&](bool is_left_first) {
      PartialSweep below(surface, guide, {}, {.high = low});
      PartialSweep between(surface, guide, {}, {.low = low, .high = high});
      PartialSweep above(surface, reversed, {}, {.high = -high});
      for (PartialSweep* part : {&below, &between, &above}) part->run();
      if (is_left_first) {
        below.absorb(between);
        below.absorb(above);
      } else {
        between.absorb(above);
        below.absorb(between);
      }
      below.finish();
      return below.take_result();
    };
    const SweepResult a = mesh(true), b = mesh(false);
    CHECK(a.mesh.surface.triangle_list() == b.mesh.surface.triangle_list());
    CHECK(std::ranges::equal(a.mesh.points, b.mesh.points, {}, &surface::SurfacePoint::position,
                             &surface::SurfacePoint::position));
    CHECK(a.operations.futile_outside_protecting == b.operations.futile_outside_protecting);
    CHECK(a.operations.creep == b.operations.creep);
    ++runs;
    closed += a.open_edges == 0;
  });
  CHECK(closed == runs);
}

TEST_CASE("the middle level keeps out of the interval between a close minimum and maximum") {
  support::for_seeds(200, [&](unsigned seed) {
    const Swept swept(seed);
    if (!swept.skin) return;
    const double level = middle_level(swept.skin->surface, swept.guide);
    for (const auto& p : swept.guide.points) {
      for (const auto& q : swept.guide.points) {
        if (p.index != 0 || q.index != 2) continue;
        const double reach = std::min(p.point.length_scale, q.point.length_scale);
        if ((p.point.position - q.point.position).norm() > reach) continue;
        CHECK_FALSE((p.value <= level && level <= q.value));
      }
    }
  });
}

TEST_CASE("a reversed Morse function has the same critical points with minima and maxima swapped") {
  support::for_seeds(50, [&](unsigned seed) {
    const Swept swept(seed);
    if (!swept.skin) return;
    const auto reversed =
        morse::critical_points(swept.skin->surface, swept.guide.function.reversed()).points;
    for (const auto& p : swept.guide.points) {
      const auto same = std::find_if(reversed.begin(), reversed.end(), [&](const auto& q) {
        return (p.point.position - q.point.position).norm() < 1e-9 * p.point.length_scale &&
               p.reversed().index == q.index;
      });
      REQUIRE(same != reversed.end());
      CHECK(same->value == doctest::Approx(p.reversed().value));
      CHECK(std::abs(same->descending.dot(p.reversed().descending)) ==
            doctest::Approx(p.index == 1 ? 1 : 0));
    }
  });
}

TEST_CASE("no value within a distance differs by more than a Morse function's most change") {
  support::Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const geometry::Point from = 3 * random.direction(), x = 5 * random.direction();
    for (const auto& f : {morse::MorseFunction::height(random.direction()),
                          morse::MorseFunction::squared_distance(from),
                          morse::MorseFunction::squared_distance(from).reversed()}) {
      const double distance = random.between(0, 4);
      const geometry::Point y = x + distance * random.direction();
      CHECK(std::abs(f(y) - f(x)) <= f.max_change(x, distance) * (1 + 1e-12));
    }
  }
}
