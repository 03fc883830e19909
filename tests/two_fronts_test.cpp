#include "front/two_fronts.h"

#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;

namespace {

/// Tries a law for skins of random ball sets and the guides of sweeps over them.
template <class Law>
void for_guides(unsigned count, Law law) {
  for_skins(count, [&](const PreparedSkin& skin) { law(skin.surface, guide_for(skin)); });
}

}  // namespace

TEST_CASE("two fronts leave a closed mesh of the same surface that one front leaves") {
  for_skins(30, [&](const PreparedSkin& skin) {
    const MeshResult a = make_mesh(skin, {.sizing = {}, .fronts = 1}), b = make_mesh(skin);
    CHECK_MESSAGE(a.certificate.certified, a.certificate.reason);
    CHECK_MESSAGE(b.certificate.certified, b.certificate.reason);
    CHECK(std::abs(a.certificate.area - b.certificate.area) < 2e-3 * a.certificate.area);
  });
}

TEST_CASE("two fronts lay the same triangles in one thread as in two") {
  for_guides(10, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const SweepResult a = sweep_from_both_ends(surface, guide, {}, {}, Run(1));
    const SweepResult b = sweep_from_both_ends(surface, guide, {}, {}, Run(2));
    CHECK(a.mesh.surface.triangle_list() == b.mesh.surface.triangle_list());
    CHECK(a.open_edges == 0);
  });
}

TEST_CASE("three fronts absorbed in either bracketing leave the same bytes") {
  std::size_t closed = 0, runs = 0;
  for_guides(30, [&](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const morse::Guide reversed = guide.reversed();
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
  for_guides(200, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const double level = middle_level(surface, guide);
    for (const auto& p : guide.points) {
      for (const auto& q : guide.points) {
        if (p.index != 0 || q.index != 2) continue;
        const double reach = std::min(p.point.length_scale, q.point.length_scale);
        if ((p.point.position - q.point.position).norm() > reach) continue;
        CHECK_FALSE((p.value <= level && level <= q.value));
      }
    }
  });
}

TEST_CASE("a reversed Morse function has the same critical points with minima and maxima swapped") {
  for_guides(50, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const auto reversed = morse::critical_points(surface, guide.function.reversed()).points;
    for (const auto& p : guide.points) {
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
  Random random(1);
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
